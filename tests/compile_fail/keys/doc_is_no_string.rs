use newton_euler::rigid_body;

rigid_body!(Stone {
    doc: A thrown stone,
    motion: translation,
    mass: 1[kg],
});

fn main() {}
