use newton_euler::rigid_system;

rigid_system!(Arm {
    motion: planar,
    bodies: [
        upper {
            mass: 1[kg],
            inertia: 0.1[kg * m ^ 2],
            points: [hinge = (0, 0.5)[m], tip = (0, -0.5)[m]],
        },
    ],
    joints: [
        shoulder = revolute(world(0, 0), upper.hinge),
        elbow = revolute(upper.tip, lower.hinge),
    ],
    moments: [wind = moment(0.1[N * m]).on(lower)],
    locals: [height = lower.G.position().in_world().y],
    potentials: [spring = 2[N] * height],
    outputs: [jacobian(lower.tip)],
});

fn main() {}
