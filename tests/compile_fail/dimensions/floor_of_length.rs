newton_euler::rigid_body!(Peg {
    motion: translation,
    inputs: [gap[m]],
    mass: 1[kg],
    locals: [whole = gap.floor()],
    forces: [push = world(whole, 0, 0)],
});

fn main() {}
