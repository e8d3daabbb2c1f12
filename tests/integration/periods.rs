//! Conditions that switch at a period which is lost in the rounding of time: an error, and no motion
//! without an end or without the condition.

use newton_euler::ensemble::{Ensemble, MemberError, OneByOne};
use newton_euler::integrate::{Classical4, Fixed, IntegrationError, Setting, Verner};
use newton_euler::prelude::*;

rigid_body!(Valve::<T> {
    motion: planar_translation,
    params: [period = 0.1[s]],
    mass: 2[kg],
    forces: [valve = if t / period - (t / period).floor() < 0.5 {
        world(4[N], 0)
    } else {
        world(0, 0)
    }],
});

const STEPS: Fixed<Classical4> = Fixed {
    method: Classical4,
    step: 0.01,
};

type Ended = Result<PlanarTranslation, IntegrationError<PlanarTranslation>>;

fn valve(period: f64) -> Valve<f64> {
    Valve::new(ValveParams { period }).unwrap()
}

fn is_refused(error: &IntegrationError<PlanarTranslation>, period: f64) -> bool {
    let setting = Setting::PeriodOfCondition;
    matches!(error, IntegrationError::InvalidSetting { setting: told, value, .. }
        if *told == setting && *value == period)
}

#[test]
fn periods_lost_in_rounding_are_refused() {
    let rest = PlanarTranslation::default();
    for period in [1e-15, 1e-20, 1e-100, 1e-290, 1e-300] {
        for end in [1.0, -1.0] {
            let body = valve(period);
            let motion = || body.integrate(&rest);
            let ends = [motion().to(end), motion().method(STEPS).to(end)];
            for end in ends {
                assert!(is_refused(&end.unwrap_err(), period), "{period}");
            }
        }
    }
    let told = valve(1e-20).integrate(&rest).to(1.0).unwrap_err();
    assert_eq!(
        told.to_string().lines().next(),
        Some(
            "the period of a condition on time is 1e-20 s: it must be far above the rounding of time"
        ),
    );
    // far above the rounding of early times, not of late ones
    let late = |start: f64| {
        valve(1e-6)
            .integrate(&rest)
            .starting_at(start)
            .to(start + 1e-4)
    };
    assert!(is_refused(&late(1e9).unwrap_err(), 1e-6));
    assert!((late(0.0).unwrap().velocity.x - 1e-4).abs() < 1e-16);
    // half of the time, at 2 m/s²
    let short = valve(1e-9).integrate(&rest).to(1e-6).unwrap();
    assert!((short.velocity.x - 1e-6).abs() < 1e-18);
}

/// One member that is refused leaves the others as they are alone.
#[test]
fn members_are_refused_by_themselves() {
    let periods = [0.1, 1e-20, 0.3, 0.1, 1e-300, 0.2, 0.1, 0.1, 0.1, 0.7];
    let rest = PlanarTranslation::default();
    let ensemble = || {
        let members = periods.map(|period| (ValveParams { period }, rest));
        Ensemble::with_params(members).unwrap()
    };
    let check = |all: &Ensemble<Valve<f64>>, alone: &dyn Fn(&Valve<f64>) -> Ended| {
        for (index, period) in periods.into_iter().enumerate() {
            let expected = if period < 1e-10 {
                rest
            } else {
                alone(&valve(period)).unwrap()
            };
            assert_eq!(all.state(index), expected, "{index}");
        }
    };
    let refused = |errors: &[MemberError<PlanarTranslation>]| {
        let told = errors.iter().map(|told| (told.index, told.error));
        assert!(told.clone().map(|(index, _)| index).eq([1, 4]));
        for (index, error) in told {
            assert!(is_refused(&error, periods[index]));
        }
    };
    let verner = Verner { tolerance: 1e-9 };
    for end in [1.0, -1.0] {
        let mut all = ensemble();
        refused(&all.integrate().method(STEPS).each_to(end).unwrap());
        check(&all, &|body| body.integrate(&rest).method(STEPS).to(end));
        let mut all = ensemble();
        refused(
            &all.integrate()
                .method(OneByOne(STEPS))
                .each_to(end)
                .unwrap(),
        );
        check(&all, &|body| body.integrate(&rest).method(STEPS).to(end));
        let mut all = ensemble();
        refused(&all.integrate().method(verner).each_to(end).unwrap());
        check(&all, &|body| body.integrate(&rest).method(verner).to(end));
    }
}

/// A period that is lost at the end of the motion is refused at its start, also under a controller.
#[test]
fn periods_lost_at_the_end() {
    let rest = PlanarTranslation::default();
    let members = [2e5, 1e-9].map(|period| (ValveParams { period }, rest));
    let mut all = Ensemble::<Valve<f64>>::with_params(members).unwrap();
    let motion = all.integrate().method(Fixed { step: 1e5, ..STEPS });
    let motion = motion.control(2e4, |_, _, _: &PlanarTranslation| ());
    let lost = motion.each_to(1e6).unwrap();
    assert!(lost.len() == 1 && lost[0].index == 1 && is_refused(&lost[0].error, 1e-9));
}
