use newton_euler::rigid_body;

rigid_body!(Stone {
    motion: planar_translation,
    mass: 1[kg],
    inputs: [u.moving[N], v.moving()[N], w[N].moved],
    forces: [push = world(u + v, w)],
});

fn main() {}
