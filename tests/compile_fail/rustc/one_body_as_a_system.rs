use newton_euler::rigid_system;

rigid_system!(Ball {
    mass: 1[kg],
    inertia: sphere(0.1[m]),
    points: [hook = (0, 0, 0.1[m])],
    forces: [push = body(1[N], 0, 0).at(hook)],
    outputs: [energy],
});

// the state of a body stays
const _: fn(&Ball, &newton_euler::state::Spatial) = |_, _| {};

fn main() {}
