use newton_euler::rigid_system;

rigid_system!(Gears {
    motion: planar,
    bodies: [
        small { mass: 1[kg], inertia: 1[kg * m ^ 2] },
        large { mass: 1[kg], inertia: 1[kg * m ^ 2] },
    ],
    joints: [first = revolute(world(0, 0), small.G), second = revolute(nope.G, large.G)],
    constraints: [mesh = first.angle + 2 * second.angle],
    drives: [friction = (-0.2 * mesh).on(first)],
});

fn main() {}
