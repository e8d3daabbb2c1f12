use newton_euler::rigid_body;

rigid_body!(Plank {
    motion: planar,
    mass: 2[kg],
    inertia: 0.3[kg * m ^ 2],
    fields: [weight = mass * (world(0, 9.81[m / s ^ 2]) - velocity)],
});

fn main() {}
