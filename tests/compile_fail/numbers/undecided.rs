use newton_euler::rigid_body;

rigid_body!(Pushed {
    motion: translation,
    mass: 1[kg],
    params: [k = 3[N]],
    forces: [push = k * world(2.ln() + 3.ln() - 6.ln(), 0, 0)],
});

fn main() {}
