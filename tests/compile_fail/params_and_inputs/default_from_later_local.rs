use newton_euler::rigid_body;

rigid_body!(Plank {
    motion: planar,
    mass: 2[kg],
    inertia: 0.3[kg * m ^ 2],
    params: [span = 2 * arm],
    locals: [arm = 0.5[m]],
    points: [tip = (span, 0)],
    forces: [push = body(0, 1).at(tip)],
});

fn main() {}
