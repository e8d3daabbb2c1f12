use newton_euler::rigid_system;

rigid_system!(Pendulum {
    motion: planar,
    bodies: [
        upper {
            mass: 1.2[kg],
            forces: [f = body(1, 0).at(elbow), g = 2[N].at(elbow)],
            inertia: 0.04[kg * m ^ 2],
            points: [hinge = (-0.28, 0)[m], elbow = (0.32, 0)[m]],
        },
        lower { mass: 0.8[kg], inertia: 0.015[kg * m ^ 2], points: [hinge = (-0.22, 0)[m]] },
    ],
    joints: [
        shoulder = revolute(world(0, 0), upper.hinge),
        elbow = revolute(upper.elbow, lower.hinge),
    ],
});

fn main() {}
