use newton_euler::rigid_body;

rigid_body!(Dart {
    motion: spatial,
    mass: 0.02[kg],
    inertia: principal(1e-5, 1e-5, 1e-6),
    points: [tail = (0, 0, -0.1[m])],
    fields: [weight = mass * world(0, 0, -9.81[m / s ^ 2])],
    forces: [
        thrust = body(0, 0, 1)[N],
        fins = (-0.01[N * s / m] * tail.velocity()).at(tail),
    ],
    outputs: [flow],
});

fn main() {}
