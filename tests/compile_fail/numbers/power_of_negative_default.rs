use newton_euler::rigid_body;

rigid_body!(Stone {
    motion: planar,
    params: [exponent = 2.5],
    mass: 1[kg],
    inertia: 1[kg * m ^ 2],
    forces: [push = body(0, (-2).powf(exponent))],
});

fn main() {}
