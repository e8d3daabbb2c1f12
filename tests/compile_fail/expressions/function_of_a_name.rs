use newton_euler::rigid_body;

rigid_body!(Rocket {
    motion: spatial,
    mass: 1[kg],
    inertia: principal(1, 1, 1)[kg * m ^ 2],
    inputs: [thrust[N]],
    forces: [push = body(0, sin(2 * t) * 1[N], max(thrust, 0))],
});

fn main() {}
