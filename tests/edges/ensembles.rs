//! Many bodies at once: one whose motion fails does not affect the others.

use newton_euler::ensemble::Ensemble;
use newton_euler::integrate::{Classical4, Fixed, IntegrationError};
use newton_euler::lanes::Width;
use newton_euler::prelude::*;

use crate::bounded;
use crate::kinds::*;

fn planks() -> Ensemble<Plank<f64>> {
    let thrown = |i: u32| Planar {
        angular_velocity: 0.1 * f64::from(i),
        ..Planar::default()
    };
    Ensemble::new(&Plank::default(), (0..11).map(thrown))
}

const STEPS: Fixed<Classical4> = Fixed {
    method: Classical4,
    step: 0.1,
};

/// The error names the member, and the ensemble stays where it is; moved without a check, the others move as ever.
#[test]
fn a_member_that_is_lost() {
    bounded("members", || {
        for width in Width::ALL.into_iter().filter(|width| width.is_there()) {
            let mut ensemble = planks();
            ensemble.set_width(width);
            let lost = PlankInput { thrust: f64::NAN };
            ensemble.inputs_mut().set(5, &lost);
            let before = ensemble.clone();
            let error = ensemble.integrate().method(STEPS).to(1.0).unwrap_err();
            let lost = error.member().unwrap();
            assert!(matches!(
                lost.error,
                IntegrationError::NotFinite { time: 0.0, .. }
            ));
            assert_eq!((lost.index, ensemble.states()), (5, before.states()));
            let error = ensemble.integrate().to(1.0).unwrap_err();
            let index = error.member().unwrap().index;
            assert_eq!((index, ensemble.states()), (5, before.states()));

            let mut others = planks();
            others.cf4(0.0..1.0, 10);
            ensemble.cf4(0.0..1.0, 10);
            let accelerations = ensemble.accelerations(0.0);
            for (index, (state, other)) in ensemble
                .states()
                .iter()
                .zip(others.states().iter())
                .enumerate()
            {
                assert_eq!(state == other, index != 5, "{index}");
                assert_eq!(accelerations.get(index).angular.is_nan(), index == 5);
            }
        }
    });
}

#[test]
fn times_and_steps_that_are_none() {
    bounded("times", || {
        for end in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
            assert!(planks().integrate().to(end).is_err());
            assert!(planks().integrate().method(STEPS).to(end).is_err());
            assert!(planks().integrate().starting_at(end).to(1.0).is_err());
            assert!(
                planks()
                    .integrate()
                    .starting_at(end)
                    .method(STEPS)
                    .to(1.0)
                    .is_err()
            );
            let input = |_: f64, _: usize, _: &Planar| PlankInput::default();
            assert!(
                planks()
                    .integrate()
                    .method(STEPS)
                    .control(0.1, input)
                    .to(end)
                    .is_err()
            );
            assert!(
                planks()
                    .integrate()
                    .starting_at(end)
                    .control(0.1, input)
                    .to(1.0)
                    .is_err()
            );
            planks().cf4(0.0..end, 3);
        }
        for step in [f64::NAN, 0.0, -0.1, 5e-324] {
            let method = Fixed {
                method: Classical4,
                step,
            };
            assert!(planks().integrate().method(method).to(1.0).is_err());
            let input = |_: f64, _: usize, _: &Planar| PlankInput::default();
            assert!(planks().integrate().control(step, input).to(1.0).is_err());
        }
        assert!(planks().integrate().tolerance(f64::NAN).to(1.0).is_err());
        // of none, nothing
        let mut none = Ensemble::new(&Plank::<f64>::default(), []);
        assert!(none.integrate().to(1.0).is_ok() && none.integrate().method(STEPS).to(1.0).is_ok());
        none.cf4(0.0..1.0, 3);
        assert!(none.accelerations(0.0).is_empty());
    });
}
