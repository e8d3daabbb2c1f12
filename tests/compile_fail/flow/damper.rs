use newton_euler::rigid_body;

rigid_body!(Arm {
    motion: pivot(pin),
    mass: 2[kg],
    inertia: 0.1[kg * m ^ 2],
    points: [pin = (0, 0.5[m])],
    fields: [weight = mass * world(0, -9.81[m / s ^ 2])],
    moments: [damper = -0.1[N * m * s] * angular_velocity],
    outputs: [flow],
});

fn main() {}
