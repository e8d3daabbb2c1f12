//! A system that is generic over its scalar, with directions, rotations and pitches as params.

use nalgebra::Vector3;
use newton_euler::prelude::*;

use super::agree;
use super::compare::{Jointed, Random, close, link, principal, unit};
use super::oracle::{Kind, Link};

// generic, with directions, turnings and pitches of params
rigid_system!(Tilted::<T> {
    params: [length = 0.5[m], tilt = 0.3, stiff = 2[N / m]],
    inputs: [torque[N * m]],
    bodies: [
        a {
            mass: 1[kg],
            inertia: principal(1, 1.5, 1.2)[kg * m ^ 2],
            points: [p = (length, 0, 0), q = (0, length, 0.1)]
        },
        b {
            mass: 2[kg],
            inertia: principal(1, 2, 1.9)[kg * m ^ 2],
            points: [q = (0, 0.3, length)]
        },
        c {
            mass: 0.5[kg],
            inertia: principal(0.1, 0.12, 0.11)[kg * m ^ 2],
            points: [q = (0, 0.3, length)]
        },
    ],
    joints: [
        base = free(a),
        one = revolute(a.p, b.q, body(tilt.cos(), tilt.sin(), 0)).turned(body(0, 0, 1), tilt),
        two = screw(b.G, c.q, body(0, 1, 0), 0.1 * length).turned(body(1, 0, 0), -2 * tilt),
    ],
    fields: [weight = mass * world(0, 0, -9.81[m / s ^ 2])],
    forces: [s = (stiff * length).between(a.q, c.G)],
    drives: [
        m = torque.on(one),
        n = (-0.1[N * m * s] * two.angular_velocity).on(two)
    ],
    outputs: [reactions, energy, momentum],
});

fn tilted(length: f64, tilt: f64) -> [Link; 3] {
    let direction = Vector3::new(tilt.cos(), tilt.sin(), 0.0);
    let pin = [0.0, 0.3, length];
    let mut links = [
        link(
            (1.0, principal(1.0, 1.5, 1.2)),
            None,
            [0.0; 3],
            [0.0; 3],
            Kind::Free,
        ),
        link(
            (2.0, principal(1.0, 2.0, 1.9)),
            Some(0),
            [length, 0.0, 0.0],
            pin,
            Kind::Revolute(direction),
        ),
        link(
            (0.5, principal(0.1, 0.12, 0.11)),
            Some(1),
            [0.0; 3],
            pin,
            Kind::Screw(unit(0.0, 1.0, 0.0), 0.1 * length),
        ),
    ];
    links[1].turned = (Vector3::z(), tilt);
    links[2].turned = (Vector3::x(), -2.0 * tilt);
    links
}

#[test]
fn what_joints_have_may_be_params() {
    let make = |numbers: &mut Random| {
        let [length, tilt, stiff] = [0; 3].map(|_| 1.2 + numbers.number());
        let input = TiltedInput {
            torque: numbers.number(),
        };
        (
            Tilted::<f64>::new(TiltedParams {
                length,
                tilt,
                stiff,
            })
            .unwrap(),
            input,
            tilted(length, tilt),
        )
    };
    agree!(Tilted<f64>, make, [0.0, 0.0, -9.81], moving [base one two], held [1 one 2 two], still [],
    |loads, system, input| {
        let TiltedParams { length, stiff, .. } = *system.params();
        loads.tension(stiff * length, (0, [0.0, length, 0.1]), (2, [0.0; 3]));
        loads.drives[1] = vec![input.torque];
        loads.drives[2] = vec![-0.1 * loads.rates[2].1[0]];
    });
}

#[test]
#[allow(
    clippy::cast_possible_truncation,
    reason = "single precision is what is tested"
)]
fn single_precision_is_near() {
    let (single, double) = (Tilted::<f32>::default(), Tilted::<f64>::default());
    let mut numbers = Random::new(8);
    for _ in 0..50 {
        let mut state = TiltedState::<f64>::default();
        let mut near = TiltedState::<f32>::default();
        state.base = Jointed::random(&mut numbers);
        state.one = Jointed::random(&mut numbers);
        state.two = Jointed::random(&mut numbers);
        near.base.position = state.base.position.cast();
        near.base.attitude = state.base.attitude.cast();
        near.base.velocity = state.base.velocity.cast();
        near.base.angular_velocity = state.base.angular_velocity.cast();
        near.one.angle = state.one.angle as f32;
        near.one.angular_velocity = state.one.angular_velocity as f32;
        near.two.angle = state.two.angle as f32;
        near.two.angular_velocity = state.two.angular_velocity as f32;
        let found = single.acceleration(0.0, &near, &TiltedInput { torque: 1.0 });
        let expected = double.acceleration(0.0, &state, &TiltedInput { torque: 1.0 });
        let found = [found.one, found.two].map(f64::from);
        close("single", &found, &[expected.one, expected.two], 10.0, 1e-5);
    }
}
