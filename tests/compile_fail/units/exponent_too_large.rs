use newton_euler::rigid_body;

rigid_body!(Stone {
    motion: translation,
    params: [length = 2[m]],
    mass: 2[kg],
    forces: [push = length.powi(64).powi(64) * velocity],
});

fn main() {}
