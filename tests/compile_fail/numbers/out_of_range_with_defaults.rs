use newton_euler::rigid_body;

rigid_body!(Stone {
    motion: translation,
    params: [big = 1e200],
    mass: 1[kg],
    forces: [push = world(big * big, 0, 0)],
});

fn main() {}
