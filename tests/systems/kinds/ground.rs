//! Joints between the G of a body and the ground.

use nalgebra::{Matrix3, Vector3};
use newton_euler::prelude::*;

use crate::agree;
use crate::compare::{Random, link, principal, unit};
use crate::oracle::{Kind, Link};

// a gantry that does not turn, and what hangs from it; a hub that turns about its G, with a wheel
rigid_system!(Shifted {
    inputs: [push = world(_, _, _)[N], torque[N * m]],
    bodies: [
        gantry {
            mass: 2[kg],
            points: [hook = (0.1, 0.2, -0.3)],
            forces: [side = (push * 2).at(hook)],
        },
        load {
            mass: 1.5[kg],
            inertia: principal(0.1, 0.2, 0.15)[kg * m ^ 2],
            points: [eye = (0, 0.1, 0.4)],
        },
        hub {
            mass: 5[kg],
            inertia: tensor {
                xx: 0.3,
                yy: 0.35,
                zz: 0.25,
                xy: 0.02,
                yz: -0.03,
                zx: 0.05
            }[kg * m ^ 2],
            points: [side = (0.2, 0.1, -0.1)],
            moments: [magnet = body(0, 0, torque)],
        },
        wheel {
            mass: 0.5[kg],
            inertia: principal(0.02, 0.03, 0.01)[kg * m ^ 2],
            points: [off = (0.05, 0, 0.1)]
        },
    ],
    joints: [
        bridge = translation(gantry),
        rope = spherical(gantry.hook, load.eye),
        gimbal = rotation(hub),
        spin = revolute(hub.side, wheel.off, body(2, -1, 2)),
    ],
    fields: [weight = mass * world(0.3, -0.2, -9.81[m / s ^ 2])],
    drives: [
        motors = (push - 3[N * s / m] * bridge.velocity).on(bridge),
        held = (-7[N / m] * bridge.position).on(bridge.position),
        brake = (-0.3[N * m * s] * gimbal.angular_velocity).on(gimbal),
    ],
    outputs: [energy, momentum, reactions],
});

fn shifted() -> [Link; 4] {
    let tensor = Matrix3::new(0.3, 0.02, 0.05, 0.02, 0.35, -0.03, 0.05, -0.03, 0.25);
    [
        // it does not turn: any inertia
        link(
            (2.0, Matrix3::identity()),
            None,
            [0.0; 3],
            [0.0; 3],
            Kind::Shift(3),
        ),
        link(
            (1.5, principal(0.1, 0.2, 0.15)),
            Some(0),
            [0.1, 0.2, -0.3],
            [0.0, 0.1, 0.4],
            Kind::Spherical,
        ),
        link((5.0, tensor), None, [0.0; 3], [0.0; 3], Kind::Spherical),
        link(
            (0.5, principal(0.02, 0.03, 0.01)),
            Some(2),
            [0.2, 0.1, -0.1],
            [0.05, 0.0, 0.1],
            Kind::Revolute(unit(2.0, -1.0, 2.0)),
        ),
    ]
}

#[test]
fn translation_and_rotation() {
    let make = |numbers: &mut Random| {
        let input = ShiftedInput {
            push: numbers.vector() * 3.0,
            torque: numbers.number(),
        };
        (Shifted::default(), input, shifted())
    };
    agree!(Shifted, make, [0.3, -0.2, -9.81], moving [bridge rope gimbal spin],
    held [0 bridge 1 rope 2 gimbal 3 spin], still [], |loads, _system, input| {
        let (q, v): (Vec<_>, Vec<_>) = loads.rates.iter().cloned().unzip();
        loads.force(0, [0.1, 0.2, -0.3], input.push * 2.0);
        let torque = loads.turned(2, [0.0, 0.0, input.torque]);
        loads.moment(2, torque);
        let motor = (0..3).map(|k| input.push[k] - 3.0 * v[0][k] - 7.0 * q[0][k]);
        let brake = v[2].iter().map(|w| -0.3 * w);
        loads.drives = vec![motor.collect(), vec![0.0; 3], brake.collect(), vec![0.0]];
    });
}

// in the plane, by both words
rigid_system!(Carts {
    motion: planar,
    bodies: [
        one {
            mass: 2[kg],
            points: [pin = (0.1, -0.2)]
        },
        arm {
            mass: 1[kg],
            inertia: 0.1[kg * m ^ 2],
            points: [pin = (0.3, 0.1)]
        },
        two { mass: 3[kg] },
    ],
    joints: [
        first = translation(one),
        swing = revolute(one.pin, arm.pin),
        second = planar_translation(two),
    ],
    fields: [weight = mass * world(0.5, -9.81)[m / s ^ 2]],
    drives: [motor = (world(2, 1)[N] - 3[N / m] * first.position).on(first)],
    forces: [spring = (2[N]).between(arm.G, two.G)],
    outputs: [energy, momentum, reactions],
});

#[test]
fn translation_in_the_plane() {
    let flat = |inertia: f64| Matrix3::identity() * inertia;
    let links = [
        link((2.0, flat(1.0)), None, [0.0; 3], [0.0; 3], Kind::Shift(2)),
        link(
            (1.0, flat(0.1)),
            Some(0),
            [0.1, -0.2, 0.0],
            [0.3, 0.1, 0.0],
            Kind::Revolute(Vector3::z()),
        ),
        link((3.0, flat(1.0)), None, [0.0; 3], [0.0; 3], Kind::Shift(2)),
    ];
    let make = |_: &mut Random| (Carts::default(), (), links);
    agree!(Carts, make, [0.5, -9.81, 0.0], moving [first swing second],
    held [0 first 1 swing 2 second], still [], |loads, _system, _input| {
        let q = loads.rates[0].0.clone();
        loads.tension(2.0, (1, [0.0; 3]), (2, [0.0; 3]));
        loads.drives = vec![vec![2.0 - 3.0 * q[0], 1.0 - 3.0 * q[1]], vec![0.0], vec![0.0; 2]];
    });
}
