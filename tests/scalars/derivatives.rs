//! Dual numbers.

use nalgebra::Vector3;
use newton_euler::state::generic;
use newton_euler::{Dual, Scalar, prelude::*};
use proptest::prelude::*;

use crate::{Craft, CraftInput, Derived, numbers, state};

proptest! {
    /// Derivatives by dual numbers are the limits of differences.
    #[test]
    fn derivatives(numbers in numbers(), thrust in 0.6..6.0_f64, tilt in -1.0..1.0_f64, variable in 0_usize..9) {
        let evaluate = |change: f64| {
            let mut numbers = numbers;
            numbers[variable] += change;
            Craft::<f64>::default().acceleration(0.0, &state(numbers), &CraftInput { thrust, tilt })
        };
        let step = 1e-6;
        prop_assume!(variable != 2 || numbers[2].abs() > 2.0 * step);
        let difference = (evaluate(step).linear - evaluate(-step).linear) / (2.0 * step);
        let turning = (evaluate(step).angular - evaluate(-step).angular) / (2.0 * step);

        let mut state = state::<Derived>(numbers);
        let part = match variable / 3 {
            0 => &mut state.position,
            1 => &mut state.velocity,
            _ => &mut state.angular_velocity,
        };
        part[variable % 3] = Dual::variable(numbers[variable], 0);
        let input = CraftInput { thrust: thrust.into(), tilt: tilt.into() };
        let derived = Craft::<Derived>::default().acceleration(0.0.into(), &state, &input);
        let linear = derived.linear.map(|component| component.derivatives[0]);
        let angular = derived.angular.map(|component| component.derivatives[0]);
        prop_assert!((linear - difference).amax() < 1e-7, "{linear} {difference}");
        prop_assert!((angular - turning).amax() < 1e-6, "{angular} {turning}");
        let plain = evaluate(0.0);
        prop_assert_eq!(derived.linear.map(|component| component.value), plain.linear);
        prop_assert_eq!(derived.angular.map(|component| component.value), plain.angular);
    }
}

/// Elementary functions of dual numbers, by their differences.
#[test]
fn slopes_of_functions() {
    type D = Derived;
    type Function = (fn(D) -> D, fn(f64) -> f64);
    type Pair = (
        fn(Dual<f64, 2>, Dual<f64, 2>) -> Dual<f64, 2>,
        fn(f64, f64) -> f64,
    );
    let functions: [Function; 15] = [
        (D::sin, f64::sin),
        (D::cos, f64::cos),
        (D::tan, f64::tan),
        (D::asin, f64::asin),
        (D::acos, f64::acos),
        (D::atan, f64::atan),
        (D::sinh, f64::sinh),
        (D::cosh, f64::cosh),
        (D::tanh, f64::tanh),
        (D::exp, f64::exp),
        (D::ln, f64::ln),
        (D::sqrt, f64::sqrt),
        (D::cbrt, f64::cbrt),
        (|x| -x.abs() / (x + D::from(2.0)), |x| -x.abs() / (x + 2.0)),
        (
            |x| x.floor() * x.ceil() * x.signum() * x,
            |x| x.floor() * x.ceil() * x,
        ),
    ];
    let step = 1e-6;
    for (index, (ours, plain)) in functions.into_iter().enumerate() {
        for x in [0.1, 0.35, 0.8] {
            let slope = (plain(x + step) - plain(x - step)) / (2.0 * step);
            let dual = ours(D::variable(x, 0));
            assert!((dual.value - plain(x)).abs() < 1e-15, "{index} at {x}");
            assert!(
                (dual.derivatives[0] - slope).abs() < 1e-8,
                "{index} at {x}: {slope}"
            );
        }
    }
    let pairs: [Pair; 5] = [
        (Dual::atan2, f64::atan2),
        (Dual::powf, f64::powf),
        (Dual::hypot, f64::hypot),
        (Dual::min, f64::min),
        (Dual::max, f64::max),
    ];
    for (index, (ours, plain)) in pairs.into_iter().enumerate() {
        for (x, y) in [(0.3, 0.8), (2.5, -1.5)] {
            let dual = ours(Dual::variable(x, 0), Dual::variable(y, 1));
            let slopes = [
                (plain(x + step, y) - plain(x - step, y)) / (2.0 * step),
                (plain(x, y + step) - plain(x, y - step)) / (2.0 * step),
            ];
            for (slope, derivative) in slopes.into_iter().zip(dual.derivatives) {
                assert!(
                    (derivative - slope).abs() < 1e-8,
                    "{index} at {x}, {y}: {slope}"
                );
            }
        }
    }
    // a negative base under a constant exponent
    let cube = D::variable(-2.0, 0).powf(D::from(3.0));
    assert!((cube.derivatives[0] - 12.0).abs() < 1e-14);
}

/// Derivatives of derivatives.
#[test]
fn second_derivatives() {
    type Second = Dual<Dual<f64, 1>, 1>;
    let x = Second {
        value: Dual::variable(0.7, 0),
        derivatives: [Dual::from(1.0)],
    };
    let cube = (x * x * x).derivatives[0].derivatives[0];
    assert!((cube - 6.0 * 0.7).abs() < 1e-15);
    // (1 + u^2)^(3/2) at the bottom, by power and by root
    let u = Second {
        value: Dual::variable(0.0, 0),
        derivatives: [Dual::from(1.0)],
    };
    let one = Second::from(Dual::from(1.0));
    let (square, power) = (one + u * u, Second::from(Dual::from(1.5)));
    for bowl in [square.powf(power), square * square.sqrt()] {
        assert!(
            (bowl.derivatives[0].derivatives[0] - 3.0).abs() < 1e-15,
            "{bowl:?}"
        );
    }
}

/// Quadratic drag has no slope at rest, and a length of nothing none either.
#[test]
fn derivatives_at_rest() {
    let still = generic::Spatial::<Derived> {
        velocity: Vector3::new(
            Dual::from(2.0) + Derived::variable(0.0, 0),
            Dual::from(0.5),
            Dual::from(-0.3),
        ),
        ..generic::Spatial::default()
    };
    let input = CraftInput {
        thrust: 1.0.into(),
        tilt: 0.0.into(),
    };
    let acceleration = Craft::default().acceleration(0.0.into(), &still, &input);
    assert_eq!(
        acceleration.linear.map(|a| a.derivatives[0]),
        Vector3::zeros()
    );
    let [zero, length] = [
        Derived::from(0.0),
        Derived::from(0.0).hypot(Derived::from(0.0)),
    ];
    assert_eq!([zero.sqrt().derivatives, length.derivatives], [[0.0]; 2]);
}

/// A power of zero does not change with its exponent, nor a power to nothing with its base; a
/// length of nothing has a slope of zero, as in a linearization.
#[test]
#[allow(clippy::float_cmp, reason = "all are exact")]
fn powers_and_lengths_of_nothing() {
    type D = Dual<f64, 2>;
    let base = D::variable(0.0, 0);
    let exponent = |value| D::variable(value, 1);
    assert_eq!(base.powf(exponent(2.0)).derivatives, [0.0, 0.0]);
    assert_eq!(base.powf(exponent(1.0)).derivatives, [1.0, 0.0]);
    assert_eq!(base.powf(D::from(0.0)).derivatives, [0.0, 0.0]);
    let line = Dual {
        value: D::variable(0.0, 0),
        derivatives: [D::from(1.0)],
    };
    let straight = line.powf(Dual::from(D::from(1.0)));
    assert_eq!(straight.derivatives[0].derivatives, [0.0, 0.0]);
    for length in [base.hypot(D::variable(0.0, 1)), base.hypot(D::from(0.0))] {
        assert_eq!((length.value, length.derivatives), (0.0, [0.0, 0.0]));
        assert_eq!((length * base).derivatives, [0.0, 0.0]);
    }
}
