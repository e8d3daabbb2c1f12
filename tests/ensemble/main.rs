//! Ensembles: each member moves as it would alone, bit for bit.

use std::fmt::Debug;

use nalgebra::{Quaternion, UnitQuaternion, Vector2, Vector3};
use newton_euler::columns::{Generic, Source};
use newton_euler::ensemble::{Blocks, Ensemble, InvalidMember, Moves, OneByOne, Together};
use newton_euler::integrate::{
    Classical4, DormandPrince, DormandPrince8, Fixed, Midpoint, RungeKutta, Tolerant as _,
    Tsitouras5, Verner, Verner9,
};
use newton_euler::lanes::Width;
use newton_euler::{columns::Columns, integrate, prelude::*};

mod bodies;
mod changing;
mod errors;
mod integration;
mod settings;
mod sines;
#[path = "../handwritten/mod.rs"]
mod systems;

/// Numbers between -1 and 1, the same at each run.
struct Numbers(u64);

impl Source<f64> for Numbers {
    fn take(&mut self) -> f64 {
        self.0 = self
            .0
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1);
        #[expect(clippy::cast_precision_loss, reason = "any number will do")]
        let number = (self.0 >> 33) as f64 / f64::from(1_u32 << 30);
        number - 1.0
    }
}

/// A state with a unit attitude.
trait Unit: Sized {
    fn unit(self) -> Self {
        self
    }
}

fn normalized(q: UnitQuaternion<f64>) -> UnitQuaternion<f64> {
    UnitQuaternion::new_normalize(Quaternion::from(q.as_ref().coords))
}

impl Unit for Spatial {
    fn unit(self) -> Self {
        Self {
            attitude: normalized(self.attitude),
            ..self
        }
    }
}

impl Unit for Rotation {
    fn unit(self) -> Self {
        Self {
            attitude: normalized(self.attitude),
            ..self
        }
    }
}

impl Unit for Rod {
    fn unit(self) -> Self {
        let axis = nalgebra::Unit::new_normalize(self.axis.into_inner());
        Self {
            axis,
            axis_rate: self.axis_rate - axis.into_inner() * axis.dot(&self.axis_rate),
            ..self
        }
    }
}

impl Unit for systems::AssemblyState<f64> {
    fn unit(self) -> Self {
        Self {
            orbit: self.orbit.unit(),
            ball: self.ball.unit(),
            needle: self.needle.unit(),
            ..self
        }
    }
}

impl Unit for systems::DoublePendulumState<f64> {}
impl Unit for Translation {}
impl Unit for Planar {}
impl Unit for PlanarTranslation {}
impl Unit for Hinge {}

/// Compares an ensemble with its members alone, in all widths.
fn check<B>(params: impl Fn(f64) -> B::Params)
where
    B: Generic<State: Unit + PartialEq, Input: Clone> + Integrate<Best: Together<B>>,
    <B::State as State>::Acceleration: PartialEq + Debug + Columns<f64>,
{
    let mut numbers = Numbers(7);
    let count = 21;
    let states: Vec<B::State> = (0..count)
        .map(|_| B::State::read(&mut numbers).unit())
        .collect();
    let inputs: Vec<B::Input> = (0..count).map(|_| B::Input::read(&mut numbers)).collect();
    let params: Vec<B::Params> = (0..count)
        .map(|i| params(1.0 + 0.01 * f64::from(i)))
        .collect();
    let members = params.into_iter().zip(states.iter().cloned());
    let mut start = Ensemble::<B>::with_params(members).expect("possible bodies");
    for (index, input) in inputs.iter().enumerate() {
        start.inputs_mut().set(index, input);
    }
    let alone = states.iter().zip(&inputs).enumerate();
    let alone = alone.map(|(index, (state, input))| {
        let body = start.body(index);
        let acceleration = body.acceleration(0.3, state, input);
        let end = integrate::cf4(&body, state, input, 0.3..0.7, 7);
        (acceleration, end)
    });
    let alone: Vec<_> = alone.collect();
    for width in widths() {
        let mut ensemble = start.clone();
        ensemble.set_width(width);
        assert_eq!(ensemble.width(), width);
        let accelerations = ensemble.accelerations(0.3);
        ensemble.cf4(0.3..0.7, 7);
        for (index, (acceleration, end)) in alone.iter().enumerate() {
            assert_eq!(accelerations.get(index), *acceleration, "{width:?}");
            assert!(
                ensemble.state(index) == *end,
                "member {index}, {width:?}: {end:?}"
            );
        }
    }
    let fixed = |step| Steps(&start, step);
    fixed(0.06).move_as_alone(Classical4);
    fixed(0.06).move_as_alone(Tsitouras5);
    fixed(0.1).move_as_alone(DormandPrince8);
    fixed(0.1).move_as_alone(Verner9);
    fixed(0.02).move_as_alone(Midpoint);
    for tolerance in [1e-3, 1e-8, 1e-13] {
        moves_as_if_alone(&start, &widths(), Verner { tolerance });
    }
    let best = B::Best::with_tolerance(1e-8);
    moves_as_if_alone(&start, &[Width::One], OneByOne(best));
}

/// The widths that this processor has.
fn widths() -> Vec<Width> {
    let all = Width::ALL.into_iter();
    all.filter(|width| width.is_there()).collect()
}

/// Equal steps \[s\] in lanes.
struct Steps<'e, B: Generic>(&'e Ensemble<B>, f64);

impl<B> Steps<'_, B>
where
    B: Generic<State: PartialEq, Input: Clone> + Integrate<Best: Together<B>>,
{
    fn move_as_alone<M: RungeKutta>(&self, method: M) {
        let Self(start, step) = *self;
        moves_as_if_alone(start, &widths(), Fixed { method, step });
    }
}

/// All members together, in each of the widths, against each member alone: forwards, backwards, and with
/// steps that end at given times.
fn moves_as_if_alone<B, M>(start: &Ensemble<B>, widths: &[Width], method: M)
where
    B: Generic<State: PartialEq, Input: Clone> + Integrate<Best: Together<B>>,
    M: Moves<B> + Copy,
{
    let plain = (f64::INFINITY, &[][..]);
    for (end, (max_step, breaks), period) in [
        (0.7, plain, None),
        (-0.1, plain, Some(0.11)),
        (0.7, (0.17, &[0.4, 0.65, 9.0, 0.3][..]), Some(0.11)),
    ] {
        let alone = (0..start.len()).map(|index| {
            let motion = start.body(index);
            let motion = motion.integrate(&start.state(index)).starting_at(0.3);
            let motion = motion.method(method.alone());
            let motion = motion.max_step(max_step).breaks(breaks);
            let motion = motion.input(start.inputs().get(index));
            motion.to(end).unwrap()
        });
        let alone: Vec<B::State> = alone.collect();
        for width in widths {
            let mut ensemble = start.clone();
            ensemble.set_width(*width);
            let motion = ensemble.integrate().starting_at(0.3).method(method);
            let motion = motion.max_step(max_step).breaks(breaks);
            motion.to(end).unwrap();
            for (index, alone) in alone.iter().enumerate() {
                assert!(
                    ensemble.state(index) == *alone,
                    "member {index}, {width:?}, {}: {alone:?}",
                    std::any::type_name::<M>()
                );
            }
        }
        let limits = (end, max_step, breaks);
        are_sampled_as_if_alone(start, widths, method, limits, period);
    }
}

/// The samples of all members are those of each alone, also under inputs that change at a period.
fn are_sampled_as_if_alone<B, M>(
    start: &Ensemble<B>,
    widths: &[Width],
    method: M,
    (end, max_step, breaks): (f64, f64, &[f64]),
    period: Option<f64>,
) where
    B: Generic<State: PartialEq, Input: Clone> + Integrate<Best: Together<B>>,
    M: Moves<B> + Copy,
{
    let input = |time: f64, index: usize| {
        if period.is_none() || time < 0.45 {
            start.inputs().get(index)
        } else {
            B::Input::default()
        }
    };
    let alone = (0..start.len()).map(|index| {
        let (body, state) = (start.body(index), start.state(index));
        let motion = body
            .integrate(&state)
            .starting_at(0.3)
            .method(method.alone());
        let motion = motion.max_step(max_step).breaks(breaks);
        let samples: Vec<_> = match period {
            None => {
                let motion = motion.input(start.inputs().get(index));
                motion.samples(end, 0.07).map(Result::unwrap).collect()
            }
            Some(period) => {
                let motion = motion.control(period, |time, _| input(time, index));
                motion.samples(end, 0.07).map(Result::unwrap).collect()
            }
        };
        samples
    });
    let alone: Vec<_> = alone.collect();
    for width in widths {
        let mut ensemble = start.clone();
        ensemble.set_width(*width);
        let motion = ensemble.integrate().starting_at(0.3).method(method);
        let motion = motion.max_step(max_step).breaks(breaks);
        let samples: Vec<_> = match period {
            None => motion.samples(end, 0.07).map(Result::unwrap).collect(),
            Some(period) => {
                let motion = motion.control(period, |time, index, _| input(time, index));
                motion.samples(end, 0.07).map(Result::unwrap).collect()
            }
        };
        assert!(samples.len() > 5);
        for (index, alone) in alone.iter().enumerate() {
            assert_eq!(samples.len(), alone.len());
            for (sample, alone) in samples.iter().zip(alone) {
                assert!(
                    sample.time.to_bits() == alone.time.to_bits()
                        && sample.state.get(index) == alone.state,
                    "member {index} at {} s, {width:?}, {}, {period:?}: {:?}",
                    alone.time,
                    std::any::type_name::<M>(),
                    alone.state
                );
            }
        }
    }
}

#[test]
fn members_move_as_if_alone() {
    roomy(|| {
        check::<bodies::Free<f64>>(|factor| bodies::FreeParams {
            mass_factor: factor,
            arm: Vector3::new(0.2 * factor, 0.0, 0.1),
        });
        check::<bodies::Turning<f64>>(|moment| bodies::TurningParams { moment });
        check::<bodies::Thrown<f64>>(|factor| bodies::ThrownParams {
            gravity: 9.8 * factor,
        });
        check::<bodies::Plank<f64>>(|length| bodies::PlankParams { length });
        check::<bodies::Slider<f64>>(|_| ());
        check::<bodies::Pendulum<f64>>(|length| bodies::PendulumParams { length });
        check::<bodies::Top<f64>>(|_| ());
        check::<bodies::Stick<f64>>(|length| bodies::StickParams { length });
        check::<bodies::Rotor<f64>>(|_| ());
    });
}

#[test]
fn members_of_the_other_pair_move_as_if_alone() {
    let spinning = |angular_velocity: f64| Rotation {
        angular_velocity: Vector3::new(0.1, angular_velocity, 0.0),
        ..Rotation::default()
    };
    let body = bodies::Turning::default();
    let start = Ensemble::new(&body, (0..11_u8).map(|i| spinning(f64::from(i))));
    for tolerance in [1e-3, 1e-8, 1e-13] {
        moves_as_if_alone(&start, &widths(), DormandPrince { tolerance });
    }
}

#[test]
fn systems_move_as_if_alone() {
    roomy(|| check::<systems::DoublePendulum<f64>>(|factor| 9.8 * factor));
}

#[test]
fn joints_of_every_kind_move_as_if_alone() {
    roomy(|| check::<systems::Assembly<f64>>(|spin| 0.1 * spin));
}

/// Not optimized, a step in eight lanes takes megabytes of stack, of sixty coordinates tens of them.
fn roomy(checked: impl FnOnce() + Send + 'static) {
    let thread = std::thread::Builder::new().stack_size(64 << 20);
    let checked = thread.spawn(checked).expect("a thread");
    checked.join().expect("no other bits");
}

#[test]
fn one_body_for_all() {
    let body = bodies::Turning::default();
    let states = (0..3_u8).map(|i| Rotation {
        angular_velocity: Vector3::new(0.1, f64::from(i), 0.0),
        ..Rotation::default()
    });
    let mut ensemble = Ensemble::new(&body, states);
    assert_eq!((ensemble.len(), ensemble.is_empty()), (3, false));
    let torque = Vector3::new(0.0, 0.0, 1.0);
    *ensemble.inputs_mut() = Blocks::repeat(&bodies::TurningInput { torque }, 3);
    let turned = Rotation {
        angular_velocity: torque,
        ..Rotation::default()
    };
    ensemble.states_mut().set(1, &turned);
    let accelerations = ensemble.accelerations(0.0);
    assert_eq!(accelerations.get(1), Vector3::new(0.0, 0.0, 1.0 / 1.5));
    assert_eq!(accelerations.len(), 3);
}

#[test]
fn none_at_all() {
    let mut ensemble = Ensemble::new(&bodies::Slider::default(), []);
    ensemble.cf4(0.0..1.0, 10);
    ensemble.integrate().to(1.0).unwrap();
    assert!(ensemble.is_empty() && ensemble.accelerations(0.0).is_empty());
}

#[test]
fn observers_count_steps() {
    let mut ensemble = Ensemble::new(&bodies::Slider::default(), [PlanarTranslation::default()]);
    let mut seen = Vec::new();
    ensemble.cf4_observed(0.0..1.0, 250, |done| seen.push(done));
    assert_eq!(seen.last(), Some(&250));
    assert!(seen.windows(2).all(|pair| pair[0] < pair[1]));
}

#[test]
fn impossible_members_are_named() {
    let params = |moment| bodies::TurningParams { moment };
    let members = [params(1.0), params(5.0)].map(|params| (params, Rotation::default()));
    let InvalidMember { index, error } =
        Ensemble::<bodies::Turning<f64>>::with_params(members).unwrap_err();
    assert_eq!(index, 1);
    assert!(error.to_string().contains("triangle inequality"), "{error}");
}

#[test]
#[should_panic(expected = "there are 1 members, and no member 1")]
fn there_is_no_such_member() {
    let ensemble = Ensemble::new(&bodies::Slider::default(), [PlanarTranslation::default()]);
    let _ = ensemble.state(1);
}

#[test]
fn ensembles_are_read_as_they_were_written() {
    let state = |angle: f64| Planar {
        position: Vector2::new(angle, 0.1),
        angle,
        ..Planar::default()
    };
    let params = |length| bodies::PlankParams { length };
    let members = (0..11_u8).map(|i| (params(1.0 + 0.1 * f64::from(i)), state(f64::from(i))));
    let mut ensemble = Ensemble::<bodies::Plank<f64>>::with_params(members).unwrap();
    ensemble
        .inputs_mut()
        .set(10, &bodies::PlankInput { thrust: 0.1 });
    let written = serde_json::to_string(&ensemble).unwrap();
    let mut read: Ensemble<bodies::Plank<f64>> = serde_json::from_str(&written).unwrap();
    assert_eq!(serde_json::to_string(&read).unwrap(), written);
    for ensemble in [&mut ensemble, &mut read] {
        ensemble.cf4(0.0..1.0, 10);
    }
    assert!(ensemble.states() == read.states());

    let wrong = [
        (
            written.replace("[1.1]", "[0.0]"),
            "member 1: inertia must be positive",
        ),
        (
            written.replace("[1.1]", "[1.1,2.0]"),
            "expected 1 parameters, and there are 2",
        ),
        (
            written.replace("[1.1],", ""),
            "as many parameters or one for all",
        ),
        (
            written.replacen("[0.1]]", "[]]", 1),
            "expected 1 inputs, and there are 0",
        ),
        ("[]".to_owned(), "expected an ensemble: `params`"),
    ];
    for (text, reason) in wrong {
        let error = serde_json::from_str::<Ensemble<bodies::Plank<f64>>>(&text).unwrap_err();
        assert!(error.to_string().contains(reason), "{error}");
    }
    let turning = Ensemble::new(&bodies::Turning::default(), [Rotation::default()]);
    let written = serde_json::to_string(&turning)
        .unwrap()
        .replace("\"w\":1.0", "\"w\":0.9");
    let error = serde_json::from_str::<Ensemble<bodies::Turning<f64>>>(&written).unwrap_err();
    assert!(error.to_string().contains("unit quaternion"), "{error}");
}

/// What fills up the last block does not count.
#[test]
fn equal_lists() {
    let [a, b] = [Vector2::new(1.0, 2.0), Vector2::new(3.0, 4.0)];
    let list: Blocks<Vector2<f64>> = [a, b].into_iter().collect();
    let mut other: Blocks<Vector2<f64>> = [b, b].into_iter().collect();
    assert!(list != other);
    other.set(0, &a);
    assert!(list == other);
    let longer: Blocks<Vector2<f64>> = [a, b, b].into_iter().collect();
    assert!(list != longer);
    let nine: Blocks<Vector2<f64>> = [a; 9].into_iter().collect();
    let mut changed = nine.clone();
    changed.set(8, &b);
    assert!(nine != changed && nine == Blocks::repeat(&a, 9));
}
