//! Free rotation in closed form: 40-digit references, conserved quantities, the group property and
//! symmetry, near a separatrix and far from it.
#![allow(clippy::float_cmp, reason = "what is exact is compared exactly")]

use crate::reference::turning::error;
use crate::reference::{self, attitude, number, numbers, trajectory, vector};
use newton_euler::exact::{FreeRotation, Path};
use newton_euler::nalgebra::{Matrix3, Quaternion, UnitQuaternion, Vector3};
use newton_euler::prelude::*;
use proptest::prelude::*;

/// Half a unit in the last place of one.
const ROUNDING: f64 = f64::EPSILON / 2.0;

fn turning(rates: [f64; 3]) -> Rotation {
    Rotation {
        attitude: UnitQuaternion::new_normalize(Quaternion::new(0.5, 0.5, -0.1, 0.7)),
        angular_velocity: rates.into(),
    }
}

fn free(moments: [f64; 3], state: &Rotation) -> FreeRotation {
    FreeRotation::principal(moments, &Matrix3::identity(), state)
}

#[test]
fn end_states_of_published_problems() {
    let problems = [
        ("symmetric_free", 2e-14),
        ("asymmetric_free", 2e-14),
        ("vanzon_schofield", 2e-14),
        ("dzhanibekov", 1e-13),
    ];
    for (name, floor) in problems {
        let problem = trajectory(name);
        let start = Rotation {
            attitude: attitude(&problem["q0"]),
            angular_velocity: vector(&problem["w0"]),
        };
        let [xx, yy, zz] = numbers(&problem["I"]);
        let inertia = InertiaTensor::principal(xx, yy, zz).unwrap();
        let time = number(&problem["T"]);
        let expected = Rotation {
            attitude: attitude(&problem["q_ref"]),
            angular_velocity: vector(&problem["w_ref"]),
        };
        let angle = start.angular_velocity.norm() * time;
        let error = error(&FreeRotation::new(&inertia, &start).at(time), &expected);
        assert!(error < floor + 4.0 * ROUNDING * angle, "{name}: {error:e}");
    }
}

#[test]
fn end_states_of_all_kinds_of_motion() {
    let cases = reference::turning::free();
    assert!(cases.len() > 60);
    for case in cases {
        let angle = case.start.angular_velocity.norm() * case.time.abs();
        let end = free(case.moments, &case.start).at(case.time);
        let error = error(&end, &case.end);
        assert!(
            error <= 2e-14 + 4.0 * ROUNDING * angle,
            "{}: {error:e}",
            case.name
        );
        // over a long time a step of 1e-9 of the inputs is not a small one
        if angle < 1e3 {
            let end_of = |moments, _, start: &_| free(moments, start).at(case.time);
            let bound = 4.0 * case.effect_of_one_ulp(end_of);
            assert!(error <= bound, "{}: {error:e} > {bound:e}", case.name);
            let turned = end.attitude.coords.dot(&case.end.attitude.coords);
            assert!(turned > 0.0, "{}: the sign of q jumps", case.name);
        }
    }
}

/// A billion seconds: phases lose no more than the rounding of their rates.
#[test]
fn long_times() {
    let long = reference::turning::free()
        .into_iter()
        .filter(|case| case.time > 1e5);
    let mut count = 0;
    for case in long {
        let angle = case.start.angular_velocity.norm() * case.time;
        let error = error(&free(case.moments, &case.start).at(case.time), &case.end);
        assert!(error < f64::EPSILON * angle, "{}: {error:e}", case.name);
        count += 1;
    }
    assert_eq!(count, 4);
}

/// H8 of the equations.
#[test]
fn periods_near_the_separatrix() {
    let periods = [
        (1e-2, 33.194_997_008_915_49),
        (1e-4, 65.109_084_209_575_28),
        (1e-6, 97.014_641_058_692_23),
        (1e-8, 128.920_196_017_516_1),
        (1e-10, 160.825_750_976_047_3),
        (1e-12, 192.731_305_934_578_5),
    ];
    for (d, period) in periods {
        let motion = free([1.0, 2.0, 3.0], &turning([d, 1.0, 2.0 * d]));
        let found = motion.period().unwrap();
        assert!((found / period - 1.0).abs() < 1e-15, "{d}: {found}");
    }
}

/// Energy and angular momentum, of a body with these principal moments.
fn conserved(moments: [f64; 3], state: &Rotation) -> (f64, Vector3<f64>) {
    let momentum = state
        .angular_velocity
        .component_mul(&Vector3::from(moments));
    (
        momentum.dot(&state.angular_velocity) / 2.0,
        state.attitude * momentum,
    )
}

fn moments() -> impl Strategy<Value = [f64; 3]> {
    // of three second moments: every possible body
    let second = prop_oneof![0.01..1.0, 1e-9..1e-6, Just(0.5)];
    [second.clone(), second.clone(), second]
        .prop_map(|[a, b, c]| [b + c, c + a, a + b])
        .prop_filter("a body that can turn", |moments| {
            let largest = moments.iter().fold(0.0, |a, b| f64::max(a, *b));
            moments.iter().all(|moment| *moment > 1e-6 * largest)
        })
}

fn rates() -> impl Strategy<Value = [f64; 3]> {
    let rate = prop_oneof![
        -2.0..2.0,
        -1e-8..1e-8,
        -1e-160..1e-160,
        Just(0.0),
        Just(1.0)
    ];
    [rate.clone(), rate.clone(), rate]
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(2000))]

    #[test]
    fn energy_and_angular_momentum_are_kept(moments in moments(), rates in rates(), time in -100.0..100.0) {
        let start = turning(rates);
        let end = free(moments, &start).at(time);
        let ((before, momentum), (after, turned)) = (conserved(moments, &start), conserved(moments, &end));
        prop_assert!((after - before).abs() <= 4e-15 * before, "{before} {after}");
        prop_assert!((turned - momentum).norm() <= 4e-15 * momentum.norm(), "{momentum} {turned}");
        prop_assert!((end.attitude.norm() - 1.0).abs() < 4e-16);
    }

    #[test]
    fn nothing_moves_in_no_time(moments in moments(), rates in rates()) {
        let start = turning(rates);
        let end = free(moments, &start).at(0.0);
        prop_assert!(error(&end, &start) < 4e-15, "{end:?}");
    }

    /// The axes may be named in any order, with any signs: the motion is the same to rounding.
    #[test]
    fn the_order_of_axes_does_not_matter(moments in moments(), rates in [-2.0..2.0, -2.0..2.0, -2.0..2.0], time in -5.0..5.0) {
        let start = turning(rates);
        let end = free(moments, &start).at(time);
        for axes in [
            Matrix3::new(0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 1.0, 0.0, 0.0),
            Matrix3::new(0.0, 1.0, 0.0, -1.0, 0.0, 0.0, 0.0, 0.0, 1.0),
            Matrix3::new(0.0, 0.0, -1.0, 0.0, -1.0, 0.0, -1.0, 0.0, 0.0),
            Matrix3::new(-1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 1.0, 0.0),
        ] {
            prop_assert_eq!(axes.determinant(), 1.0);
            let along = axes.abs().tr_mul(&Vector3::from(moments));
            let other = FreeRotation::principal(along.into(), &axes, &start).at(time);
            prop_assert!(error(&other, &end) < 1e-12, "{other:?} {end:?}");
        }
    }

    #[test]
    fn two_motions_are_one(moments in moments(), rates in [-2.0..2.0, -2.0..2.0, -2.0..2.0], first in -9.0..9.0, second in -9.0..9.0) {
        let start = turning(rates);
        let between = free(moments, &start).at(first);
        let (halting, straight) = (free(moments, &between).at(second), free(moments, &start).at(first + second));
        // what rounding of the state between moves: see the conditioning above
        let angle = start.angular_velocity.norm() * (f64::abs(first) + f64::abs(second));
        prop_assert!(error(&halting, &straight) < 1e-10 * (1.0 + angle), "{halting:?} {straight:?}");
    }
}

/// Any scale of moments and rates, and time in the unit that goes with it, to the bit.
#[test]
fn any_scale() {
    let (moments, start, time) = ([0.6, 0.8, 1.0], turning([3.0, 0.5, -0.9]), 10.0);
    let expected = free(moments, &start).at(time);
    for exponent in [-498, -40, 41, 498] {
        let scale = 2.0_f64.powi(exponent);
        let fast = Rotation {
            angular_velocity: start.angular_velocity * scale,
            ..start
        };
        for heavy in [moments, moments.map(|moment| moment / scale)] {
            let end = free(heavy, &fast).at(time / scale);
            assert_eq!(end.attitude, expected.attitude);
            assert_eq!(end.angular_velocity / scale, expected.angular_velocity);
        }
    }
}

/// What is zero stays so: no rounding may begin a flip (H8b).
#[test]
fn about_a_principal_axis_nothing_begins_to_wobble() {
    for axis in 0..3 {
        let mut rates = [0.0; 3];
        rates[axis] = 1.5;
        let start = Rotation {
            angular_velocity: rates.into(),
            ..Rotation::default()
        };
        let motion = free([1.0, 2.0, 3.0], &start);
        assert_eq!(motion.period(), None);
        for time in [0.0, 1.0, -7.5, 1e6, 1e9] {
            let state = motion.at(time);
            assert_eq!(state.angular_velocity, start.angular_velocity);
            let [x, y, z] = state.attitude.imag().into();
            let others: Vec<f64> = (0..3)
                .filter(|k| *k != axis)
                .map(|k| [x, y, z][k])
                .collect();
            assert_eq!(others, [0.0, 0.0]);
            let half = 0.75 * time;
            assert!((state.attitude.w - f64::cos(half)).abs() < 1e-15);
        }
    }
}

#[test]
fn a_symmetric_body_keeps_its_spin_exactly() {
    let start = turning([0.4, 0.1, 3.0]);
    for (moments, axis) in [
        ([2.0, 2.0, 1.0], 2),
        ([1.0, 2.0, 2.0], 0),
        ([2.0, 1.0, 2.0], 1),
    ] {
        let motion = free(moments, &start);
        let spin = start.angular_velocity[axis];
        for time in [0.3, -20.0, 1e9] {
            assert_eq!(motion.at(time).angular_velocity[axis], spin);
        }
        let nearly = free([moments[0], moments[1], moments[2] * (1.0 + 1e-13)], &start);
        assert!(error(&nearly.at(5.0), &motion.at(5.0)) < 1e-11);
    }
}

/// The axes of the tensor may lie anywhere in the body.
#[test]
fn tilted_axes() {
    let tilt = UnitQuaternion::from_euler_angles(0.3, -0.8, 1.9);
    let moments = [0.6, 0.8, 1.0];
    let inertia = InertiaTensor::principal(0.6, 0.8, 1.0)
        .unwrap()
        .rotated(&tilt);
    let plain = turning([3.0, 0.5, -0.9]);
    let tilted = Rotation {
        attitude: plain.attitude * tilt.inverse(),
        angular_velocity: tilt * plain.angular_velocity,
    };
    let motion = FreeRotation::new(&inertia, &tilted);
    for time in [-30.0, 0.0, 12.5] {
        let expected = free(moments, &plain).at(time);
        let expected = Rotation {
            attitude: expected.attitude * tilt.inverse(),
            angular_velocity: tilt * expected.angular_velocity,
        };
        assert!(error(&motion.at(time), &expected) < 1e-13);
    }
    let spun = FreeRotation::symmetric([0.8, 1.0], tilt * Vector3::z_axis(), &tilted);
    let expected = free([0.8, 0.8, 1.0], &plain).at(4.0);
    assert!((spun.at(4.0).angular_velocity - tilt * expected.angular_velocity).norm() < 1e-14);
}

/// On the separatrix the body comes to turn about its intermediate axis, and does so for ever.
#[test]
fn the_separatrix_is_left_on_neither_side() {
    // I₃ (I₃ - I₂) ω₃² = I₁ (I₂ - I₁) ω₁², exactly
    let moments = [1.0, 2.0, 2.25];
    let start = turning([0.75, 0.5, 1.0]);
    let motion = free(moments, &start);
    assert_eq!(motion.period(), None);
    let (energy, momentum) = conserved(moments, &start);
    let fast = momentum.norm() / 2.0;
    let [before, after] = [-1e4, 1e4].map(|time| motion.at(time).angular_velocity.y / fast);
    assert!((before + after).abs() < 1e-15 && (after.abs() - 1.0).abs() < 1e-15);
    for time in [-1e4, 1e4] {
        let end = motion.at(time);
        let [w1, _, w3] = end.angular_velocity.into();
        assert_eq!((w1, w3), (0.0, 0.0));
        let (kept, direction) = conserved(moments, &end);
        assert!((kept - energy).abs() < 1e-15 * energy);
        assert!((direction - momentum).norm() < 2e-15 * momentum.norm());
    }
}

/// Numbers that are no motion give no motion, and return.
#[test]
fn not_a_number() {
    for bad in [f64::NAN, f64::INFINITY, -f64::INFINITY] {
        for place in 0..3 {
            let mut rates = [1.0, -2.0, 0.5];
            rates[place] = bad;
            let end = free([1.0, 2.0, 2.5], &turning(rates)).at(1.0);
            assert!(!end.angular_velocity.norm().is_finite());
        }
        let end = free([1.0, 2.0, 2.5], &turning([1.0, -2.0, 0.5])).at(bad);
        assert!(end.angular_velocity.x.is_nan());
    }
}

/// Rates that are lost in underflow beside the one about the intermediate axis leave a steady spin.
#[test]
fn almost_nothing_beside_the_intermediate_axis() {
    for moments in [[1.1, 2.3, 2.9], [2.9, 2.3, 1.1], [1.0, 1.000_1, 1.5]] {
        for small in [5e-324, 2e-323, 1e-318, 1e-310, 1e-307, 1e-290] {
            for [x, z] in [[small, 0.0], [0.0, small], [small, small], [-small, small]] {
                for y in [1.0, -30.0] {
                    let start = turning([x, y, z]);
                    for time in [0.0, 0.5, 3.0] {
                        let axis = Vector3::new(0.0, y * time, 0.0);
                        let turned = start.attitude * UnitQuaternion::from_scaled_axis(axis);
                        let end = free(moments, &start).at(time);
                        let off = end.angular_velocity - start.angular_velocity;
                        assert!(off.norm() < 1e-14 * y.abs(), "{x:e} {y} {z:e}");
                        let angle = (end.attitude.inverse() * turned).imag().norm();
                        assert!(angle < 1e-13, "{x:e} {y} {z:e}: {angle:e}");
                    }
                }
            }
        }
    }
}
