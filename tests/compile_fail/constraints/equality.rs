use newton_euler::rigid_body;

rigid_body!(Plank {
    motion: planar,
    mass: 2[kg],
    inertia: 0.3[kg * m ^ 2],
    reactions: [support = world(0, _).at(G)],
    constraints: [contact = position.in_world().y == 0],
});

fn main() {}
