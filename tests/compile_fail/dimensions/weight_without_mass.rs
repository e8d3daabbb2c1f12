use newton_euler::rigid_body;

rigid_body!(Drone {
    motion: spatial,
    mass: 1.2[kg],
    inertia: principal(0.02, 0.03, 0.04)[kg * m ^ 2],
    fields: [weight = world(0, 0, -9.81[m / s ^ 2])],
});

fn main() {}
