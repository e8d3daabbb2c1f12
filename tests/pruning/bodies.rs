//! One body for each rule.

use newton_euler::rigid_body;

rigid_body!(Tilted {
    motion: rotation,
    inertia: tensor {
        xx: 1.3,
        yy: 1.7,
        zz: 2.1,
        xy: 0.1,
        yz: -0.2,
        zx: 0.12
    },
});
rigid_body!(Full {
    motion: rotation,
    inputs: [couple = body(_, _, _)],
    inertia: tensor {
        xx: 1.3,
        yy: 1.7,
        zz: 2.1,
        xy: 0.1,
        yz: -0.2,
        zx: 0.12
    },
    moments: [driven = couple],
});
rigid_body!(OneProduct {
    motion: rotation,
    inertia: tensor {
        xx: 1.3,
        yy: 1.7,
        zz: 2.1,
        xy: 0.12
    },
});
rigid_body!(Driven {
    motion: rotation,
    inputs: [couple = body(_, _, _)],
    inertia: principal(1.3, 1.7, 2.1),
    moments: [driven = couple],
});
rigid_body!(Symmetric {
    motion: rotation,
    inertia: principal(1.7, 2.1, 1.7),
});
rigid_body!(Ball {
    motion: rotation,
    inputs: [couple = world(_, _, _)],
    inertia: principal(2, 2, 2),
    moments: [driven = couple],
});
rigid_body!(Glider {
    motion: planar,
    mass: 2,
    inertia: 0.5,
    forces: [thrust = body(3, 0)],
    fields: [weight = mass * world(0, -9.8)],
});
rigid_body!(FourJets {
    motion: spatial,
    mass: 2,
    inertia: principal(1.3, 1.7, 2.1),
    points: [
        a = (0.1, 0.2, -0.3),
        b = (0.4, 0, 0.1),
        c = (-0.2, 0.3, 0),
        d = (0, -0.5, 0.2)
    ],
    forces: [
        first = body(1.5, 2.2, 3).at(a),
        second = body(-2, 1, 0.5).at(b),
        third = body(0, 0.5, -1).at(c),
        fourth = body(3, -1, 2).at(d),
    ],
});
rigid_body!(OneJet {
    motion: spatial,
    mass: 2,
    inertia: principal(1.3, 1.7, 2.1),
    points: [a = (0.1, 0.2, -0.3)],
    forces: [first = body(1.1, 2.3, 3.7).at(a)],
});
rigid_body!(Turned {
    motion: rotation,
    inertia: principal(1.3, 1.7, 2.1),
    moments: [motor = body(0.3, -0.2, 0.5)],
});
rigid_body!(Central {
    motion: spatial,
    inputs: [push = world(_, _, _), thrust],
    mass: 2,
    inertia: principal(1.3, 1.7, 2.1),
    points: [nozzle = (0.3, 0, 0)],
    forces: [pushed = push, engine = body(thrust, 0, 0).at(nozzle)],
});
rigid_body!(Thrown {
    motion: spatial,
    params: [m = 2],
    mass: m,
    inertia: principal(1.3, 1.7, 2.1),
    fields: [weight = mass * world(0, 0, -9.8)],
});
rigid_body!(Charged {
    motion: spatial,
    mass: 2,
    inertia: principal(1.3, 1.7, 2.1),
    points: [
        p = (0.1, 0.2, -0.3),
        q = (0.4, -0.1, 0.25),
        r = (-0.15, 0.05, 0.35)
    ],
    fields: [electric = world(2.5, -1.25, 4.75).on([0.5.at(p), -0.2.at(q), 0.45.at(r)])],
});
rigid_body!(ChargedTwice {
    motion: spatial,
    mass: 2,
    inertia: principal(1.3, 1.7, 2.1),
    points: [p = (0.1, 0.2, -0.3), q = (0.4, -0.1, 0.25)],
    fields: [electric = world(2.5, -1.25, 4.75).on([0.5.at(p), -0.2.at(q)])],
});
rigid_body!(Top {
    motion: fixed_point(tip),
    mass: 2,
    inertia: principal(1.12, 1.12, 0.7),
    points: [tip = (0, 0, -0.3)],
    fields: [weight = mass * world(0, 0, -9.8)],
});
rigid_body!(Rocket {
    motion: spatial,
    mass: 2,
    inertia: principal(1.3, 1.7, 2.1),
    points: [nozzle = (0.1, 0.2, -0.3)],
    forces: [thrust = body(0, 0, 3).at(nozzle)],
    fields: [weight = mass * world(0, 0, -9.8)],
});
rigid_body!(Damped {
    motion: spatial,
    mass: 2,
    inertia: principal(1.3, 1.7, 2.1),
    forces: [drag = -0.5[N * s / m] * velocity],
});
rigid_body!(Door {
    motion: fixed_axis(hinge, body(0, 0, 1)),
    inputs: [push = body(_, _, _)],
    mass: 2,
    inertia: tensor {
        xx: 1.3,
        yy: 1.7,
        zz: 2.1,
        xy: 0.1,
        yz: -0.2,
        zx: 0.12
    },
    points: [hinge = (-0.4, 0, 0), knob = (0.4, 0.1, 0.2)],
    forces: [pushed = push.at(knob)],
    reactions: [
        frame = world(_, _, _).at(hinge),
        bearing = moment(body(_, _, 0))
    ],
});
rigid_body!(Sledge {
    motion: planar,
    inputs: [thrust],
    mass: 2,
    inertia: 0.5,
    points: [bow = (0.6, 0.1), stern = (-0.5, 0.2)],
    forces: [
        push = body(thrust, 1).at(stern),
        wind = world(1, 2).at(bow),
        pull = world(3, -1).at(stern),
    ],
});
rigid_body!(Pendulum {
    motion: pivot(pin),
    params: [m = 2, l = 0.4],
    mass: m,
    inertia: m * l.powi(2) / 3,
    points: [pin = (0, l)],
    fields: [weight = mass * world(0, -9.8)],
});
rigid_body!(Parametric {
    motion: spatial,
    params: [
        m = 2,
        a = 1.3,
        b = 1.7,
        c = 2.1,
        x = 0.1,
        y = 0.2,
        z = -0.3,
        g = 9.8
    ],
    inputs: [push = body(_, _, _)],
    mass: m,
    inertia: principal(a, b, c),
    points: [tip = (x, y, z)],
    forces: [pushed = push.at(tip)],
    fields: [weight = mass * world(0, 0, -g)],
});
rigid_body!(Couple {
    motion: spatial,
    mass: 2,
    inertia: principal(1.3, 1.7, 2.1),
    points: [left = (-0.3, 0, 0.1), right = (0.3, 0.2, 0)],
    forces: [
        pull = body(0, 3, 1).at(left),
        push = body(0, -3, -1).at(right)
    ],
});
rigid_body!(Slider {
    motion: translation,
    inputs: [push = world(_, _, _)],
    mass: 2,
    forces: [pushed = push],
    fields: [weight = mass * world(0, 0, -9.8)],
});
rigid_body!(Hanging {
    motion: pivot(pin),
    params: [m = 2, l = 0.4],
    mass: m,
    inertia: m * l.powi(2) / 3,
    points: [pin = (0, l)],
    fields: [weight = mass * world(0, -9.8)],
    reactions: [held = world(_, _).at(pin)],
    outputs: [reactions],
});

rigid_body!(Named {
    motion: translation,
    inputs: [u],
    mass: 2,
    locals: [speed = velocity.norm(), k = u * u + 1],
    forces: [
        none = (speed - velocity.norm()) * world(0, 0, 1),
        constant = (u * u + 1 - k).exp() * world(0, 0, 1),
    ],
});
