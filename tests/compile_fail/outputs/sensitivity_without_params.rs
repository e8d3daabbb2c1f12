use newton_euler::rigid_body;

rigid_body!(Brick {
    motion: spatial,
    mass: 2[kg],
    inertia: principal(0.1, 0.2, 0.3)[kg * m ^ 2],
    outputs: [sensitivity],
});

fn main() {}
