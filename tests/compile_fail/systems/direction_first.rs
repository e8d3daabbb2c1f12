use newton_euler::rigid_system;

rigid_system!(Pendulum {
    bodies: [
        upper {
            mass: 1.2[kg],
            inertia: principal(0.01, 0.04, 0.04)[kg * m ^ 2],
            points: [hinge = (-0.28, 0, 0)[m], tip = (0.32, 0, 0)[m]],
        },
        lower {
            mass: 0.8[kg],
            inertia: principal(0.01, 0.015, 0.015)[kg * m ^ 2],
            points: [hinge = (-0.22, 0, 0)[m]],
        },
    ],
    joints: [
        shoulder = revolute(world(0, 0, 0), upper.hinge, world(0, 0, 1)),
        elbow = revolute(body(0, 0, 1), upper.tip, lower.hinge),
    ],
});

fn main() {}
