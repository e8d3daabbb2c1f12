use newton_euler::rigid_body;

rigid_body!(Drone {
    motion: spatial,
    mass: 1.2[kg],
    inertia: principal(0.02, 0.03, 0.04)[kg * m ^ 2],
    points: [tip = body(0.1, 0, 0) + world(0, 0, 1)],
    forces: [push = body(1, 0, 0).at(tip)],
});

fn main() {}
