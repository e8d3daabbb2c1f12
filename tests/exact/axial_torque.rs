//! A constant couple along the axis of a symmetric body, in closed form: 25-digit references, the
//! group property, limits, axes and scales.
#![allow(clippy::float_cmp, reason = "what is exact is compared exactly")]

use crate::reference::turning::{Turning, axial_torques, error};
use newton_euler::exact::{AxialTorque, FreeRotation, Path};
use newton_euler::nalgebra::{Quaternion, UnitQuaternion, Vector3};
use newton_euler::prelude::*;
use proptest::prelude::*;

/// Half a unit in the last place of one.
const ROUNDING: f64 = f64::EPSILON / 2.0;

fn path(case: &Turning<2>) -> AxialTorque {
    stage(case.moments, case.drive, &case.start)
}

/// The angle turned, by the rate of spin and the length of the rest.
fn angle(case: &Turning<2>) -> f64 {
    let w = case.start.angular_velocity;
    let (across, part) = (w.xy().norm(), case.time / 1024.0);
    let rate = |k: u32| {
        let time = part * (f64::from(k) + 0.5);
        across.hypot(w.z + case.drive / case.moments[1] * time)
    };
    (0..1024).map(rate).sum::<f64>() * part.abs()
}

/// One rounding for each radian, and no more than four times the effect of one ulp.
#[test]
fn end_states_of_all_kinds_of_motion() {
    let cases = axial_torques();
    assert!(cases.len() > 80);
    for case in cases {
        let end = path(&case).at(case.time);
        let error = error(&end, &case.end);
        let bound = 4e-15 + ROUNDING * angle(&case);
        assert!(error <= bound, "{}: {error:e} > {bound:e}", case.name);
        let end_of = |moments, torque, start: &_| stage(moments, torque, start).at(case.time);
        let bound = 4.0 * case.effect_of_one_ulp(end_of);
        assert!(error <= bound, "{}: {error:e} > {bound:e}", case.name);
        let turned = end.attitude.coords.dot(&case.end.attitude.coords);
        assert!(turned > 0.0, "{}: the sign of q jumps", case.name);
    }
}

fn stage(moments: [f64; 2], torque: f64, start: &Rotation) -> AxialTorque {
    AxialTorque::new(moments, Vector3::z_axis(), torque, start)
}

/// Any attitude; a wobble, and a spin, of any size beside that which the torque gives in a radian.
fn starts() -> impl Strategy<Value = Rotation> {
    let part = || -1.0..1.0_f64;
    let size = || {
        prop_oneof![
            Just(0.0),
            -20.0..20.0_f64,
            (-9.0..2.0_f64).prop_map(|size| 10.0_f64.powf(size))
        ]
    };
    (part(), part(), part(), size(), size(), -4.0..4.0_f64).prop_map(
        |(x, y, z, across, spin, heading)| Rotation {
            attitude: UnitQuaternion::new_normalize(Quaternion::new(0.3, x, y, z)),
            angular_velocity: Vector3::new(across * heading.cos(), across * heading.sin(), spin),
        },
    )
}

/// Along the axis and about it, moments that a body can have.
fn shapes() -> impl Strategy<Value = [f64; 2]> {
    (0.5..2.0_f64, prop_oneof![0.01..2.0_f64, Just(1.0)])
        .prop_map(|(across, share)| [across, across * share])
}

/// What rounding leaves, for a body that turned this long: of its rates and of the angle.
fn rounding(start: &Rotation, moments: [f64; 2], torque: f64, time: f64) -> f64 {
    let gained = torque.abs() / moments[1].min(moments[0]) * time.abs();
    4e-14 + 8.0 * f64::EPSILON * (start.angular_velocity.norm() + gained) * time.abs()
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(1000))]

    /// The way there in two parts, and the way back.
    #[test]
    fn two_motions_are_one(
        start in starts(), moments in shapes(), torque in -2.0..2.0_f64, first in -20.0..20.0_f64, second in -20.0..20.0_f64,
    ) {
        let halt = stage(moments, torque, &start).at(first);
        let end = stage(moments, torque, &halt).at(second);
        let expected = stage(moments, torque, &start).at(first + second);
        let long = rounding(&start, moments, torque, first.abs() + second.abs());
        // an ulp of the spin at the halt is one of the angle times the rate
        prop_assert!((end.attitude.coords - expected.attitude.coords).amax() < 8.0 * long);
        let size = start.angular_velocity.norm() + halt.angular_velocity.norm();
        prop_assert!((end.angular_velocity - expected.angular_velocity).amax() < 8.0 * long * (1.0 + size));
        let back = stage(moments, torque, &halt).at(-first);
        prop_assert!((back.attitude.coords - start.attitude.coords).amax() < 8.0 * long);
        let still = stage(moments, torque, &start).at(0.0);
        prop_assert!((still.attitude.coords - start.attitude.coords).amax() < 2e-15);
        prop_assert!((still.angular_velocity - start.angular_velocity).amax() <= 2e-16 * size);
    }

    /// The angular velocity across the axis keeps its length; that along it is linear in time.
    #[test]
    fn what_the_torque_leaves(start in starts(), moments in shapes(), torque in -2.0..2.0_f64, time in -1e4..1e4_f64) {
        let end = stage(moments, torque, &start).at(time);
        let [before, after] = [&start, &end].map(|state| state.angular_velocity.xy().norm());
        prop_assert!((after - before).abs() <= 1e-15 * before);
        prop_assert_eq!(end.angular_velocity.z, start.angular_velocity.z + torque / moments[1] * time);
    }

    /// Without a torque it precesses steadily, and with hardly any.
    #[test]
    fn a_torque_that_vanishes(start in starts(), moments in shapes(), exponent in -300.0..-16.0_f64, time in -20.0..20.0_f64) {
        let free = FreeRotation::symmetric(moments, Vector3::z_axis(), &start).at(time);
        prop_assert_eq!(stage(moments, 0.0, &start).at(time), free);
        let torque = 10.0_f64.powf(exponent);
        let end = stage(moments, torque, &start).at(time);
        // it turns by as much as the torque makes of it
        let turned = 400.0 * torque / moments[1].min(moments[0]);
        let bound = rounding(&start, moments, 0.0, time) + turned;
        prop_assert!((end.attitude.coords - free.attitude.coords).amax() < bound);
    }

    /// The axis may lie anywhere in the body, either way round, and the world be turned.
    #[test]
    fn any_axes(start in starts(), body in starts(), world in starts(), moments in shapes(), torque in -2.0..2.0_f64, time in -9.0..9.0_f64) {
        let [body, world] = [body.attitude, world.attitude];
        let moved = Rotation {
            attitude: world * start.attitude * body.inverse(),
            angular_velocity: body * start.angular_velocity,
        };
        let plain = stage(moments, torque, &start).at(time);
        let expected = world * plain.attitude * body.inverse();
        let bound = 100.0 * rounding(&start, moments, torque, time);
        let axis = body * Vector3::z_axis();
        for (axis, torque) in [(axis, torque), (-axis, -torque)] {
            let end = AxialTorque::new(moments, axis, torque, &moved).at(time);
            prop_assert!((end.attitude.coords - expected.coords).amax() < bound);
            let expected = body * plain.angular_velocity;
            prop_assert!((end.angular_velocity - expected).amax() < bound * (1.0 + expected.norm()));
        }
    }

    /// Rates of any power of two give the same digits.
    #[test]
    fn any_scale(start in starts(), moments in shapes(), torque in 0.1..2.0_f64, exponent in -200..200, time in -9.0..9.0_f64) {
        let factor = 2.0_f64.powi(exponent);
        let faster = Rotation { angular_velocity: start.angular_velocity * factor, ..start };
        let end = stage(moments, torque * factor * factor, &faster).at(time / factor);
        let plain = stage(moments, torque, &start).at(time);
        let bound = 10.0 * rounding(&start, moments, torque, time);
        prop_assert!((end.attitude.coords - plain.attitude.coords).amax() < bound);
    }
}

/// About its axis the body turns by `r t + N t²/2C`, and what is zero stays zero.
#[test]
fn without_a_wobble() {
    let start = Rotation {
        angular_velocity: Vector3::new(0.0, 0.0, -3.0),
        ..Rotation::default()
    };
    for (time, angle) in [(4.0, -10.0), (24.0, 0.0), (-1.0, 3.125)] {
        let end = stage([2.0, 1.0], 0.25, &start).at(time);
        let expected: [f64; 2] = [(0.5_f64 * angle).cos(), (0.5_f64 * angle).sin()];
        assert!((end.attitude.w - expected[0]).abs() < 2e-16);
        assert!((end.attitude.k - expected[1]).abs() < 2e-16);
        assert_eq!((end.attitude.i, end.attitude.j), (0.0, 0.0));
        let expected = Vector3::new(0.0, 0.0, -3.0 + 0.25 * time);
        assert_eq!(end.angular_velocity, expected);
    }
}

/// L. Landau and C. Zener: from far on one side to far on the other, the axis stays with what it was along with the probability
/// `exp(-π w²/2b)`: the cosine of the angle between the axes that are left and found is `2 exp(-π w²/2b) - 1`.
#[test]
fn from_one_spin_to_the_other() {
    for across in [0.1, 0.5, 1.0, 2.0, 4.0_f64] {
        let spin = 3e7;
        let start = Rotation {
            angular_velocity: Vector3::new(across, 0.0, -spin),
            ..Rotation::default()
        };
        let end = stage([1.0, 1.0], 1.0, &start).at(2.0 * spin);
        let expected = 2.0 * (-core::f64::consts::FRAC_PI_2 * across * across).exp() - 1.0;
        let cosine = (end.attitude * Vector3::z()).z;
        assert!(
            (cosine - expected).abs() < 8.0 * across / spin,
            "{across}: {cosine} {expected}"
        );
    }
}

/// What no body has gives what is no number, and no panic.
#[test]
fn no_numbers() {
    let extremes = [0.0, -1.0, 1e-320, 1e308, f64::INFINITY, f64::NAN];
    for x in extremes {
        for y in extremes {
            for z in extremes {
                let start = Rotation {
                    angular_velocity: Vector3::new(x, 0.0, y),
                    ..Rotation::default()
                };
                let path = stage([1.0, 0.5], z, &start);
                for time in extremes {
                    let end = path.at(time);
                    let norm = end.attitude.coords.norm();
                    assert!(!(norm - 1.0).abs().gt(&1e-14), "{x} {y} {z} {time}: {norm}");
                }
            }
        }
    }
}
