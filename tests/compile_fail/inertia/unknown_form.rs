use newton_euler::rigid_body;

rigid_body!(Drone {
    motion: spatial,
    mass: 1.2[kg],
    inertia: matrix(0.02, 0.03, 0.04)[kg * m ^ 2],
});

fn main() {}
