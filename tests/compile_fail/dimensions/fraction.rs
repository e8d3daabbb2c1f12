use newton_euler::rigid_body;

rigid_body!(Stone {
    motion: translation,
    params: [length = 2[m]],
    mass: 2[kg],
    forces: [push = length.powf(16 / 12) * world(0, 0, 1[N])],
});

fn main() {}
