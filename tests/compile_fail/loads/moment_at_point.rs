use newton_euler::rigid_body;

rigid_body!(Drone {
    motion: spatial,
    mass: 1.2[kg],
    inertia: principal(0.02, 0.03, 0.04)[kg * m ^ 2],
    points: [tip = (0.5, 0, 0)],
    moments: [drag = body(0, 0, 0.1).at(tip)],
    forces: [push = body(0, 0, 1).at(tip)],
});

fn main() {}
