use newton_euler::rigid_body;

rigid_body!(Plank {
    motion: planar,
    mass: 2[kg],
    inertia: 0.3[kg * m ^ 2],
    params: [angle = 0.1[rad]],
    forces: [push = body(angle.sgn(), angle.sine()), pull = body(log(angle), 0)],
});

fn main() {}
