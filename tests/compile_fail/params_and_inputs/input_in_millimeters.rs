use newton_euler::rigid_body;

rigid_body!(Plank {
    motion: planar,
    mass: 2[kg],
    inertia: 0.3[kg * m ^ 2],
    inputs: [stroke[mm]],
    forces: [push = body(0, 3[N / m] * stroke)],
});

fn main() {}
