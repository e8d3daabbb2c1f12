//! Linearizations of bodies with user-defined states, compared with dual numbers.

use nalgebra::{UnitQuaternion, Vector3};
use newton_euler::prelude::*;

use crate::oracle::{Derived, by, hold, unmoved};

#[path = "../states/bodies.rs"]
#[allow(dead_code, reason = "those of another test")]
mod described;
use described::{
    Arms, ArmsInput, ArmsLinearization, ArmsState, Bead, BeadState, Drone, DroneInput,
    DroneLinearization, DroneState, Filter, FilterState, FourBar, FourBarState, Servo, ServoInput,
    ServoState,
};

#[path = "../states/led.rs"]
#[allow(dead_code, reason = "those of another test")]
mod led;
use led::{
    Crane, CraneInput, CraneState, Driven, DrivenInput, DrivenState, Led, LedInput, LedState,
    Slider, SliderInput, SliderState,
};

fn time() -> Derived {
    Derived::from(0.3)
}

fn hinge(angle: f64, angular_velocity: f64) -> Hinge {
    Hinge {
        angle,
        angular_velocity,
    }
}

#[test]
fn motors_in_flight() {
    let state = DroneState {
        motion: Spatial {
            position: Vector3::new(0.4, -0.7, 1.1),
            attitude: UnitQuaternion::from_euler_angles(0.3, -0.9, 1.4),
            velocity: Vector3::new(1.3, 2.1, -0.6),
            angular_velocity: Vector3::new(0.5, -1.4, 0.8),
        },
        speed_1: 310.0,
        speed_2: 290.0,
    };
    let input = |j: usize| DroneInput {
        command_1: by(325.0, j == 0),
        command_2: by(319.0, j == 1),
    };
    let given = DroneInput {
        command_1: 325.0,
        command_2: 319.0,
    };
    let found = Drone::<f64>::default().linearize(0.3, &state, &given);
    let body = Drone::<Derived>::default();
    let at = unmoved(&state);
    hold::<_, _, DroneState<Derived>, 14, 2>(
        &found,
        &state,
        1e-14,
        |state| body.acceleration(time(), state, &input(9)),
        |j| body.acceleration(time(), &at, &input(j)),
    );
    assert_eq!(found.speed_1_rate_by_speed_1, -1.0 / 0.08);
    assert_eq!(found.acceleration.speed_2, {
        let drone = Drone::<f64>::default();
        drone.acceleration(0.3, &state, &given).speed_2
    });
    let names = <DroneLinearization<f64> as Linearized<14, 2>>::STATES;
    assert_eq!(names[11..], ["angular_velocity_z", "speed_1", "speed_2"]);
    // to first order, a step of 1 ms
    let (step, push) = found.discretized(1e-3);
    assert!((step[(12, 12)] - (-1e-3_f64 / 0.08).exp()).abs() < 1e-5);
    assert!((push[(12, 0)] + (-1e-3_f64 / 0.08).exp_m1()).abs() < 1e-5);
}

#[test]
fn a_controller_on_a_hinge() {
    let state = ServoState {
        motion: hinge(-0.4, 1.0),
        integral: 0.05,
        torque: 2.0,
    };
    let found = Servo::<f64>::default().linearize(0.3, &state, &ServoInput { target: 0.6 });
    let body = Servo::<Derived>::default();
    let at = unmoved(&state);
    let input = |j: usize| ServoInput {
        target: by(0.6, j == 0),
    };
    hold::<_, _, ServoState<Derived>, 4, 1>(
        &found,
        &state,
        1e-14,
        |state| body.acceleration(time(), state, &input(9)),
        |j| body.acceleration(time(), &at, &input(j)),
    );
}

/// What a controller comes to rest with, and how.
#[test]
fn a_controller_at_rest() {
    let servo = Servo::<f64>::default();
    let start = ServoState {
        motion: hinge(0.6, 0.0),
        ..ServoState::default()
    };
    let search = servo.trim(&start).input(&ServoInput { target: 0.6 });
    let rest = search.free(["integral", "torque"]).solve().unwrap();
    let weight = 1.5 * 9.81 * 0.3 * 0.6_f64.cos();
    assert!((rest.state.torque - weight).abs() < 1e-14);
    assert!((rest.state.integral - weight / 60.0).abs() < 1e-15);
    let modes = rest.modes().expect("A is finite");
    assert_eq!(modes.neutral(), 0);
    assert!(modes.is_stable());
    // the sum of the eigenvalues is the trace, and a complex one stands for two
    let sum: f64 = (modes.iter())
        .map(|mode| mode.eigenvalue.re * if mode.eigenvalue.im == 0.0 { 1.0 } else { 2.0 })
        .sum();
    assert!((sum + 1.0 / 0.02).abs() < 1e-12, "{sum}");
    // without its integrator free, it lacks what carries the weight
    let error = servo.trim(&start).input(&ServoInput { target: 0.6 });
    assert!(error.free(["torque"]).solve().is_err());
    let loaded = Drone::<f64>::default();
    let hover = loaded.trim(&DroneState::default());
    let hover = hover.free(["speed_1", "speed_2", "command_1", "command_2"]);
    let found = hover.solve().unwrap();
    let speed = 1.3 * 9.81 / 2.0 / 0.02;
    assert!((found.state.speed_1 - speed).abs() < 1e-10);
    assert!((found.input.command_2 - speed).abs() < 1e-10);
}

#[test]
fn under_a_constraint() {
    let state = BeadState {
        motion: Planar {
            position: [0.6, 0.8].into(),
            angle: 0.3,
            velocity: [1.6, -1.2].into(),
            angular_velocity: 0.7,
        },
        warmth: 20.0,
    };
    let found = Bead::<f64>::default().linearize(0.3, &state, &());
    let body = Bead::<Derived>::default();
    hold::<_, _, BeadState<Derived>, 7, 0>(
        &found,
        &state,
        1e-13,
        |state| body.acceleration(time(), state, &()),
        |_| unreachable!("it has no input"),
    );
}

#[test]
fn arms() {
    let state = ArmsState {
        shoulder: hinge(0.4, 1.7),
        elbow: hinge(-0.9, -1.1),
        torque_1: 2.0,
        torque_2: -0.7,
        work: 0.3,
    };
    let input = |j: usize| ArmsInput {
        command_1: by(3.0, j == 0),
        command_2: by(-1.0, j == 1),
    };
    let given = ArmsInput {
        command_1: 3.0,
        command_2: -1.0,
    };
    let found = Arms::<f64>::default().linearize(0.3, &state, &given);
    let body = Arms::<Derived>::default();
    let at = unmoved(&state);
    hold::<_, _, ArmsState<Derived>, 7, 2>(
        &found,
        &state,
        1e-13,
        |state| body.acceleration(time(), state, &input(9)),
        |j| body.acceleration(time(), &at, &input(j)),
    );
    let names = <ArmsLinearization<f64> as Linearized<7, 2>>::STATES;
    assert_eq!(names[4..], ["torque_1", "torque_2", "work"]);
    assert_eq!(found.work_rate_by_torque_1, 1.7);
}

#[test]
fn a_loop() {
    let mut state = FourBarState {
        pivot_1: hinge(1.1, 2.0),
        pivot_2: hinge(-0.4, 0.0),
        pivot_3: hinge(0.9, 0.0),
        torque: 0.7,
    };
    FourBar::default().project(0.3, &mut state, &()).unwrap();
    let found = FourBar::<f64>::default().linearize(0.3, &state, &());
    let body = FourBar::<Derived>::default();
    hold::<_, _, FourBarState<Derived>, 7, 0>(
        &found,
        &state,
        1e-12,
        |state| body.acceleration(time(), state, &()),
        |_| unreachable!("it has no input"),
    );
}

#[test]
fn of_a_system_at_rest() {
    let state = FilterState {
        force: 2.0,
        rate: 0.5,
    };
    let found = Filter::<f64>::default().linearize(0.3, &state, &());
    let body = Filter::<Derived>::default();
    hold::<_, _, FilterState<Derived>, 2, 0>(
        &found,
        &state,
        1e-15,
        |state| body.acceleration(time(), state, &()),
        |_| unreachable!("it has no input"),
    );
}

#[test]
fn an_arm_rests_on_its_controller() {
    let servo = Servo::<f64>::default();
    let given = ServoInput { target: 0.4 };
    let search = servo.trim(&ServoState::default()).input(&given);
    let rest = search.free(["angle", "integral", "torque"]).solve();
    let rest = rest.expect("it rests");
    let weight = 1.5 * 9.81 * 0.3 * 0.4_f64.cos();
    assert!((rest.state.motion.angle - 0.4).abs() < 1e-14);
    assert!((rest.state.torque - weight).abs() < 1e-13);
    assert!((rest.state.integral - weight / 60.0).abs() < 1e-14);
    assert_eq!(rest.undetermined, 0);
    // angle, rate, integral and torque: four eigenvalues, and it is well controlled
    let modes = rest.modes().expect("A is finite");
    let twice = modes.iter().filter(|mode| mode.period().is_some()).count();
    assert_eq!((modes.len() + twice, modes.neutral()), (4, 0));
    assert!(modes.is_stable());
    // with the integral held, its rate cannot be brought to zero but by the angle
    let search = servo.trim(&ServoState::default()).input(&given);
    let error = search.free(["torque"]).solve();
    assert!(error.is_err());
}

#[test]
fn a_joint_that_follows_a_state() {
    let state = CraneState {
        tower: hinge(0.3, -0.4),
        hook: hinge(-0.7, 1.2),
        reach: 0.8,
        speed: -0.5,
    };
    let input = |j: usize| CraneInput {
        command: by(0.7, j == 0),
    };
    let found = Crane::<f64>::default().linearize(0.3, &state, &CraneInput { command: 0.7 });
    let (body, at) = (Crane::<Derived>::default(), unmoved(&state));
    hold::<_, _, CraneState<Derived>, 6, 1>(
        &found,
        &state,
        1e-13,
        |state| body.acceleration(time(), state, &input(9)),
        |j| body.acceleration(time(), &at, &input(j)),
    );
}

#[test]
fn a_constraint_that_follows_states() {
    let state = SliderState {
        motion: Planar {
            position: [0.3, 1.1].into(),
            velocity: [0.72, -0.7].into(),
            angle: 0.2,
            angular_velocity: 1.4,
        },
        place: 0.3,
        speed: 0.5,
        spin: 1.4,
    };
    let input = |j: usize| SliderInput {
        command: by(0.8, j == 0),
        pace: by(3.0, j == 1),
    };
    let given = SliderInput {
        command: 0.8,
        pace: 3.0,
    };
    let found = Slider::<f64>::default().linearize(0.3, &state, &given);
    let (body, at) = (Slider::<Derived>::default(), unmoved(&state));
    hold::<_, _, SliderState<Derived>, 9, 2>(
        &found,
        &state,
        1e-13,
        |state| body.acceleration(time(), state, &input(9)),
        |j| body.acceleration(time(), &at, &input(j)),
    );
}

#[test]
fn an_arm_that_follows_a_state() {
    let elbow = Rotation {
        attitude: UnitQuaternion::from_euler_angles(0.3, 0.7, 0.4),
        angular_velocity: [0.5, -1.0, 0.8].into(),
    };
    let state = DrivenState {
        elbow,
        target: 0.3,
        speed: -0.6,
    };
    let found = Driven::<f64>::default().linearize(0.3, &state, &DrivenInput { command: 1.5 });
    let (body, at) = (Driven::<Derived>::default(), unmoved(&state));
    let input = |j: usize| DrivenInput {
        command: by(1.5, j == 0),
    };
    hold::<_, _, DrivenState<Derived>, 8, 1>(
        &found,
        &state,
        1e-13,
        |state| body.acceleration(time(), state, &input(9)),
        |j| body.acceleration(time(), &at, &input(j)),
    );
    let state = LedState {
        shoulder: hinge(0.6, -1.2),
        elbow,
        target: 0.3,
        speed: -0.6,
    };
    let found = Led::<f64>::default().linearize(0.3, &state, &LedInput { command: 1.5 });
    let (body, at) = (Led::<Derived>::default(), unmoved(&state));
    let input = |j: usize| LedInput {
        command: by(1.5, j == 0),
    };
    hold::<_, _, LedState<Derived>, 10, 1>(
        &found,
        &state,
        1e-13,
        |state| body.acceleration(time(), state, &input(9)),
        |j| body.acceleration(time(), &at, &input(j)),
    );
}
