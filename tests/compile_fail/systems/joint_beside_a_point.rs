use newton_euler::rigid_system;

rigid_system!(Arms {
    motion: planar,
    bodies: [
        a { mass: 1[kg], inertia: 1[kg * m ^ 2], points: [tip = (0.2, 0)[m]] },
        b { mass: 1[kg], inertia: 1[kg * m ^ 2] },
    ],
    joints: [first = revolute(world(0, 0), a.G), second = revolute(a.tip + a.body(0.1, 0)[m], b.G)],
});

fn main() {}
