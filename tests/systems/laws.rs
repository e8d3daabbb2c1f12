//! Laws that hold for every system: energy, momentum, inverse dynamics.

use nalgebra::{UnitQuaternion, Vector3};
use newton_euler::prelude::*;

use super::compare::{Jointed, Listed, Random, close};

// the same arm twice: with given drives, and with open ones
rigid_system!(Given {
    inputs: [
        d_1[N * m],
        d_2[N],
        d_3[N],
        d_4[N * m],
        d_5[N * m],
        d_6[N * m],
        d_7[N * m]
    ],
    bodies: [
        a {
            mass: 1.3[kg],
            inertia: principal(0.3, 0.4, 0.5)[kg * m ^ 2],
            points: [p = (0.1, -0.2, 0.3), q = (-0.2, 0.4, 0.15)],
        },
        b {
            mass: 0.7[kg],
            inertia: principal(0.3, 0.35, 0.25)[kg * m ^ 2],
            points: [p = (0.25, 0.1, -0.1), q = (0, -0.3, 0.2)],
        },
        c {
            mass: 0.9[kg],
            inertia: principal(0.12, 0.2, 0.16)[kg * m ^ 2],
            points: [p = (-0.1, 0.2, 0.3), q = (0.3, 0.1, 0)],
        },
        d {
            mass: 0.4[kg],
            inertia: principal(0.05, 0.06, 0.04)[kg * m ^ 2],
            points: [p = (0.1, 0.12, 0.2)],
        },
        e {
            mass: 0.5[kg],
            inertia: principal(0.07, 0.05, 0.06)[kg * m ^ 2],
            points: [p = (0.2, -0.1, 0.1)],
        },
    ],
    joints: [
        turn = revolute(world(0.5, 0.2, -0.1), a.p, body(2, -1, 2)),
        slide = prismatic(a.q, b.p, body(1, 2, -2)),
        both = cylindrical(b.q, c.p, body(0, 3, 4)),
        nut = screw(c.q, d.p, body(3, 0, -4), 0.15[m]),
        cross = universal(a.q, e.p, body(1, 0, 0), body(0, 3, 4)).turned(body(0, 0, 1), 90[deg]),
    ],
    fields: [
        weight = mass * world(0, 0, -9.81[m / s ^ 2]),
        air = -0.3[N * s / m] * velocity
    ],
    drives: [
        friction = (-0.3[N * m * s] * turn.angular_velocity).on(turn),
        a = d_1.on(turn),
        b = d_2.on(slide),
        c = d_3.on(both.position),
        d = d_4.on(both.angle),
        e = d_5.on(nut),
        f = d_6.on(cross.angle_1),
        g = d_7.on(cross.angle_2),
    ],
});

rigid_system!(Open {
    bodies: [
        a {
            mass: 1.3[kg],
            inertia: principal(0.3, 0.4, 0.5)[kg * m ^ 2],
            points: [p = (0.1, -0.2, 0.3), q = (-0.2, 0.4, 0.15)],
        },
        b {
            mass: 0.7[kg],
            inertia: principal(0.3, 0.35, 0.25)[kg * m ^ 2],
            points: [p = (0.25, 0.1, -0.1), q = (0, -0.3, 0.2)],
        },
        c {
            mass: 0.9[kg],
            inertia: principal(0.12, 0.2, 0.16)[kg * m ^ 2],
            points: [p = (-0.1, 0.2, 0.3), q = (0.3, 0.1, 0)],
        },
        d {
            mass: 0.4[kg],
            inertia: principal(0.05, 0.06, 0.04)[kg * m ^ 2],
            points: [p = (0.1, 0.12, 0.2)],
        },
        e {
            mass: 0.5[kg],
            inertia: principal(0.07, 0.05, 0.06)[kg * m ^ 2],
            points: [p = (0.2, -0.1, 0.1)],
        },
    ],
    joints: [
        turn = revolute(world(0.5, 0.2, -0.1), a.p, body(2, -1, 2)),
        slide = prismatic(a.q, b.p, body(1, 2, -2)),
        both = cylindrical(b.q, c.p, body(0, 3, 4)),
        nut = screw(c.q, d.p, body(3, 0, -4), 0.15[m]),
        cross = universal(a.q, e.p, body(1, 0, 0), body(0, 3, 4)).turned(body(0, 0, 1), 90[deg]),
    ],
    fields: [
        weight = mass * world(0, 0, -9.81[m / s ^ 2]),
        air = -0.3[N * s / m] * velocity
    ],
    drives: [
        friction = (-0.3[N * m * s] * turn.angular_velocity).on(turn),
        a = _.on(turn),
        b = _.on(slide),
        c = _.on(both.position),
        d = _.on(both.angle),
        e = _.on(nut),
        f = _.on(cross.angle_1),
        g = _.on(cross.angle_2),
    ],
    outputs: [inverse],
});

#[test]
fn inverse_dynamics_returns_the_drives() {
    let mut numbers = Random::new(5);
    for _ in 0..50 {
        let state = GivenState {
            turn: Jointed::random(&mut numbers),
            slide: Jointed::random(&mut numbers),
            both: Jointed::random(&mut numbers),
            nut: Jointed::random(&mut numbers),
            cross: Jointed::random(&mut numbers),
        };
        let GivenState {
            turn,
            slide,
            both,
            nut,
            cross,
        } = state;
        let drives = [0; 7].map(|_| 5.0 * numbers.number());
        let [d_1, d_2, d_3, d_4, d_5, d_6, d_7] = drives;
        let input = GivenInput {
            d_1,
            d_2,
            d_3,
            d_4,
            d_5,
            d_6,
            d_7,
        };
        let found = Given::default().acceleration(0.0, &state, &input);
        let given = OpenAcceleration {
            turn: found.turn,
            slide: found.slide,
            both: found.both,
            nut: found.nut,
            cross: found.cross,
        };
        let state = OpenState {
            turn,
            slide,
            both,
            nut,
            cross,
        };
        let found = Open::default().inverse(0.0, &state, &given, &());
        let found = [
            found.a, found.b, found.c, found.d, found.e, found.f, found.g,
        ];
        close("drives", &found, &drives, 100.0, 1e-12);
    }
}

// all loads but two have a potential; two bodies have fields of their own
rigid_system!(Swinging {
    bodies: [
        base {
            mass: 2[kg],
            inertia: principal(0.2, 0.3, 0.4)[kg * m ^ 2],
            points: [p = (0.1, 0.2, 0.3), q = (-0.1, 0.3, -0.2)],
        },
        bob {
            mass: 0.6[kg],
            inertia: principal(0.05, 0.04, 0.03)[kg * m ^ 2],
            points: [p = (0, 0.1, 0.3), q = (0.1, 0, -0.3)],
            fields: [lift = mass * world(0, 0, 3[m / s ^ 2])],
        },
        nut {
            mass: 0.3[kg],
            inertia: principal(0.02, 0.03, 0.01)[kg * m ^ 2],
            points: [p = (0.1, 0.1, 0)],
            fields: [wind = mass * world(1, 0.5, 0)[m / s ^ 2]],
        },
    ],
    joints: [
        stem = universal(world(0, 0, 1), base.p, body(1, 0, 0), body(0, 1, 0)),
        ball = spherical(base.q, bob.p),
        thread = screw(bob.q, nut.p, body(1, 2, 2), 0.1[m]),
    ],
    fields: [weight = mass * world(0, 0, -9.81[m / s ^ 2])],
    drives: [friction = (-0.4[N * m * s] * thread.angular_velocity).on(thread)],
    forces: [damper = (-1.5[N]).between(base.G, nut.G)],
    outputs: [energy],
});

#[test]
fn energy_changes_by_the_power_of_the_loads() {
    let system = Swinging::default();
    let mut numbers = Random::new(6);
    for _ in 0..20 {
        let state = SwingingState {
            stem: Jointed::random(&mut numbers),
            ball: Jointed::random(&mut numbers),
            thread: Jointed::random(&mut numbers),
        };
        let step = 1e-3;
        let energy = |steps: f64| {
            let moved = system
                .integrate(&state)
                .tolerance(1e-13)
                .to(step * steps)
                .unwrap();
            system.kinetic_energy(&moved) + system.potential_energy(0.0, &moved, &())
        };
        // by differences of the eighth order
        let rate = [
            (1.0, 4.0 / 5.0),
            (2.0, -0.2),
            (3.0, 4.0 / 105.0),
            (4.0, -1.0 / 280.0),
        ]
        .iter()
        .map(|(steps, share)| share * (energy(*steps) - energy(-steps)) / step)
        .sum::<f64>();
        let spin = state.thread.angular_velocity;
        let power = -0.4 * spin * spin + 1.5 * stretching(&state);
        close("power", &[rate], &[power], 100.0, 1e-8);
    }
}

/// How fast the centers of the base and of the nut move apart.
fn stretching(state: &SwingingState) -> f64 {
    let step = 1e-4;
    let distance = |steps: f64| {
        let still = SwingingAcceleration::default();
        let moved = state.moved(&(state.rate(&still) * (steps * step)));
        let stem = UnitQuaternion::new(Vector3::x() * moved.stem.angle_1)
            * UnitQuaternion::new(Vector3::y() * moved.stem.angle_2);
        let bob = stem * moved.ball.attitude;
        let axis = Vector3::new(1.0, 2.0, 2.0) / 3.0;
        let nut = bob * UnitQuaternion::new(axis * moved.thread.angle);
        let ball = stem * Vector3::new(-0.1, 0.3, -0.2);
        let thread = bob * (Vector3::new(0.1, -0.1, -0.6) + axis * (0.1 * moved.thread.angle));
        (ball + thread - nut * Vector3::new(0.1, 0.1, 0.0)).norm()
    };
    [(1.0, 2.0 / 3.0), (2.0, -1.0 / 12.0)]
        .iter()
        .map(|(steps, share)| share * (distance(*steps) - distance(-steps)) / step)
        .sum()
}

// nothing from outside
rigid_system!(Drifting {
    bodies: [
        hub {
            mass: 3[kg],
            inertia: principal(0.5, 0.4, 0.6)[kg * m ^ 2],
            points: [p = (0.1, 0.2, 0.3)],
        },
        boom {
            mass: 0.6[kg],
            inertia: principal(0.05, 0.04, 0.03)[kg * m ^ 2],
            points: [p = (0, 0.1, 0.3), q = (0.1, 0, -0.3)],
        },
        mass_ {
            mass: 0.3[kg],
            inertia: principal(0.02, 0.03, 0.01)[kg * m ^ 2],
            points: [p = (0.1, 0.1, 0)],
        },
        other {
            mass: 1[kg],
            inertia: principal(0.1, 0.1, 0.1)[kg * m ^ 2]
        },
    ],
    joints: [
        base = free(hub),
        joint = universal(hub.p, boom.p, body(1, 0, 0), body(0, 1, 0)),
        rail = cylindrical(boom.q, mass_.p, body(1, 2, 2)),
        flight = free(other),
    ],
    drives: [
        a = (2[N * m] * (3[rad / s] * t).cos()).on(joint.angle_1),
        b = (-5[N / m] * rail.position).on(rail.position),
    ],
    forces: [gravity =
        (0.5[N * m ^ 2] / (hub.position - other.position).norm_squared()).between(hub.G, other.G)],
    moments: [magnet = moment(hub.body(0.1, 0, 0)[N * m]).between(other, mass_)],
    outputs: [momentum],
});

#[test]
fn momentum_of_what_drifts_is_constant() {
    let system = Drifting::default();
    let mut numbers = Random::new(7);
    for _ in 0..5 {
        let mut state = DriftingState {
            base: Jointed::random(&mut numbers),
            joint: Jointed::random(&mut numbers),
            rail: Jointed::random(&mut numbers),
            flight: Jointed::random(&mut numbers),
        };
        state.flight.position += Vector3::new(20.0, 0.0, 0.0);
        let later = system.integrate(&state).tolerance(1e-13).to(1.0).unwrap();
        let momenta = |state: &DriftingState| {
            let linear = system.linear_momentum(state).list();
            let angular = system.angular_momentum(state).list();
            [
                linear,
                angular,
                system.angular_momentum_about_pole(0.0, state).list(),
            ]
        };
        for (found, expected) in momenta(&later).iter().zip(&momenta(&state)) {
            close("momentum", found, expected, 10.0, 1e-11);
        }
    }
}

/// A million meters away, the momentum about G has all its digits; places are halves of a
/// micrometer apart, so that all are moved alike.
#[test]
fn momentum_keeps_its_digits_far_away() {
    let system = Drifting::default();
    let mut numbers = Random::new(8);
    let step = 2.0_f64.powi(-21);
    let away = Vector3::new(1e6, -2e6, 3e6);
    for _ in 0..20 {
        let mut near = DriftingState {
            base: Jointed::random(&mut numbers),
            joint: Jointed::random(&mut numbers),
            rail: Jointed::random(&mut numbers),
            flight: Jointed::random(&mut numbers),
        };
        for place in [&mut near.base.position, &mut near.flight.position] {
            *place = place.map(|x| (x / step).round() * step);
        }
        let mut far = near;
        for place in [&mut far.base.position, &mut far.flight.position] {
            *place += away;
        }
        let angular = system.angular_momentum(&near);
        let moved = system.angular_momentum(&far);
        assert_eq!(moved, angular);
        let linear = system.linear_momentum(&near);
        let about_pole = system.angular_momentum_about_pole(0.0, &near) + away.cross(&linear);
        let moved = system.angular_momentum_about_pole(0.0, &far);
        assert!((moved - about_pole).norm() < 1e-15 * away.norm() * linear.norm());
    }
}
