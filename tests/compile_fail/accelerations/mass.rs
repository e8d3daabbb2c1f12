use newton_euler::rigid_body;

rigid_body!(Hull {
    motion: translation,
    mass: 12[kg] + 1[kg * s ^ 2 / m] * acceleration.norm(),
    forces: [push = world(1[N], 0, 0)],
});

fn main() {}
