use newton_euler::rigid_body;

rigid_body!(Plank {
    motion: planar,
    mass: 2[kg],
    inertia: 0.3[kg * m ^ 2],
    points: [left_tip = (0.5, 0)],
    forces: [push = body(0, 1).at(left_tpi), pull = body(0, 2).at(left_tip)],
});

fn main() {}
