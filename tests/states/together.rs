//! Many bodies at once: each moves as if alone, bit for bit.

use newton_euler::ensemble::{Ensemble, OneByOne};
use newton_euler::integrate::{DormandPrince, DormandPrince8, Fixed, TaylorSeries};
use newton_euler::prelude::*;

use crate::bodies::{Arms, ArmsInput, ArmsState, Drone, DroneInput, DroneState};

#[test]
fn drones() {
    let drone = Drone::default();
    let start = |k: u32| DroneState {
        motion: Spatial {
            velocity: [0.1 * f64::from(k), -0.2, 0.4].into(),
            angular_velocity: [0.5, 0.1 * f64::from(k), -1.1].into(),
            ..Spatial::default()
        },
        speed_1: 300.0 + f64::from(k),
        speed_2: 310.0 - f64::from(k),
    };
    let input = DroneInput {
        command_1: 325.0,
        command_2: 319.0,
    };
    let mut ensemble = Ensemble::new(&drone, (0..13).map(start));
    for k in 0..13 {
        ensemble.inputs_mut().set(k, &input);
    }
    let steps = Fixed {
        method: DormandPrince8,
        step: 0.02,
    };
    let tolerance = 1e-10;
    let (series, pairs) = (TaylorSeries { tolerance }, DormandPrince { tolerance });
    let [mut by_series, mut by_pairs] = [ensemble.clone(), ensemble.clone()];
    let one_by_one = by_series.integrate().method(OneByOne(series));
    one_by_one.to(1.0).unwrap();
    by_pairs.integrate().method(pairs).to(1.0).unwrap();
    ensemble.integrate().method(steps).to(1.0).unwrap();
    for k in 0..13 {
        let index = usize::try_from(k).unwrap();
        let alone = drone.integrate(&start(k)).input(input).method(steps);
        assert!(ensemble.state(index) == alone.to(1.0).unwrap(), "{k}");
        let alone = drone.integrate(&start(k)).input(input).method(series);
        assert!(by_series.state(index) == alone.to(1.0).unwrap(), "{k}");
        let alone = drone.integrate(&start(k)).input(input).method(pairs);
        assert!(by_pairs.state(index) == alone.to(1.0).unwrap(), "{k}");
    }
}

#[test]
fn arms() {
    let arms = Arms::default();
    let start = |k: u32| ArmsState {
        torque_1: 0.1 * f64::from(k),
        work: f64::from(k),
        ..ArmsState::default()
    };
    let input = ArmsInput {
        command_1: 3.0,
        command_2: -1.0,
    };
    let mut ensemble = Ensemble::new(&arms, (0..9).map(start));
    for k in 0..9 {
        ensemble.inputs_mut().set(k, &input);
    }
    let steps = Fixed {
        method: DormandPrince8,
        step: 0.02,
    };
    ensemble.integrate().method(steps).to(1.0).unwrap();
    for k in 0..9 {
        let alone = arms.integrate(&start(k)).input(input).method(steps);
        let index = usize::try_from(k).unwrap();
        assert!(ensemble.state(index) == alone.to(1.0).unwrap(), "{k}");
    }
}

/// In single precision, and with derivatives by a parameter.
#[test]
fn over_other_scalars() {
    let drone = Drone::<f32>::default();
    let input = DroneInput {
        command_1: 300.0,
        command_2: 300.0,
    };
    let rate = drone.acceleration(0.0, &DroneState::default(), &input);
    assert!((rate.speed_1 - 3750.0).abs() < 1e-2, "{}", rate.speed_1);
}
