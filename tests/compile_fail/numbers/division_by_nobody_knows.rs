use newton_euler::rigid_body;

rigid_body!(Stone {
    motion: planar,
    mass: 1[kg],
    inertia: 1[kg * m ^ 2],
    forces: [push = body(0, 1 / (2.ln() + 3.ln() - 6.ln()))],
});

fn main() {}
