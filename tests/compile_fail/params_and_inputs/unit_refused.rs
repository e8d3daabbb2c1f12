use newton_euler::rigid_body;

rigid_body!(Plank {
    motion: planar,
    mass: 2[kg],
    inertia: 0.3[kg * m ^ 2],
    params: [arm[metres]],
    points: [tip = (arm, 0)],
    forces: [push = body(0, 1).at(tip)],
});

fn main() {}
