use newton_euler::rigid_body;

rigid_body!(Drone {
    motion: spatial,
    mass: 1.2[kg],
    inertia: principal(0.02, 0.03, 0.04)[kg * m ^ 2],
    points: [tip = (0.1[m], 0, 0.2[s])],
    forces: [push = body(1, 0, 0).at(tip)],
});

fn main() {}
