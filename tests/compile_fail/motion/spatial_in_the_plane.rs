use newton_euler::rigid_body;

rigid_body!(Plank {
    motion: spatial,
    mass: 1[kg],
    inertia: 0.1[kg * m ^ 2],
    points: [tip = (1, 0)[m]],
    forces: [push = body(0, 1[N]).at(tip)],
});

fn main() {}
