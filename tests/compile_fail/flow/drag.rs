use newton_euler::rigid_body;

rigid_body!(Parachute {
    motion: translation,
    mass: 80[kg],
    fields: [weight = mass * world(0, 0, -9.81[m / s ^ 2])],
    forces: [drag = -30[N * s / m] * velocity],
    outputs: [flow],
});

fn main() {}
