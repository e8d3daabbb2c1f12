//! The dual numbers of the crate `num-dual`.

use newton_euler::scalar::NumDual;
use newton_euler::state::generic;
use newton_euler::{Dual, Scalar, prelude::*};
use num_dual::{Dual2_64, Dual64};

use crate::{Craft, CraftInput, Derived, state};

/// The numbers of another crate give the derivatives of ours, and second ones that ours give when nested.
#[test]
fn numbers_of_num_dual() {
    /// Lists the numbers of an acceleration.
    fn list<T: Scalar>(acceleration: generic::SpatialAcceleration<T>) -> [T; 6] {
        let ([a, b, c], [x, y, z]) = (acceleration.linear.into(), acceleration.angular.into());
        [a, b, c, x, y, z]
    }

    /// The acceleration of a craft whose first velocity and tilt are given.
    fn accelerated<T: Scalar>(speed: T, tilt: T, time: T) -> [T; 6] {
        let mut state = state::<T>([
            0.3, -0.2, -0.4, 0.0, 0.7, -1.1, 0.4, 0.2, -0.6, 0.1, 0.5, -0.3, 0.8,
        ]);
        state.velocity.x = speed;
        let thrust = time.constant(4.0, 4.0);
        list(Craft::<T>::default().acceleration(time, &state, &CraftInput { thrust, tilt }))
    }

    type Twice = Dual<Dual<f64, 1>, 1>;
    let close = |one: f64, other: f64| (one - other).abs() <= 1e-13 * (1.0 + other.abs());
    let theirs = accelerated(
        NumDual(Dual64::from_re(1.3).derivative()),
        NumDual(Dual64::from(0.4)),
        NumDual::default(),
    );
    let ours = accelerated::<Derived>(Dual::variable(1.3, 0), Dual::from(0.4), Dual::from(0.0));
    for (theirs, ours) in theirs.iter().zip(ours) {
        assert!(close(theirs.0.re, ours.value) && close(theirs.0.eps, ours.derivatives[0]));
    }
    let second = accelerated(
        NumDual(Dual2_64::from_re(1.3).derivative()),
        NumDual(Dual2_64::from(0.4)),
        NumDual::default(),
    );
    let mut speed = Twice::variable(Dual::variable(1.3, 0), 0);
    speed.derivatives[0] = Dual::from(1.0);
    let ours = accelerated::<Twice>(speed, Dual::from(Dual::from(0.4)), Dual::default());
    for (theirs, ours) in second.iter().zip(ours) {
        assert!(
            close(theirs.0.v2, ours.derivatives[0].derivatives[0]),
            "{theirs:?} {ours:?}"
        );
    }
    // the functions that are not that crate's own
    let x = |value: f64| NumDual(Dual64::from_re(value).derivative());
    let parts = |number: NumDual<Dual64>| (number.0.re, number.0.eps);
    assert_eq!(parts(x(-2.0).abs()), (2.0, -1.0));
    assert_eq!(parts(x(-2.5).floor()), (-3.0, 0.0));
    assert_eq!(parts(x(-2.5).signum()), (-1.0, 0.0));
    for size in [1.0, 1e200] {
        let (length, slope) = parts(x(3.0 * size).hypot(NumDual(Dual64::from(4.0 * size))));
        assert!(close(length / size, 5.0) && close(slope, 0.6));
    }
    assert_eq!(
        parts(x(-2.0).powf(NumDual(Dual64::from(3.0)))),
        (-8.0, 12.0)
    );
    assert_eq!(parts(x(2.0).min(NumDual(Dual64::from(3.0)))), (2.0, 1.0));
    assert_eq!(parts(x(2.0).max(NumDual(Dual64::from(3.0)))), (3.0, 0.0));
    assert_eq!(
        parts(x(f64::NAN).max(NumDual(Dual64::from(3.0)))),
        (3.0, 0.0)
    );
}

/// Angles have slopes on both axes, where one quotient of the sides is infinite.
#[test]
fn angles_all_around() {
    let places = [-2.0, -0.3, 0.0, 0.3, 2.0];
    for (y, x) in places.into_iter().flat_map(|y| places.map(|x| (y, x))) {
        if y == 0.0 && x == 0.0 {
            continue;
        }
        for index in 0..2 {
            let number = |value: f64, number: usize| {
                let plain = Dual64::from_re(value);
                NumDual(if number == index {
                    plain.derivative()
                } else {
                    plain
                })
            };
            let theirs = number(y, 0).atan2(number(x, 1)).0;
            let slope = [x, -y][index] / (x * x + y * y);
            assert!((theirs.re - y.atan2(x)).abs() < 1e-15, "{y} {x} {theirs}");
            assert!((theirs.eps - slope).abs() < 1e-15, "{y} {x} {theirs}");
        }
    }
}
