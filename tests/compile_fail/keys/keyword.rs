use newton_euler::rigid_body;

rigid_body!(Stone {
    type: translation,
    motion: translation,
    mass: 1[kg],
});

fn main() {}
