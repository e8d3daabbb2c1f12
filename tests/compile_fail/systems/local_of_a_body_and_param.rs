use newton_euler::rigid_system;

rigid_system!(Pendulum {
    motion: planar,
    params: [rest = 0.5[N]],
    bodies: [
        upper {
            mass: 1.2[kg],
            inertia: 0.04[kg * m ^ 2],
            points: [hinge = (-0.28, 0)[m], tip = (0.32, 0)[m]],
        },
        lower { mass: 0.8[kg], locals: [rest = 2[N]],
            forces: [f = rest * body(1, 0)], inertia: 0.015[kg * m ^ 2], points: [hinge = (-0.22, 0)[m]] },
    ],
    joints: [
        shoulder = revolute(world(0, 0), upper.hinge),
        elbow = revolute(upper.tip, lower.hinge),
    ],
});

fn main() {}
