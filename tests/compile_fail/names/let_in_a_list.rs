use newton_euler::rigid_body;

rigid_body!(Plank {
    motion: planar,
    mass: 2[kg],
    inertia: 0.3[kg * m ^ 2],
    inputs: [thrust[N]],
    locals: [let twice = 2 * thrust],
    forces: [lift = body(0, twice)],
});

fn main() {}
