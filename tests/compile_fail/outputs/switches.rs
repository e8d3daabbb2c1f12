use newton_euler::rigid_body;

rigid_body!(Stone {
    motion: translation,
    mass: 1[kg],
    outputs: { energy: true, momentum: true },
});

rigid_body!(Pebble {
    motion: translation,
    mass: 1[kg],
    outputs: [energy = true],
});

fn main() {}
