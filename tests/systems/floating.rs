//! Given drives of free bodies: a force at G and a moment, as if written in the braces of the body.

use nalgebra::Vector2;
use newton_euler::prelude::*;

use super::compare::{Jointed, Listed, Random, close, link, principal};
use super::oracle::{Kind, Link};
use crate::agree;

rigid_system!(Pushed {
    inputs: [thrust[N], turn[N * m], wind = world(_, _, _)[N]],
    bodies: [
        hub {
            mass: 3[kg],
            inertia: principal(0.5, 0.4, 0.6)[kg * m ^ 2],
            points: [p = (0.1, 0.2, 0.3)]
        },
        arm {
            mass: 1[kg],
            inertia: principal(0.05, 0.04, 0.06)[kg * m ^ 2],
            points: [p = (0.1, 0.2, 0)]
        },
    ],
    joints: [base = free(hub), hip = spherical(hub.p, arm.p)],
    drives: [
        push = (hub.body(0, 2[N], thrust) + wind - 2[N * s / m] * base.velocity).on(base.position),
        twist = (hub.body(turn, 0, 0) + world(0, 0, 1[N * m])
            - 0.3[N * m * s] * base.angular_velocity)
            .on(base.attitude),
        bend = world(0, 0, turn).on(hip.attitude),
    ],
    outputs: [energy, momentum, reactions, balance],
});

fn links() -> [Link; 2] {
    let tensors = [principal(0.5, 0.4, 0.6), principal(0.05, 0.04, 0.06)];
    [
        link((3.0, tensors[0]), None, [0.0; 3], [0.0; 3], Kind::Free),
        link(
            (1.0, tensors[1]),
            Some(0),
            [0.1, 0.2, 0.3],
            [0.1, 0.2, 0.0],
            Kind::Spherical,
        ),
    ]
}

fn random(numbers: &mut Random) -> PushedInput {
    PushedInput {
        thrust: numbers.number(),
        turn: numbers.number(),
        wind: numbers.vector(),
    }
}

#[test]
fn drives_of_a_free_body_are_a_force_at_its_center_and_a_moment() {
    let make = |numbers: &mut Random| (Pushed::default(), random(numbers), links());
    agree!(Pushed, make, [0.0; 3], moving [base hip], held [1 hip], still [], |loads, _system, input| {
        let hub = loads.motions[0];
        let force = loads.turned(0, [0.0, 2.0, input.thrust]) + input.wind - hub.velocity * 2.0;
        loads.force(0, [0.0; 3], force);
        let moment = loads.turned(0, [input.turn, 0.0, 0.0]) + nalgebra::Vector3::z()
            - hub.angular_velocity * 0.3;
        loads.moment(0, moment);
        let bend = loads.motions[1].attitude.transpose() * nalgebra::Vector3::z() * input.turn;
        loads.drives[1] = bend.list();
    });
}

#[test]
fn balances_have_the_drives_of_free_bodies() {
    let (pushed, mut numbers) = (Pushed::default(), Random::new(4));
    for _ in 0..20 {
        let state = PushedState {
            base: Jointed::random(&mut numbers),
            hip: Jointed::random(&mut numbers),
        };
        let input = random(&mut numbers);
        let acceleration = pushed.acceleration(0.0, &state, &input);
        let reactions = pushed.reactions(0.0, &state, &input);
        let left = pushed.residual(0.0, &state, &acceleration, &reactions, &input);
        for wrench in [left.hub, left.arm] {
            close("residual", &wrench.list(), &[0.0; 6], 100.0, 1e-13);
        }
        let loads = pushed.loads(0.0, &state, &input).hub;
        let names = loads.map(|load| load.name);
        assert!(
            names.contains(&"push") && names.contains(&"twist"),
            "{names:?}"
        );
    }
}

rigid_system!(Tossed {
    motion: planar,
    inputs: [turn[N * m], force = world(_, _)[N]],
    bodies: [plate {
        mass: 2[kg],
        inertia: 0.3[kg * m ^ 2]
    }],
    joints: [flight = free(plate)],
    drives: [
        push = (force + plate.body(1[N], 0)).on(flight.position),
        twist = (2 * turn).on(flight.angle),
    ],
});

#[test]
fn drives_of_a_free_body_in_the_plane() {
    let input = TossedInput {
        turn: 0.6,
        force: Vector2::new(3.0, -1.0),
    };
    let flight = Planar {
        angle: 0.4,
        ..Planar::default()
    };
    let found = Tossed::default().acceleration(0.0, &TossedState { flight }, &input);
    let along = Vector2::new(0.4_f64.cos(), 0.4_f64.sin());
    let expected = (input.force + along) / 2.0;
    close(
        "linear",
        &found.flight.linear.list(),
        &expected.list(),
        1.0,
        1e-15,
    );
    close("angular", &[found.flight.angular], &[4.0], 1.0, 1e-15);
}
