use newton_euler::rigid_body;

rigid_body!(Rocket {
    motion: spatial,
    mass: 1[kg],
    inertia: principal(1, 1, 1)[kg * m ^ 2],
    points: [nozzle = (0, 0, -0.6)],
    forces: [pull = nozzle.x * body(0, 0, 1)[N / m]],
});

fn main() {}
