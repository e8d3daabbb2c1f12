//! A NaN propagates through every evaluation that reads it.

use newton_euler::columns::{Columnar, Columns, Sink, Source};
use newton_euler::prelude::*;
use newton_euler::state::Coordinates;

use crate::kinds::*;

/// Numbers one after another.
struct List(Vec<f64>);

impl List {
    fn of(value: &impl Columns<f64>) -> Self {
        let mut list = Self(Vec::new());
        value.write(&mut list);
        list
    }

    /// The same with another number at one place.
    fn with(&self, place: usize, number: f64) -> Numbers<'_> {
        Numbers {
            list: &self.0,
            place,
            number,
            next: 0,
        }
    }
}

impl Sink<f64> for List {
    fn put(&mut self, scalar: f64) {
        self.0.push(scalar);
    }
}

struct Numbers<'l> {
    list: &'l [f64],
    place: usize,
    number: f64,
    next: usize,
}

impl Source<f64> for Numbers<'_> {
    fn take(&mut self) -> f64 {
        let place = self.next;
        self.next += 1;
        if place == self.place {
            self.number
        } else {
            self.list[place]
        }
    }
}

/// A state in which nothing is zero, or where a function has a bend.
fn state<S: Coordinates<Scalar = f64, Acceleration: Columns<f64>> + Columns<f64> + Default>() -> S {
    struct Some(f64);
    impl Source<f64> for Some {
        fn take(&mut self) -> f64 {
            self.0 = (self.0 * 37.0 + 0.11).fract();
            self.0 + 0.05
        }
    }
    let mut some = Some(0.3);
    S::default().moved(&(S::read(&mut some).rate(&Columns::read(&mut some)) * 0.8))
}

/// What depends on a number, as a small change of it shows, is not a number where the number is none. The rest may be anything. And infinite
/// numbers do no harm.
fn hands_on<V: Columns<f64>>(from: &V, evaluate: impl Fn(&V) -> Vec<f64>) {
    let list = List::of(from);
    let before = evaluate(from);
    assert!(before.iter().all(|number| number.is_finite()), "{before:?}");
    for place in 0..list.0.len() {
        let with = |number| evaluate(&V::read(&mut list.with(place, number)));
        let (near, none) = (with(list.0[place] * 1.01), with(f64::NAN));
        for (output, (before, near)) in before.iter().zip(near).enumerate() {
            if *before != near {
                assert!(
                    none[output].is_nan(),
                    "output {output} of number {place}: {}",
                    none[output]
                );
            }
        }
        for number in [
            f64::INFINITY,
            f64::NEG_INFINITY,
            f64::MAX,
            f64::MIN,
            5e-324,
            -0.0,
        ] {
            let _ = with(number);
        }
    }
}

/// The acceleration of a body, and what else is asked of it, by its state, its inputs and time.
fn check<B>(body: &B, input: &B::Input, also: impl Fn(f64, &B::State, &B::Input) -> Vec<f64>)
where
    B: RigidBody<Scalar = f64>,
    B::State: Coordinates<Acceleration: Columns<f64>> + Columns<f64> + Default,
{
    let all = |time: f64, state: &B::State, input: &B::Input| {
        let mut all = List::of(&body.acceleration(time, state, input)).0;
        all.extend(also(time, state, input));
        all
    };
    let state = state::<B::State>();
    hands_on(&state, |state| all(0.3, state, input));
    hands_on(&0.3, |time| all(*time, &state, input));
}

/// The same, by its inputs too.
fn check_inputs<B: Columnar<f64, State: Default>>(
    body: &B,
    also: impl Fn(f64, &B::State, &B::Input) -> Vec<f64>,
) {
    let list = List(vec![0.7; 8]);
    let input = Columns::read(&mut list.with(0, 0.6));
    check(body, &input, &also);
    let state = state::<B::State>();
    hands_on(&input, |input| {
        let mut all = List::of(&body.acceleration(0.3, &state, input)).0;
        all.extend(also(0.3, &state, input));
        all
    });
}

fn energies<B: Energy<Scalar = f64>>(
    body: &B,
) -> impl Fn(f64, &B::State, &B::Input) -> Vec<f64> + '_ {
    |time, state, input| {
        vec![
            body.kinetic_energy(state),
            body.potential_energy(time, state, input),
        ]
    }
}

fn nothing<B: RigidBody>(_: f64, _: &B::State, _: &B::Input) -> Vec<f64> {
    Vec::new()
}

#[test]
fn in_space() {
    let body = Craft::<f64>::default();
    check_inputs(&body, |time, state, input| {
        let mut all = energies(&body)(time, state, input);
        for vector in [
            body.linear_momentum(state),
            body.angular_momentum(state),
            body.angular_momentum_about_pole(time, state),
            body.applied(time, state, input).force,
            body.applied(time, state, input).moment,
        ] {
            all.extend(vector.iter());
        }
        for load in body.loads(time, state, input) {
            all.extend(load.force.iter().chain(&load.point).chain(&load.moment));
        }
        all
    });
    let body = Quadrotor::default();
    check(&body, &(), |time, state, ()| {
        let drives = body.inverse(time, state, &SpatialAcceleration::default(), &());
        drives
            .thrust
            .iter()
            .chain(&drives.rotors)
            .copied()
            .collect()
    });
    let body = Dipole::default();
    check(&body, &(), energies(&body));
}

#[test]
fn held_and_turning() {
    let body = Turning::<f64>::default();
    check_inputs(&body, energies(&body));
    let body = Top::<f64>::default();
    check_inputs(&body, |time, state, input| {
        let mut all = energies(&body)(time, state, input);
        all.extend(body.reactions(time, state, input).ground.iter());
        all
    });
    let body = Rotor::<f64>::default();
    check_inputs(&body, |time, state, input| {
        let loads = body.reactions(time, state, input);
        loads.below.iter().chain(&loads.beside).copied().collect()
    });
    let body = Pendulum::<f64>::default();
    check_inputs(&body, |time, state, input| {
        body.reactions(time, state, input)
            .hold
            .iter()
            .copied()
            .collect()
    });
}

#[test]
fn points_planes_and_rods() {
    check_inputs(&Wave::<f64>::default(), nothing::<Wave<f64>>);
    check(&Stone::default(), &(), nothing::<Stone>);
    let body = Plank::<f64>::default();
    check_inputs(&body, energies(&body));
    check_inputs(&Slider::<f64>::default(), nothing::<Slider<f64>>);
    let body = Stick::<f64>::default();
    check_inputs(&body, energies(&body));
}

/// Under constraints too; what can say so, does.
#[test]
fn under_constraints() {
    let body = Bead::default();
    check(&body, &(), energies(&body));
    let lost = Planar {
        angle: f64::NAN,
        ..Planar::default()
    };
    assert!(body.reactions(0.0, &lost, &()).is_err());
    let inconsistent = body.project(0.0, &mut lost.clone(), &()).unwrap_err();
    assert!(inconsistent.violation.is_nan());
    let mut far = Planar {
        angle: f64::INFINITY,
        ..Planar::default()
    };
    assert!(body.project(0.0, &mut far, &()).is_err());
}

/// In closed form: all that a state is.
#[test]
fn closed_forms() {
    fn check<B: Flow<Scalar = f64>>(body: &B)
    where
        B::State: Coordinates<Acceleration: Columns<f64>> + Columns<f64> + Default,
    {
        let state = state::<B::State>();
        let after = |state: &B::State, time: f64| List::of(&body.flow(state, time)).0;
        hands_on(&state, |state| after(state, 0.7));
        hands_on(&0.7, |time| after(&state, *time));
    }
    check(&Brick::default());
    check(&Top::<f64>::default());
    check(&Pendulum::<f64>::default());
    check(&Needle::default());
}
