//! Loops on carriers that move freely: the motion of the carrier makes no difference to them.

use newton_euler::nalgebra::{UnitQuaternion, Vector3};
use newton_euler::prelude::*;

/// Two equal bodies at the same place, held to each other by two joints that allow no motion
/// together.
macro_rules! pair {
    ($name:ident $first:expr, $second:expr) => {
        rigid_system!($name {
            bodies: [
                base {
                    mass: 1[kg],
                    inertia: principal(0.1, 0.2, 0.25)[kg * m ^ 2],
                    points: [h = (0.1, 0.2, 0.3), l = (0.1, -0.2, 0.1)]
                },
                arm {
                    mass: 1[kg],
                    inertia: principal(0.1, 0.2, 0.25)[kg * m ^ 2],
                    points: [h = (0.1, 0.2, 0.3), l = (0.1, -0.2, 0.1)]
                },
            ],
            joints: [flight = free(base), first = $first, second = $second],
        });
    };
}
pair!(Slides prismatic(base.h, arm.h, body(0, 0, 1)), prismatic(base.l, arm.l, body(0, 0.3, 1)));
pair!(SlideAndScrew
    prismatic(base.h, arm.h, body(0, 0, 1)), screw(base.l, arm.l, body(0, 0, 1), 0.1[m])
);
pair!(ScrewAndSlide
    screw(base.h, arm.h, body(0, 0, 1), 0.1[m]), prismatic(base.l, arm.l, body(0, 0, 1))
);
pair!(BallAndScrew spherical(base.h, arm.h), screw(base.l, arm.l, body(0, 1, 0), 0.1[m]));
pair!(PlaneAndScrew planar(base.h, arm.h, body(0, 0.6, 0.8)), screw(base.l, arm.l, body(1, 1, 0), 1[m]));
pair!(Hinges revolute(base.h, arm.h, body(0, 0, 1)), revolute(base.l, arm.l, body(0, 1, 0)));

/// Numbers between -1 and 1.
pub fn numbers() -> impl FnMut() -> f64 {
    let mut number = 0.3;
    move || {
        number = 1.0 - 2.0 * f64::abs(f64::sin(1e4 * number));
        number
    }
}

fn flight(next: &mut impl FnMut() -> f64) -> Spatial {
    let mut vector = || Vector3::new(next(), next(), next());
    let (position, velocity, angular_velocity) = (vector(), vector(), vector());
    let turned = vector();
    Spatial {
        position: 7e6 * position,
        velocity: 7e3 * velocity,
        angular_velocity,
        attitude: UnitQuaternion::new(turned),
    }
}

#[test]
fn bodies_that_two_joints_lock_fly_as_one() {
    let tensor = Vector3::new(0.1, 0.2, 0.25);
    macro_rules! check {
        ($name:ident $state:ident, |$joint:ident, $next:ident| $displaced:block, $left:expr) => {
            let body = $name::default();
            let mut next = numbers();
            for scale in [1e-3, 0.1, 1e-9].repeat(10) {
                let mut state = $state {
                    flight: flight(&mut next),
                    ..$state::default()
                };
                let ($joint, mut $next) = (&mut state.first, || scale * next());
                $displaced;
                body.project(0.0, &mut state, &()).unwrap();
                body.check(0.0, &state, &()).unwrap();
                let $joint = &state.first;
                assert!(f64::abs($left) < 1e-14, "{}", stringify!($name));
                let found = body.acceleration(0.0, &state, &()).flight;
                let w = state.flight.angular_velocity;
                let expected = -w.cross(&tensor.component_mul(&w)).component_div(&tensor);
                let error = (found.angular - expected).norm() + found.linear.norm();
                assert!(error < 1e-13, "{}: {error}", stringify!($name));
            }
        };
    }
    check!(Slides SlidesState, |joint, next| {
        (joint.position, joint.velocity) = (next(), next());
    }, joint.position);
    check!(SlideAndScrew SlideAndScrewState, |joint, next| {
        (joint.position, joint.velocity) = (next(), next());
    }, joint.position);
    check!(ScrewAndSlide ScrewAndSlideState, |joint, next| {
        (joint.angle, joint.angular_velocity) = (next(), next());
    }, joint.angle);
    check!(PlaneAndScrew PlaneAndScrewState, |joint, next| {
        (joint.angle, joint.angular_velocity) = (next(), next());
    }, joint.angle);
    check!(Hinges HingesState, |joint, next| {
        (joint.angle, joint.angular_velocity) = (next(), next());
    }, joint.angle);
    check!(BallAndScrew BallAndScrewState, |joint, next| {
        joint.attitude = UnitQuaternion::new(Vector3::new(next(), next(), next()));
        joint.angular_velocity = Vector3::new(next(), next(), next());
    }, joint.attitude.angle());
}

// a four-bar linkage on a satellite, in space and in the plane
rigid_system!(Carried {
    bodies: [
        base {
            mass: 100[kg],
            inertia: principal(10, 20, 25)[kg * m ^ 2],
            points: [l = (-0.5, 0, 1), r = (0.5, 0, 1)]
        },
        left {
            mass: 1[kg],
            inertia: rod(1).along(body(0, 0, 1)),
            points: [a = (0, 0, -0.5), b = (0, 0, 0.5)]
        },
        rung {
            mass: 1[kg],
            inertia: rod(1).along(body(1, 0, 0)),
            points: [a = (-0.5, 0, 0), b = (0.5, 0, 0)]
        },
        right {
            mass: 1[kg],
            inertia: rod(1).along(body(0, 0, 1)),
            points: [a = (0, 0, -0.5), b = (0, 0, 0.5)]
        },
    ],
    joints: [
        flight = free(base),
        first = revolute(base.l, left.a, body(0, 1, 0)),
        second = revolute(left.b, rung.a, body(0, 1, 0)),
        third = revolute(base.r, right.a, body(0, 1, 0)),
        last = revolute(right.b, rung.b, body(0, 1, 0)),
    ],
    outputs: [energy],
});

#[test]
fn violations_have_the_same_bits_wherever_the_carrier_is() {
    let body = Carried::default();
    let mut next = numbers();
    let mut state = CarriedState::default();
    (state.first.angle, state.second.angle, state.third.angle) = (0.3, 0.2, -0.4);
    (state.first.angular_velocity, state.third.angular_velocity) = (0.7, -0.2);
    let at_rest = body.violations(0.0, &state, &());
    for _ in 0..10 {
        state.flight = flight(&mut next);
        for (found, expected) in body.violations(0.0, &state, &()).iter().zip(&at_rest) {
            assert_eq!(found.position, expected.position);
            assert_eq!(found.velocity.to_bits(), expected.velocity.to_bits());
        }
    }
}

/// The closed linkage keeps energy, and its joints are closed to rounding, far from the origin.
#[test]
fn linkages_in_orbit_stay_closed_to_rounding() {
    let body = Carried::default();
    let mut state = CarriedState::default();
    let mut next = numbers();
    state.flight = flight(&mut next);
    (state.first.angle, state.third.angle) = (0.3, 0.3);
    state.second.angle = -0.3;
    state.first.angular_velocity = 0.5;
    body.project(0.0, &mut state, &()).unwrap();
    state.flight.velocity = Vector3::zeros();
    let before = body.kinetic_energy(&state);
    let end = body.integrate(&state).to(3.0).unwrap();
    let after = body.kinetic_energy(&end);
    assert!((after - before).abs() < 1e-9 * before, "{before} {after}");
    for violation in body.violations(0.0, &end, &()) {
        assert!(
            violation.position.unwrap_or(0.0).abs() < 1e-14,
            "{violation:?}"
        );
    }
}

// the last joint keeps the second angle of the first at zero; its rows do so in two ways, which are
// independent in all states but those
rigid_system!(Gimbal {
    bodies: [
        fork {
            mass: 2[kg],
            inertia: principal(0.1, 0.2, 0.25)[kg * m ^ 2],
            points: [h = (0, 0.5, 0)]
        },
        wheel {
            mass: 1[kg],
            inertia: principal(0.1, 0.2, 0.25)[kg * m ^ 2]
        },
    ],
    inputs: [torque[N * m]],
    joints: [
        first = universal(world(0, 0, 0), fork.h, world(0, 1, 0), world(0, 0, 1)),
        second = revolute(fork.h, wheel.G, body(0, 1, 0)),
        last = planar(world(0, 0, 0), wheel.G, world(0, 1, 0)),
    ],
    drives: [motor = torque.on(second)],
});

#[test]
fn a_gimbal_that_is_held_upright_turns_about_its_axis() {
    let body = Gimbal::default();
    let input = GimbalInput { torque: 0.3 };
    for (angle_1, angle) in [(0.0, 0.0), (0.3, -0.2), (2.0, 1.0)] {
        let mut state = GimbalState::default();
        (state.first.angle_1, state.second.angle) = (angle_1, angle);
        (
            state.first.angular_velocity_1,
            state.second.angular_velocity,
        ) = (0.4, -1.0);
        body.check(0.0, &state, &input).unwrap();
        let found = body.acceleration(0.0, &state, &input);
        // the fork turns about its own axis, and the wheel relative to it
        let of_fork = -0.3 / 0.2;
        let of_wheel = 0.3 / 0.2;
        assert!((found.first.x - of_fork).abs() < 1e-14);
        assert!(found.first.y.abs() < 1e-14);
        assert!((found.second - (of_wheel - of_fork)).abs() < 1e-14);
    }
}

/// The same linkage on a satellite, with one joint after another as the one that closes the loop.
macro_rules! crank {
    ($name:ident [$($joint:ident = $kind:expr),+]) => {
        rigid_system!($name {
            bodies: [
                base {
                    mass: 10[kg],
                    inertia: principal(2, 3, 4)[kg * m ^ 2],
                    points: [l = (-0.5, 0.1, 1), r = (0.5, 0, 1)],
                    forces: [thrust = body(3, -1, 2).at(l)]
                },
                left {
                    mass: 1[kg],
                    inertia: principal(0.1, 0.12, 0.05)[kg * m ^ 2],
                    points: [a = (0, 0.1, -0.5), b = (0, 0, 0.5)]
                },
                rung {
                    mass: 2[kg],
                    inertia: principal(0.05, 0.12, 0.13)[kg * m ^ 2],
                    points: [a = (-0.5, 0, 0), b = (0.5, 0, 0)]
                },
                right {
                    mass: 1.5[kg],
                    inertia: principal(0.1, 0.12, 0.05)[kg * m ^ 2],
                    points: [a = (0, 0, -0.5), b = (0, 0, 0.5)]
                },
            ],
            joints: [flight = free(base), $($joint = $kind),+],
            outputs: [reactions],
        });
    };
}
crank!(ByBall [
    first = revolute(base.l, left.a, body(0, 1, 0)),
    second = universal(left.b, rung.a, body(0, 0.6, 0.8), body(1, 0, 0)),
    third = revolute(base.r, right.a, body(0.6, 0.8, 0)),
    last = spherical(right.b, rung.b)
]);
crank!(ByUniversal [
    first = revolute(base.l, left.a, body(0, 1, 0)),
    third = revolute(base.r, right.a, body(0.6, 0.8, 0)),
    last = spherical(right.b, rung.b),
    second = universal(left.b, rung.a, body(0, 0.6, 0.8), body(1, 0, 0))
]);
crank!(ByHinge [
    first = revolute(base.l, left.a, body(0, 1, 0)),
    second = universal(left.b, rung.a, body(0, 0.6, 0.8), body(1, 0, 0)),
    last = spherical(rung.b, right.b),
    third = revolute(base.r, right.a, body(0.6, 0.8, 0))
]);

#[test]
fn any_joint_of_a_loop_may_close_it() {
    let mut next = numbers();
    for _ in 0..10 {
        let flight = flight(&mut next);
        macro_rules! found {
            ($name:ident $state:ident) => {{
                let state = $state {
                    flight,
                    ..$state::default()
                };
                let body = $name::default();
                body.check(0.0, &state, &()).unwrap();
                let all = body.reactions(0.0, &state, &());
                let acceleration = body.acceleration(0.0, &state, &()).flight;
                let [first, second, third, last] = [all.first, all.second, all.third, all.last]
                    .map(|wrench| [wrench.force, wrench.moment]);
                (
                    [first, second, third].concat(),
                    last[0],
                    [acceleration.linear, acceleration.angular],
                )
            }};
        }
        let ball = found!(ByBall ByBallState);
        let universal = found!(ByUniversal ByUniversalState);
        let mut hinge = found!(ByHinge ByHingeState);
        // there, the ball holds the other body
        hinge.1 = -hinge.1;
        for other in [universal, hinge] {
            let pairs = ball.0.iter().zip(&other.0);
            let pairs = pairs.chain([(&ball.1, &other.1)]);
            for (one, other) in pairs.chain(ball.2.iter().zip(&other.2)) {
                assert!(
                    (one - other).norm() < 1e-12 * (1.0 + one.norm()),
                    "{one} {other}"
                );
            }
        }
    }
}
