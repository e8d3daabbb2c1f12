use newton_euler::rigid_body;

rigid_body!(Plank {
    motion: planar,
    mass: 2[kg],
    inertia: 0.3[kg * m ^ 2],
    params: [arm = 0.5[m], span = 2 * arm],
    points: [tip = (span, 0)],
    forces: [push = body(0, 1).at(tip)],
});

fn main() {}
