use newton_euler::rigid_body;

rigid_body!(Stone {
    motion: translation,
    params: [big = 1e200, small = 1e-300],
    mass: 1[kg],
    forces: [push = world(big * big * small, 0, 0)],
});

fn main() {}
