use newton_euler::rigid_body;

rigid_body!(Stone {
    motion: planar,
    mass: 1[kg],
    inertia: 1[kg * m ^ 2],
    forces: [push = body(0, (-2).powf(2.5))],
});

fn main() {}
