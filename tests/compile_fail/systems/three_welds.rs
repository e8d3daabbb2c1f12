use newton_euler::rigid_system;

// two plates that three welds hold together
rigid_system!(Plates {
    bodies: [
        left { mass: 1[kg], inertia: principal(1, 1, 1)[kg * m ^ 2], points: [a = (1, 0, 0), b = (1, 1, 0), c = (1, 0, 1)] },
        right { mass: 1[kg], inertia: principal(1, 1, 1)[kg * m ^ 2], points: [a = (-1, 0, 0), b = (-1, 1, 0), c = (-1, 0, 1)] },
    ],
    joints: [
        base = revolute(world(0, 0, 0), left.G, world(0, 0, 1)),
        a = weld(left.a, right.a),
        b = weld(left.b, right.b),
        c = weld(left.c, right.c),
    ],
    outputs: [reactions],
});

fn main() {}
