//! Bodies with every kind of structure.

use newton_euler::rigid_body;

rigid_body!(Thrown {
    motion: spatial,
    mass: 2,
    inertia: principal(1.3, 1.7, 2.1),
    fields: [weight = mass * world(0, 0, -9.8)],
});
rigid_body!(Probe {
    motion: spatial,
    inputs: [thrust],
    mass: 2,
    inertia: principal(1.3, 1.3, 0.7),
    fields: [weight = mass * world(0, 0, -9.8)],
    forces: [engine = body(0, 0, thrust)],
});
rigid_body!(Satellite {
    motion: rotation,
    inputs: [torque = body(_, _, _)],
    inertia: principal(1.3, 1.7, 2.1),
    moments: [wheels = torque],
});
rigid_body!(Top {
    motion: fixed_point(tip),
    params: [m, l, across, along],
    mass: m,
    inertia: principal(across, across, along),
    points: [tip = (0, 0, -l)],
    fields: [weight = mass * world(0, 0, -9.8)],
});
rigid_body!(Hanging {
    motion: fixed_point(hook),
    mass: 2,
    inertia: principal(1.3, 1.7, 2.1),
    points: [hook = (0.1, 0.2, 0.3)],
    fields: [weight = mass * world(0, 6, -8)],
});
// 2 - n n / 2 about n = (3, 0, 4) / 5
rigid_body!(Tilted {
    motion: rotation,
    inertia: tensor {
        xx: 1.82,
        yy: 2,
        zz: 1.68,
        zx: -0.24
    },
});
rigid_body!(Ball {
    motion: spatial,
    params: [k = 0.1],
    mass: 2,
    inertia: principal(1.3, 1.3, 1.3),
    forces: [drag = -k * velocity.norm() * velocity],
});
rigid_body!(Dart {
    motion: spatial,
    params: [k = 0.1],
    mass: 2,
    inertia: principal(1.7, 1.7, 2.1),
    points: [fin = (0, 0, -0.3)],
    locals: [air = fin.velocity()],
    forces: [drag = (-k * air.norm_squared() * air).at(fin)],
});
rigid_body!(Tethered {
    motion: spatial,
    mass: 2,
    inertia: principal(1.3, 1.7, 2.1),
    points: [post = world(0, 0, 3)],
    potentials: [spring = 10 * ((position - post.position()).norm() - 0.5).powi(2)],
});
rigid_body!(Floating {
    motion: spatial,
    mass: 2,
    inertia: principal(1.3, 1.7, 2.1),
    locals: [depth = position.in_world().z],
    forces: [
        lift = if depth < 1 {
            world(0, 0, 20)
        } else {
            world(0, 0, 1)
        },
        wave = world(0, 0, 2[N / m] * (3 * t).sin() * depth.abs()),
    ],
});
rigid_body!(Fenced {
    motion: spatial,
    mass: 2,
    inertia: principal(1.3, 1.7, 2.1),
    forces: [lift = if position.in_world().x < 1 {
        world(0, 0, 20)
    } else {
        world(0, 0, 1)
    }],
});
rigid_body!(Sail {
    motion: spatial,
    inputs: [wind = world(_, _, _)],
    mass: 2,
    inertia: principal(1.3, 1.7, 2.1),
    points: [mast = (0.1, 0.3, 0.5)],
    forces: [pull = (2[N * s / m] * (wind - velocity)).at(mast)],
});
rigid_body!(Glider {
    motion: planar,
    mass: 2,
    inertia: 0.5,
    forces: [thrust = body(3, 0)],
});
rigid_body!(Raft {
    motion: planar,
    mass: 2,
    inertia: 0.5,
    points: [bow = (0.3, 0.1)],
    forces: [wind = world(3, 0).at(bow)],
});
rigid_body!(Pendulum {
    motion: pivot(pin),
    mass: 2,
    inertia: 0.5,
    points: [pin = (0, 0.4)],
    fields: [weight = mass * world(0, -9.8)],
});
rigid_body!(Pellet {
    motion: translation,
    mass: 2,
    forces: [drag = -0.1 * velocity],
});
rigid_body!(Compass {
    motion: rod(body(1, 0, 0)),
    mass: 2,
    inertia: 0.3,
    moments: [magnetic = axis.cross(world(0, 0, 0.1))],
});
rigid_body!(Drifting {
    motion: rod(body(1, 0, 0)),
    mass: 2,
    inertia: 0.3,
});
// a puck on a plane, by its constraint
rigid_body!(Puck {
    motion: spatial,
    mass: 2,
    inertia: principal(1.3, 1.7, 2.1),
    fields: [weight = mass * world(0, 3, -4)],
    reactions: [table = world(0, 0, _)],
    constraints: [flat = position.in_world().z],
});
rigid_body!(General::<T> {
    motion: spatial,
    inputs: [push = body(_, _, _)],
    mass: 2,
    inertia: principal(1.3, 1.3, 1.3),
    points: [tip = (0.1, 0.2, 0.3), post = world(1, 2, 3)],
    forces: [
        pushed = push.at(tip),
        spring = (2[N / m] * (post.position() - tip.position())).at(tip)
    ],
    moments: [
        shaken = body(0, 0, 2[N * m / s] * t),
        damped = -2[N * m * s] * angular_velocity
    ],
});
