use newton_euler::rigid_body;

// ten mistakes of different kinds, all in one compile
rigid_body!(Drone {
    motion: spatial,
    mass = 1.2[kg],
    inertia: principal(0.0123, 0.0123, 0.224)[kg * m ^ 2],
    params: [arm = 0.17[m], type = 3],
    inputs: [thrust[N], torque[N * m], wind = world(_, _, _)[km / h]],
    points: [
        front = (arm, 0, 0),
        back = (-arm, 0),
    ],
    fields: [weight = mass * world(0, 0, -9.80665[m / s ^ 2])],
    forces: [
        lift = body(0, 0, thrust + torque).at(front),
        tail = body(0, 0, 2N).at(bakc),
        drag = -0.1[N * s / m] * (velocity - wind),
    ],
    moments: [spin = body(0, 0, -0.01 * angular_velocity.z)],
    outputs: [energy, momentun],
});

fn main() {}
