use newton_euler::rigid_body;

rigid_body!(pub Stone {
    motion: translation,
    mass: 1[kg],
});

fn main() {}
