use newton_euler::rigid_body;

rigid_body!(Block {
    motion: planar,
    mass: 2[kg],
    inertia: 1[kg * m ^ 2],
    fields: [weight = mass * world(0, -9.8[m / s ^ 2])],
    constraints: [floor = position.in_world().y],
    reactions: [normal = world(0, _)],
    forces: [push = world(0, 3[N]).at(G + normal.in_world().y / 10[N / m] * world(1, 0))],
});

fn main() {}
