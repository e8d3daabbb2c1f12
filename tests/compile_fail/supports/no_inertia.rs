use newton_euler::rigid_body;

rigid_body!(Pendulum {
    motion: pivot(G),
    mass: 2[kg],
    inertia: 0[kg * m ^ 2],
    points: [heel = (0.2, -0.3)[m]],
    fields: [weight = mass * world(0, -9.80665[m / s ^ 2])],
});

fn main() {}
