use newton_euler::rigid_body;

rigid_body!(Bead {
    motion: planar_translation,
    mass: 2[kg],
    constraints: [wire = position.in_world().y],
    reactions: [push = world(0, _)],
    outputs: [flow],
});

fn main() {}
