use newton_euler::rigid_body;

rigid_body!(Stone {
    motion: planar,
    mass: 1[kg],
    inertia: 1[kg * m ^ 2],
    forces: [push = body(0, 1 / ((3 + 2 * 2.sqrt()).sqrt() - 1 - 2.sqrt()))],
});

fn main() {}
