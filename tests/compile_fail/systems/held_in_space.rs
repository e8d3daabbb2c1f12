use newton_euler::rigid_system;

// two hinges of one axis: each kind that holds less is not enough
rigid_system!(Door {
    bodies: [
        door { mass: 20[kg], inertia: principal(3, 4, 1), points: [low = (0, 0, 0), high = (0, 0, 2)] },
    ],
    joints: [
        low = revolute(world(0, 0, 0), door.low, body(0, 0, 1)),
        high = revolute(world(0, 0, 2), door.high, body(0, 0, 1)),
    ],
    outputs: [reactions],
});

// one as a ball joint: what both hold along the axis is left
rigid_system!(Gate {
    bodies: [
        gate { mass: 20[kg], inertia: principal(3, 4, 1), points: [low = (0, 0, 0), high = (0, 0, 2)] },
    ],
    joints: [
        low = revolute(world(0, 0, 0), gate.low, body(0, 0, 1)),
        high = spherical(world(0, 0, 2), gate.high),
    ],
    outputs: [reactions(high)],
});

// a plate on two slides
rigid_system!(Plate {
    motion: planar,
    bodies: [
        plate { mass: 1[kg], inertia: 1[kg * m ^ 2], points: [side = (0.2, 0.3)[m]] },
    ],
    joints: [
        first = prismatic(world(0, 0), plate.G, body(1, 0)),
        second = prismatic(world(0.2, 0.3), plate.side, body(1, 0)),
    ],
    outputs: [reactions(second)],
});

fn main() {}
