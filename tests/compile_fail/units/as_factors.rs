use newton_euler::rigid_body;

rigid_body!(Plank {
    motion: planar,
    params: [length = 2 * m],
    mass: 1[kg],
    inertia: 0.1 * kg * m ^ 2,
    points: [tip = (length, 0)],
    forces: [push = body(0, 3 * N).at(tip)],
    fields: [weight = mass * world(0, -9.81 * m / s ^ 2)],
});

fn main() {}
