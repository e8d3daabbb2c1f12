use newton_euler::rigid_body;

rigid_body!(Pushed {
    motion: translation,
    mass: 1[kg],
    inputs: [u[N]],
    forces: [push = world(2 u, 0, 0)],
});

rigid_body!(Pulsed {
    motion: translation,
    mass: 1[kg],
    forces: [pulse = if t > 0 and t < 2 { world(1, 0, 0) } else { world(0, 0, 0) }],
});

fn main() {}
