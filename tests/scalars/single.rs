//! Single precision.

use nalgebra::Vector3;
use newton_euler::state::generic;
use newton_euler::{Scalar, integrate, prelude::*};
use proptest::prelude::*;

use crate::{Craft, CraftInput, numbers, state};

proptest! {
    /// Results in single precision are those of doubles to a few units in the last place of the largest term.
    #[test]
    fn single_precision(numbers in numbers(), thrust in -5.0..9.0_f64, tilt in -1.0..1.0_f64) {
        // the same inputs to both
        #[expect(clippy::cast_possible_truncation, reason = "to single precision")]
        let numbers = numbers.map(|x| f64::from(x as f32));
        #[expect(clippy::cast_possible_truncation, reason = "to single precision")]
        let (thrust, tilt) = (thrust as f32, tilt as f32);
        let single = Craft::<f32>::default();
        let double = Craft::<f64>::default();
        let input = CraftInput { thrust: f64::from(thrust), tilt: f64::from(tilt) };
        let ours = single.acceleration(0.0, &state(numbers), &CraftInput { thrust, tilt });
        let exact = double.acceleration(0.0, &state(numbers), &input);
        let terms = 9.9 + f64::from(thrust.abs()) + 10.0;
        let close = |a: Vector3<f32>, b: Vector3<f64>, size: f64| (a.map(f64::from) - b).amax() <= 32.0 * f64::from(f32::EPSILON) * size;
        prop_assert!(close(ours.linear, exact.linear, terms), "{ours:?} {exact:?}");
        // over the smallest moment of inertia, and w x J w
        let terms = (0.17 * f64::from(thrust.abs()) + 0.3) / 0.012;
        prop_assert!(close(ours.angular, exact.angular, terms), "{ours:?} {exact:?}");
        let energy = single.kinetic_energy(&state(numbers));
        let exact = double.kinetic_energy(&state(numbers));
        prop_assert!((f64::from(energy) - exact).abs() <= 16.0 * f64::from(f32::EPSILON) * exact);
    }
}

rigid_body!(Tie::<T> {
    motion: translation,
    mass: 1[kg],
    // 2^-24 + 1e-20 above one: a double takes it for the middle between two numbers of single precision
    forces: [push = world(1.00000005960464478540, 0, 1e300)],
});

#[test]
fn constants_are_rounded_once() {
    let single = Tie::<f32>::default().acceleration(0.0, &generic::Translation::default(), &());
    assert_eq!(single, Vector3::new(1.0 + f32::EPSILON, 0.0, f32::INFINITY));
    let double = Tie::<f64>::default().acceleration(0.0, &Translation::default(), &());
    assert_eq!(double, Vector3::new(1.0 + 2.0_f64.powi(-24), 0.0, 1e300));
}

rigid_body!(Handle::<T> {
    motion: rotation,
    inertia: principal(1, 2, 3)[kg * m ^ 2],
    outputs: [energy, momentum],
});

/// Round-off in single precision grows with the square root of the steps.
#[test]
fn flips_in_single_precision() {
    let start = generic::Rotation::<f32> {
        angular_velocity: Vector3::new(0.01, 1.0, 0.01),
        ..generic::Rotation::default()
    };
    let handle = Handle::<f32>::default();
    let steps = 4000_u16;
    let end = integrate::cf4(&handle, &start, &(), 0.0..20.0, usize::from(steps));
    assert!(end.angular_velocity.y < -0.9, "it has flipped: {end:?}");
    let bound = 50.0 * f32::EPSILON * f32::from(steps).sqrt();
    let [before, after] = [start, end].map(|state| handle.kinetic_energy(&state));
    assert!((after / before - 1.0).abs() <= bound);
    let [before, after] = [start, end].map(|state| handle.angular_momentum(&state));
    assert!((after - before).amax() <= bound * before.amax());
    let q = end.attitude.as_ref().coords;
    assert!((q.dot(&q) - 1.0).abs() <= 4.0 * f32::EPSILON);
}

rigid_body!(Scaled::<T> {
    motion: rotation,
    params: [scale],
    inertia: tensor {
        xx: 1.3 * scale,
        yy: 1.7 * scale,
        zz: 2.1 * scale,
        xy: -0.12 * scale,
        yz: -0.05 * scale,
        zx: 0.07 * scale,
    },
    inputs: [torque = body(_, _, _)[N * m]],
    moments: [drive = torque],
});

/// The inverse of a tensor at any scale, to 1e-6 in single precision.
#[test]
fn inertias_of_any_scale() {
    let exact = {
        let body = Scaled::new(ScaledParams { scale: 1.0_f64 }).expect("a possible body");
        let torque = Vector3::new(0.3, -0.5, 0.7);
        body.acceleration(0.0, &Rotation::default(), &ScaledInput { torque })
    };
    for scale in [1e-30_f32, 1e-20, 1e-15, 1.0, 1e24, 1e30] {
        let body = Scaled::new(ScaledParams { scale }).expect("a possible body");
        let torque = Vector3::new(0.3, -0.5, 0.7) * scale;
        let still = generic::Rotation::default();
        let ours = body.acceleration(0.0, &still, &ScaledInput { torque });
        let error = (ours.map(f64::from) - exact).amax();
        assert!(error <= 1e-6 * exact.amax(), "{scale:e}: {error:e}");
    }
    let flat = Scaled::new(ScaledParams { scale: 0.0_f32 });
    assert!(flat.is_err() && Scaled::new(ScaledParams { scale: f32::NAN }).is_err());
}

/// The error of a result in single precision, in units of the last place of the exact one.
fn units_off(result: f32, exact: f64) -> f64 {
    #[expect(clippy::cast_possible_truncation, reason = "to single precision")]
    let near = (exact as f32).abs();
    let unit = f64::from(near.next_up()) - f64::from(near);
    (f64::from(result) - exact).abs() / unit
}

/// Sine and cosine in single precision are own code, without doubles: compared with those of doubles at angles of all sizes.
#[test]
fn sines_in_single_precision() {
    let mut worst = [0.0_f64; 3];
    let mut check = |place: usize, angle: f32| {
        let (sine, cosine) = Scalar::sin_cos(angle);
        let exact = f64::from(angle).sin_cos();
        let off = units_off(sine, exact.0).max(units_off(cosine, exact.1));
        worst[place] = worst[place].max(off);
        assert_eq!((Scalar::sin(angle), Scalar::cos(angle)), (sine, cosine));
        let opposite = Scalar::sin_cos(-angle);
        assert_eq!(
            (opposite.0.to_bits(), opposite.1),
            ((-sine).to_bits(), cosine),
            "{angle}"
        );
    };
    for bits in (0..100_f32.to_bits()).step_by(2003) {
        check(0, f32::from_bits(bits));
    }
    for bits in (100_f32.to_bits()..f32::INFINITY.to_bits()).step_by(2003) {
        check(1, f32::from_bits(bits));
    }
    // next to multiples of a quarter turn, where next to nothing is left
    for turns in (1..10_000_u32).chain((0..10_000).map(|k| 400_000 * k + 10_000)) {
        let exact = f64::from(turns) * std::f64::consts::FRAC_PI_2;
        #[expect(clippy::cast_possible_truncation, reason = "to single precision")]
        let near = exact as f32;
        for angle in [near.next_down(), near, near.next_up()] {
            check(2, angle);
        }
    }
    assert!(
        worst[0] < 0.8 && worst[1] < 0.85 && worst[2] < 0.85,
        "{worst:?}"
    );
    for angle in [f32::NAN, f32::INFINITY, f32::NEG_INFINITY] {
        let (sine, cosine) = Scalar::sin_cos(angle);
        assert!(sine.is_nan() && cosine.is_nan());
    }
}
