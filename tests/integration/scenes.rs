//! The bodies; each method is the default of one of them.

use nalgebra::Vector3;
use newton_euler::prelude::*;
use serde_json::Value;

use crate::reference::{attitude, distance, trajectory, vector};

pub const GRAVITY: f64 = 9.80665;

rigid_body!(HeavyTop {
    doc: "The asymmetric heavy top of the reference, by DOP853.",
    motion: rotation,
    inertia: principal(0.6, 0.8, 1)[kg * m ^ 2],
    moments: [weight = body(0, 0, 1).cross(world(0, 0, -1))],
    outputs: [energy],
});

rigid_body!(SeriesTop {
    doc: "The same by series.",
    motion: rotation,
    inertia: principal(0.6, 0.8, 1)[kg * m ^ 2],
    moments: [weight = body(0, 0, 1).cross(world(0, 0, -1))],
    outputs: [taylor],
});

rigid_body!(FreeBody {
    motion: rotation,
    inertia: principal(0.6, 0.8, 1)[kg * m ^ 2],
    outputs: [energy, momentum],
});

rigid_body!(ExactBody {
    doc: "The same in closed form.",
    motion: rotation,
    inertia: principal(0.6, 0.8, 1)[kg * m ^ 2],
    outputs: [flow],
});

rigid_body!(Pendulum {
    motion: pivot(pin),
    mass: 2[kg],
    inertia: 0.1[kg * m ^ 2],
    points: [pin = (0, 0.5)[m]],
    fields: [weight = mass * world(0, -9.80665[m / s ^ 2])],
    reactions: [hold = world(_, _).at(pin)],
    outputs: [energy],
});

rigid_body!(SeriesPendulum {
    motion: pivot(pin),
    mass: 2[kg],
    inertia: 0.1[kg * m ^ 2],
    points: [pin = (0, 0.5)[m]],
    fields: [weight = mass * world(0, -9.80665[m / s ^ 2])],
    reactions: [hold = world(_, _).at(pin)],
    outputs: [taylor],
});

rigid_body!(ExactPendulum {
    motion: pivot(pin),
    mass: 2[kg],
    inertia: 0.1[kg * m ^ 2],
    points: [pin = (0, 0.5)[m]],
    fields: [weight = mass * world(0, -9.80665[m / s ^ 2])],
    reactions: [hold = world(_, _).at(pin)],
    outputs: [flow],
});

rigid_body!(HeldPendulum {
    doc: "The same in the plane, its pin as a constraint.",
    motion: planar,
    mass: 2[kg],
    inertia: 0.1[kg * m ^ 2],
    points: [pin = (0, 0.5)[m]],
    fields: [weight = mass * world(0, -9.80665[m / s ^ 2])],
    constraints: [held = pin.position()],
    reactions: [hinge = world(_, _).at(pin)],
});

rigid_body!(Drifting {
    motion: translation,
    mass: 1[kg],
});

rigid_body!(Cart {
    doc: "A cart that is pushed, in the manner that its parameter says.",
    motion: translation,
    inputs: [push[N]],
    params: [drag = 0.3[kg / s]],
    mass: 2[kg],
    forces: [motor = world(push, 0, 0), air = -drag * velocity],
});

rigid_body!(SeriesCart {
    motion: translation,
    inputs: [push[N]],
    params: [drag = 0.3[kg / s]],
    mass: 2[kg],
    forces: [motor = world(push, 0, 0), air = -drag * velocity],
    outputs: [taylor],
});

rigid_body!(Collapse {
    doc: "Falls into the origin: 1/r² along a line.",
    motion: translation,
    mass: 1[kg],
    forces: [pull = -1[N * m ^ 2] * position / position.norm().powi(3)],
});

rigid_body!(SeriesCollapse {
    motion: translation,
    mass: 1[kg],
    forces: [pull = -1[N * m ^ 2] * position / position.norm().powi(3)],
    outputs: [taylor],
});

rigid_body!(Chirp {
    doc: "Its series has every fourth term, from time zero on.",
    motion: translation,
    mass: 1[kg],
    forces: [push = world((1[1 / s ^ 2] * t * t).cos() * 1[N], 0, 0)],
    outputs: [taylor],
});

rigid_body!(Stiffening {
    doc: "Every sixth term.",
    motion: translation,
    mass: 1[kg],
    forces: [spring = -1[N / m] * (t / 1[s]).powi(4) * position],
    outputs: [taylor],
});

rigid_body!(Kicked {
    doc: "Something acts for a second, after five.",
    motion: translation,
    mass: 1[kg],
    forces: [kick = world(
        if t > 5[s] {
            if t < 6[s] { 1[N] } else { 0[N] }
        } else {
            0[N]
        },
        0,
        0
    )],
});

rigid_body!(Tethered {
    doc: "On a string that is let out.",
    motion: translation,
    inputs: [out[m].moving],
    mass: 1[kg],
    fields: [weight = mass * world(0, 0, -9.80665[m / s ^ 2])],
    constraints: [taut = position.norm() - 1[m] - out],
    reactions: [string = _ * (position / 1[m])],
});

/// The start of a problem of the reference and its end after 10 s.
pub fn ends(name: &str) -> [Rotation; 2] {
    let problem = trajectory(name);
    let [early, whole] = [&problem["at_T_10"], &problem];
    let end = if early.is_null() { whole } else { early };
    let state = |attitude_of: &Value, rates: &Value| Rotation {
        attitude: attitude(attitude_of),
        angular_velocity: vector(rates),
    };
    [
        state(&problem["q0"], &problem["w0"]),
        state(&end["q_ref"], &end["w_ref"]),
    ]
}

/// The error as the reference measures it.
pub fn error(end: &Rotation, expected: &Rotation) -> f64 {
    let w: Vector3<f64> = expected.angular_velocity;
    distance(&end.attitude, &expected.attitude).max((end.angular_velocity - w).norm() / w.norm())
}

/// The period of the pendulums: 2 π / ω₀ / agm(1, cos(amplitude / 2)).
pub fn period(amplitude: f64) -> f64 {
    let rate = (2.0 * GRAVITY * 0.5 / 0.6_f64).sqrt();
    let (mut a, mut b) = (1.0, (amplitude / 2.0).cos());
    for _ in 0..6 {
        (a, b) = (f64::midpoint(a, b), (a * b).sqrt());
    }
    std::f64::consts::TAU / rate / a
}
