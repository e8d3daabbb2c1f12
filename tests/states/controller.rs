//! A controller with an integrator, and a motor that lags, on a hinge, compared with the same
//! equations by hand.

use newton_euler::integrate::DormandPrince;
use newton_euler::prelude::*;

use crate::bodies::{Bead, BeadState, FourBar, FourBarState, Servo, ServoInput, ServoState};
use crate::distance;

const TARGET: f64 = 0.6;

/// Angle, its rate, the integral, the torque.
fn by_hand([angle, rate, integral, torque]: [f64; 4]) -> [f64; 4] {
    let (mass, arm, gravity) = (1.5, 0.3, 9.81);
    let about_hinge = 0.08 + mass * arm * arm;
    let weight = -mass * gravity * arm * angle.cos();
    let lack = TARGET - angle;
    let asked = 40.0 * lack + 60.0 * integral - 8.0 * rate;
    let turned = (torque + weight) / about_hinge;
    [rate, turned, lack, (asked - torque) / 0.02]
}

/// The classical method of Runge and Kutta, by hand too.
fn step(y: [f64; 4], h: f64) -> [f64; 4] {
    let moved = |k: [f64; 4], h: f64| [0, 1, 2, 3].map(|i| y[i] + h * k[i]);
    let first = by_hand(y);
    let second = by_hand(moved(first, h / 2.0));
    let third = by_hand(moved(second, h / 2.0));
    let fourth = by_hand(moved(third, h));
    [0, 1, 2, 3].map(|i| y[i] + h / 6.0 * (first[i] + 2.0 * (second[i] + third[i]) + fourth[i]))
}

fn start() -> ServoState<f64> {
    ServoState {
        motion: Hinge {
            angle: -0.4,
            angular_velocity: 1.0,
        },
        integral: 0.05,
        torque: 2.0,
    }
}

#[test]
fn holds_an_arm() {
    let servo = Servo::default();
    let input = ServoInput { target: TARGET };
    let list = |state: &ServoState<f64>| {
        let Hinge {
            angle,
            angular_velocity,
        } = state.motion;
        [angle, angular_velocity, state.integral, state.torque]
    };
    let motion = || {
        servo
            .integrate(&start())
            .input(input)
            .tolerance(1e-13)
            .to(1.5)
    };
    let mut y = list(&start());
    for _ in 0..60_000 {
        y = step(y, 1.5 / 60_000.0);
    }
    let (series, steps) = (
        motion().unwrap(),
        servo
            .integrate(&start())
            .input(input)
            .method(DormandPrince { tolerance: 1e-14 })
            .to(1.5)
            .unwrap(),
    );
    for end in [series, steps] {
        for (found, expected) in list(&end).into_iter().zip(y) {
            assert!((found - expected).abs() < 1e-11, "{found} is {expected}");
        }
    }
    // at last the integrator carries the weight
    let end = servo.integrate(&series).input(input).to(60.0).unwrap();
    let weight = 1.5 * 9.81 * 0.3 * TARGET.cos();
    assert!((end.motion.angle - TARGET).abs() < 1e-8);
    assert!((60.0 * end.integral - weight).abs() < 1e-5);
    let pin = servo.reactions(0.0, &end, &input).pin;
    assert!((pin.y - 1.5 * 9.81).abs() < 1e-4, "{pin}");
}

/// A controller's integrator is set back where it is to be.
#[test]
fn is_set_back() {
    let servo = Servo::default();
    let input = ServoInput { target: TARGET };
    let mut half = servo.integrate(&start()).input(input).to(0.5).unwrap();
    half.integral = 0.0;
    let end = servo.integrate(&half).input(input).starting_at(0.5);
    assert_ne!(
        end.to(1.0).unwrap(),
        servo.integrate(&start()).input(input).to(1.0).unwrap()
    );
}

/// What the brake of a bead on a ring loses is what it is warmed by; the constraint is kept, and the
/// projection leaves what is one's own as it is.
#[test]
fn under_a_constraint() {
    use newton_euler::constrained::Constrained;

    let bead = Bead::default();
    let start = BeadState {
        motion: Planar {
            position: [1.0, 0.0].into(),
            ..Planar::default()
        },
        warmth: 5.0,
    };
    let energy = |state: &BeadState<f64>| {
        bead.kinetic_energy(state) + bead.potential_energy(0.0, state, &())
    };
    let end = bead.integrate(&start).tolerance(1e-13).to(3.0).unwrap();
    let lost = energy(&start) - energy(&end);
    assert!((end.warmth - 5.0 - lost).abs() < 1e-11, "{lost}");
    assert!((end.motion.position.norm() - 1.0).abs() < 1e-13);
    assert!(lost > 1.0);
    let mut aside = end;
    aside.motion.position *= 1.001;
    bead.project(0.0, &mut aside, &()).unwrap();
    assert_eq!(aside.warmth, end.warmth);
    assert!((aside.motion.position.norm() - 1.0).abs() < 1e-13);
}

/// A motor that turns a loop does the work that is gained.
#[test]
fn in_a_loop() {
    use newton_euler::constrained::Constrained;

    let bar = FourBar::default();
    let mut start = FourBarState::default();
    (start.pivot_1.angle, start.pivot_2.angle) = (1.1, -0.4);
    bar.project(0.0, &mut start, &()).unwrap();
    assert_eq!(start.torque, 0.0);
    let motion = || bar.integrate(&start).tolerance(1e-12);
    let (mut work, mut last) = (0.0, 0.0);
    // Simpson's rule, from samples
    let samples: Vec<_> = motion().samples(0.4, 0.0005).map(Result::unwrap).collect();
    let power = |state: &FourBarState<f64>| state.torque * state.pivot_1.angular_velocity;
    for three in samples.windows(3).step_by(2) {
        let [a, b, c] = [&three[0], &three[1], &three[2]].map(|one| power(&one.state));
        work += 0.0005 / 3.0 * (a + 4.0 * b + c);
        last = bar.kinetic_energy(&three[2].state);
    }
    let gained = last - bar.kinetic_energy(&start);
    assert!((work - gained).abs() < 1e-9, "{work} is {gained}");
    assert!(gained > 0.01);
    assert!(distance(&motion().to(0.4).unwrap(), &start) > 0.1);
}
