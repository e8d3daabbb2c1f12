use newton_euler::rigid_body;

rigid_body!(Probe {
    motion: spatial,
    mass: 85[kg],
    inertia: principal(12, 12, 20) kg m^2,
    points: [nozzle = (0, 0, -0.6) m],
    inputs: [thrust N, roll N*m],
    forces: [engine = body(0, 0, thrust).at(nozzle)],
    fields: [weight = mass * world(0, 0, -9.81 m / s ^ 2)],
});

fn main() {}
