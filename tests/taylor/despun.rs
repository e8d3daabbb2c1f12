//! Axes that do not spin with a symmetric body. Every motion is compared with that of a twin: the
//! same body with numbers that are equal only at run time, so that its series use its own axes.

use nalgebra::Vector3;
use newton_euler::integrate::{IntegrationError, Motion, taylor, taylor_step};
use newton_euler::prelude::*;
use newton_euler::structure::{Structured, Symmetry};

use crate::motions::{check, tilted};
use crate::reference::distance;

/// A body that is symmetric about its z, and its twin.
macro_rules! twins {
    ($symmetric:ident, $twin:ident: [$($head:tt)*], [$($tail:tt)*]) => {
        newton_euler::rigid_body!($symmetric {
            $($head)*
            params: [across = 0.9[kg * m ^ 2], along = 0.6[kg * m ^ 2]],
            inertia: principal(across, across, along),
            $($tail)*
        });
        newton_euler::rigid_body!($twin {
            $($head)*
            params: [across = 0.9[kg * m ^ 2], again = 0.9[kg * m ^ 2], along = 0.6[kg * m ^ 2]],
            inertia: principal(across, again, along),
            $($tail)*
        });
    };
}

twins!(Top, TopTwin: [motion: fixed_point(foot), mass: 2[kg],], [
    points: [foot = (0, 0, -0.3)],
    fields: [weight = mass * world(0, 0, -9.80665[m / s ^ 2])],
    outputs: [taylor, energy],
]);

twins!(Rocket, RocketTwin: [motion: spatial, inputs: [thrust[N], wind = world(_, _, _)[m / s]], mass: 2[kg],], [
    points: [tail = (0, 0, -0.8), mast = world(1, 2, 9)],
    locals: [air = velocity - wind],
    fields: [weight = mass * world(0, 0, -9.80665[m / s ^ 2])],
    forces: [
        engine = body(0, 0, thrust + (3 * t / 1[s]).sin() * 1[N]).at(tail),
        drag = -0.01 * air.norm() * air,
        tether = (1[N / m] * (mast.position() - tail.position())).at(tail),
    ],
    outputs: [taylor],
]);

// symmetric about (2, -1, 2) / 3
newton_euler::rigid_body!(Leaning {
    motion: fixed_point(foot),
    mass: 2[kg],
    inertia: tensor {
        xx: 2.4,
        yy: 2.1,
        zz: 2.4,
        xy: -0.2,
        yz: -0.2,
        zx: 0.4
    }[kg * m ^ 2],
    points: [foot = (-0.2, 0.1, -0.2)],
    fields: [weight = mass * world(0, 0, -9.80665[m / s ^ 2])],
    outputs: [taylor],
});

newton_euler::rigid_body!(LeaningTwin {
    motion: fixed_point(foot),
    params: [xx = 2.4, yy = 2.1, zz = 2.4, xy = -0.2],
    mass: 2[kg],
    inertia: tensor {
        xx,
        yy,
        zz,
        xy,
        yz: -0.2,
        zx: 0.4
    }[kg * m ^ 2],
    points: [foot = (-0.2, 0.1, -0.2)],
    fields: [weight = mass * world(0, 0, -9.80665[m / s ^ 2])],
    outputs: [taylor],
});

fn spun(spin: f64) -> Rotation {
    Rotation {
        attitude: tilted(),
        angular_velocity: [0.4, -0.7, spin].into(),
    }
}

fn launched() -> Spatial {
    Spatial {
        position: [0.3, -0.2, 0.5].into(),
        velocity: [1.0, -0.4, 6.0].into(),
        attitude: tilted(),
        angular_velocity: [0.4, -0.7, 9.0].into(),
    }
}

/// The largest difference of two states.
trait Near: State {
    fn difference(&self, other: &Self) -> f64;
}

impl Near for Rotation {
    fn difference(&self, other: &Self) -> f64 {
        let rates = (self.angular_velocity - other.angular_velocity).amax();
        distance(&self.attitude, &other.attitude).max(rates)
    }
}

impl Near for Spatial {
    fn difference(&self, other: &Self) -> f64 {
        let paths = (self.position - other.position).amax();
        let velocities = (self.velocity - other.velocity).amax();
        let rates = (self.angular_velocity - other.angular_velocity).amax();
        let turns = distance(&self.attitude, &other.attitude);
        paths.max(velocities).max(rates).max(turns)
    }
}

/// All that a motion hands out, forth and back, beside the same of its twin.
fn compare<B, T>(body: &B, twin: &T, start: &B::State, input: (&B::Input, &T::Input), limit: f64)
where
    B: Taylor<State: Near + std::fmt::Debug> + Structured,
    T: Taylor<State = B::State> + Structured,
{
    let [of_body, of_twin] = [B::STRUCTURE, T::STRUCTURE].map(|structure| structure.angular.body);
    assert!(matches!(of_body, Symmetry::About(_)) && B::STRUCTURE.keeps_spin);
    assert_eq!(of_twin, Symmetry::None);
    for end in [6.0, -6.0] {
        let (mut motion, mut other) = (
            Motion::<_, 21>::new(body, 1.5, start),
            Motion::<_, 21>::new(twin, 1.5, start),
        );
        assert_eq!(motion.state().difference(start), 0.0);
        while let Some(step) = motion.step_towards(end, input.0, 1e-13).unwrap() {
            let middle = 0.5 * (step.start() + step.end());
            let [between, last] = [step.at(middle), step.at(step.end())];
            while other
                .step_towards(middle, input.1, 1e-13)
                .unwrap()
                .is_some()
            {}
            let difference = between.difference(&other.state());
            assert!(difference < limit, "{difference:e} at {middle}");
            let difference = last.difference(&motion.state());
            assert!(difference < 1e-12, "{difference:e} at the end of a step");
        }
        while other.step_towards(end, input.1, 1e-13).unwrap().is_some() {}
        let difference = motion.state().difference(&other.state());
        assert!(difference < limit, "{difference:e} at {end}");
    }
}

/// Errors of steps, 1e-13 each, some hundred steps, and what the motion makes of them.
const LIMIT: f64 = 1e-10;

#[test]
fn heavy_tops_move_as_their_twins() {
    for (across, along) in [(0.9, 0.6), (0.9, 1.5), (0.9, 0.05), (0.9, 0.9)] {
        let body = Top::new(TopParams { across, along }).unwrap();
        let again = across;
        let twin = TopTwin::new(TopTwinParams {
            across,
            again,
            along,
        });
        for spin in [11.0, -11.0, 0.0] {
            compare(
                &body,
                twin.as_ref().unwrap(),
                &spun(spin),
                (&(), &()),
                LIMIT,
            );
        }
    }
}

#[test]
fn about_an_axis_that_is_not_a_coordinate_axis() {
    let Symmetry::About(axis) = Leaning::STRUCTURE.angular.body else {
        panic!("symmetric")
    };
    assert_eq!(axis, [2.0 / 3.0, -1.0 / 3.0, 2.0 / 3.0]);
    let start = Rotation {
        attitude: tilted(),
        angular_velocity: [6.0, -3.5, 5.0].into(),
    };
    compare(
        &Leaning::default(),
        &LeaningTwin::default(),
        &start,
        (&(), &()),
        LIMIT,
    );
}

#[test]
fn a_rocket_under_thrust() {
    let (thrust, wind) = (25.0, [-1.5, 0.5, 1.0].into());
    compare(
        &Rocket::default(),
        &RocketTwin::default(),
        &launched(),
        (
            &RocketInput { thrust, wind },
            &RocketTwinInput { thrust, wind },
        ),
        LIMIT,
    );
}

/// Another thrust from the middle on.
#[test]
fn inputs_may_change_on_the_way() {
    let wind = [0.5, 0.0, -1.0].into();
    let (rocket, twin) = (Rocket::default(), RocketTwin::default());
    let mut motion = Motion::<_, 21>::new(&rocket, 0.0, &launched());
    let mut other = Motion::<_, 21>::new(&twin, 0.0, &launched());
    for (end, thrust) in [(2.0, 25.0), (4.0, 0.0)] {
        let (input, same) = (
            RocketInput { thrust, wind },
            RocketTwinInput { thrust, wind },
        );
        while motion.step_towards(end, &input, 1e-13).unwrap().is_some() {}
        while other.step_towards(end, &same, 1e-13).unwrap().is_some() {}
    }
    assert!(motion.state().difference(&other.state()) < LIMIT);
}

/// Where the x axis of the body, which spins with it, passes the horizontal.
#[test]
fn events_of_what_spins() {
    fn times<B: Taylor<State = Rotation, Input = ()>>(body: &B) -> Vec<(f64, bool)> {
        let mut motion = Motion::<_, 21>::new(body, 0.0, &spun(11.0));
        let mut times = Vec::new();
        while let Some(step) = motion.step_towards(3.0, &(), 1e-13).unwrap() {
            let height = |_: f64, state: &Rotation| (state.attitude * Vector3::x()).z;
            times.extend(step.zeros(height).map(Result::unwrap).map(|event| {
                assert!(height(0.0, &event.state).abs() < 1e-12);
                (event.time, event.rises)
            }));
        }
        times
    }
    let (found, expected) = (times(&Top::default()), times(&TopTwin::default()));
    assert!(found.len() > 8 && found.len() == expected.len());
    for (found, expected) in found.iter().zip(&expected) {
        assert!(
            (found.0 - expected.0).abs() < LIMIT && found.1 == expected.1,
            "{found:?} for {expected:?}"
        );
    }
}

/// Series are in the axes of the body for who asks for them.
#[test]
fn series_are_those_of_the_body() {
    check("top", &Top::default(), &spun(5.0), &());
    check("leaning", &Leaning::default(), &spun(5.0), &());
    let input = RocketInput {
        thrust: 25.0,
        wind: [-1.5, 0.5, 1.0].into(),
    };
    check("rocket", &Rocket::default(), &launched(), &input);
}

#[test]
fn one_step_is_of_its_order() {
    let (body, start) = (Top::default(), spun(5.0));
    let error = |step: f64| {
        let by_step = taylor_step::<_, 9>(&body, 2.0, &start, &(), step);
        let exact = taylor(&body, &start, &(), 2.0..2.0 + step, 1e-15).unwrap();
        by_step.difference(&exact)
    };
    let slope = (error(0.1) / error(0.05)).log2();
    assert!((slope - 9.0).abs() < 0.4, "{slope}");
}

/// What ends a motion on the way tells the state in the axes of the body.
#[test]
fn errors_tell_the_state_of_the_body() {
    let body = Top::default();
    let mut motion = Motion::<_, 21>::new(&body, 0.0, &spun(11.0));
    while motion.step_towards(1.0, &(), 1e-12).unwrap().is_some() {}
    let here = motion.state();
    let error = motion.step_towards(2.0, &(), 0.0).unwrap_err();
    let IntegrationError::InvalidSetting { time, state, .. } = error else {
        panic!("{error:?}")
    };
    assert_eq!((time, state), (1.0, here));
    let expected = taylor(&TopTwin::default(), &spun(11.0), &(), 0.0..1.0, 1e-13).unwrap();
    assert!(state.difference(&expected) < LIMIT);
}

/// It takes fewer steps, and never more: of a slender, a common and a flat top.
#[test]
fn steps_are_longer() {
    fn steps<B: Taylor<State = Rotation, Input = ()>>(body: &B) -> f64 {
        let mut motion = Motion::<_, 17>::new(body, 0.0, &spun(20.0));
        let mut count = 0.0;
        while motion.step_towards(20.0, &(), 1e-9).unwrap().is_some() {
            count += 1.0;
        }
        count
    }
    for (along, most) in [(0.1, 0.45), (0.6, 0.75), (1.7, 1.02)] {
        let (across, again) = (0.9, 0.9);
        let body = Top::new(TopParams { across, along }).unwrap();
        let twin = TopTwin::new(TopTwinParams {
            across,
            again,
            along,
        });
        let (despun, plain) = (steps(&body), steps(&twin.unwrap()));
        assert!(
            despun <= most * plain,
            "{despun} of {plain} steps, along {along}"
        );
    }
}

/// Rounding does not add up, in 10⁶ steps: the spin is kept to the bit, energy and the vertical angular momentum to a few parts in 10¹³.
#[test]
fn long_runs_keep_what_is_conserved() {
    let (body, start) = (Top::default(), spun(11.0));
    let energy =
        |state: &Rotation| body.kinetic_energy(state) + body.potential_energy(0.0, state, &());
    // about the foot, 0.3 m below G
    let across = 0.9 + 2.0 * 0.3 * 0.3;
    let vertical = |state: &Rotation| {
        let momentum = state
            .angular_velocity
            .component_mul(&Vector3::new(across, across, 0.6));
        (state.attitude * momentum).z
    };
    let mut motion = Motion::<_, 17>::new(&body, 0.0, &start);
    let steps = if cfg!(debug_assertions) {
        10_000
    } else {
        1_000_000
    };
    for _ in 0..steps {
        motion.step(0.06, &()).unwrap();
    }
    let end = motion.state();
    assert_eq!(end.angular_velocity.z, 11.0);
    assert!((energy(&end) / energy(&start) - 1.0).abs() < 1e-12);
    assert!((vertical(&end) / vertical(&start) - 1.0).abs() < 1e-12);
}
