use newton_euler::rigid_body;

rigid_body!(Stone {
    motion: planar,
    params: [length = 0],
    mass: 1[kg],
    inertia: 1[kg * m ^ 2],
    forces: [push = body(0, 3 / length)],
});

fn main() {}
