//! Conditions on time: steps end where a condition switches, and each step is taken with the
//! equations of its own side. Compared with closed forms, to rounding.

use newton_euler::ensemble::{Ensemble, EnsembleError};
use newton_euler::integrate::{
    Classical4, DormandPrince8, Fixed, IntegrationError, Setting, Switches, Tsitouras5, Verner9,
    next_switch,
};
use newton_euler::{integrate, nalgebra, prelude::*};

rigid_body!(Pulse {
    motion: planar_translation,
    mass: 2[kg],
    forces: [blow = if t > 50[s] && t < 50.01[s] {
        world(5[N], 0)
    } else {
        world(0, 0)
    }],
});

rigid_body!(Burn::<T> {
    motion: planar_translation,
    params: [ignition = 2[s], burn = 1.5[s], thrust = 60[N]],
    mass: 3[kg],
    locals: [is_on = if t >= ignition && t - ignition <= burn {
        1
    } else {
        0
    }],
    forces: [engine = world(is_on * thrust, 0)],
});

rigid_body!(Given::<T> {
    motion: planar_translation,
    inputs: [start[s], thrust[N]],
    mass: 2[kg],
    forces: [engine = world(if 2 * t - 1[s] > start { thrust } else { 0 }, 0)],
});

/// Far away, and still.
fn rest() -> PlanarTranslation {
    PlanarTranslation::default()
}

/// Velocity and position a time after a start from rest with these accelerations, each from one time to another.
fn pushed(pushes: &[(f64, f64, f64)], end: f64) -> [f64; 2] {
    pushes.iter().fold([0.0, 0.0], |[x, v], (from, to, a)| {
        let (since, lasted) = (end - from, to - from);
        let until = since - lasted;
        [x + a * lasted * (0.5 * lasted + until), v + a * lasted]
    })
}

#[track_caller]
fn assert_near(state: &PlanarTranslation, expected: [f64; 2]) {
    let [x, v] = expected;
    let size = 1.0 + x.abs() + v.abs();
    let off = (state.position.x - x)
        .abs()
        .max((state.velocity.x - v).abs());
    assert!(off < 1e-12 * size, "{state:?} is not at {expected:?}");
}

/// By every method that there is.
macro_rules! by_every_method {
    ($body:expr, $start:expr, $from:expr, $end:expr, $expected:expr) => {{
        let (body, start) = ($body, $start);
        for tolerance in [1e-3, 1e-6, 1e-9, 1e-13] {
            let motion = body
                .integrate(&start)
                .starting_at($from)
                .tolerance(tolerance);
            assert_near(&motion.to($end).unwrap(), $expected);
        }
        for step in [0.03, 0.7, 1e3] {
            let motion = || body.integrate(&start).starting_at($from);
            let ends = [
                motion()
                    .method(Fixed {
                        method: Classical4,
                        step,
                    })
                    .to($end),
                motion()
                    .method(Fixed {
                        method: Tsitouras5,
                        step,
                    })
                    .to($end),
                motion()
                    .method(Fixed {
                        method: DormandPrince8,
                        step,
                    })
                    .to($end),
                motion()
                    .method(Fixed {
                        method: Verner9,
                        step,
                    })
                    .to($end),
            ];
            for end in ends {
                assert_near(&end.unwrap(), $expected);
            }
        }
    }};
}

#[test]
fn a_short_pulse_is_not_stepped_over() {
    by_every_method!(
        Pulse::default(),
        rest(),
        0.0,
        100.0,
        pushed(&[(50.0, 50.01, 2.5)], 100.0)
    );
    // from a switch on, and from within
    by_every_method!(
        Pulse::default(),
        rest(),
        50.0,
        60.0,
        pushed(&[(50.0, 50.01, 2.5)], 60.0)
    );
    by_every_method!(
        Pulse::default(),
        rest(),
        50.004,
        60.0,
        pushed(&[(50.004, 50.01, 2.5)], 60.0)
    );
    // to a switch, and from its end
    by_every_method!(
        Pulse::default(),
        rest(),
        49.0,
        50.01,
        pushed(&[(50.0, 50.01, 2.5)], 50.01)
    );
    by_every_method!(Pulse::default(), rest(), 50.01, 70.0, [0.0, 0.0]);
}

#[test]
fn backwards_too() {
    let [x, v] = pushed(&[(50.0, 50.01, 2.5)], 60.0);
    let there = PlanarTranslation {
        position: [x, 0.0].into(),
        velocity: [v, 0.0].into(),
    };
    by_every_method!(Pulse::default(), there, 60.0, 0.0, [0.0, 0.0]);
    by_every_method!(Pulse::default(), there, 60.0, 50.0, [0.0, 0.0]);
    let [x, v] = pushed(&[(50.0, 50.01, 2.5)], 50.01);
    let there = PlanarTranslation {
        position: [x, 0.0].into(),
        velocity: [v, 0.0].into(),
    };
    by_every_method!(Pulse::default(), there, 50.01, 40.0, [0.0, 0.0]);
}

#[test]
fn bounds_are_parameters_and_inputs() {
    for (ignition, burn) in [
        (2.0, 1.5),
        (1.0 / 3.0, 1e-4),
        (7.1, 0.3),
        (-4.0, 6.0),
        (1e3, 1.0),
    ] {
        let body = Burn::new(BurnParams {
            ignition,
            burn,
            thrust: 60.0,
        })
        .unwrap();
        let from = f64::max(ignition, 0.0);
        let to = f64::min(ignition + burn, 10.0).max(from);
        let pushes = if from < 10.0 {
            vec![(from, to, 20.0)]
        } else {
            vec![]
        };
        by_every_method!(body.clone(), rest(), 0.0, 10.0, pushed(&pushes, 10.0));
    }
    let input = GivenInput {
        start: 4.3,
        thrust: 8.0,
    };
    let end = Given::<f64>::default()
        .integrate(&rest())
        .input(input)
        .to(10.0)
        .unwrap();
    assert_near(&end, pushed(&[(2.65, 10.0, 4.0)], 10.0));
}

/// A body under a force of one newton per kilogram while a condition holds, and when it does.
macro_rules! while_it_holds {
    ($($name:ident: $condition:expr, $pushes:expr;)*) => {
        #[test]
        fn forms_of_conditions() {
            $({
                rigid_body!($name {
                    motion: planar_translation,
                    params: [a = 3.1[s], w = 0.07[s], T = 2.3[s], n = 4, far = 1e6[s]],
                    mass: 1[kg],
                    forces: [push = world(if $condition { 1 } else { 0 }, 0 * (a + w + T + far + n * 1[s]))],
                });
                let pushes: Vec<(f64, f64)> = $pushes.into_iter().collect();
                let pushes: Vec<_> = pushes.into_iter().map(|(from, to)| (from, to, 1.0)).collect();
                by_every_method!($name::default(), rest(), 0.0, 20.0, pushed(&pushes, 20.0));
            })*
        }
    };
}

while_it_holds! {
    Quotient: t / T > 1, [(2.3, 20.0)];
    Difference: a - t < w, [(3.1 - 0.07, 20.0)];
    Window: (t - a).abs() < w, [(3.1 - 0.07, 3.1 + 0.07)];
    Later: t - far > 3[s] - far, [(3.0, 20.0)];
    Scaled: 3 * (t - a) / w >= -6, [(3.1 - 0.14, 20.0)];
    Least: t.min(a) * 2 < 5[s], [(0.0, 2.5)];
    Largest: (t - 1[s]).max(a - t) < 1.5[s], [(1.6, 2.5)];
    Clamped: t.clamp(1[s], a) > 2[s], [(2.0, 20.0)];
    Sign: (t - a).signum() + (t - 5[s]).signum() == 0, [(3.1, 5.0)];
    Not: !(t < a) && !(t > 3.2[s] || t > 4[s]), [(3.1, 3.2)];
    Chosen: t < (if n > 3 { a } else { T }), [(0.0, 3.1)];
    Both: (if t < a { 2 * t } else { t }) > 6[s], [(3.0, 3.1), (6.0, 20.0)];
    Whole: (t / T).floor() == 3, [(6.9, 9.2)];
    Above: (t / T).ceil() < n, [(0.0, 6.9)];
    Duty: t / T - (t / T).floor() < 0.25, (0..9).map(|k| (2.3 * f64::from(k), (2.3 * (f64::from(k) + 0.25)).min(20.0)));
    Wave: (TAU * t / T).sin() > 0, (0..9).map(|k| (2.3 * f64::from(k), (2.3 * (f64::from(k) + 0.5)).min(20.0)));
    Peaks: 2 * (PI * t / 4[s]).cos() >= 1, [(0.0, 4.0 / 3.0), (8.0 - 4.0 / 3.0, 8.0 + 4.0 / 3.0), (16.0 - 4.0 / 3.0, 16.0 + 4.0 / 3.0)];
}

rigid_body!(Ramp {
    motion: planar_translation,
    mass: 1[kg],
    forces: [push = world(
        (t - 3[s]).abs() * 1[N / s] + (t - 7[s]).max(0) * (t - 7[s]) * 1[N / s ^ 2],
        0
    )],
});

/// Continuous, but not smooth: by methods that are exact for what is between.
#[test]
fn corners_are_ends_of_steps() {
    let velocity = 4.5 + 0.5 * 49.0 + 9.0;
    let position = 9.0 + 4.5 * 7.0 + f64::powi(7.0, 3) / 6.0 + f64::powi(3.0, 4) / 12.0;
    let by = |method| {
        Ramp::default()
            .integrate(&rest())
            .method(Fixed { method, step: 9.0 })
            .to(10.0)
    };
    assert_near(&by(DormandPrince8).unwrap(), [position, velocity]);
    assert_eq!(next_switch(&Ramp::default(), &(), 0.0, 10.0), Some(3.0));
    assert_eq!(next_switch(&Ramp::default(), &(), 10.0, 0.0), Some(7.0));
    assert_eq!(next_switch(&Ramp::default(), &(), 3.0, 7.0), None);
}

#[test]
fn samples_and_events_see_each_side() {
    let pulse = Pulse::default();
    for sample in pulse.integrate(&rest()).samples(51.0, 0.005) {
        let integrate::Sample { time, state } = sample.unwrap();
        let until = time.clamp(50.0, 50.01);
        assert_near(&state, pushed(&[(50.0, until, 2.5)], time.max(50.0)));
    }
    let mut fast = pulse
        .integrate(&rest())
        .events(100.0, |_, state| state.velocity.x - 0.0125);
    let event = fast.next().unwrap().unwrap();
    assert!((event.time - 50.005).abs() < 1e-12 && event.rises);
    assert!(fast.next().is_none());
}

#[test]
fn members_move_as_they_would_alone() {
    let ignition = |i: u32| 0.3 + 0.37 * f64::from(i);
    let params = |i| BurnParams {
        ignition: ignition(i),
        burn: 0.01 + 0.1 * f64::from(i),
        thrust: 6.0,
    };
    for step in [0.07, 100.0] {
        for (max_step, breaks) in [(f64::INFINITY, vec![]), (0.05, vec![3.3, 1.0, 7.0])] {
            let fixed = Fixed {
                method: Tsitouras5,
                step,
            };
            let mut all =
                Ensemble::<Burn<f64>>::with_params((0..21).map(|i| (params(i), rest()))).unwrap();
            let mut each = all.clone();
            let motion = all
                .integrate()
                .method(fixed)
                .max_step(max_step)
                .breaks(&breaks);
            motion.to(5.0).unwrap();
            each.integrate()
                .max_step(max_step)
                .breaks(breaks.iter())
                .to(5.0)
                .unwrap();
            for i in 0..21 {
                let body = Burn::new(params(i)).unwrap();
                let alone = body.integrate(&rest()).max_step(max_step).breaks(&breaks);
                let (from, to) = (
                    ignition(i).min(5.0),
                    (ignition(i) + params(i).burn).min(5.0),
                );
                assert_near(&each.state(i as usize), pushed(&[(from, to, 2.0)], 5.0));
                assert_eq!(all.state(i as usize), alone.method(fixed).to(5.0).unwrap());
            }
        }
    }
}

rigid_body!(Bell {
    motion: planar_translation,
    mass: 2[kg],
    forces: [blow = world(8[N] * (-((t - 40[s]) / 0.01[s]).powi(2)).exp(), 1e-3[N])],
});

#[test]
fn what_cannot_be_seen_is_said() {
    let (bell, momentum) = (Bell::default(), 8.0 * 0.01 * std::f64::consts::PI.sqrt());
    let off = |end: PlanarTranslation| (2.0 * end.velocity.x - momentum).abs();
    let motion = || bell.integrate(&rest());
    assert!(off(motion().max_step(0.02).to(100.0).unwrap()) < 1e-8);
    let places = [40.05, 39.95, 40.0];
    assert!(off(motion().breaks(places).to(100.0).unwrap()) < 1e-8);
    assert!(off(motion().breaks(&places).to(100.0).unwrap()) < 1e-8);
    assert!(
        off(motion()
            .breaks(places.iter().map(|at| at + 0.001))
            .to(100.0)
            .unwrap())
            < 1e-8
    );
    let outside = [-3.0, 200.0];
    assert_eq!(motion().breaks(outside).to(100.0), motion().to(100.0));
    // after the steps have ended there, so do samples and steps
    let ends: Vec<f64> = motion()
        .breaks(places)
        .steps(100.0)
        .map(|step| step.unwrap().time)
        .collect();
    assert!(places.iter().all(|place| ends.contains(place)));
    let steps = motion()
        .max_step(0.25)
        .steps(10.0)
        .map(|step| step.unwrap().time);
    let steps: Vec<f64> = steps.collect();
    assert!(
        steps
            .windows(2)
            .all(|ends| ends[1] - ends[0] < 0.25 + 1e-12)
            && steps.len() < 50
    );
}

#[test]
fn steps_that_are_none_are_errors() {
    for max_step in [0.0, -1.0, f64::NAN, 1e-30, f64::NEG_INFINITY] {
        let bell = Bell::default();
        let motion = || bell.integrate(&rest()).starting_at(1.0).max_step(max_step);
        let is_told = |end: Result<_, IntegrationError<_>>| match end.unwrap_err() {
            IntegrationError::InvalidSetting { setting, .. } => setting == Setting::MaxStep,
            _ => false,
        };
        let steps = Fixed {
            method: Verner9,
            step: 0.1,
        };
        assert!(is_told(motion().to(2.0)), "{max_step}");
        assert!(is_told(motion().method(steps).to(2.0)), "{max_step}");
        let is_of_all = |end: Result<(), EnsembleError<_>>| match end.unwrap_err() {
            EnsembleError::Setting(invalid) => invalid.setting == Setting::MaxStep,
            EnsembleError::Member(_) => false,
        };
        let mut all = Ensemble::new(&Burn::<f64>::default(), [rest(); 3]);
        let each = all.integrate().starting_at(1.0).max_step(max_step);
        assert!(is_of_all(each.to(2.0)), "{max_step}");
        let in_lanes = all.integrate().starting_at(1.0).max_step(max_step);
        assert!(is_of_all(in_lanes.method(steps).to(2.0)), "{max_step}");
    }
}

/// By hand, with a switch that is nobody's business to find.
struct Kicked;

impl RigidBody for Kicked {
    type Scalar = f64;
    type State = PlanarTranslation;
    type Input = f64;

    fn acceleration(
        &self,
        time: f64,
        _: &PlanarTranslation,
        start: &f64,
    ) -> nalgebra::Vector2<f64> {
        [
            if time > *start && time <= start + 1e-3 {
                7.0
            } else {
                0.0
            },
            0.0,
        ]
        .into()
    }

    fn switches(&self, start: &f64, times: &mut Switches) {
        times.at(*start);
        times.at(start + 1e-3);
    }
}

impl Integrate for Kicked {
    type Best = newton_euler::integrate::DormandPrince;
}

#[test]
fn by_hand_and_under_control() {
    let end = Kicked.integrate(&rest()).input(12.5).to(30.0).unwrap();
    assert_near(&end, pushed(&[(12.5, 12.501, 7.0)], 30.0));
    // a controller that asks for one in each of its periods
    let motion = Kicked.integrate(&rest()).control(1.0, |time, _| time + 0.4);
    let pushes: Vec<_> = (0..6)
        .map(|k| (f64::from(k) + 0.4, f64::from(k) + 0.401, 7.0))
        .collect();
    assert_near(&motion.to(6.0).unwrap(), pushed(&pushes, 6.0));
}
