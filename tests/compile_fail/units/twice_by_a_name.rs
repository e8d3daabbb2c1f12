use newton_euler::rigid_body;

rigid_body!(Stone {
    motion: planar_translation,
    mass: 1[kg],
    inputs: [u[N]],
    forces: [push = world(u, 0)[N]],
});

fn main() {}
