use newton_euler::rigid_body;

rigid_body!(Rocket {
    motion: spatial,
    mass: 1[kg],
    inertia: principal(1, 1, 1)[kg * m ^ 2],
    parameters: [drag = 0.2[N * s / m]],
    forces: [friction = -drag * velocity],
});

fn main() {}
