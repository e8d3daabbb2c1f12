newton_euler::rigid_body!(Peg {
    motion: translation,
    mass: 1[kg],
    forces: [push = 2 world(1, 0, 0)],
});

fn main() {}
