use newton_euler::rigid_system;

rigid_system!(Pendulum {
    motion: planar,
    bodies: [
        upper {
            mass: 1.2[kg],
            inertia: 0.04[kg * m ^ 2],
            points: [hinge = (-0.28, 0)[m], tip = (0.32, 0)[m]],
        },
        lower { mass: 0.8[kg], inertia: 0.015[kg * m ^ 2], points: [hinge = (-0.22, 0)[m]] },
    ],
    inputs: [torque[N * m]],
    joints: [
        elbow = revolute(lower.hinge, upper.tip),
        shoulder = revolute(world(0, 0), upper.hinge),
    ],
    drives: [motor = torque.on(shoulder)],
});

fn main() {}
