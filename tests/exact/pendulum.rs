//! The plane pendulum in closed form: 40-digit references, energy, near the separatrix and beyond
//! it.
#![allow(clippy::float_cmp, reason = "what is exact is compared exactly")]

use std::f64::consts::{FRAC_PI_2, PI, TAU};

use crate::reference::{number, trajectory};
use newton_euler::exact::{Path, Pendulum};
use newton_euler::prelude::*;
use proptest::prelude::*;
use serde_json::Value;

#[test]
fn the_published_pendulum() {
    let problem = trajectory("pendulum_planar");
    let rate = f64::sqrt(number(&problem["k"]) / number(&problem["I"][0]));
    let start = Hinge {
        angle: 2.5,
        angular_velocity: 0.0,
    };
    let end = Pendulum::new(rate, 0.0, &start).at(number(&problem["T"]));
    // 60 is the conditioning of this problem
    assert!((end.angle - number(&problem["theta_T"])).abs() < 60.0 * f64::EPSILON);
    assert!((end.angular_velocity - number(&problem["w_ref"][0])).abs() < 100.0 * f64::EPSILON);
}

#[test]
fn end_states_of_all_kinds_of_motion() {
    let list: Value = serde_json::from_str(include_str!("../reference/pendulum.json")).unwrap();
    let list = list.as_array().unwrap();
    assert!(list.len() > 25);
    for case in list {
        let start = Hinge {
            angle: number(&case["angle"]),
            angular_velocity: number(&case["angular_velocity"]),
        };
        let (rate, time) = (number(&case["rate"]), number(&case["time"]));
        let run = |start: &Hinge| Pendulum::new(rate, 0.0, start).at(time);
        let end = run(&start);
        let errors = [
            end.angle - number(&case["end_angle"]),
            end.angular_velocity - number(&case["end_angular_velocity"]),
        ];
        // by how much it moves with the inputs; the first step is below what is near to the separatrix
        let mut moves: f64 = 0.0;
        for (step, angle, velocity) in [(1e-13, 1.0, 0.0), (1e-13, 0.0, 1.0), (1e-9, 0.0, 1.0)] {
            let moved = run(&Hinge {
                angle: start.angle * (1.0 + step * angle),
                angular_velocity: start.angular_velocity * (1.0 + step * velocity),
            });
            let by = f64::max(
                (moved.angle - end.angle).abs(),
                (moved.angular_velocity - end.angular_velocity).abs(),
            );
            moves = moves.max(by / step * f64::EPSILON);
        }
        let size = 1.0 + start.angular_velocity.abs() * time.abs() + rate * time.abs();
        let bound = 4.0 * moves + f64::EPSILON * size;
        for error in errors {
            assert!(error.abs() <= bound, "{case}: {error:e} > {bound:e}");
        }
    }
}

/// `θ'²/2 - Ω² cos(θ - θ₀)`, less its least value.
fn energy(rate: f64, hanging: f64, state: &Hinge) -> f64 {
    let half = f64::sin((state.angle - hanging) / 2.0);
    state.angular_velocity.powi(2) / 2.0 + 2.0 * (rate * half).powi(2)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(1000))]

    #[test]
    fn energy_is_kept(angle in -20.0..20.0, speed in -5.0..5.0, rate in 0.01..3.0, hanging in -3.0..3.0, time in -50.0..50.0) {
        let start = Hinge { angle, angular_velocity: speed };
        let end = Pendulum::new(rate, hanging, &start).at(time);
        let (before, after) = (energy(rate, hanging, &start), energy(rate, hanging, &end));
        let rounding = f64::EPSILON * (1.0 + end.angle.abs()) * rate * rate;
        prop_assert!((after - before).abs() <= 1e-14 * before + 2.0 * rounding, "{before} {after}");
    }

    #[test]
    fn two_motions_are_one(angle in -9.0..9.0, speed in -5.0..5.0, first in -9.0..9.0, second in -9.0..9.0) {
        let start = Hinge { angle, angular_velocity: speed };
        let run = |start: &Hinge, time| Pendulum::new(1.0, 0.5, start).at(time);
        let (halting, straight) = (run(&run(&start, first), second), run(&start, first + second));
        prop_assert!((halting.angle - straight.angle).abs() < 1e-8);
        prop_assert!((halting.angular_velocity - straight.angular_velocity).abs() < 1e-8);
        let still = run(&start, 0.0);
        prop_assert!((still.angle - angle).abs() < 2e-15 * (1.0 + f64::abs(angle)));
        prop_assert!((still.angular_velocity - speed).abs() < 2e-15 * (1.0 + f64::abs(speed)));
    }
}

/// From 90 degrees, `K(1/√2) = Γ(1/4)²/(4 √π)`.
#[test]
fn periods() {
    let start = |angle, angular_velocity| Hinge {
        angle,
        angular_velocity,
    };
    let quarter = 1.854_074_677_301_371_9;
    let period = Pendulum::new(2.0, 0.0, &start(FRAC_PI_2, 0.0)).period();
    assert!((period - 4.0 * quarter / 2.0).abs() < 2e-15);
    // half around: k' = 1e-6, K = ln(4/k')
    let period = Pendulum::new(1.0, 0.0, &start(PI - 2e-6, 0.0)).period();
    assert!((period - 4.0 * f64::ln(4e6)).abs() < 1e-8);
    assert_eq!(
        Pendulum::new(1.0, 0.0, &start(0.0, 2.0)).period(),
        f64::INFINITY
    );
    let period = Pendulum::new(0.0, 0.0, &start(0.0, 2.0)).period();
    assert!((period - PI).abs() < 1e-15);
}

/// On the separatrix it rises for ever: `θ = 4 atan(exp(Ω t)) - π`.
#[test]
fn the_separatrix() {
    let rising = Pendulum::new(
        1.0,
        0.0,
        &Hinge {
            angle: 0.0,
            angular_velocity: 2.0,
        },
    );
    for time in [-3.0, 0.5, 5.0, 1e4_f64] {
        let expected = 4.0 * time.exp().atan() - PI;
        assert!((rising.at(time).angle - expected).abs() < 1e-15 * (1.0 + expected.abs()));
    }
    assert_eq!(rising.at(1e4).angular_velocity, 0.0);
}

/// Released at rest next to upright, it falls the way it leans: it hangs after `K = ln(4/k')`, `k' = sin(φ/2)`, as far before as
/// after. The doubles next to upright lean too, and the sine says how.
#[test]
fn released_next_to_upright() {
    for hanging in [0.0, PI, -FRAC_PI_2] {
        for turns in [0.0, 1.0, -1.0, 7.0] {
            for tilt in [1e-4, 1e-7, -1e-9, 1e-12, -1e-14, 1e-15, 4e-16, 0.0] {
                let angle = hanging + PI + TAU * turns + tilt;
                // of upright and a tilt, sine and cosine are those of the tilt, with a sign
                let leans = if hanging == -FRAC_PI_2 {
                    -f64::cos(angle)
                } else {
                    -f64::sin(angle) * f64::cos(hanging)
                };
                let leans = leans.asin();
                let start = Hinge {
                    angle,
                    angular_velocity: 0.0,
                };
                if leans == 0.0 {
                    assert_eq!(Pendulum::new(1.0, hanging, &start).at(1e9), start);
                    continue;
                }
                let fall = f64::ln(4.0 / f64::sin(0.5 * leans.abs()));
                for time in [fall, -fall] {
                    let end = Pendulum::new(1.0, hanging, &start).at(time);
                    let fallen = end.angle - (angle - leans);
                    let error = fallen - f64::copysign(PI, leans);
                    let case = format!("{hanging} {turns} {leans:e}: {fallen}");
                    // of the end, and of the tilt in twice the precision
                    let ulps = angle.abs() * (4.0 * f64::EPSILON + 8e-31 / leans.abs());
                    assert!(error.abs() < 3e-14 + 8.0 * leans * leans + ulps, "{case}");
                    let speed = f64::copysign(2.0, leans * time);
                    assert!(
                        (end.angular_velocity - speed).abs() < leans * leans + 2e-15,
                        "{case}"
                    );
                }
            }
        }
    }
}

/// An angle from upright has all digits of any tilt: `φ cosh(Ω t)` while it is small.
#[test]
fn tilts_from_upright_keep_their_digits() {
    for tilt in [1e-9, -3e-16, 1e-20, 5e-29] {
        let start = Hinge {
            angle: tilt,
            angular_velocity: 0.0,
        };
        for time in [-8.0, -1.0, 0.0, 0.5, 9.0] {
            let end = Pendulum::new(1.0, PI, &start).at(time);
            let expected = tilt * f64::cosh(time);
            let bound = 4e-15 + end.angle * end.angle;
            assert!(
                (end.angle / expected - 1.0).abs() < bound,
                "{tilt:e} {time}: {:e}",
                end.angle
            );
            let again = Pendulum::new(1.0, PI, &end).at(-time);
            let size = f64::cosh(2.0 * time);
            assert!(
                (again.angle / tilt - 1.0).abs() < 4e-15 * size,
                "{tilt:e} {time}"
            );
        }
    }
}

#[test]
fn at_rest_and_without_weight() {
    for turns in [0.0, 2.0] {
        let hanging = Hinge {
            angle: 0.5 + turns * TAU,
            angular_velocity: 0.0,
        };
        let end = Pendulum::new(3.0, 0.5, &hanging).at(1e6);
        assert!((end.angle - hanging.angle).abs() < 4e-15);
        // two turns in doubles are 5e-16 off
        assert!(end.angular_velocity.abs() <= 3.0 * 5e-16 * turns);
    }
    for angular_velocity in [2.0, -1e-3, 0.0] {
        let start = Hinge {
            angle: 0.3,
            angular_velocity,
        };
        let end = Pendulum::new(0.0, 0.0, &start).at(7.0);
        assert!((end.angle - (0.3 + 7.0 * angular_velocity)).abs() < 4e-15);
        assert!((end.angular_velocity - angular_velocity).abs() <= 4e-16 * angular_velocity.abs());
    }
}

/// A billion seconds: the phase loses no more than the rounding of its rate.
#[test]
fn long_times() {
    let start = Hinge {
        angle: 2.0,
        angular_velocity: 0.0,
    };
    let swing = Pendulum::new(1.0, 0.0, &start);
    let periods = 1e8_f64;
    let end = swing.at(periods * swing.period());
    assert!((end.angle - 2.0).abs() < f64::EPSILON * periods * TAU);
}
