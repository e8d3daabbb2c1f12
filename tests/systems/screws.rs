//! Screws that close loops, compared with formulas by hand and with screws that carry bodies.

use core::f64::consts::PI;

use nalgebra::{UnitQuaternion, Vector3};
use newton_euler::prelude::*;

use super::compare::{Jointed, Random, close};

// a spindle moves the jaw of a vise, which slides on a rail
rigid_system!(Vise {
    params: [pitch = 0.01[m]],
    inputs: [torque[N * m], load[N]],
    bodies: [
        jaw {
            mass: 3[kg],
            inertia: principal(0.1, 0.1, 0.1)[kg * m ^ 2],
            points: [nut = (0, 0.2, 0.1)[m]],
            forces: [work = world(load, 0, 0)],
        },
        spindle {
            mass: 0.5[kg],
            inertia: principal(2e-4, 3e-3, 3e-3)[kg * m ^ 2],
        },
    ],
    joints: [
        rail = prismatic(world(0, 0, 0), jaw.G, body(1, 0, 0)),
        spin = revolute(world(0, 0.2, 0.1), spindle.G, body(1, 0, 0)),
        thread = screw(spindle.G, jaw.nut, body(1, 0, 0), pitch),
    ],
    drives: [motor = torque.on(spin)],
    outputs: [energy],
});

// the jaw stands where the spindle has turned back: x = -pitch * angle
#[test]
fn a_vise() {
    let vise = Vise::default();
    let mut state = ViseState {
        rail: Slide {
            position: -0.021,
            velocity: -0.03,
        },
        spin: Hinge {
            angle: 2.1,
            angular_velocity: 3.0,
        },
    };
    let input = ViseInput {
        torque: 0.7,
        load: -40.0,
    };
    vise.check(0.0, &state, &input).unwrap();
    let found = vise.acceleration(0.0, &state, &input);
    let angular = (0.7 + 0.01 * 40.0) / (2e-4 + 3.0 * 1e-4);
    close(
        "motion",
        &[found.spin, found.rail],
        &[angular, -0.01 * angular],
        1e4,
        1e-13,
    );
    // with ten turns more it is as well closed, and half a turn beside it is not
    state.spin.angle += 20.0 * PI;
    vise.check(0.0, &state, &input).unwrap();
    state.spin.angle += 1.0 * PI;
    let half = vise.check(0.0, &state, &input).unwrap_err();
    assert_eq!((half.constraint, half.is_velocity), ("thread_5", false));
    // the way back is to the nearest turn
    state.spin.angle = 2.1 + 20.0 * PI + 1.5;
    vise.project(0.0, &mut state, &input).unwrap();
    let turned = state.rail.position / -0.01 - state.spin.angle;
    close("closed", &[turned], &[-20.0 * PI], 60.0, 1e-14);
    let end = vise.integrate(&state).input(input).to(0.5).unwrap();
    let more = [
        end.rail.position - state.rail.position,
        end.spin.angle - state.spin.angle,
    ];
    assert!(more[1] > 200.0, "many turns");
    close("thread", &[more[0]], &[-0.01 * more[1]], 1.0, 1e-12);
}

/// A base and a rotor, with one joint or two between them.
macro_rules! threaded {
    ($name:ident, [$($joints:tt)*]) => {
        rigid_system!($name {
            inputs: [torque[N * m]],
            bodies: [
                base {
                    mass: 2[kg],
                    inertia: principal(0.3, 0.4, 0.5)[kg * m ^ 2],
                    points: [p = (0.2, -0.1, 0.3)[m]],
                    moments: [turn = body(0, torque, 0)],
                },
                rotor {
                    mass: 0.7[kg],
                    inertia: principal(0.1, 0.07, 0.05)[kg * m ^ 2],
                    points: [q = (0.1, 0.1, -0.2)[m]],
                    forces: [push = world(1[N], -0.3[N], 2[N])],
                },
            ],
            joints: [orbit = free(base), $($joints)*],
            outputs: [energy, momentum],
        });
    };
}
threaded!(
    Carried,
    [thread = screw(base.p, rotor.q, body(1, 2, -2), 0.2[m]).turned(body(0, 0, 1), 90[deg])]
);
threaded!(
    Twice,
    [
        sleeve = cylindrical(base.p, rotor.q, body(1, 2, -2)).turned(body(0, 0, 1), 90[deg]),
        thread = screw(base.p, rotor.q, body(1, 2, -2), 0.2[m]).turned(body(0, 0, 1), 90[deg]),
    ]
);
threaded!(
    Loose,
    [
        other = free(rotor),
        thread = screw(base.p, rotor.q, body(1, 2, -2), 0.2[m]).turned(body(0, 0, 1), 90[deg]),
    ]
);

#[test]
fn a_sleeve_with_a_thread_is_a_screw() {
    let (carried, twice, mut numbers) = (Carried::default(), Twice::default(), Random::new(3));
    for _ in 0..10 {
        let orbit = Spatial::random(&mut numbers);
        let thread = Hinge::random(&mut numbers);
        let one = CarriedState { orbit, thread };
        let sleeve = Cylinder {
            position: 0.2 * thread.angle,
            angle: thread.angle,
            velocity: 0.2 * thread.angular_velocity,
            angular_velocity: thread.angular_velocity,
        };
        let two = TwiceState { orbit, sleeve };
        let torque = numbers.number();
        twice.check(0.0, &two, &TwiceInput { torque }).unwrap();
        let expected = carried.acceleration(0.0, &one, &CarriedInput { torque });
        let found = twice.acceleration(0.0, &two, &TwiceInput { torque });
        let thread = expected.thread;
        close(
            "sleeve",
            &[found.sleeve.linear, found.sleeve.angular],
            &[0.2 * thread, thread],
            10.0,
            1e-12,
        );
        close(
            "base",
            found.orbit.linear.as_slice(),
            expected.orbit.linear.as_slice(),
            10.0,
            1e-12,
        );
        close(
            "base",
            found.orbit.angular.as_slice(),
            expected.orbit.angular.as_slice(),
            10.0,
            1e-12,
        );
    }
}

#[test]
fn two_free_bodies_on_a_thread() {
    let (carried, loose, mut numbers) = (Carried::default(), Loose::default(), Random::new(4));
    for _ in 0..10 {
        // a rotor that is near its place, moving in any way
        let orbit = Spatial::random(&mut numbers);
        let axis = Vector3::new(1.0, 2.0, -2.0) / 3.0;
        let quarter = UnitQuaternion::new(Vector3::new(0.0, 0.0, PI / 2.0));
        let along = orbit.attitude * (quarter * axis);
        let angle = 0.9 * numbers.number();
        let place = orbit.position + orbit.attitude * Vector3::new(0.2, -0.1, 0.3);
        let attitude = orbit.attitude * quarter * UnitQuaternion::new(axis * angle);
        let mut other = Spatial::random(&mut numbers);
        other.attitude = attitude * UnitQuaternion::new(numbers.vector() * 0.1);
        let arm = other.attitude * Vector3::new(0.1, 0.1, -0.2);
        other.position = place + along * (0.2 * angle) - arm + numbers.vector() * 0.05;
        let mut state = LooseState { orbit, other };
        let input = LooseInput { torque: 0.4 };
        loose.project(0.0, &mut state, &input).unwrap();
        // the same in the coordinates of the screw
        let base = state.orbit;
        let along = base.attitude * (quarter * axis);
        let arm = state.other.attitude * Vector3::new(0.1, 0.1, -0.2);
        let lever = base.attitude * Vector3::new(0.2, -0.1, 0.3);
        let apart = state.other.position + arm - base.position - lever;
        let turning = state.other.attitude * state.other.angular_velocity
            - base.attitude * base.angular_velocity;
        let thread = Hinge {
            angle: along.dot(&apart) / 0.2,
            angular_velocity: along.dot(&turning),
        };
        let one = CarriedState {
            orbit: base,
            thread,
        };
        let mut relative = base.attitude * quarter * UnitQuaternion::new(axis * thread.angle);
        relative = relative.inverse() * state.other.attitude;
        close("turned", &[relative.angle()], &[0.0], 1.0, 1e-13);
        close("across", &[apart.cross(&along).norm()], &[0.0], 1.0, 1e-14);
        let (p, q) = (loose.linear_momentum(&state), carried.linear_momentum(&one));
        close("momentum", p.as_slice(), q.as_slice(), 10.0, 1e-13);
        let (p, q) = (
            loose.angular_momentum(&state),
            carried.angular_momentum(&one),
        );
        close("momentum", p.as_slice(), q.as_slice(), 10.0, 1e-13);
        let expected = carried.acceleration(0.0, &one, &CarriedInput { torque: 0.4 });
        let found = loose.acceleration(0.0, &state, &input);
        close(
            "base",
            found.orbit.linear.as_slice(),
            expected.orbit.linear.as_slice(),
            10.0,
            1e-12,
        );
        close(
            "base",
            found.orbit.angular.as_slice(),
            expected.orbit.angular.as_slice(),
            10.0,
            1e-12,
        );
    }
}

/// The turns by which a vise is off its thread.
fn turns_off(state: &ViseState) -> f64 {
    (state.rail.position / -0.01 - state.spin.angle) / (2.0 * PI)
}

#[test]
fn the_way_is_that_to_the_nearest_turn() {
    let (vise, mut numbers) = (Vise::default(), Random::new(9));
    let input = ViseInput {
        torque: 0.0,
        load: 0.0,
    };
    for number in 0..1000 {
        let mut state = ViseState {
            rail: Slide {
                position: 0.2 * numbers.number(),
                velocity: numbers.number(),
            },
            spin: Hinge {
                angle: 300.0 * numbers.number(),
                angular_velocity: numbers.number(),
            },
        };
        let nearest = turns_off(&state).round();
        if number % 2 == 0 {
            // close to half a turn
            let off = 0.5 - 1e-10 - 1e-3 * numbers.number().powi(10);
            let turns = nearest + off.copysign(numbers.number());
            state.spin.angle = state.rail.position / -0.01 - 2.0 * PI * turns;
        }
        vise.project(0.0, &mut state, &input).unwrap();
        vise.check(0.0, &state, &input).unwrap();
        close("turns", &[turns_off(&state)], &[nearest], 100.0, 1e-12);
    }
    // at half a turn, either turn
    for angle in [PI, -PI, 3.0 * PI] {
        let mut state = ViseState::default();
        state.spin.angle = angle;
        let off = vise.check(0.0, &state, &input).unwrap_err();
        close("half", &[off.violation.abs()], &[0.02], 0.02, 1e-13);
        vise.project(0.0, &mut state, &input).unwrap();
        let turns = turns_off(&state);
        close("turns", &[turns], &[turns.round()], 1.0, 1e-12);
        assert!((turns * 2.0 * PI + angle).abs() < 3.2, "{turns}");
    }
}

/// The distance of a state from the law of the screw: the angle between the attitude and that at
/// the place along the axis, and the distance from the axis.
fn off_the_screw(state: &LooseState) -> [f64; 2] {
    let (base, other) = (state.orbit, state.other);
    let axis = Vector3::new(1.0, 2.0, -2.0) / 3.0;
    let meant = base.attitude * UnitQuaternion::new(Vector3::new(0.0, 0.0, PI / 2.0));
    let along = meant * axis;
    let apart = other.position + other.attitude * Vector3::new(0.1, 0.1, -0.2)
        - base.position
        - base.attitude * Vector3::new(0.2, -0.1, 0.3);
    let angle = along.dot(&apart) / 0.2;
    let meant = meant * UnitQuaternion::new(axis * angle);
    [meant.angle_to(&other.attitude), apart.cross(&along).norm()]
}

#[test]
fn free_bodies_find_the_screw_from_anywhere() {
    let (loose, mut numbers) = (Loose::default(), Random::new(11));
    let input = LooseInput { torque: 0.4 };
    for _ in 0..300 {
        let mut state = LooseState {
            orbit: Spatial::random(&mut numbers),
            other: Spatial::random(&mut numbers),
        };
        loose.project(0.0, &mut state, &input).unwrap();
        loose.check(0.0, &state, &input).unwrap();
        close("off", &off_the_screw(&state), &[0.0; 2], 1.0, 1e-12);
    }
}

rigid_system!(Bolt {
    bodies: [bolt {
        mass: 1[kg],
        inertia: principal(0.1, 0.2, 0.3)[kg * m ^ 2],
        points: [hole = (0.1, 0.4, 0.2)[m]],
    },],
    joints: [thread = screw(world(1, 0, 0), bolt.hole, body(0, 3, 4), 0.1)],
});

/// Along one twist from the ground, the inertia is constant: a velocity needs no load.
#[test]
fn a_bolt_turns_on_without_a_load() {
    assert_eq!(Bolt::OPERATIONS[0].total(), 0);
    let thread = Hinge {
        angle: 0.3,
        angular_velocity: 5.0,
    };
    let found = Bolt::default().acceleration(0.0, &BoltState { thread }, &());
    assert!(found.thread.abs() < f64::MIN_POSITIVE);
}
