use newton_euler::rigid_system;

rigid_system!(Arm {
    motion: planar,
    bodies: [
        upper {
            mass: 1.2[kg],
            inertia: principal(0.1, 0.2, 0.3)[kg * m ^ 2],
            points: [hinge = (-0.28, 0, 0)[m]],
        },
    ],
    joints: [shoulder = revolute(world(0, 0, 0), upper.hinge, body(0, 0, 1))],
    fields: [weight = mass * world(0, 0, -9.80665[m / s ^ 2])],
});

fn main() {}
