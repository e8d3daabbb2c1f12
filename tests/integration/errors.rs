//! What ends a motion, with the last good state: errors are values, nothing panics, and nothing
//! runs forever.

use newton_euler::integrate::{Classical4, DormandPrince8, Fixed, IntegrationError, Midpoint};
use newton_euler::prelude::*;

use crate::scenes::{
    Cart, CartInput, Collapse, ExactPendulum, Pendulum, SeriesCollapse, SeriesPendulum,
};

const START: Hinge = Hinge {
    angle: 2.0,
    angular_velocity: 0.0,
};

/// From rest at 1 m the origin is reached after π/2 √(1/2) s.
#[test]
fn a_singularity() {
    let start = Translation {
        position: [1.0, 0.0, 0.0].into(),
        ..Translation::default()
    };
    let collapse = std::f64::consts::PI / 2.0 * 0.5_f64.sqrt();
    let by_stages = Collapse::default().integrate(&start).to(3.0).unwrap_err();
    let by_series = SeriesCollapse::default()
        .integrate(&start)
        .to(3.0)
        .unwrap_err();
    for error in [by_stages, by_series] {
        let (time, state) = (error.time(), error.state());
        assert!((time - collapse).abs() < 1e-3, "{time}");
        assert!(
            state.position.x.abs() < 0.02 && state.velocity.x < -10.0,
            "{state:?}"
        );
    }
}

/// A wall that is reached fast from far away: stages beyond it have no force, in one component, and the step is taken again, shorter.
#[test]
fn stages_out_of_the_domain() {
    rigid_body!(Bouncing {
        motion: translation,
        mass: 1[kg],
        forces: [wall = world(2025[N] / (position.in_world().x / 1[m]).powf(5.5), 0, 0)],
        outputs: [energy],
    });
    for far in [100.0, 300.0, 1e3, 3e3, 1e4] {
        let start = Translation {
            position: [far, 0.0, 0.0].into(),
            velocity: [-30.0, 0.0, 0.0].into(),
        };
        let body = Bouncing::default();
        let motion = body.integrate(&start).tolerance(1e-6);
        let end = motion.to(far / 15.0).unwrap();
        // U = 450 / x^4.5
        let energy = |state: &Translation| {
            0.5 * state.velocity.norm_squared() + 450.0 / state.position.x.powf(4.5)
        };
        assert!(end.velocity.x > 20.0, "{end:?}");
        assert!(
            (energy(&end) / energy(&start) - 1.0).abs() < 1e-3,
            "{end:?}"
        );
    }
}

/// The last item of an iterator is the error, and after it there is none.
#[test]
fn iterators_end_with_the_error() {
    let start = Translation {
        position: [1.0, 0.0, 0.0].into(),
        ..Translation::default()
    };
    let body = Collapse::default();
    let samples: Vec<_> = body.integrate(&start).samples(3.0, 0.1).collect();
    assert_eq!(samples.len(), 13);
    assert!(samples[..12].iter().all(Result::is_ok) && samples[12].is_err());
    let mut steps = body.integrate(&start).steps(3.0).skip_while(Result::is_ok);
    assert!(steps.next().unwrap().is_err() && steps.next().is_none());
    let mut events = body
        .integrate(&start)
        .events(3.0, |_, state| state.position.x - 0.5);
    assert!((events.next().unwrap().unwrap().state.position.x - 0.5).abs() < 1e-12);
    assert!(events.next().unwrap().is_err() && events.next().is_none());
}

/// Numbers that are none, everywhere.
#[test]
fn what_is_no_number() {
    let (body, series, exact) = (
        Pendulum::default(),
        SeriesPendulum::default(),
        ExactPendulum::default(),
    );
    for end in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        assert!(body.integrate(&START).to(end).is_err());
        assert!(series.integrate(&START).to(end).is_err());
        assert!(exact.integrate(&START).to(end).is_err());
        assert!(
            body.integrate(&START)
                .samples(end, 0.1)
                .any(|sample| sample.is_err())
        );
        assert!(
            body.integrate(&START)
                .events(end, |_, _| 1.0)
                .any(|event| event.is_err())
        );
    }
    for tolerance in [f64::NAN, 0.0, -1.0] {
        assert!(
            body.integrate(&START).tolerance(tolerance).to(1.0).is_err(),
            "{tolerance}"
        );
        assert!(
            series
                .integrate(&START)
                .tolerance(tolerance)
                .to(1.0)
                .is_err(),
            "{tolerance}"
        );
    }
    for step in [f64::NAN, 0.0, -0.1] {
        assert!(
            body.integrate(&START)
                .method(Fixed {
                    method: Classical4,
                    step
                })
                .to(1.0)
                .is_err()
        );
    }
    for every in [f64::NAN, 0.0, -0.1] {
        assert!(
            body.integrate(&START)
                .samples(1.0, every)
                .any(|sample| sample.is_err())
        );
    }
    for state in [f64::NAN, f64::INFINITY] {
        let start = Hinge {
            angle: state,
            angular_velocity: 0.0,
        };
        assert!(matches!(
            body.integrate(&start).to(1.0),
            Err(IntegrationError::InvalidSetting { time: 0.0, .. })
        ));
        assert!(
            series.integrate(&start).to(1.0).is_err() && exact.integrate(&start).to(1.0).is_err()
        );
        assert!(
            body.integrate(&start)
                .method(Fixed {
                    method: DormandPrince8,
                    step: 0.1
                })
                .to(1.0)
                .is_err()
        );
        assert!(
            body.integrate(&start)
                .method(Fixed {
                    method: Midpoint,
                    step: 0.1
                })
                .to(1.0)
                .is_err()
        );
    }
    let (cart, rest) = (Cart::default(), Translation::default());
    for period in [f64::NAN, 0.0, -0.1] {
        let control = |_: f64, _: &Translation| CartInput { push: 1.0 };
        assert!(
            cart.integrate(&rest)
                .control(period, control)
                .to(1.0)
                .is_err()
        );
    }
    assert!(
        cart.integrate(&rest)
            .input(CartInput { push: f64::NAN })
            .to(1.0)
            .is_err()
    );
}

/// A tolerance finer than any rounding ends too, and a start that is no time is an error.
#[test]
fn extremes_come_to_an_end() {
    let (body, series) = (Pendulum::default(), SeriesPendulum::default());
    for tolerance in [1e-17, 1e-20, 1e-300] {
        let by_stages = body.integrate(&START).tolerance(tolerance).to(0.5).unwrap();
        let by_series = series
            .integrate(&START)
            .tolerance(tolerance)
            .to(0.5)
            .unwrap();
        assert!((by_stages.angle - by_series.angle).abs() < 1e-13);
    }
    for begin in [f64::NAN, f64::INFINITY] {
        let exact = ExactPendulum::default();
        assert!(body.integrate(&START).starting_at(begin).to(1.0).is_err());
        assert!(series.integrate(&START).starting_at(begin).to(1.0).is_err());
        assert!(exact.integrate(&START).starting_at(begin).to(1.0).is_err());
        assert!(
            body.integrate(&START)
                .starting_at(begin)
                .samples(1.0, 0.1)
                .any(|sample| sample.is_err())
        );
        assert!(
            body.integrate(&START)
                .starting_at(begin)
                .steps(1.0)
                .any(|step| step.is_err())
        );
    }
}

/// No time, no motion.
#[test]
fn no_time() {
    let body = Pendulum::default();
    assert_eq!(body.integrate(&START).starting_at(2.0).to(2.0), Ok(START));
    assert_eq!(body.integrate(&START).steps(0.0).count(), 0);
    assert_eq!(
        body.integrate(&START)
            .events(0.0, |_, state| state.angle)
            .count(),
        0
    );
    assert_eq!(body.integrate(&START).samples(0.0, 0.1).count(), 1);
}

/// Numbers of every size have squares that have not: the error of a step is no less one.
#[test]
fn magnitudes_beyond_squares() {
    rigid_body!(Spring {
        motion: translation,
        mass: 1[kg],
        forces: [spring = -1[N / m] * position],
    });
    for size in [
        1e-300, 1e-200, 1e-160, 1e-100, 1.0, 1e100, 1e160, 1e200, 1e290,
    ] {
        let start = Translation {
            position: [size, 0.0, 0.0].into(),
            ..Translation::default()
        };
        let body = Spring::default();
        for tolerance in [1e-3, 1e-9, 1e-12] {
            let end = body
                .integrate(&start)
                .tolerance(tolerance)
                .to(10.0)
                .unwrap();
            // below 1 the tolerance is absolute
            let permitted = 100.0 * tolerance * size.max(1.0);
            let off = (end.position.x - size * 10.0_f64.cos()).abs();
            assert!(off < permitted, "{size:e} at {tolerance:e}: {off:e}");
        }
    }
    // stages that are far beyond a wall, where the force has a number but its square has none
    rigid_body!(Wall {
        motion: translation,
        mass: 1[kg],
        locals: [_x = position.in_world().x / 1[m]],
        forces: [wall = world(-1[N] * (1e4 * (_x - 0.5)).exp(), 0, 0)],
    });
    for speed in [0.1, 1.0, 1.02, 1.05, 1.1, 1.2, 3.0] {
        let start = Translation {
            velocity: [speed, 0.0, 0.0].into(),
            ..Translation::default()
        };
        for tolerance in [1e-3, 1e-6, 1e-9, 1e-12] {
            let body = Wall::default();
            let end = body
                .integrate(&start)
                .tolerance(tolerance)
                .to(10.0)
                .unwrap();
            let energy = 0.5 * (end.velocity.x.powi(2) - speed * speed);
            assert!(
                energy.abs() < 200.0 * tolerance,
                "{speed} at {tolerance:e}: {end:?}"
            );
        }
    }
}
