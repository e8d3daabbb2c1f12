//! Systems of bodies whose mass and inertia change, compared with the balances of each body at that
//! instant; and motions in closed form.

use nalgebra::Vector3;
use newton_euler::body::Impossible;
use newton_euler::ensemble::Ensemble;
use newton_euler::integrate::{Classical4, DormandPrince, Fixed, IntegrationError};
use newton_euler::prelude::*;

use super::compare::{Answer, Jointed, Listed, Random, TIME, check, link, principal, unit};
use super::oracle::{Kind, Link};

// every part of a joint carries what changes, one body is of parts, and one is welded on
rigid_system!(Leaking::<T> {
    params: [dry = 2[kg], k = 0.3[m]],
    states: [fuel[kg], ballast[kg]],
    rates: [fuel = -0.1[kg / s], ballast = 0.2[1 / s] * (fuel - ballast)],
    locals: [filled = 1[kg] + fuel],
    bodies: [
        base {
            mass: dry + fuel,
            inertia: tensor {
                xx: 2 * mass * k.powi(2) + 2[kg * m ^ 2],
                yy: 0.5[m ^ 2] * fuel + 2[kg * m ^ 2],
                zz: mass * k.powi(2) + 3[kg * m ^ 2],
                xy: 0.1[m ^ 2] * fuel,
                zx: 0.05[kg * m ^ 2],
            },
            points: [p = (0.4, 0, 0), q = (0, 0.5, 0.1)],
        },
        arm {
            mass: 1[kg] + ballast,
            inertia: principal(1, 2, 1.9)[kg * m ^ 2],
            points: [q = (0, 0.3, 0.2), tip = (0.2, 0, 0)],
        },
        slider {
            locals: [half = filled / 2],
            mass: half,
            inertia: principal(0.1[m ^ 2] * mass, 0.12[m ^ 2] * mass, 0.11[m ^ 2] * mass),
        },
        tank {
            inertia: compose([
                cuboid(0.4, 0.5, 0.9).mass(3[kg]),
                point(fuel / 2).at((0.3, 0, 0)),
                point(fuel / 2).at((-0.3, 0, 0)),
            ]),
            points: [top = (0, 0, 0.45)],
        },
        fixed {
            mass: 0.2[kg] + 0.1 * fuel,
            inertia: principal(1, 1, 1)[kg * m ^ 2]
        },
        ring {
            mass: 0.5[kg] + ballast,
            inertia: principal(mass * k * k, 0.2[kg * m ^ 2], 0.2[kg * m ^ 2])
        },
        bolt {
            mass: fuel + ballast,
            inertia: principal(0.1, 0.1, 0.1)[kg * m ^ 2]
        },
    ],
    joints: [
        orbit = free(base),
        hinge = revolute(base.p, arm.q, body(0.6, 0.8, 0)),
        slide = prismatic(arm.tip, slider.G, body(0, 0, 1)),
        ball = spherical(base.q, tank.top),
        held = weld(tank.G, fixed.G),
        cross = universal(tank.G, ring.G, body(1, 0, 0), body(0, 1, 0)),
        thread = screw(slider.G, bolt.G, body(1, 0, 0), 0.1[m]),
    ],
    fields: [weight = mass * world(0, 0, -9.81[m / s ^ 2])],
    drives: [motor = (0.3[m ^ 2 / s ^ 2] * fuel).on(hinge)],
    outputs: [
        reactions,
        energy,
        momentum,
        mass_matrix,
        linearization,
        taylor
    ],
});

/// Those of an instant.
fn leaking(fuel: f64, ballast: f64) -> Vec<Link> {
    let (k, dry) = (0.09, 2.0 + fuel);
    let mut base = principal(2.0 * dry * k + 2.0, 0.5 * fuel + 2.0, dry * k + 3.0);
    (base.m12, base.m13) = (0.1 * fuel, 0.05);
    (base.m21, base.m31) = (base.m12, base.m13);
    let half = f64::midpoint(1.0, fuel);
    let cuboid = |a: f64, b: f64| 3.0 / 12.0 * (a * a + b * b);
    let tanks = fuel * 0.09;
    let tank = principal(
        cuboid(0.5, 0.9),
        cuboid(0.4, 0.9) + tanks,
        cuboid(0.4, 0.5) + tanks,
    );
    let ring = 0.5 + ballast;
    let none = [0.0; 3];
    vec![
        link((dry, base), None, none, none, Kind::Free),
        link(
            (1.0 + ballast, principal(1.0, 2.0, 1.9)),
            Some(0),
            [0.4, 0.0, 0.0],
            [0.0, 0.3, 0.2],
            Kind::Revolute(unit(0.6, 0.8, 0.0)),
        ),
        link(
            (half, principal(0.1, 0.12, 0.11) * half),
            Some(1),
            [0.2, 0.0, 0.0],
            none,
            Kind::Prismatic(Vector3::z()),
        ),
        link(
            (3.0 + fuel, tank),
            Some(0),
            [0.0, 0.5, 0.1],
            [0.0, 0.0, 0.45],
            Kind::Spherical,
        ),
        link(
            (0.2 + 0.1 * fuel, principal(1.0, 1.0, 1.0)),
            Some(3),
            none,
            none,
            Kind::Weld,
        ),
        link(
            (ring, principal(ring * k, 0.2, 0.2)),
            Some(3),
            none,
            none,
            Kind::Universal(Vector3::x(), Vector3::y()),
        ),
        link(
            (fuel + ballast, principal(0.1, 0.1, 0.1)),
            Some(2),
            none,
            none,
            Kind::Screw(Vector3::x(), 0.1),
        ),
    ]
}

/// Where everything moves, and so much is left.
fn drawn(numbers: &mut Random) -> LeakingState<f64> {
    LeakingState {
        orbit: Jointed::random(numbers),
        hinge: Jointed::random(numbers),
        slide: Jointed::random(numbers),
        ball: Jointed::random(numbers),
        cross: Jointed::random(numbers),
        thread: Jointed::random(numbers),
        fuel: 1.5 + numbers.number(),
        ballast: 1.2 + numbers.number(),
    }
}

/// Accelerations, loads of joints, energy and momentum are those of the bodies that are there.
#[test]
fn as_the_bodies_of_the_instant() {
    let (system, mut numbers) = (Leaking::<f64>::default(), Random::new(5));
    for _ in 0..50 {
        let state = drawn(&mut numbers);
        let found = system.acceleration(TIME, &state, &());
        let none = (vec![], vec![]);
        let held = system.reactions(TIME, &state, &());
        let answer = Answer {
            rates: vec![
                state.orbit.rates(),
                state.hinge.rates(),
                state.slide.rates(),
                state.ball.rates(),
                none,
                state.cross.rates(),
                state.thread.rates(),
            ],
            accelerations: vec![
                found.orbit.list(),
                found.hinge.list(),
                found.slide.list(),
                found.ball.list(),
                vec![],
                found.cross.list(),
                found.thread.list(),
            ],
            reactions: vec![
                (1, held.hinge.list()),
                (2, held.slide.list()),
                (3, held.ball.list()),
                (4, held.held.list()),
                (5, held.cross.list()),
                (6, held.thread.list()),
            ],
            kinetic: system.kinetic_energy(&state),
            momentum: [
                system.linear_momentum(&state).list(),
                system.angular_momentum(&state).list(),
                system.angular_momentum_about_pole(TIME, &state).list(),
            ],
        };
        let links = leaking(state.fuel, state.ballast);
        check(&links, [0.0, 0.0, -9.81], &answer, |loads| {
            loads.drives[1] = vec![0.3 * state.fuel];
        });
        assert!((found.fuel + 0.1).abs() < 1e-15);
    }
}

/// What slides, turns or hangs without its mass in the equations is seen to run out all the same.
#[test]
fn each_body_by_name() {
    let (system, mut numbers) = (Leaking::<f64>::default(), Random::new(9));
    let start = drawn(&mut numbers);
    let name = |fuel: f64, ballast: f64| {
        let state = LeakingState {
            fuel,
            ballast,
            ..start
        };
        match system.possible(0.0, &state, &()) {
            Ok(()) => "",
            Err(InvalidBody::Member { body, .. }) => body,
            Err(other) => panic!("{other}"),
        }
    };
    assert_eq!(name(1.0, 1.0), "");
    assert_eq!(name(-2.5, 4.0), "base");
    assert_eq!(name(1.5, -1.1), "arm");
    assert_eq!(name(-1.1, 3.0), "slider");
    assert_eq!(name(0.6, -0.55), "ring");
    assert_eq!(name(-0.3, 0.2), "bolt");
    // J_yy > J_xx + J_zz
    assert_eq!(name(40.0, 1.0), "base");
}

rigid_system!(Stages {
    doc: "Two stages on a rail: the lower one burns for 10 s, then the upper one, which still carries it.",
    params: [exhaust = 2500[m / s], flow = 1.5[kg / s]],
    states: [first[kg], second[kg]],
    rates: [
        first = if t < 10[s] { -flow } else { 0 },
        second = if t < 10[s] { 0 } else { -flow / 2 },
    ],
    locals: [burns = if t < 10[s] { flow } else { flow / 2 }],
    bodies: [
        lower {
            mass: 20[kg] + first,
            points: [top = (0, 0, 1.2)]
        },
        upper {
            mass: 10[kg] + second
        },
    ],
    joints: [
        rail = prismatic(world(0, 0, 0), lower.G, world(0, 0, 1)),
        coupling = weld(lower.top, upper.G),
    ],
    fields: [weight = mass * world(0, 0, -9.81[m / s ^ 2])],
    drives: [thrust = (burns * exhaust).on(rail)],
    outputs: [reactions, energy],
});

fn full() -> StagesState {
    StagesState {
        first: 16.0,
        second: 9.0,
        ..StagesState::default()
    }
}

/// Tsiolkovsky, twice: the velocity, and what the coupling carries.
#[test]
fn two_stages() {
    let stages = Stages::default();
    let steps = Fixed {
        method: Classical4,
        step: 0.01,
    };
    let start = stages.integrate(&full());
    let by_pair = start.method(DormandPrince { tolerance: 1e-13 }).to(20.0);
    let by_steps = stages.integrate(&full()).method(steps).to(20.0);
    let by_default = stages.integrate(&full()).tolerance(1e-13).to(20.0);
    let velocity = 2500.0 * ((55.0_f64 / 40.0).ln() + (40.0_f64 / 32.5).ln()) - 9.81 * 20.0;
    for (end, error) in [(by_pair, 1e-11), (by_steps, 1e-9), (by_default, 1e-11)] {
        let end = end.unwrap();
        assert!((end.rail.velocity / velocity - 1.0).abs() < error);
        assert!((end.first - 1.0).abs() < 1e-11 && (end.second - 1.5).abs() < 1e-11);
        let held = stages.reactions(20.0, &end, &());
        let thrust = 0.75 * 2500.0;
        assert!((held.coupling.force.z - 11.5 / 32.5 * thrust).abs() < 1e-9);
        let kinetic = 0.5 * 32.5 * end.rail.velocity.powi(2);
        assert!((stages.kinetic_energy(&end) / kinetic - 1.0).abs() < 1e-14);
    }
}

fn runs_out<S>(error: &IntegrationError<S>, name: &str, time: f64) {
    let IntegrationError::InvalidBody { invalid, .. } = error else {
        panic!("{}", error.time())
    };
    let InvalidBody::Member {
        body,
        impossible: Impossible::Mass(_),
    } = invalid
    else {
        panic!("{invalid}")
    };
    assert_eq!(*body, name);
    assert!((error.time() - time).abs() < 0.02, "{}", error.time());
}

/// The upper stage has nothing left, after 10 s and 19 kg / 0.75 kg/s.
#[test]
fn a_stage_runs_out() {
    let (stages, out) = (Stages::default(), 10.0 + 19.0 / 0.75);
    let start = || stages.integrate(&full());
    let steps = Fixed {
        method: Classical4,
        step: 0.01,
    };
    let pair = DormandPrince { tolerance: 1e-9 };
    runs_out(&start().to(50.0).unwrap_err(), "upper", out);
    runs_out(&start().method(steps).to(50.0).unwrap_err(), "upper", out);
    runs_out(&start().method(pair).to(50.0).unwrap_err(), "upper", out);
    let empty = StagesState {
        first: -21.0,
        ..full()
    };
    runs_out(&stages.integrate(&empty).to(1.0).unwrap_err(), "lower", 0.0);
}

rigid_system!(Pendulum::<T> {
    doc: "A bob that leaks to all sides, on a rod without mass.",
    motion: planar,
    params: [length = 0.8[m], leak = 0.05[kg / s]],
    states: [water[kg]],
    rates: [water = -leak],
    bodies: [bob {
        mass: 0.3[kg] + water,
        inertia: 0.02[kg * m ^ 2] + 0.01[m ^ 2] * water,
        points: [pin = (0, length)],
    }],
    joints: [hook = revolute(world(0, 0), bob.pin)],
    fields: [weight = mass * world(0, -9.81[m / s ^ 2])],
    drives: [friction = (-0.02[N * m * s] * hook.angular_velocity).on(hook)],
    outputs: [taylor, energy, linearization],
});

/// `(J + m l^2) q'' = -m g l sin q - c q'`, with the mass of the moment.
fn swing(water: f64, [angle, rate]: [f64; 2]) -> [f64; 2] {
    let mass = 0.3 + water;
    let inertia = 0.02 + 0.01 * water + mass * 0.64;
    [
        rate,
        (-mass * 9.81 * 0.8 * angle.sin() - 0.02 * rate) / inertia,
    ]
}

/// The same with a classical method of many steps.
fn swung(seconds: f64) -> [f64; 2] {
    let (mut at, count) = ([1.2, 0.0], 20_000);
    let step = seconds / f64::from(count);
    for k in 0..count {
        let after = |part: f64, slope: [f64; 2]| {
            let water = 0.4 - 0.05 * step * (f64::from(k) + part);
            swing(water, [0, 1].map(|i| at[i] + part * step * slope[i]))
        };
        let first = after(0.0, [0.0; 2]);
        let second = after(0.5, first);
        let third = after(0.5, second);
        let last = after(1.0, third);
        let sum = |i: usize| first[i] + 2.0 * (second[i] + third[i]) + last[i];
        at = [0, 1].map(|i| at[i] + step / 6.0 * sum(i));
    }
    at
}

fn lifted() -> PendulumState<f64> {
    PendulumState {
        hook: Hinge {
            angle: 1.2,
            angular_velocity: 0.0,
        },
        water: 0.4,
    }
}

#[test]
fn a_bob_that_leaks() {
    let pendulum = Pendulum::<f64>::default();
    let [angle, rate] = swung(7.0);
    let by_series = pendulum.integrate(&lifted()).tolerance(1e-13).to(7.0);
    let pair = DormandPrince { tolerance: 1e-13 };
    let by_pair = pendulum.integrate(&lifted()).method(pair).to(7.0);
    for end in [by_series.unwrap(), by_pair.unwrap()] {
        assert!((end.hook.angle - angle).abs() < 1e-11);
        assert!((end.hook.angular_velocity - rate).abs() < 1e-11);
    }
    let a = pendulum.linearize(0.0, &lifted(), &()).a().into_owned();
    let slope = |step: f64| {
        let moved = |sign: f64| swing(0.4 + sign * step, [1.2, 0.0])[1];
        (moved(1.0) - moved(-1.0)) / (2.0 * step)
    };
    assert!((a[(1, 2)] - slope(1e-5)).abs() < 1e-8, "{a}");
}

/// The inertia of the pendulum stays positive long after that of the bob, so that nothing in the
/// equations ends; and members of an ensemble end where they would alone.
#[test]
fn a_bob_runs_dry() {
    let pendulum = Pendulum::<f64>::default();
    let start = || pendulum.integrate(&lifted());
    let pair = DormandPrince { tolerance: 1e-9 };
    runs_out(&start().to(30.0).unwrap_err(), "bob", 14.0);
    runs_out(&start().method(pair).to(30.0).unwrap_err(), "bob", 14.0);
    let wet = PendulumState {
        water: 4.0,
        ..lifted()
    };
    let mut members = Ensemble::new(&pendulum, [wet, lifted()]);
    let error = members.integrate().tolerance(1e-9).to(30.0).unwrap_err();
    let lost = error.member().unwrap();
    assert_eq!(lost.index, 1);
    runs_out(&lost.error, "bob", 14.0);
}
