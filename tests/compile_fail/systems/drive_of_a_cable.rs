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
        rope = cable(upper.hinge, lower.G, 0.5[m], 20[N / m]),
        strut = link(world(1, 0)[m], lower.G, 0.9[m]),
    ],
    drives: [f = 2[N].on(rope), jack = 2[N].on(strut)],
    outputs: [reactions(rope)],
});

fn main() {}
