//! Loads that switch on: in time, in the state, in a parameter, from 1e-3 to 1e6.

use newton_euler::{
    prelude::*,
    structure::{Structure, Structured},
};

/// A body under one moment about its axis z, and a point under one force along x, that are a function of a quantity:
/// `switched!(name, (extra keys), quantity, function)`.
macro_rules! switched {
    ($name:ident, [$($key:tt)*], $x:expr) => {
        mod $name {
            newton_euler::rigid_body!(Turned {
                motion: rotation,
                $($key)*
                inertia: principal(1, 1, 1)[kg * m ^ 2],
                moments: [motor = 2[N * m] * ($x) * body(0, 0, 1)],
            });
            newton_euler::rigid_body!(Pushed {
                motion: translation,
                $($key)*
                mass: 1[kg],
                forces: [motor = 2[N] * ($x) * world(1, 0, 0)],
            });
        }
    };
}

switched!(tanh_short, [], 1 + ((t - 0.001[s]) / 0.00001[s]).tanh());
switched!(tanh_middle, [], 1 + ((t - 10[s]) / 0.05[s]).tanh());
switched!(tanh_long, [], 1 + ((t - 1e6[s]) / 3[s]).tanh());
switched!(tanh_off, [], 1 - ((t - 10[s]) / 0.05[s]).tanh());
switched!(exponential, [], (100 * (t / 1[s] - 10)).exp());
switched!(root, [], (t / 1[s] - 10) + (t / 1[s] - 10).powi(2).sqrt());
switched!(
    root_off,
    [],
    (t / 1[s] - 10).powi(2).sqrt() - (t / 1[s] - 10)
);
switched!(
    power,
    [],
    (t / 1[s] - 10) + (t / 1[s] - 10).powi(2).powf(0.5)
);
switched!(distance, [], (t / 1[s] - 10) + (t / 1[s] - 10).hypot(0));
switched!(size, [], (t / 1[s] - 10) + (t / 1[s] - 10).abs());
switched!(most, [], (t / 1[s] - 10).max(0));
switched!(least, [], (t / 1[s] - 10).min(0));
switched!(sign, [], 1 + (t / 1[s] - 10).signum());
switched!(steps, [], (t / 10[s]).floor());
switched!(chosen, [], if t > 10[s] { 1 } else { 0 });
switched!(sawtooth, [], (t / 1[s]).sin().asin() - t / 1[s]);
switched!(parameter, [params: [gain],], (gain - 3).powi(2).sqrt() + (gain - 3));
switched!(input, [inputs: [gain],], (gain - 3) + ((gain - 3) * (gain - 3)).sqrt());

/// The claims that a load that is there somewhere refutes.
fn assert_unclaimed(structure: &Structure, what: &str) {
    assert!(!structure.is_torque_free, "{what}");
    assert!(!structure.keeps_spin, "{what}");
}

/// What a motor of `function` of a quantity does, at quantities on either side.
macro_rules! check {
    ($name:ident, $quantities:expr, $function:expr) => {
        check!($name, $quantities, $function, |time| {
            let (turned, pushed) = ($name::Turned::default(), $name::Pushed::default());
            let turned = turned.acceleration(time, &Rotation::default(), &());
            (
                turned.z,
                pushed.acceleration(time, &Translation::default(), &()).x,
            )
        })
    };
    ($name:ident, $quantities:expr, $function:expr, $accelerations:expr) => {
        assert_unclaimed(&$name::Turned::STRUCTURE, stringify!($name));
        assert!(!$name::Pushed::STRUCTURE.is_force_free, stringify!($name));
        for quantity in $quantities {
            let function: fn(f64) -> f64 = $function;
            let expected = 2.0 * function(quantity);
            let (turned, pushed) = $accelerations(quantity);
            let bound = 1e-9 * expected.abs();
            assert!(
                (turned - expected).abs() <= bound,
                "{}: {turned} {expected}",
                stringify!($name)
            );
            assert!(
                (pushed - expected).abs() <= bound,
                "{}: {pushed} {expected}",
                stringify!($name)
            );
        }
    };
}

#[test]
fn what_switches_on_later_is_there() {
    let around_ten = [0.0, 1.0, 9.0, 11.0, 12.0, 1e3, 1e6];
    check!(tanh_short, [0.0, 0.002, 1.0], |t| 1.0
        + ((t - 0.001) / 0.00001).tanh());
    check!(tanh_middle, around_ten, |t| 1.0
        + ((t - 10.0) / 0.05).tanh());
    check!(tanh_long, [0.0, 1.0, 1e6 + 100.0], |t| 1.0
        + ((t - 1e6) / 3.0).tanh());
    check!(tanh_off, around_ten, |t| 1.0 - ((t - 10.0) / 0.05).tanh());
    check!(exponential, [0.0, 9.0, 10.5, 11.0], |t| (100.0
        * (t - 10.0))
        .exp());
    check!(root, around_ten, |t| t - 10.0 + (t - 10.0).abs());
    check!(root_off, around_ten, |t| (t - 10.0).abs() - (t - 10.0));
    check!(power, around_ten, |t| t - 10.0 + (t - 10.0).abs());
    check!(distance, around_ten, |t| t - 10.0 + (t - 10.0).abs());
    check!(size, around_ten, |t| t - 10.0 + (t - 10.0).abs());
    check!(most, around_ten, |t| (t - 10.0).max(0.0));
    check!(least, around_ten, |t| (t - 10.0).min(0.0));
    check!(sign, around_ten, |t| 1.0 + (t - 10.0).signum());
    check!(steps, [0.0, 5.0, 15.0, 1e6], |t| (t / 10.0).floor());
    check!(chosen, around_ten, |t| if t > 10.0 { 1.0 } else { 0.0 });
    check!(sawtooth, [0.5, 1.0, 2.0, 3.0, 12.0], |t| t.sin().asin() - t);
}

#[test]
fn what_a_parameter_or_an_input_switches_on_is_there() {
    let of = |gain: f64| 2.0 * if gain > 3.0 { gain - 3.0 } else { 0.0 };
    let quantities = [-1e6, 0.0, 2.9, 3.1, 5.0, 1e6];
    check!(
        parameter,
        quantities,
        |gain| if gain > 3.0 { 2.0 * (gain - 3.0) } else { 0.0 },
        |gain| {
            let turned = parameter::Turned::new(parameter::TurnedParams { gain }).unwrap();
            let pushed = parameter::Pushed::new(parameter::PushedParams { gain }).unwrap();
            let turned = turned.acceleration(0.0, &Rotation::default(), &());
            (
                turned.z,
                pushed.acceleration(0.0, &Translation::default(), &()).x,
            )
        }
    );
    check!(
        input,
        quantities,
        |gain| if gain > 3.0 { 2.0 * (gain - 3.0) } else { 0.0 },
        |gain| {
            let (turned, pushed) = (input::Turned::default(), input::Pushed::default());
            let turned =
                turned.acceleration(0.0, &Rotation::default(), &input::TurnedInput { gain });
            let input = input::PushedInput { gain };
            (
                turned.z,
                pushed.acceleration(0.0, &Translation::default(), &input).x,
            )
        }
    );
    assert!(of(5.0) > 0.0);
}

/// A governor that acts beyond a rate, of a body that is symmetric about its axis.
mod governor {
    newton_euler::rigid_body!(Governed {
        motion: rotation,
        locals: [w = angular_velocity.in_body()],
        inertia: principal(1, 1, 2)[kg * m ^ 2],
        moments: [governor = -1[N * m * s]
            * ((w.z - 5[rad / s]) + (w.z - 5[rad / s]).powi(2).sqrt())
            * body(0, 0, 1)],
    });
}

#[test]
fn a_governor_governs() {
    assert_unclaimed(&governor::Governed::STRUCTURE, "governor");
    for (rate, expected) in [(-7.0, 0.0), (4.9, 0.0), (5.5, -0.5), (1e3, -995.0)] {
        let state = Rotation {
            angular_velocity: [0.0, 0.0, rate].into(),
            ..Rotation::default()
        };
        let acceleration = governor::Governed::default().acceleration(0.0, &state, &());
        assert!((acceleration.z - expected).abs() < 1e-12);
    }
}

/// A motor that switches on: the rate that it leaves, by its integral.
#[test]
fn a_motor_that_switches_on_turns_the_body() {
    let body = tanh_middle::Turned::default();
    let end = body
        .integrate(&Rotation::default())
        .tolerance(1e-12)
        .to(12.0)
        .unwrap();
    let log_cosh = |x: f64| x.abs() + (-2.0 * x.abs()).exp().ln_1p() - core::f64::consts::LN_2;
    let expected = 2.0 * (12.0 + 0.05 * (log_cosh(2.0 / 0.05) - log_cosh(-10.0 / 0.05)));
    assert!(
        (end.angular_velocity.z - expected).abs() < 1e-9,
        "{}",
        end.angular_velocity.z
    );
}

/// Bearings whose distance is written with conditions of a parameter, and a drive that is one on a side only.
mod bearings {
    newton_euler::rigid_body!(Rotor {
        motion: fixed_axis(a, body(0, 0, 1)),
        params: [p, torque],
        mass: 2[kg],
        inertia: principal(1, 2, 3)[kg * m ^ 2],
        points: [
            a = (0, 0, -(p - 100[m]).max(0[m])),
            b = (0, 0, if p > 50[m] { p } else { 1[m] }),
        ],
        fields: [weight = mass * world(0, -9.80665[m / s ^ 2], 0)],
        moments: [drive = body(0, 0, (torque - 3[N * m]).max(0[N * m]))],
        reactions: [in_a = body(_, _, _).at(a), in_b = body(_, _, 0).at(b)],
        outputs: [reactions],
    });
}

#[test]
fn distances_of_bearings_may_have_branches() {
    for (p, torque) in [(60.0_f64, 0.0_f64), (20.0, 5.0), (160.0, 1.0), (1e6, 1e3)] {
        let rotor = bearings::Rotor::new(bearings::RotorParams { p, torque }).unwrap();
        let (a, b) = (-(p - 100.0).max(0.0), if p > 50.0 { p } else { 1.0 });
        let acceleration = rotor.acceleration(0.0, &Hinge::default(), &());
        assert!((acceleration - (torque - 3.0).max(0.0) / 3.0).abs() < 1e-12 * torque.max(1.0));
        let reactions = rotor.reactions(0.0, &Hinge::default(), &());
        // a lever: m g = A + B, a A + b B = 0
        let weight = 2.0 * 9.80665;
        let in_b = -a / (b - a) * weight;
        assert!(
            (reactions.in_a.y - (weight - in_b)).abs() < 1e-12 * weight,
            "{p}"
        );
        assert!((reactions.in_b.y - in_b).abs() < 1e-12 * weight, "{p}");
    }
}

/// Conditions on time that parameters make hold at no time, or at all times.
mod never {
    newton_euler::rigid_body!(Paced {
        motion: planar_translation,
        params: [rate = 0[1 / s], bound = 1],
        mass: 1[kg],
        forces: [
            late = if t * rate > bound {
                world(1[N], 0)
            } else {
                world(0, 0)
            },
            often = if (t * rate).sin() > bound {
                world(0, 1[N])
            } else {
                world(0, 0)
            },
        ],
    });
}

#[test]
fn a_switch_at_no_time_is_none() {
    let still = PlanarTranslation::default();
    let end = never::Paced::default().integrate(&still).to(3.0).unwrap();
    assert_eq!(end, still);
    for (rate, bound, expected) in [
        (0.0, 1.0, [0.0, 0.0]),
        (1e-310, 2.0, [0.0, 0.0]),
        (0.0, -1.0, [3.0, 3.0]),
        (0.5, 1.0, [1.0, 0.0]),
    ] {
        let body = never::Paced::new(never::PacedParams { rate, bound }).unwrap();
        let end = body.integrate(&still).to(3.0).unwrap();
        let found = [end.velocity.x, end.velocity.y];
        assert!(
            (found[0] - expected[0]).abs() < 1e-12,
            "{rate} {bound}: {found:?}"
        );
        assert!(
            (found[1] - expected[1]).abs() < 1e-12,
            "{rate} {bound}: {found:?}"
        );
    }
}
