use newton_euler::rigid_body;

rigid_body!(Pendulum {
    motion: rod(body(1, 0, 0)),
    mass: 1[kg],
    inertia: 0.1[kg * m ^ 2],
    points: [hinge = (0, 0.5)],
    fields: [weight = mass * world(0, -9.81[m / s ^ 2])],
});

fn main() {}
