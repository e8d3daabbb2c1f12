use newton_euler::rigid_body;

rigid_body!(Plank {
    motion: planar,
    mass: 2[kg],
    inertia: 0.3[kg * m ^ 2],
    params: [k = 2],
    locals: [a = k * b, b = c + 1, c = 2 * a, d = a + 1],
    forces: [push = body(0, d)],
});

fn main() {}
