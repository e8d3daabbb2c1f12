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
    joints: [
        shoulder = revolute(world(0, 0), upper.hinge),
        elbow = revolute(upper.tip, lower.hinge),
    ],
    fields: [
        weight_of_upper = upper.mass * world(0, -9.81[m / s ^ 2]),
        attraction = mass * (1[m ^ 3 / s ^ 2 / kg] * upper.mass * world(0, 1)[m / s ^ 2] / 1[m ^ 3 / s ^ 2]),
    ],
});

fn main() {}
