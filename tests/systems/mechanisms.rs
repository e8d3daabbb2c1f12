//! Mechanisms in space and in the plane: the loops stay closed, each body is balanced, and the
//! joints that close the loops push only in directions that they hold.

use nalgebra::Vector3;
use newton_euler::prelude::*;

use super::compare::{Listed, Random, close};

/// A system at a random state near its assembly at zero coordinates.
macro_rules! near_zero {
    ($name:ident, $state:ident, $numbers:expr, $size:expr) => {{
        let system = $name::default();
        let mut rate = <$state as State>::Rate::default();
        for entry in &mut rate.0 {
            *entry = $size * $numbers.number();
        }
        let mut state = $state::default().moved(&rate);
        system.project(0.0, &mut state, &()).unwrap();
        (system, state)
    }};
}

/// Loops stay closed to the third power of a short time, and all bodies are balanced.
macro_rules! check {
    ($name:ident, $state:ident, $seed:expr, [$($body:ident),*]) => {{
        let mut numbers = Random::new($seed);
        for _ in 0..10 {
            let (system, state) = near_zero!($name, $state, numbers, 0.1);
            let found = system.acceleration(0.0, &state, &());
            let moved = |time: f64| {
                let middle = state.moved(&(state.rate(&found) * (0.5 * time)));
                state.moved(&(middle.rate(&found) * time))
            };
            let worst = |time: f64| {
                let violations = system.violations(0.0, &moved(time), &());
                let sizes = violations.iter().map(|one| one.velocity.abs());
                sizes.fold(0.0, f64::max)
            };
            assert!(worst(0.0) < 1e-13);
            // rates are off by the square of the time, were accelerations right
            let (long, short) = (worst(1e-3), worst(1e-4));
            assert!(short < 0.015 * long + 1e-11, "{long:e} {short:e}");
            let reactions = system.reactions(0.0, &state, &());
            let left = system.residual(0.0, &state, &found, &reactions, &());
            $(
                close("force", left.$body.force.as_slice(), &[0.0; 3][..left.$body.force.len()], 30.0, 1e-12);
                close("moment", &left.$body.moment.list(), &[0.0; 3][..left.$body.moment.list().len()], 30.0, 1e-12);
            )*
        }
    }};
}

// a crank turns a rocker about a skew axis by a coupler with two balls
rigid_system!(Rssr {
    bodies: [
        crank {
            mass: 0.4[kg],
            inertia: principal(0.01, 0.02, 0.015),
            points: [o = (-0.1, 0, 0), a = (0.1, 0, 0.05)]
        },
        coupler {
            mass: 0.7[kg],
            inertia: principal(0.03, 0.01, 0.02),
            points: [a = (-0.2, 0, 0), b = (0.2, 0.05, 0)]
        },
        rocker {
            mass: 0.6[kg],
            inertia: principal(0.02, 0.03, 0.01),
            points: [b = (0, -0.2, 0), c = (0, 0.2, 0.1)]
        },
    ],
    joints: [
        o = revolute(world(0, 0, 0), crank.o, body(0, 0, 1)),
        a = spherical(crank.a, coupler.a),
        // at zero the coupler ends at (0.6, 0.05, 0.05)
        c = revolute(world(0.6, 0.45, 0.15), rocker.c, body(0.6, 0, 0.8)),
        b = spherical(coupler.b, rocker.b),
    ],
    fields: [weight = mass * world(0, 0, -9.81[m / s ^ 2])],
    outputs: [reactions, balance, energy],
});

#[test]
fn a_linkage_with_balls() {
    check!(Rssr, RssrState, 11, [crank, coupler, rocker]);
    let mut numbers = Random::new(12);
    let (system, state) = near_zero!(Rssr, RssrState, numbers, 0.1);
    let ball = system.reactions(0.0, &state, &()).b;
    close(
        "a ball has no moment",
        ball.moment.as_slice(),
        &[0.0; 3],
        1.0,
        1e-13,
    );
    let energy =
        |state: &RssrState| system.kinetic_energy(state) + system.potential_energy(0.0, state, &());
    let end = system.integrate(&state).tolerance(1e-12).to(2.0).unwrap();
    assert!((energy(&end) - energy(&state)).abs() < 1e-10);
    for violation in system.violations(2.0, &end, &()) {
        assert!(violation.position.unwrap().abs() < 1e-14);
    }
}

// each kind of joint closes a loop with enough freedoms in it, on a base that floats
macro_rules! floating {
    ($name:ident, $($joint:tt)*) => {
        rigid_system!($name {
            bodies: [
                base { mass: 2[kg], inertia: principal(0.3, 0.2, 0.25), points: [p = (0.2, 0, 0), q = (0.1, 0.5, 0), end = (0.75, 0.05, 0.07)] },
                first { mass: 0.5[kg], inertia: principal(0.03, 0.02, 0.025), points: [p = (-0.1, 0, 0.05), q = (0.15, 0.1, 0)] },
                second { mass: 0.4[kg], inertia: principal(0.02, 0.02, 0.015), points: [p = (-0.1, 0.05, 0), q = (0.1, 0, 0.1)] },
                third { mass: 0.3[kg], inertia: principal(0.01, 0.02, 0.015), points: [p = (0, 0.1, 0), q = (0.1, 0.1, 0.02)] },
            ],
            joints: [
                orbit = free(base),
                a = spherical(base.p, first.p),
                b = universal(first.q, second.p, body(1, 0, 0), body(0, 1, 0)),
                c = spherical(second.q, third.p),
                d = $($joint)*,
            ],
            fields: [weight = mass * world(0, 0, -9.81[m / s ^ 2])],
            forces: [spring = 3[N].between(base.q, second.q)],
            outputs: [reactions, balance],
        });
    };
}
// where the end of the chain is on the base at zero coordinates: 0.2 + 0.25 + 0.2 + 0.1, ...
floating!(ByBall, spherical(base.end, third.q));
floating!(ByHinge, revolute(base.end, third.q, body(0, 0, 1)));
floating!(
    BySkewHinge,
    revolute(base.end, third.q, body(1, 2, 2)).turned(body(0, 0, 1), 0.4)
);
floating!(
    ByCardan,
    universal(base.end, third.q, body(1, 0, 0), body(0, 0.6, 0.8))
);
floating!(ByRail, cylindrical(base.end, third.q, body(0, 0, 1)));
floating!(BySlide, prismatic(base.end, third.q, body(0, 1, 0)));
floating!(ByPlane, planar(base.end, third.q, body(1, 2, 3)));
floating!(ByWeld, weld(base.end, third.q));

#[test]
fn each_kind_closes_a_loop() {
    check!(ByBall, ByBallState, 21, [base, first, second, third]);
    check!(ByHinge, ByHingeState, 22, [base, first, second, third]);
    check!(
        BySkewHinge,
        BySkewHingeState,
        23,
        [base, first, second, third]
    );
    check!(ByCardan, ByCardanState, 24, [base, first, second, third]);
    check!(ByRail, ByRailState, 25, [base, first, second, third]);
    check!(BySlide, BySlideState, 26, [base, first, second, third]);
    check!(ByPlane, ByPlaneState, 28, [base, first, second, third]);
    check!(ByWeld, ByWeldState, 27, [base, first, second, third]);
}

#[test]
fn they_push_where_they_hold() {
    let mut numbers = Random::new(31);
    let (system, state) = near_zero!(ByHinge, ByHingeState, numbers, 0.1);
    let load = system.reactions(0.0, &state, &()).d;
    let axis = state.orbit.attitude * Vector3::z();
    close("a hinge", &[load.moment.dot(&axis)], &[0.0], 1.0, 1e-12);
    let (system, state) = near_zero!(ByRail, ByRailState, numbers, 0.1);
    let load = system.reactions(0.0, &state, &()).d;
    let axis = state.orbit.attitude * Vector3::z();
    let along = [load.moment.dot(&axis), load.force.dot(&axis)];
    close("a rail", &along, &[0.0; 2], 1.0, 1e-12);
    let (system, state) = near_zero!(BySlide, BySlideState, numbers, 0.1);
    let load = system.reactions(0.0, &state, &()).d;
    let axis = state.orbit.attitude * Vector3::y();
    close("a slide", &[load.force.dot(&axis)], &[0.0], 1.0, 1e-12);
}

// in the plane: a slider, two loops that share bodies, and a weld
rigid_system!(Engine {
    motion: planar,
    bodies: [
        crank {
            mass: 1.8[kg],
            inertia: 0.002_5[kg * m ^ 2],
            points: [o = (-0.015, 0), a = (0.035, 0)]
        },
        rod {
            mass: 0.9[kg],
            inertia: 0.003_1[kg * m ^ 2],
            points: [a = (-0.045, 0), b = (0.115, 0)]
        },
        piston {
            mass: 0.65[kg],
            inertia: 0.001[kg * m ^ 2]
        },
    ],
    joints: [
        o = revolute(world(0, 0), crank.o),
        a = revolute(crank.a, rod.a),
        b = revolute(rod.b, piston.G),
        guide = prismatic(world(0, 0), piston.G, body(1, 0)),
    ],
    fields: [weight = mass * world(0, -9.806_65[m / s ^ 2])],
    forces: [gas = (-1500[N]).between(world(1[m], 0), piston.G)],
    outputs: [reactions, balance, energy],
});

// reference/systems/slider_crank.json: maximal coordinates with multipliers, 45 digits
#[test]
fn an_engine() {
    check!(Engine, EngineState, 41, [crank, rod, piston]);
    let (theta, omega) = (0.8_f64, 300.0);
    let beta = -(0.05 * theta.sin() / 0.16).asin();
    let beta_rate = -0.05 * theta.cos() * omega / (0.16 * beta.cos());
    let hinge = |angle: f64, angular_velocity: f64| Hinge {
        angle,
        angular_velocity,
    };
    let state = EngineState {
        o: hinge(theta, omega),
        a: hinge(beta - theta, beta_rate - omega),
        b: hinge(-beta, -beta_rate),
    };
    let system = Engine::default();
    let found = system.acceleration(0.0, &state, &());
    close("crank", &[found.o], &[-10_588.606_611_247_707], 1e4, 1e-13);
    let reactions = system.reactions(0.0, &state, &());
    close(
        "O",
        reactions.o.force.as_slice(),
        &[-4_177.555_882_609_736, -3_816.355_841_028_622_8],
        4e3,
        1e-12,
    );
    close(
        "A",
        reactions.a.force.as_slice(),
        &[-2_689.645_217_957_496_7, -1_891.649_371_888_043_8],
        4e3,
        1e-12,
    );
    close(
        "B",
        reactions.b.force.as_slice(),
        &[-232.555_241_266_353_96, 426.308_189_999_108_27],
        4e3,
        1e-12,
    );
    let guide = reactions.guide;
    close(
        "guide",
        guide.force.as_slice(),
        &[0.0, -419.933_867_499_108_26],
        4e3,
        1e-12,
    );
    close("guide", &[guide.moment], &[0.0], 4e3, 1e-13);
}

rigid_system!(Truss {
    motion: planar,
    bodies: [
        a {
            mass: 1[kg],
            inertia: 0.02[kg * m ^ 2],
            points: [p = (-0.2, 0), q = (0.2, 0)]
        },
        b {
            mass: 1.2[kg],
            inertia: 0.03[kg * m ^ 2],
            points: [p = (-0.3, 0), q = (0.3, 0), r = (0, 0.1)]
        },
        c {
            mass: 0.8[kg],
            inertia: 0.01[kg * m ^ 2],
            points: [p = (0, 0.3), q = (0, -0.1)]
        },
        d {
            mass: 0.5[kg],
            inertia: 0.01[kg * m ^ 2],
            points: [p = (0, -0.3), q = (0, 0.2)]
        },
        cap {
            mass: 0.2[kg],
            inertia: 0.001[kg * m ^ 2],
            points: [p = (0.1, 0)]
        },
    ],
    joints: [
        j1 = revolute(world(0, 0), a.p),
        j2 = revolute(a.q, b.p),
        j3 = revolute(b.q, c.p),
        j4 = revolute(b.r, d.q),
        lid = weld(d.p, cap.p).turned(0.3),
        // at zero: a.q (0.4, 0), b.q (1, 0), c.q (1, -0.4); b.r (0.7, 0.1), d.p (0.7, -0.4)
        j5 = revolute(world(1, -0.4), c.q),
        j6 = revolute(world(0.7, -0.4), d.p),
    ],
    fields: [weight = mass * world(0.3[m / s ^ 2], -9.81[m / s ^ 2])],
    outputs: [reactions, balance],
});

#[test]
fn two_loops() {
    // four hinges in each of two loops: the chain of five has one freedom less than three
    check!(Truss, TrussState, 51, [a, b, c, d, cap]);
}
