use newton_euler::rigid_body;

rigid_body!(Plank {
    motion: planar,
    mass: 2[kg],
    inertia: 0.3[kg * m ^ 2],
    points: [tip = (0.5, 0)],
    forces: [push = body(0, 1).at(tip), pull = body(0, 1).at(tail)],
    points: [tail = (-0.5, 0)],
});

fn main() {}
