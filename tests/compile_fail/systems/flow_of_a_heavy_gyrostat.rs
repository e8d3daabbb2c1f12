use newton_euler::rigid_system;

rigid_system!(Gyroscope {
    bodies: [
        frame { mass: 1[kg], inertia: principal(0.01, 0.01, 0.005), points: [tip = (0, 0, -0.1)] },
        rotor { mass: 3[kg], inertia: principal(0.004, 0.004, 0.006) },
    ],
    joints: [
        foot = spherical(world(0, 0, 0), frame.tip),
        spin = revolute(frame.G, rotor.G, body(0, 0, 1)),
    ],
    fields: [weight = mass * world(0, 0, -9.80665[m / s ^ 2])],
    outputs: [flow],
});

fn main() {}
