//! One generic body of each kind of motion, with parameters and inputs.

use newton_euler::rigid_body;

rigid_body!(Free::<T> {
    motion: spatial,
    params: [mass_factor = 1, arm = body(0.2, 0, 0.1)[m]],
    inputs: [thrust[N], gust = world(_, _, _)[N]],
    mass: 1.5 * mass_factor,
    inertia: tensor {
        xx: 1.3,
        yy: 1.7,
        zz: 2.1,
        xy: -0.12,
        yz: -0.05,
        zx: 0.07
    }[kg * m ^ 2],
    points: [nozzle = arm],
    locals: [speed = velocity.norm()],
    fields: [weight = mass * world(0, 0, -9.80665[m / s ^ 2])],
    forces: [
        push = body(0, thrust, 0.1 * thrust).at(nozzle),
        wind = gust,
        drag = if speed < 1.5 {
            -0.1 * velocity
        } else {
            -0.2 * speed.sqrt() * velocity
        },
    ],
});

rigid_body!(Turning::<T> {
    motion: rotation,
    params: [moment = 0.9[kg * m ^ 2]],
    inputs: [torque = body(_, _, _)[N * m]],
    inertia: principal(moment, 1.2, 1.5)[kg * m ^ 2],
    moments: [drive = torque],
});

rigid_body!(Thrown::<T> {
    motion: translation,
    params: [gravity = 9.80665[m / s ^ 2]],
    mass: 2[kg],
    fields: [weight = mass * world(0, 0, -gravity)],
    forces: [drag = -0.05 * velocity.norm() * velocity],
});

rigid_body!(Plank::<T> {
    motion: planar,
    params: [length = 2.4[m]],
    inputs: [thrust[N]],
    mass: 6[kg],
    inertia: mass * length.powi(2) / 12,
    points: [end = (length / 2, 0)],
    forces: [push = body(0, thrust).at(end)],
});

rigid_body!(Slider::<T> {
    motion: planar_translation,
    mass: 3[kg],
    forces: [
        spring = -4[N / m] * position,
        wave = 1[N] * world((t / 1[s]).sin(), (t / 1[s]).exp().ln())
    ],
});

rigid_body!(Pendulum::<T> {
    motion: pivot(tip),
    params: [length = 0.5[m]],
    mass: 2[kg],
    inertia: 0.01[kg * m ^ 2],
    points: [tip = (0, length)],
    fields: [weight = mass * world(0, -9.80665[m / s ^ 2])],
});

rigid_body!(Top::<T> {
    motion: fixed_point(foot),
    mass: 0.3[kg],
    inertia: principal(0.002, 0.002, 0.001)[kg * m ^ 2],
    points: [foot = (0, 0, -0.1[m])],
    fields: [weight = mass * world(0, 0, -9.80665[m / s ^ 2])],
});

rigid_body!(Stick::<T> {
    motion: rod(body(0, 0, 1)),
    params: [length = 1.2[m]],
    inputs: [pull = world(_, _, _)[N]],
    mass: 0.5[kg],
    inertia: mass * length.powi(2) / 12,
    points: [tip = (0, 0, length / 2)],
    fields: [weight = mass * world(0, 0, -9.80665[m / s ^ 2])],
    forces: [
        string = pull.at(tip),
        drag = -0.1 * velocity.norm() * velocity
    ],
});

rigid_body!(Rotor::<T> {
    motion: fixed_axis(G, body(1, 2, 2)),
    inputs: [brake[N * m]],
    mass: 3[kg],
    inertia: tensor {
        xx: 1.3,
        yy: 1.7,
        zz: 2.1,
        xy: -0.12,
        yz: -0.05,
        zx: 0.07
    }[kg * m ^ 2],
    moments: [drag = body(
        brake,
        -brake.abs(),
        0.1[N * m * s] * angular_velocity.in_body().x
    )],
});
