//! Final states, compared with 40-digit trajectories at several tolerances; reversal, energy, loads
//! that depend on time and inputs, and what ends an integration.

use newton_euler::integrate::{IntegrationError, Motion, Setting, taylor, taylor_step};
use newton_euler::prelude::*;

use crate::reference::{attitude, distance, number, trajectory, vector};
use crate::scenes;

fn end<B>(body: &B, start: &B::State, time: f64, tolerance: f64) -> B::State
where
    B: Taylor<Input = ()>,
    B::State: std::fmt::Debug,
{
    taylor(body, start, &(), 0.0..time, tolerance).unwrap()
}

/// The error of attitude and relative angular velocity at the end of a problem, in tolerances times its condition: by how much
/// relative changes on the way grow until the end.
fn errors<B: Taylor<State = Rotation, Input = ()>>(name: &str, body: &B) -> [f64; 3] {
    let problem = trajectory(name);
    let start = Rotation {
        attitude: attitude(&problem["q0"]),
        angular_velocity: vector(&problem["w0"]),
    };
    let (q, w) = (attitude(&problem["q_ref"]), vector(&problem["w_ref"]));
    let condition = number(&problem["cond_worst"]);
    [1e-6, 1e-9, 1e-12].map(|tolerance| {
        let end = end(body, &start, number(&problem["T"]), tolerance);
        let rates = (end.angular_velocity - w).norm() / w.norm();
        distance(&end.attitude, &q).max(rates) / (tolerance * condition)
    })
}

#[test]
fn ends_are_as_good_as_the_tolerance() {
    let problems = [
        (
            "symmetric_free",
            errors("symmetric_free", &scenes::SymmetricFree::default()),
        ),
        (
            "asymmetric_free",
            errors("asymmetric_free", &scenes::AsymmetricFree::default()),
        ),
        (
            "vanzon_schofield",
            errors("vanzon_schofield", &scenes::Brick::default()),
        ),
        (
            "lagrange_nutation",
            errors("lagrange_nutation", &scenes::LagrangeTop::default()),
        ),
        (
            "sleeping_top",
            errors("sleeping_top", &scenes::LagrangeTop::default()),
        ),
        (
            "heavy_asym",
            errors("heavy_asym", &scenes::HeavyAsym::default()),
        ),
    ];
    for (name, errors) in problems {
        assert!(
            errors.iter().all(|error| *error < 1.0),
            "{name}: {errors:?}"
        );
    }
}

/// A pendulum in space stays in its plane, and hangs on the wrong side of its support without harm.
#[test]
fn a_pendulum_stays_in_its_plane() {
    let problem = trajectory("pendulum_planar");
    let start = Rotation {
        attitude: attitude(&problem["q0"]),
        angular_velocity: vector(&problem["w0"]),
    };
    let end = end(
        &scenes::Hanging::default(),
        &start,
        number(&problem["T"]),
        1e-12,
    );
    assert!(distance(&end.attitude, &attitude(&problem["q_ref"])) < 1e-10);
    assert!((end.angular_velocity - vector(&problem["w_ref"])).amax() < 1e-10);
    assert_eq!([end.angular_velocity.y, end.angular_velocity.z], [0.0; 2]);
}

/// The slope of the error of one step by its length is its order and one.
#[test]
fn a_step_is_of_its_order() {
    fn slope<const N: usize>(step: f64) -> f64 {
        let body = scenes::HeavyAsym::default();
        let start = Rotation {
            angular_velocity: [3.0, 0.5, -0.9].into(),
            ..Rotation::default()
        };
        let error = |step: f64| {
            let [by_step, exact] = [
                taylor_step::<_, N>(&body, 0.0, &start, &(), step),
                end(&body, &start, step, 1e-15),
            ];
            (by_step.angular_velocity - exact.angular_velocity).norm()
        };
        (error(step) / error(step / 2.0)).log2()
    }
    for (order, slope) in [
        (2.0, slope::<3>(2e-2)),
        (4.0, slope::<5>(0.1)),
        (8.0, slope::<9>(0.2)),
    ] {
        assert!(
            (slope - order - 1.0).abs() < 0.3,
            "{slope} for order {order}"
        );
    }
}

#[test]
fn back_to_the_start() {
    let body = scenes::HeavyAsym::default();
    let start = Rotation {
        angular_velocity: [3.0, 0.5, -0.9].into(),
        ..Rotation::default()
    };
    let there = taylor(&body, &start, &(), 2.0..12.0, 1e-13).unwrap();
    let back = taylor(&body, &there, &(), 12.0..2.0, 1e-13).unwrap();
    assert!(distance(&back.attitude, &start.attitude) < 1e-11);
    assert!((back.angular_velocity - start.angular_velocity).amax() < 1e-11);
    let here = taylor(&body, &start, &(), 2.0..2.0, 1e-13).unwrap();
    assert_eq!(here, start);
}

/// Under 3 sin 2t along x and a held force along y, of 2 kg: x = (3 / 8) (2 t - sin 2t), y = u t² / 4.
#[test]
fn loads_of_time_and_inputs() {
    let body = scenes::Driven::default();
    let input = scenes::DrivenInput { push: 0.8 };
    let end = taylor(
        &body,
        &PlanarTranslation::default(),
        &input,
        0.0..7.0,
        1e-13,
    )
    .unwrap();
    let (x, y) = (0.375 * (14.0 - 14.0_f64.sin()), 0.8 * 49.0 / 4.0);
    assert!(
        (end.position.x - x).abs() < 1e-12,
        "{} for {x}",
        end.position.x
    );
    assert!(
        (end.position.y - y).abs() < 1e-12,
        "{} for {y}",
        end.position.y
    );

    // another input from the middle on
    let first = scenes::DrivenInput { push: 0.0 };
    let mut motion = Motion::<_, 15>::new(&body, 0.0, &PlanarTranslation::default());
    while motion.step_towards(3.0, &first, 1e-12).unwrap().is_some() {}
    while motion.step_towards(7.0, &input, 1e-12).unwrap().is_some() {}
    assert!((motion.time() - 7.0).abs() < f64::EPSILON);
    assert!((motion.state().position.y - 0.8 * 16.0 / 4.0).abs() < 1e-12);
}

/// 10⁶ steps: energy and angular momentum of the free body within a few parts in 10¹³, as rounding that does not add up leaves them.
#[test]
fn long_runs_keep_energy_and_momentum() {
    let body = scenes::AsymmetricFree::default();
    let start = Rotation {
        angular_velocity: [3.0, 0.5, -0.9].into(),
        ..Rotation::default()
    };
    let mut motion = Motion::<_, 17>::new(&body, 0.0, &start);
    let steps = if cfg!(debug_assertions) {
        10_000
    } else {
        1_000_000
    };
    for _ in 0..steps {
        motion.step(0.125, &()).unwrap();
    }
    let end = motion.state();
    let energy = body.kinetic_energy(&end) / body.kinetic_energy(&start) - 1.0;
    let momentum = (body.angular_momentum(&end) - body.angular_momentum(&start)).norm()
        / body.angular_momentum(&start).norm();
    assert!(energy.abs() < 2e-13, "{energy:e}");
    assert!(momentum < 2e-13, "{momentum:e}");
    assert!((motion.time() - 0.125 * f64::from(steps)).abs() < f64::EPSILON);
}

/// From rest at 1, a mass drawn by 1/r² arrives at the center after π/√8: no step leads there.
#[test]
fn a_singularity_ends_the_motion() {
    let start = Translation {
        position: [1.0, 0.0, 0.0].into(),
        ..Translation::default()
    };
    let fall = std::f64::consts::PI / 8.0_f64.sqrt();
    let error = taylor(&scenes::Falling::default(), &start, &(), 0.0..2.0, 1e-9).unwrap_err();
    let (time, state) = (error.time(), error.state());
    assert!((time - fall).abs() < 1e-6, "{time} for {fall}");
    assert!(state.position.x.abs() < 1e-3, "{state:?}");
}

#[test]
fn what_is_no_number_ends_the_motion() {
    let start = Translation {
        position: [f64::NAN, 0.0, 0.0].into(),
        ..Translation::default()
    };
    let error = taylor(&scenes::Falling::default(), &start, &(), 0.5..2.0, 1e-9).unwrap_err();
    assert!(
        matches!(error, IntegrationError::InvalidSetting { time: 0.5, .. }),
        "{error:?}"
    );
    let message = "a coordinate of the initial state is NaN: it must be finite";
    assert_eq!(error.to_string(), message);
    // at the center the force is 0/0
    let center = Translation::default();
    let error = taylor(&scenes::Falling::default(), &center, &(), 0.5..2.0, 1e-9).unwrap_err();
    assert!(
        matches!(error, IntegrationError::NotFinite { time: 0.5, .. }),
        "{error:?}"
    );
}

/// A tolerance that no double can hold is an error, and no endless run.
#[test]
fn a_tolerance_below_rounding() {
    let start = Rotation {
        angular_velocity: [3.0, 0.5, -0.9].into(),
        ..Rotation::default()
    };
    let error = taylor(
        &scenes::AsymmetricFree::default(),
        &start,
        &(),
        1.0..2.0,
        0.0,
    )
    .unwrap_err();
    assert!(
        matches!(
            error,
            IntegrationError::InvalidSetting {
                setting: Setting::Tolerance,
                time: 1.0,
                value: 0.0,
                ..
            }
        ),
        "{error:?}"
    );
}
