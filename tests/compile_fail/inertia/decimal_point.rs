use newton_euler::rigid_body;

rigid_body!(Drone {
    motion: spatial,
    mass: 1.2[kg],
    inertia: principal(0.0123, 0.0123, 0.224)[kg * m ^ 2],
});

fn main() {}
