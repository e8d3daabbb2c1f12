use newton_euler::rigid_body;

rigid_body!(Rocket {
    motion: spatial,
    mass: 1[kg],
    inertia: principal(1, 1, 1)[kg * m ^ 2],
    inputs: [thrust[N]],
    locals: [up = Vector3::new(0, 0, 1)],
    forces: [push = vector![0, 0, thrust]],
});

fn main() {}
