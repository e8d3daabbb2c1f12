//! Steady precession: F12 and M7, compared with integration, at thresholds, and after a long time
//! (H19).

#![allow(
    clippy::float_cmp,
    clippy::cast_precision_loss,
    clippy::excessive_precision,
    reason = "what is exact is compared exactly, with all digits of the references"
)]
use std::f64::consts::{FRAC_PI_2, PI};

use nalgebra::{Quaternion, UnitQuaternion, Vector3};
use newton_euler::integrate::cf4;
use newton_euler::precession::Precession;
use newton_euler::prelude::*;
use newton_euler::top::{HeavyTop, SymmetricTop};
use proptest::prelude::*;

use crate::reference::{attitude, body, distance, number, numbers, statement, vector};

/// Euler's equations of a symmetric top on a fixed point, m g l \[N m\] along its axis; nothing of what is tested.
struct Top {
    transverse: f64,
    axial: f64,
    torque: f64,
}

impl RigidBody for Top {
    type Scalar = f64;
    type State = Rotation;
    type Input = ();

    fn acceleration(&self, _: f64, state: &Rotation, (): &()) -> Vector3<f64> {
        let moments = Vector3::new(self.transverse, self.transverse, self.axial);
        let w = state.angular_velocity;
        let weight = state.attitude.inverse() * (Vector3::z() * -self.torque);
        (Vector3::z().cross(&weight) - w.cross(&moments.component_mul(&w))).component_div(&moments)
    }
}

fn about_x(angle: f64) -> UnitQuaternion<f64> {
    UnitQuaternion::from_axis_angle(&Vector3::x_axis(), angle)
}

/// Of one motion and its integral over this time.
fn difference(motion: &Precession, top: &Top, time: f64, steps: usize) -> [f64; 2] {
    let [start, end] = [motion.at(0.0), motion.at(time)];
    let integrated = cf4(top, &start, &(), 0.0..time, steps);
    [
        distance(&end.attitude, &integrated.attitude),
        (end.angular_velocity - integrated.angular_velocity).amax(),
    ]
}

/// F12.
#[test]
fn free_top() {
    let expected = statement("F12 regular precession");
    let value = |name: &str| number(&expected[name]);
    let [transverse, axial, momentum, tilt] = ["I1", "I3", "M", "theta"].map(value);
    let top = SymmetricTop::new(transverse, axial).unwrap();
    let rates = top.rates(momentum, tilt);
    let spin = value("spin relative to precessing frame psi_dot = Omega3 - Omega_pr cos th");
    for (found, expected) in [
        (rates.axial, value("Omega3 (33.4)")),
        (rates.transverse, value("Omega1=(M/I1) sin th")),
        (rates.precession, value("Omega_pr (33.5)")),
        (rates.spin, spin),
    ] {
        // At most four roundings.
        assert!((found / expected - 1.0).abs() < 5e-16, "{found} {expected}");
    }

    let motion = top.free_with_momentum(about_x(tilt), &(Vector3::z() * momentum));
    let later = motion.at(0.2);
    let name = "q(0.2) closed = qz(Wpr t) qx(th) qz(psi t)";
    assert!(distance(&later.attitude, &attitude(&expected[name])) < 4e-16);
    let axis = later.attitude * Vector3::z();
    assert!((axis - vector(&expected["axis(t=0.2) closed"])).amax() < 6e-16);
    let found = [
        motion.rate(),
        motion.spin(),
        motion.axial_rate(),
        motion.tilt(),
    ];
    let same = [rates.precession, rates.spin, rates.axial, tilt];
    for (found, same) in found.into_iter().zip(same) {
        assert!((found / same - 1.0).abs() < 1e-15);
    }
    // ω is what J takes to M, at any time.
    for time in [0.0, 0.2, -3.0, 1e6] {
        let state = motion.at(time);
        let w = state.angular_velocity;
        let m = state.attitude * Vector3::new(transverse * w.x, transverse * w.y, axial * w.z);
        assert!((m - Vector3::z() * momentum).amax() < 1e-15 * momentum);
        assert!((w.z - rates.axial).abs() < 1e-13);
    }
}

/// Edges of F12.
#[test]
fn free_top_edges() {
    let up = Vector3::z() * 0.456;
    let free = |i3: f64, tilt| {
        SymmetricTop::new(0.0123, i3)
            .unwrap()
            .free_with_momentum(about_x(tilt), &up)
    };
    // Along its axis: precession cannot be seen, and is there.
    let along = free(0.0187, 0.0);
    assert_eq!((along.tilt(), along.rate()), (0.0, 0.456 / 0.0123));
    let spun = UnitQuaternion::from_axis_angle(&Vector3::z_axis(), 0.456 / 0.0187 * 0.1);
    assert!(distance(&along.at(0.1).attitude, &spun) < 1e-15);
    assert!((along.at(0.1).angular_velocity - Vector3::z() * (0.456 / 0.0187)).amax() < 1e-14);
    let against = free(0.0187, PI);
    assert!((against.axial_rate() + 0.456 / 0.0187).abs() < 1e-14);
    // Across: no spin.
    let across = free(0.0187, FRAC_PI_2);
    assert!(across.axial_rate().abs() < 1e-14 && across.spin().abs() < 1e-14);
    // Spherical: Ω along M, no spin at all; nearly spherical: a small spin with all its digits.
    assert_eq!(free(0.0123, 0.7).spin(), 0.0);
    let tops = |i3: f64| SymmetricTop::new(1.0, i3).unwrap().rates(1.0, 0.0).spin;
    assert!((tops(1.0 + 2f64.powi(-40)) * 2f64.powi(40) + 1.0).abs() < 1e-11);
    // A rod has no spin, and no body has I₃ > 2 I₁.
    assert!(SymmetricTop::new(1.0, 0.0).is_err());
    assert!(SymmetricTop::new(0.0, 0.0).is_err());
    assert!(SymmetricTop::new(1.0, 2.1).is_err());
    assert!(SymmetricTop::new(1.0, f64::NAN).is_err());
    // A thin one spins fast, finitely.
    assert!(free(1e-300, 0.3).spin() > 1e299);
    // At rest.
    let top = SymmetricTop::new(1.0, 1.5).unwrap();
    let start = Rotation {
        attitude: about_x(0.4),
        ..Rotation::default()
    };
    assert_eq!(top.free(&start).at(1e9).angular_velocity, Vector3::zeros());
    assert!(distance(&top.free(&start).at(1e9).attitude, &start.attitude) < 1e-16);
    assert_eq!(top.free(&start).axis(), Vector3::zeros());
    // At any size.
    for decade in [-200, 200] {
        let angular_velocity = Vector3::new(0.3, -0.4, 2.0);
        let factor = 10f64.powi(decade);
        let motion = |factor| {
            top.free(&Rotation {
                angular_velocity: angular_velocity * factor,
                ..start
            })
        };
        let [small, one] = [motion(factor), motion(1.0)];
        assert!((small.rate() / factor / one.rate() - 1.0).abs() < 1e-15);
        assert!((small.spin() / factor / one.spin() - 1.0).abs() < 1e-15);
        assert!(distance(&small.at(3.0 / factor).attitude, &one.at(3.0).attitude) < 1e-14);
        let by_momentum = top.free_with_momentum(start.attitude, &(up * factor));
        assert!((by_momentum.rate() / factor / 0.456 - 1.0).abs() < 1e-15);
    }
}

/// H19: after 1e9 s, phases of 1e9 rad whose values come from 40-digit arithmetic.
#[test]
fn long_times() {
    // I₁ = 1, so Ω = M; I₃ = 0.5: ψ̇ = M₃; at θ = 0 both act about one axis, the whole turn is M t/I₃.
    let top = SymmetricTop::new(1.0, 0.5).unwrap();
    let upright = top.free_with_momentum(UnitQuaternion::identity(), &Vector3::z());
    let state = upright.at(1e9);
    // cos 1e9 and sin 1e9: the half turn is 1e9 rad (Python's mpmath).
    let half = Quaternion::new(0.837_887_181_363_902_3, 0.0, 0.0, 0.545_843_449_448_699_6);
    assert!(distance(&state.attitude, &UnitQuaternion::new_unchecked(half)) < 4e-16);
    // A rate that is no double: M/I₁ = 1/3, over 3e9 s.
    let top = SymmetricTop::new(3.0, 1.5).unwrap();
    let third = top.free_with_momentum(UnitQuaternion::identity(), &Vector3::z());
    let state = third.at(3e9);
    assert!(distance(&state.attitude, &UnitQuaternion::new_unchecked(half)) < 4e-16);
    // From the angular velocity, which is 2/3 rounded to 1 ± 5.6e-17 of it: off by that times the phase, and no more.
    let start = Rotation {
        angular_velocity: Vector3::z() * (2.0 / 3.0),
        ..Rotation::default()
    };
    let rounded = (2.0f64 / 3.0).mul_add(3.0, -2.0) / 2.0; // relative
    let phase = Vector3::z() * (2e9 * rounded);
    let expected = UnitQuaternion::new_unchecked(half) * UnitQuaternion::from_scaled_axis(phase);
    assert!(rounded != 0.0);
    assert!(distance(&top.free(&start).at(3e9).attitude, &expected) < 1e-15);
    // A magnitude that is no double: √2 about (1, 1, 0), a sphere.
    let sphere = SymmetricTop::new(1.0, 1.0).unwrap();
    let diagonal = Vector3::new(1.0, 1.0, 0.0);
    let motion = sphere.free_with_momentum(UnitQuaternion::identity(), &diagonal);
    let half = Quaternion::from_parts(
        -0.992_397_006_788_456_35,
        diagonal * -0.087_029_250_592_293_722,
    );
    let half = UnitQuaternion::new_unchecked(half);
    assert!(distance(&motion.at(1e9).attitude, &half) < 4e-16);
    let start = Rotation {
        angular_velocity: diagonal,
        ..Rotation::default()
    };
    assert!(distance(&sphere.free(&start).at(1e9).attitude, &half) < 4e-16);
    // There and back.
    let motion = top.free_with_momentum(about_x(0.5), &Vector3::new(1.0, 2.0, -2.0));
    let [once, back] = [motion.at(1e9), motion.at(-1e9)];
    let on = top.free(&once).at(-1e9);
    // ω known to 1e-16: 1e-7 rad of 1e9.
    assert!(distance(&on.attitude, &motion.at(0.0).attitude) < 2e-6);
    assert!((back.attitude.quaternion().norm() - 1.0).abs() < 4e-16);
}

fn m7() -> (HeavyTop, Top, f64, f64) {
    let [m, l, transverse, axial, tilt, spin, g] = ["m", "l", "I1", "I3", "theta", "Omega3", "g"]
        .map(|name| number(&body("M7")["given"][name]));
    let torque = m * g * l;
    let heavy = HeavyTop::new(SymmetricTop::new(transverse, axial).unwrap(), torque);
    (
        heavy,
        Top {
            transverse,
            axial,
            torque,
        },
        tilt,
        spin,
    )
}

/// M7: both rates, thresholds, the reaction of the pivot, and the motion itself.
#[test]
fn heavy_top() {
    let (heavy, top, tilt, axial_rate) = m7();
    let expected = &body("M7")["expect"];
    let value = |name: &str| number(&expected[name]);
    let rates = heavy.steady_rates(tilt, axial_rate).unwrap();
    let [slow, fast] = [rates.slow, rates.fast.unwrap()];
    for (found, name) in [
        (slow, "slow"),
        (fast, "fast"),
        (
            heavy.sleeping_axial_rate(),
            "sleeping threshold W3: 2 sqrt(I1 m g l)/I3",
        ),
        (
            heavy.least_axial_rate(tilt),
            "min W3 for regular precession at theta: 2 sqrt(I1 cos th m g l)/I3",
        ),
    ] {
        // Four roundings of what is given.
        assert!((found / value(name) - 1.0).abs() < 5e-16, "{name}: {found}");
    }
    let level = heavy.steady_rates(FRAC_PI_2, axial_rate).unwrap();
    assert!((level.slow / value("gyroscopic approx mgl/(I3 W3)") - 1.0).abs() < 5e-16);
    assert_eq!(level.fast, None);

    // The horizontal reaction is that of G on its circle.
    let [slow_pull, fast_pull] = numbers(&expected["horizontal, toward axis: m l sin(th) Om^2"]);
    for (rate, pull) in [(slow, slow_pull), (fast, fast_pull)] {
        let motion = heavy.steady(tilt, axial_rate, rate);
        let center = |t: f64| motion.at(t).attitude * Vector3::z() * 0.06;
        let h = 1e-3 / rate;
        let acceleration = (center(h) - center(0.0) * 2.0 + center(-h)) / (h * h);
        // Differences: h² Ω²/12 of the whole, and rounding over h² Ω².
        assert!((acceleration.norm() * 0.4 / pull - 1.0).abs() < 1e-7);
        assert!((motion.tilt() - tilt).abs() < 1e-15);
        assert!((motion.axial_rate() - axial_rate).abs() < 1e-13);
        assert_eq!(motion.rate(), rate);
        // A revolution and a half of the slow one; steps of 20 and 10 mrad: (2e-2)⁴/100 of 180 rad a second.
        let [attitude, rates] = difference(&motion, &top, 3.0 / slow.min(10.0), 40_000);
        assert!(
            attitude < 1e-7 && rates < 1e-5,
            "{rate}: {attitude:e} {rates:e}"
        );
    }
    // Any other rate is no motion.
    let other = heavy.steady(tilt, axial_rate, slow * 1.1);
    assert!(difference(&other, &top, 1.0, 10_000)[0] > 1e-2);
}

/// Where there is none, one, or two.
#[test]
fn heavy_top_limits() {
    let (heavy, top, tilt, axial_rate) = m7();
    let least = heavy.least_axial_rate(tilt);
    for sign in [1.0, -1.0] {
        assert_eq!(heavy.steady_rates(tilt, sign * least * (1.0 - 1e-14)), None);
        let double = heavy.steady_rates(tilt, sign * least).unwrap();
        let middle = sign * top.axial * least / (2.0 * top.transverse * tilt.cos());
        for rate in [double.slow, double.fast.unwrap()] {
            assert!((rate / middle - 1.0).abs() < 1e-7); // the square root of rounding
        }
        let both = heavy.steady_rates(tilt, sign * least * 1.01).unwrap();
        assert!(both.slow.abs() < middle.abs() && middle.abs() < both.fast.unwrap().abs());
        // The other way round, the other way round.
        let [forth, back] =
            [1.0, -1.0].map(|sign| heavy.steady_rates(tilt, sign * axial_rate).unwrap());
        assert_eq!(
            (back.slow, back.fast),
            (-forth.slow, forth.fast.map(|rate| -rate))
        );
    }
    // Hanging: at any spin; without one, a conical pendulum with Ω² = m g l/(I₁ |cos θ|).
    let below = PI - 0.6;
    assert_eq!(heavy.least_axial_rate(below), 0.0);
    let still = heavy.steady_rates(below, 0.0).unwrap();
    let conical = (top.torque / (top.transverse * 0.6f64.cos())).sqrt();
    assert!((still.fast.unwrap().abs() / conical - 1.0).abs() < 1e-15);
    assert!((still.slow + still.fast.unwrap()).abs() < 1e-14);
    assert_eq!(heavy.steady_rates(0.6, 0.0), None);
    // The same hanging as a center below the pivot.
    let hung = HeavyTop::new(
        SymmetricTop::new(top.transverse, top.axial).unwrap(),
        -top.torque,
    );
    assert_eq!(
        (hung.least_axial_rate(0.6), hung.sleeping_axial_rate()),
        (0.0, 0.0)
    );
    let [a, b] = [
        hung.steady_rates(0.6, 50.0),
        heavy.steady_rates(below, -50.0),
    ]
    .map(Option::unwrap);
    assert!((a.slow - b.slow).abs() < 1e-14);
    // Level: one rate, to infinity with 1/Ω₃; none without spin.
    assert!(heavy.least_axial_rate(FRAC_PI_2) < 1e-6);
    assert_eq!(heavy.steady_rates(FRAC_PI_2, 0.0), None);
    assert_eq!(heavy.steady_rates(-FRAC_PI_2, 10.0).unwrap().fast, None);
    // Just off level: the fast one is far up, with the digits of the angle; the slow one where it was.
    let near = heavy.steady_rates(FRAC_PI_2 - 1e-12, axial_rate).unwrap();
    assert!((near.slow / (top.torque / (top.axial * axial_rate)) - 1.0).abs() < 1e-12);
    assert!(
        (near.fast.unwrap() / (top.axial * axial_rate / (top.transverse * 1e-12)) - 1.0).abs()
            < 1e-3
    );
    // Without weight: the free top, whose slow precession is none.
    let free = HeavyTop::new(SymmetricTop::new(0.0123, 0.0187).unwrap(), 0.0);
    let rates = SymmetricTop::new(0.0123, 0.0187).unwrap().rates(0.456, 0.5);
    let weightless = free.steady_rates(0.5, rates.axial).unwrap();
    assert_eq!(weightless.slow, 0.0);
    assert!((weightless.fast.unwrap() / rates.precession - 1.0).abs() < 5e-16);
    let rest = free.steady_rates(0.5, 0.0).unwrap();
    assert_eq!((rest.slow, rest.fast), (0.0, Some(0.0)));
    assert_eq!(free.steady_rates(FRAC_PI_2, 0.0).unwrap().fast, None);
}

/// A fast top: the slow root, 1e-16 of the fast one, keeps its digits.
#[test]
fn no_cancellation() {
    let (heavy, top, tilt, _) = m7();
    for decade in 3..14 {
        let axial_rate = 10f64.powi(decade);
        let [b, a] = [top.axial * axial_rate, top.transverse * tilt.cos()];
        // Ω = k/b + a k²/b³ + 2 a² k³/b⁵ + ..
        let [k, x] = [top.torque, a * top.torque / (b * b)];
        let series = k / b * (1.0 + x * (1.0 + x * (2.0 + x * (5.0 + x * 14.0))));
        let slow = heavy.steady_rates(tilt, axial_rate).unwrap().slow;
        // x = 5e-4 at 1000 rad/s: the next term is 42 x⁵.
        assert!((slow / series - 1.0).abs() < 1e-14, "{decade}");
    }
}

/// Above the threshold an upright top sleeps; below, it falls.
#[test]
fn sleeping() {
    let (heavy, top, ..) = m7();
    let widest = |factor: f64| {
        let angular_velocity = Vector3::z() * (heavy.sleeping_axial_rate() * factor);
        let mut state = Rotation {
            attitude: about_x(1e-4),
            angular_velocity,
        };
        let mut widest: f64 = 0.0;
        for _ in 0..300 {
            state = cf4(&top, &state, &(), 0.0..0.01, 20);
            widest = widest.max((state.attitude * Vector3::z()).xy().norm());
        }
        widest
    };
    // In linear terms: at 1.05 the amplitude from rest grows by 1/√(1 - 1.05⁻²) = 3.3, at 0.95 by a factor e in 0.3 s.
    assert!(widest(1.05) < 1e-3);
    assert!(widest(0.95) > 0.3);
}

/// H16: straight up and straight down, nothing is divided by sin θ.
#[test]
fn vertical() {
    let (heavy, top, _, axial_rate) = m7();
    for tilt in [0.0, 1e-300, 1e-12, PI] {
        let rates = heavy.steady_rates(tilt, axial_rate).unwrap();
        for rate in [rates.slow, rates.fast.unwrap()] {
            let motion = heavy.steady(tilt, axial_rate, rate);
            let [attitude, rates] = difference(&motion, &top, 0.5, 20_000);
            // Steps of 4 mrad: (4e-3)⁴/100 of 90 rad.
            assert!(
                attitude < 1e-9 && rates < 1e-7,
                "{tilt} {rate}: {attitude:e} {rates:e}"
            );
            assert!((motion.axial_rate() - axial_rate).abs() < 1e-13);
        }
    }
}

fn some_attitude() -> impl Strategy<Value = UnitQuaternion<f64>> {
    prop::array::uniform4(-1.0..1.0)
        .prop_map(|[w, x, y, z]| Quaternion::new(w, x, y, z))
        .prop_filter("of some length", |q| q.norm() > 0.1)
        .prop_map(UnitQuaternion::new_normalize)
}

fn some_vector() -> impl Strategy<Value = Vector3<f64>> {
    prop::array::uniform3(-3.0..3.0).prop_map(Vector3::from)
}

proptest! {
    /// Any attitude, any direction of the angular momentum: what is integrated, and both ways to start.
    #[test]
    fn any_free_top(start in some_attitude(), w in some_vector(), axial in 0.1..2.0) {
        let top = SymmetricTop::new(1.0, axial).unwrap();
        let state = Rotation { attitude: start, angular_velocity: w };
        let motion = top.free(&state);
        let begun = motion.at(0.0);
        prop_assert!(distance(&begun.attitude, &start) < 1e-15);
        prop_assert!((begun.angular_velocity - w).amax() < 1e-14);
        let integrated = Top { transverse: 1.0, axial, torque: 0.0 };
        let [attitude, rates] = difference(&motion, &integrated, 0.5, 250);
        // Steps of at most 10 mrad, 2.5 rad in all.
        prop_assert!(attitude < 1e-9 && rates < 1e-9);
        let momentum = start * Vector3::new(w.x, w.y, axial * w.z);
        let same = top.free_with_momentum(start, &momentum).at(2.0);
        prop_assert!(distance(&same.attitude, &motion.at(2.0).attitude) < 1e-13);
        prop_assert!((same.angular_velocity - motion.at(2.0).angular_velocity).amax() < 1e-12);
    }

    /// Both roots solve the equation, at every angle and spin that has them.
    #[test]
    fn any_heavy_top(tilt in 0.0..PI, spin in -50.0..50.0, torque in -3.0..3.0, axial in 0.1..2.0) {
        let heavy = HeavyTop::new(SymmetricTop::new(1.0, axial).unwrap(), torque);
        let [a, b] = [tilt.cos(), axial * spin];
        match heavy.steady_rates(tilt, spin) {
            None => prop_assert!(b * b < 4.0 * a * torque),
            Some(rates) => {
                prop_assert!(b * b >= 4.0 * a * torque * (1.0 - 1e-14));
                for rate in [Some(rates.slow), rates.fast].into_iter().flatten() {
                    let terms = [a * rate * rate, -b * rate, torque];
                    let size = terms.iter().fold(0.0f64, |size, term| size.max(term.abs()));
                    prop_assert!(terms.iter().sum::<f64>().abs() < 2e-15 * size);
                }
                prop_assert!(rates.fast.is_none_or(|fast| fast.abs() >= rates.slow.abs()));
            }
        }
    }
}
