use newton_euler::rigid_system;

rigid_system!(Pendulum {
    motion: planar,
    inputs: [angle[rad].moving],
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
    drives: [
        stop = (-30[N * m] * (elbow.angle - 1).max(0)).on(elbow),
        motor = (-3[N * m] * (shoulder.angle - angle)).on(shoulder),
    ],
    forces: [rope = (20[N / m] * ((lower.G.position() - upper.G.position()).norm() - 0.5[m]).max(0)).between(upper.G, lower.G)],
    outputs: [taylor],
});

fn main() {}
