use newton_euler::rigid_system;

// a beam that two walls hold has loads that no balance determines
rigid_system!(Beam {
    motion: planar,
    bodies: [
        beam {
            mass: 1[kg],
            inertia: 1[kg * m ^ 2],
            points: [left = (-1, 0)[m], right = (1, 0)[m]],
        },
    ],
    joints: [
        left = weld(world(-1, 0), beam.left),
        right = weld(world(1, 0), beam.right),
    ],
    outputs: [reactions],
});

// two joints that are driven, and a third one that closes the loop
rigid_system!(Driven {
    motion: planar,
    bodies: [
        crank { mass: 1[kg], inertia: 1[kg * m ^ 2], points: [o = (0, 0)[m], a = (0.3, 0.4)[m]] },
        rod { mass: 1[kg], inertia: 1[kg * m ^ 2], points: [a = (0, 0)[m], b = (0.6, 0.8)[m]] },
    ],
    joints: [
        o = revolute(world(0, 0), crank.o).driven(1[rad / s] * t),
        a = revolute(crank.a, rod.a).driven(-2[rad / s] * t),
        b = revolute(world(1, 1), rod.b),
    ],
    outputs: [reactions(o)],
});

fn main() {}
