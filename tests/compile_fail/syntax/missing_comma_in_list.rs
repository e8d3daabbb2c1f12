use newton_euler::rigid_body;

rigid_body!(Plank {
    motion: planar,
    mass: 2[kg],
    inertia: 0.3[kg * m ^ 2],
    params: [a = 0.1[m] b = 0.2[m]],
    points: [tip = (a, 0) tail = (-b, 0)],
    forces: [push = body(0, 1).at(tip), pull = body(0, 1).at(tail)],
});

fn main() {}
