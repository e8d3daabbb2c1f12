use newton_euler::rigid_system;

// one more than is needed: neither tension is determined
rigid_system!(Swing {
    motion: planar,
    bodies: [
        seat { mass: 1[kg], inertia: 1[kg * m ^ 2], points: [p = (0.1, 0)[m]] },
    ],
    joints: [
        orbit = free(seat),
        rope = link(world(0, 0), seat.p, 2[m]),
        chain = link(world(0, 0), seat.p, 2[m]),
    ],
    outputs: [reactions],
});

// a square with both diagonals: its bars, and not what stands beside it
rigid_system!(Braced {
    motion: planar,
    bodies: [
        a { mass: 1[kg], inertia: 1[kg * m ^ 2] },
        b { mass: 1[kg], inertia: 1[kg * m ^ 2] },
        top { mass: 1[kg], inertia: 1[kg * m ^ 2] },
    ],
    joints: [
        first = translation(a),
        second = translation(b),
        third = translation(top),
        left = link(world(0, 0), a.G, 1[m]),
        right = link(world(1, 0), b.G, 1[m]),
        bar = link(a.G, b.G, 1[m]),
        rising = link(world(0, 0), b.G, 1.4142135623730951[m]),
        falling = link(world(1, 0), a.G, 1.4142135623730951[m]),
        mast = link(a.G, top.G, 1[m]),
        stay = link(b.G, top.G, 1[m]),
    ],
    outputs: [reactions(mast, bar, stay, left)],
});

rigid_system!(Held {
    motion: planar,
    bodies: [
        seat { mass: 1[kg], inertia: 1[kg * m ^ 2], points: [p = (0.1, 0)[m]] },
    ],
    joints: [
        weld = weld(world(0, 0), seat.G),
        rope = link(world(0, 3), seat.p, 2[m]),
    ],
    outputs: [reactions],
});

// from the pin of a hinge to the ground
rigid_system!(Pinned {
    motion: planar,
    bodies: [
        seat { mass: 1[kg], inertia: 1[kg * m ^ 2], points: [p = (0.1, 0)[m]] },
    ],
    joints: [
        pin = revolute(world(1, 0), seat.p),
        rope = link(world(1, 3), seat.p, 3[m]),
    ],
});

// friction follows a tension that nothing determines
rigid_system!(Rubbed {
    motion: planar,
    bodies: [
        seat {
            mass: 1[kg],
            inertia: 1[kg * m ^ 2],
            points: [p = (0.1, 0)[m]],
            forces: [friction = world(-0.1 * rope, 0)],
        },
    ],
    joints: [
        orbit = free(seat),
        rope = link(world(0, 0), seat.p, 2[m]),
        chain = link(world(0, 0), seat.p, 2[m]),
    ],
});

// one of both is a constraint that is written
rigid_system!(Written {
    motion: planar,
    bodies: [
        seat { mass: 1[kg], inertia: 1[kg * m ^ 2] },
    ],
    joints: [
        orbit = free(seat),
        rope = link(world(0, 0), seat.G, 2[m]),
    ],
    constraints: [circle = seat.G.position().norm_squared() - 4[m ^ 2]],
});

rigid_system!(Spoiled {
    motion: planar,
    params: [reach = -2[m], none = 0[m], slack = -1[m]],
    bodies: [
        seat { mass: 1[kg], inertia: 1[kg * m ^ 2] },
    ],
    joints: [
        orbit = free(seat),
        rope = link(world(0, 0), seat.G, reach),
        chain = link(world(0, 1), seat.G, none),
        wire = cable(world(0, 1), seat.G, slack, 5[N / m]),
    ],
});

fn main() {}
