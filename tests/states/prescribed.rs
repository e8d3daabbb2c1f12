//! States that prescribe a motion, of driven joints and in constraints. They are compared with the
//! same motion as a `.moving` input, as a joint, and by hand.

use newton_euler::constrained::Constrained;
use newton_euler::integrate::{DormandPrince, TaylorSeries};
use newton_euler::nalgebra::UnitQuaternion;
use newton_euler::prelude::*;

use crate::led::*;

fn hinge(angle: f64, angular_velocity: f64) -> Hinge {
    Hinge {
        angle,
        angular_velocity,
    }
}

fn close(found: f64, expected: f64, bound: f64) {
    let error = (found - expected).abs() / expected.abs().max(1.0);
    assert!(error < bound, "{found} is {expected}");
}

fn cranes() -> impl Iterator<Item = CraneState<f64>> {
    (0..5).map(f64::from).map(|n| CraneState {
        tower: hinge(0.1 * n - 0.2, 0.3 - 0.2 * n),
        hook: hinge(0.9 - 0.3 * n, 0.5 * n),
        reach: 0.4 * n - 0.5,
        speed: 1.0 - 0.7 * n,
    })
}

#[test]
fn a_joint_follows_a_state() {
    let (crane, same) = (Crane::<f64>::default(), Given::default());
    for state in cranes() {
        let input = CraneInput { command: 0.7 };
        let pull = (0.7 - state.speed) / 0.4;
        let (sine, share) = (state.reach.sin(), 1.0 + 0.1 * state.reach.cos());
        let moving = GivenInput {
            place: state.reach + 0.1 * sine,
            place_rate: state.speed * share,
            place_acceleration: pull * share - 0.1 * sine * state.speed.powi(2),
        };
        let at = GivenState {
            tower: state.tower,
            hook: state.hook,
        };
        let found = crane.acceleration(0.0, &state, &input);
        let expected = same.acceleration(0.0, &at, &moving);
        close(found.tower, expected.tower, 1e-13);
        close(found.hook, expected.hook, 1e-13);
        close(found.reach, state.speed, 1e-15);
        close(found.speed, pull, 1e-15);
        let found = crane.reactions(0.0, &state, &input);
        let expected = same.reactions(0.0, &at, &moving);
        close(found.rail_drive, expected.rail_drive, 1e-12);
        let found = crane.kinetic_energy(0.0, &state, &input);
        close(found, same.kinetic_energy(0.0, &at, &moving), 1e-14);
    }
}

/// Series and Runge-Kutta steps agree, and the state is where its law has it.
#[test]
fn a_joint_that_follows_moves_on() {
    let crane = Crane::<f64>::default();
    for state in cranes() {
        let run = || {
            let input = CraneInput { command: 0.7 };
            crane.integrate(&state).input(input)
        };
        let tolerance = 1e-12;
        let series = run().method(TaylorSeries { tolerance }).to(2.0).unwrap();
        let steps = run().method(DormandPrince { tolerance }).to(2.0).unwrap();
        assert!(crate::distance(&series, &steps) < 1e-9);
        let lag = 0.4;
        let decayed = (-2.0_f64 / lag).exp();
        let reach = state.reach + 0.7 * 2.0 + (state.speed - 0.7) * lag * (1.0 - decayed);
        close(series.reach, reach, 1e-11);
        close(series.speed, 0.7 + (state.speed - 0.7) * decayed, 1e-11);
    }
}

/// Where all joints are driven, the states are all that is integrated.
#[test]
fn nothing_else_moves() {
    let turret = Turret::default();
    let start = TurretState {
        angle: 0.4,
        speed: 0.2,
    };
    let input = TurretInput { torque: 1.5 };
    let end = turret.integrate(&start).input(input).to(2.0).unwrap();
    close(end.speed, 0.2 + 0.5 * 2.0, 1e-14);
    close(end.angle, 0.4 + 0.2 * 2.0 + 0.25 * 4.0, 1e-14);
    // the drive of the yaw is the rate of the angular momentum about z, of two bodies
    let about_z = |angle: f64, speed: f64| {
        let pitch = 0.3 * angle.sin();
        let (sine, cosine) = pitch.sin_cos();
        let barrel = 0.1 * sine * sine + 0.3 * cosine * cosine + 2.0 * (0.3 * cosine).powi(2);
        (2.0 + barrel) * speed
    };
    let step = 1e-4;
    let later = |time: f64| {
        let speed = start.speed + 0.5 * time;
        about_z(start.angle + start.speed * time + 0.25 * time * time, speed)
    };
    let expected = (later(step) - later(-step)) / (2.0 * step);
    let found: TurretReactions = turret.reactions(0.0, &start, &input);
    close(found.yaw_drive, expected, 1e-7);
}

/// By hand: `x'' = place''`, where `place' = speed + k y`.
#[test]
fn constraints_follow_states() {
    let slider = Slider::<f64>::default();
    let input = SliderInput {
        command: 0.8,
        pace: 3.0,
    };
    let start = SliderState {
        motion: Planar {
            position: [0.3, 1.1].into(),
            velocity: [0.5 + 0.2 * 1.1, -0.7].into(),
            angle: 0.2,
            angular_velocity: 1.4,
        },
        place: 0.3,
        speed: 0.5,
        spin: 1.4,
    };
    assert!(slider.check(0.0, &start, &input).is_ok());
    let found = slider.acceleration(0.0, &start, &input);
    let pull = (0.8 - 0.5) / 0.3 + 0.1 * 0.7;
    let expected = pull + 0.2 * -0.7;
    close(found.motion.linear.x, expected, 1e-14);
    close(found.motion.linear.y, -9.81, 1e-14);
    close(found.motion.angular, 1.6 / 0.1, 1e-13);
    close(found.speed, pull, 1e-15);
    let loads = slider.reactions(0.0, &start, &input).unwrap();
    close(loads.side.x, 2.0 * expected, 1e-14);
    close(loads.torque, 0.3 * 16.0, 1e-13);
    // both are kept, by steps and by series, and projected onto with the states held
    let run = || slider.integrate(&start).input(input);
    let tolerance = 1e-11;
    let steps = run().method(DormandPrince { tolerance });
    for end in [run().tolerance(tolerance).to(0.7), steps.to(0.7)] {
        let end = end.unwrap();
        assert!(slider.check(0.7, &end, &input).is_ok());
        close(end.motion.position.x, end.place, 1e-13);
        close(end.spin, 3.0 - 1.6 * (-7.0_f64).exp(), 1e-10);
        close(end.motion.angular_velocity, end.spin, 1e-13);
    }
    let mut off = start;
    off.motion.position.x += 0.1;
    off.motion.angular_velocity -= 0.3;
    slider.project(0.0, &mut off, &input).unwrap();
    assert_eq!((off.place, off.speed, off.spin), (0.3, 0.5, 1.4));
    close(off.motion.position.x, 0.3, 1e-14);
    close(off.motion.angular_velocity, 1.4, 1e-14);
}

/// A constraint moves a system as a driven joint does, with the load of its drive.
#[test]
fn a_joint_is_led() {
    let (led, driven) = (Led::<f64>::default(), Driven::<f64>::default());
    for n in 0..5 {
        let n = f64::from(n);
        let elbow = Rotation {
            attitude: UnitQuaternion::from_euler_angles(0.3 * n, 0.7 - n, 0.4),
            angular_velocity: [0.5, n - 1.0, 0.8].into(),
        };
        let (target, speed, command) = (0.3 * n - 0.4, 0.7 - 0.5 * n, 1.5);
        let state = LedState {
            shoulder: hinge(2.0 * target, 2.0 * speed),
            elbow,
            target,
            speed,
        };
        let same = DrivenState {
            elbow,
            target,
            speed,
        };
        let found = led.acceleration(0.0, &state, &LedInput { command });
        let expected = driven.acceleration(0.0, &same, &DrivenInput { command });
        close(found.shoulder, 2.0 * (command - speed) / 0.2, 1e-12);
        for axis in 0..3 {
            close(found.elbow[axis], expected.elbow[axis], 1e-11);
        }
        let found = led.reactions(0.0, &state, &LedInput { command });
        let expected = driven.reactions(0.0, &same, &DrivenInput { command });
        close(found.follow, expected.shoulder_drive, 1e-11);
    }
}
