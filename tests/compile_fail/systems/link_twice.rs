use newton_euler::rigid_system;

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

fn main() {}
