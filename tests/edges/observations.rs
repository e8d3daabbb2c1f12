//! Observations of a motion, with functions and periods that are invalid.

use newton_euler::integrate::{Event, IntegrationError, Motion};
use newton_euler::prelude::*;

use crate::bounded;
use crate::kinds::*;
use crate::motions::spun;

/// What `events` and `Step::zeros` give, of bodies by every method.
fn events_of(function: impl Fn(f64, f64) -> f64 + Copy) -> Vec<Vec<Result<f64, f64>>> {
    type Found<S> = Result<Event<S>, IntegrationError<S>>;
    fn time<S>(found: Found<S>) -> Result<f64, f64> {
        found.map(|event| event.time).map_err(|error| {
            assert!(matches!(error, IntegrationError::EventNotANumber { .. }));
            error.time()
        })
    }
    let (body, series, exact) = (Craft::default(), Quadrotor::default(), Brick::default());
    let along = |time: f64, state: &Spatial| function(time, state.position.x);
    let mut motion = Motion::<_, 13>::new(&series, 0.0, &spun());
    let step = motion.step(1.0, &Default::default()).unwrap();
    vec![
        body.integrate(&spun())
            .events(1.0, along)
            .map(time)
            .collect(),
        series
            .integrate(&spun())
            .events(1.0, along)
            .map(time)
            .collect(),
        exact
            .integrate(&spun())
            .events(1.0, along)
            .map(time)
            .collect(),
        step.zeros(along).map(time).collect(),
    ]
}

/// Of infinities there are no zeros, and none of what is always zero; what becomes zero and stays so is one. What is not a number, at once or
/// later, is an error, and the end.
#[test]
fn functions_that_are_no_number() {
    bounded("events", || {
        for value in [0.0, -0.0, f64::INFINITY, f64::NEG_INFINITY] {
            assert!(events_of(|_, _| value).iter().all(Vec::is_empty));
        }
        for seen in events_of(|_, _| f64::NAN) {
            assert_eq!(seen, [Err(0.0)]);
        }
        for seen in events_of(|time, _| (0.3 - time).max(0.0)) {
            assert!(
                matches!(seen[..], [Ok(time)] if (0.3..0.5).contains(&time)),
                "{seen:?}"
            );
        }
        for seen in events_of(|time, _| (0.3 - time).sqrt()) {
            assert!(matches!(seen[..], [Err(time)] if time > 0.3), "{seen:?}");
        }
        // a zero before; a sign that is lost between two places
        for seen in events_of(|time, _| (time - 0.1) * (0.49 - time).sqrt()) {
            assert!(
                matches!(seen[..], [Ok(zero), Err(time)] if (zero - 0.1).abs() < 1e-12 && time > 0.49),
                "{seen:?}"
            );
        }
        let broken = |time: f64| {
            if (0.41..0.42).contains(&time) {
                f64::NAN
            } else {
                time - 0.415
            }
        };
        for seen in events_of(|time, _| broken(time)) {
            assert!(
                matches!(seen[..], [Err(time)] if (0.41..0.42).contains(&time)),
                "{seen:?}"
            );
        }
    });
}

/// Signs that change everywhere; samples at no distance are an error.
#[test]
fn observations() {
    bounded("observations", || {
        let body = Craft::default();
        // signs that change everywhere, or from one infinity to the other
        let jumps = |time: f64, _: &Spatial| {
            if time < 0.3 {
                f64::NEG_INFINITY
            } else {
                f64::INFINITY
            }
        };
        let event = body
            .integrate(&spun())
            .events(1.0, jumps)
            .next()
            .unwrap()
            .unwrap();
        assert!((event.time - 0.3).abs() < 1e-12, "{}", event.time);
        let wild = |time: f64, _: &Spatial| {
            if time.to_bits().is_multiple_of(2) {
                -1.0
            } else {
                1.0
            }
        };
        assert!(
            body.integrate(&spun())
                .events(1.0, wild)
                .all(|event| event.is_ok())
        );
        for period in [f64::NAN, 0.0, -0.1, 5e-324] {
            assert!(
                body.integrate(&spun())
                    .samples(1.0, period)
                    .all(|sample| sample.is_err())
            );
        }
        assert_eq!(
            body.integrate(&spun()).samples(1.0, f64::INFINITY).count(),
            1
        );
    });
}
