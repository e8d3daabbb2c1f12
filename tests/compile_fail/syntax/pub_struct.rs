use newton_euler::rigid_body;

rigid_body!(pub struct Stone {
    motion: translation,
    mass: 1[kg],
});

rigid_body!(#[derive(Debug)] Pebble {
    motion: translation,
    mass: 1[kg],
});

fn main() {}
