//! Inputs that are held constant, and controllers.

use newton_euler::integrate::{Classical4, Fixed};
use newton_euler::prelude::*;

use crate::scenes::{Cart, CartInput, SeriesCart, SeriesCartInput};

const RATE: f64 = 0.3 / 2.0;

/// Velocity and way under a constant push, from rest: `u/d (1 - e^-rt)`, `u/d (t - (1 - e^-rt)/r)`.
fn pushed(velocity: f64, push: f64, time: f64) -> (f64, f64) {
    let (end, fade) = (push / 0.3, (-RATE * time).exp());
    (
        end + (velocity - end) * fade,
        end * time + (velocity - end) * (1.0 - fade) / RATE,
    )
}

#[test]
fn a_held_input() {
    let (cart, rest) = (Cart::default(), Translation::default());
    let end = cart
        .integrate(&rest)
        .input(CartInput { push: 5.0 })
        .tolerance(1e-13)
        .to(4.0)
        .unwrap();
    let (velocity, way) = pushed(0.0, 5.0, 4.0);
    assert!((end.velocity.x - velocity).abs() < 1e-12 && (end.position.x - way).abs() < 1e-11);
}

/// A push that changes every half second is held in between: the same as one motion after another.
#[test]
fn a_controller_holds() {
    for direction in [1.0, -1.0] {
        let mut asked = Vec::new();
        let cart = SeriesCart::default();
        let rest = Translation::default();
        let motion = cart
            .integrate(&rest)
            .starting_at(2.0)
            .tolerance(1e-13)
            .control(0.5, |time, state| {
                asked.push((time, state.velocity.x));
                SeriesCartInput { push: time }
            });
        let end = motion.to(2.0 + direction * 2.2).unwrap();
        let (mut velocity, mut way) = (0.0, 0.0);
        for (k, count) in (0..5).zip(0_u32..) {
            let time = 2.0 + direction * 0.5 * f64::from(count);
            assert_eq!(asked[k].0, time);
            assert!((asked[k].1 - velocity).abs() < 1e-12);
            let span = direction * if k == 4 { 0.2 } else { 0.5 };
            let next = pushed(velocity, time, span);
            (velocity, way) = (next.0, way + next.1);
        }
        assert_eq!(asked.len(), 5);
        assert!(
            (end.velocity.x - velocity).abs() < 1e-12 && (end.position.x - way).abs() < 1e-11,
            "{end:?}"
        );
    }
}

/// Steps end where the input changes, whatever their length is.
#[test]
fn fixed_steps_end_where_inputs_change() {
    let (cart, rest) = (Cart::default(), Translation::default());
    let steps = Fixed {
        method: Classical4,
        step: 0.03,
    };
    let motion = cart
        .integrate(&rest)
        .method(steps)
        .control(0.1, |_, _| CartInput { push: 1.0 });
    let times: Vec<f64> = motion.steps(0.25).map(|step| step.unwrap().time).collect();
    let expected = [
        0.025, 0.05, 0.075, 0.1, 0.125, 0.15, 0.175, 0.2, 0.225, 0.25,
    ];
    assert_eq!(times.len(), expected.len());
    assert!(
        times
            .iter()
            .zip(expected)
            .all(|(time, expected)| (time - expected).abs() < 1e-15)
    );
}

/// Samples show the input that was held.
#[test]
fn samples_between_instants() {
    let (cart, rest) = (Cart::default(), Translation::default());
    let motion = cart
        .integrate(&rest)
        .tolerance(1e-12)
        .control(1.0, |time, _| CartInput { push: time + 1.0 });
    let speeds: Vec<f64> = motion
        .samples(2.0, 0.5)
        .map(|sample| sample.unwrap().state.velocity.x)
        .collect();
    let (middle, _) = pushed(0.0, 1.0, 0.5);
    let (first, _) = pushed(0.0, 1.0, 1.0);
    let (third, _) = pushed(first, 2.0, 0.5);
    let (last, _) = pushed(first, 2.0, 1.0);
    for (speed, expected) in speeds.iter().zip([0.0, middle, first, third, last]) {
        assert!((speed - expected).abs() < 1e-11, "{speed} for {expected}");
    }
}

/// The controller is called once for each whole period, whatever the rounding of times.
#[test]
fn an_end_is_no_instant() {
    let cart = Cart::default();
    for (start, period, way, count) in [
        (0.0, 0.7, 2.1, 3),
        (0.0, 0.1, 0.3, 3),
        (5.0, 0.3, 2.1, 7),
        (1e6, 0.1, 0.6, 6),
        (0.0, 0.7, 2.1 + 1e-6, 4),
        (0.0, 0.7, 2.1 - 1e-6, 3),
    ] {
        for end in [start + way, start - way] {
            let mut asked = Vec::new();
            let motion = cart
                .integrate(&Translation::default())
                .starting_at(start)
                .control(period, |time, _| {
                    asked.push(time);
                    CartInput { push: 1.0 }
                });
            motion.to(end).unwrap();
            assert_eq!(asked.len(), count, "{start} {period} {end}: {asked:?}");
        }
    }
}
