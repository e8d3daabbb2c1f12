use newton_euler::rigid_body;

rigid_body!(Plank {
    motion: planar,
    mass: 2[kg],
    inertia: 0.3[kg * m ^ 2],
    params: [t = 0.5[m]],
    points: [tip = (t, 0)],
    forces: [push = body(0, 1[N / s] * t).at(tip)],
});

fn main() {}
