use newton_euler::rigid_body;

rigid_body!(Crate {
    motion: translation,
    mass: 10[kg],
    points: [corner = (0.5, 0.5, 0)],
    forces: [push = world(3[N], 0, 0).at(corner), pull = world(1[N], 0, 0)],
});

fn main() {}
