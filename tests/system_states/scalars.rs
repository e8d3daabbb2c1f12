//! Systems over any scalar.

use newton_euler::integrate::{DormandPrince8, cf4_step, runge_kutta_step};
use newton_euler::private::generic;
use newton_euler::state::Coordinates;
use newton_euler::{Dual, Scalar};

use crate::lifted;
use crate::systems::{
    Assembly, AssemblyState, DoublePendulum, DoublePendulumInput, DoublePendulumState,
};

fn start<T: Scalar + From<f32>>() -> DoublePendulumState<T> {
    let hinge = |angle: f32, rate: f32| generic::Hinge {
        angle: T::from(angle),
        angular_velocity: T::from(rate),
    };
    DoublePendulumState {
        shoulder: hinge(1.5, 0.25),
        elbow: hinge(-0.5, 2.0),
    }
}

fn steps<T: Scalar + From<f32>>() -> DoublePendulumState<T> {
    let (body, input) = (
        DoublePendulum::<T>::default(),
        DoublePendulumInput::default(),
    );
    let [time, step] = [T::from(0.0), T::from(0.03125)];
    let stepped = runge_kutta_step::<DormandPrince8, _>(&body, time, &start(), &input, step);
    cf4_step(&body, time, &stepped, &input, step)
}

#[test]
fn single_precision() {
    let (single, double) = (steps::<f32>(), steps::<f64>());
    for (single, double) in single
        .coordinates()
        .0
        .into_iter()
        .zip(double.coordinates().0)
    {
        // some tens of roundings, of numbers of this size
        let size = double.abs().max(1.0) * f64::from(f32::EPSILON);
        assert!(
            (f64::from(single) - double).abs() < 64.0 * size,
            "{single} {double}"
        );
    }
    let mut assembly = AssemblyState::<f32>::default();
    let body = Assembly::<f32> { spin: 0.5 };
    for _ in 0..20 {
        assembly = runge_kutta_step::<DormandPrince8, _>(&body, 0.0, &assembly, &(), 0.125);
    }
    for attitude in [assembly.orbit.attitude, assembly.ball.attitude] {
        assert!((attitude.as_ref().norm() - 1.0).abs() < 1e-6);
    }
    assert!((assembly.needle.axis.norm() - 1.0).abs() < 1e-6);
    assert!(assembly.needle.axis.dot(&assembly.needle.axis_rate).abs() < 1e-5);
}

/// Derivatives of a step by the gravity, beside quotients of differences.
#[test]
fn derivatives() {
    type Derived = Dual<f64, 1>;
    let step = |gravity: f64| {
        let state = lifted();
        let body = DoublePendulum { gravity };
        let input = DoublePendulumInput::default();
        runge_kutta_step::<DormandPrince8, _>(&body, 0.0, &state, &input, 0.1)
    };
    let constant = |value: f64| Derived::default().constant(value, 0.0);
    let list = lifted().coordinates().0.map(constant);
    let state = DoublePendulumState::from_coordinates(&newton_euler::state::List(list));
    let gravity = Derived {
        value: 9.8,
        derivatives: [1.0],
    };
    let (time, length) = (constant(0.0), constant(0.1));
    let (body, input) = (DoublePendulum { gravity }, DoublePendulumInput::default());
    let derived = runge_kutta_step::<DormandPrince8, _>(&body, time, &state, &input, length);
    let off = 1e-3;
    let [more, less] = [step(9.8 + off), step(9.8 - off)].map(|state| state.coordinates().0);
    for (k, derived) in derived.coordinates().0.into_iter().enumerate() {
        assert_eq!(
            derived.value.to_bits(),
            step(9.8).coordinates().0[k].to_bits()
        );
        let quotient = (more[k] - less[k]) / (2.0 * off);
        assert!(
            (derived.derivatives[0] - quotient).abs() < 1e-9,
            "{derived:?} {quotient}"
        );
    }
}
