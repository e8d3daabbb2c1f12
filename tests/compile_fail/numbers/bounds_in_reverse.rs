newton_euler::rigid_body!(Peg {
    motion: translation,
    inputs: [push[N]],
    mass: 1[kg],
    forces: [limited = world(push.clamp(2[N], -2[N]), 0, 0)],
});

fn main() {}
