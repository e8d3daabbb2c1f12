use newton_euler::rigid_body;

rigid_body!(Stone {
    motion: translation,
    mass: 1[kg],
    params: [push: [N], lift: f64],
    forces: [both = world(push, 0, lift)],
});

fn main() {}
