//! The outputs of bodies in a state.

use newton_euler::Scalar;
use newton_euler::columns::{Columnar, Columns};
use newton_euler::load::generic::{Load, PlanarLoad};
use newton_euler::prelude::*;
use newton_euler::scalar::Dual;
use newton_euler::state::Coordinates;
use newton_euler::wrench::generic::{PlanarWrench, Wrench};

use crate::bits::{Bits, Numbers};
use crate::kinds::*;

const STATES: usize = 50;

/// A state and an input of a generic body.
type At<B> = (<B as RigidBody>::State, <B as RigidBody>::Input);

/// In some states and under some inputs: the acceleration, and what else is asked.
fn of<T: Scalar, B: Columnar<T, State: Default>>(
    body: &B,
    also: impl Fn(&mut Bits, T, &At<B>),
) -> Bits {
    let (mut bits, mut numbers) = (Bits::new(), Numbers(3));
    for _ in 0..STATES {
        let time: T = Columns::read(&mut numbers);
        let at: At<B> = (numbers.state(), Columns::read(&mut numbers));
        bits.add(&body.acceleration(time, &at.0, &at.1));
        also(&mut bits, time, &at);
    }
    bits
}

/// The same of a body that is not generic and has no inputs.
fn of_doubles<B>(body: &B, also: impl Fn(&mut Bits, f64, &B::State)) -> Bits
where
    B: RigidBody<Scalar = f64, Input = ()>,
    B::State: Coordinates<Acceleration: Columns<f64>> + Columns<f64> + Default,
{
    let (mut bits, mut numbers) = (Bits::new(), Numbers(3));
    for _ in 0..STATES {
        let (time, state) = (Columns::read(&mut numbers), numbers.state());
        bits.add(&body.acceleration(time, &state, &()));
        also(&mut bits, time, &state);
    }
    bits
}

fn energy<T: Scalar, B: Energy<Scalar = T>>(body: &B, bits: &mut Bits, time: T, at: &At<B>) {
    bits.all([
        body.kinetic_energy(&at.0),
        body.potential_energy(time, &at.0, &at.1),
    ]);
}

fn wrench<T: Scalar>(bits: &mut Bits, wrench: &Wrench<T>) {
    bits.add(&wrench.force);
    bits.add(&wrench.moment);
}

fn planar_wrench<T: Scalar>(bits: &mut Bits, wrench: &PlanarWrench<T>) {
    bits.add(&wrench.force);
    bits.all([wrench.moment]);
}

pub fn craft<T: Scalar>() -> Bits {
    let body = Craft::<T>::default();
    of(&body, |bits, time, at| {
        let (state, input) = at;
        energy(&body, bits, time, at);
        bits.add(&body.linear_momentum(state));
        bits.add(&body.angular_momentum(state));
        bits.add(&body.angular_momentum_about_pole(time, state));
        wrench(bits, &body.applied(time, state, input));
        let still = Columns::read(&mut Numbers(4));
        wrench(bits, &body.residual(time, state, &still, &(), input));
        for Load {
            force,
            point,
            moment,
            ..
        } in body.loads(time, state, input)
        {
            for vector in [force, point, moment] {
                bits.add(&vector);
            }
        }
    })
}

pub fn turning<T: Scalar>() -> Bits {
    let body = Turning::<T>::default();
    of(&body, |bits, time, at| {
        energy(&body, bits, time, at);
        bits.add(&body.angular_momentum(&at.0));
    })
}

pub fn top<T: Scalar>() -> Bits {
    let body = Top::<T>::default();
    of(&body, |bits, time, at| {
        energy(&body, bits, time, at);
        bits.add(&body.reactions(time, &at.0, &at.1).ground);
    })
}

pub fn rotor<T: Scalar>() -> Bits {
    let body = Rotor::<T>::default();
    of(&body, |bits, time, at| {
        energy(&body, bits, time, at);
        let loads = body.reactions(time, &at.0, &at.1);
        bits.add(&loads.below);
        bits.add(&loads.beside);
    })
}

pub fn wave<T: Scalar>() -> Bits {
    of(&Wave::<T>::default(), |_, _, _| {})
}

pub fn bubble<T: Scalar>() -> Bits {
    of(&Bubble::<T>::default(), |_, _, _| {})
}

/// Derivatives of all functions.
pub fn slopes() -> Bits {
    let (body, mut numbers, mut bits) = (Wave::<Dual<f64, 2>>::default(), Numbers(5), Bits::new());
    for _ in 0..STATES {
        let [x, y]: [f64; 2] = core::array::from_fn(|_| Columns::read(&mut numbers));
        let position = [
            Dual::variable(x, 0),
            Dual::variable(y, 1),
            Dual::variable(x * y, 0),
        ];
        let state = newton_euler::state::generic::Translation {
            position: position.into(),
            ..Default::default()
        };
        let acceleration = body.acceleration(Dual::default(), &state, &());
        for component in acceleration.iter() {
            bits.all([component.value]);
            bits.all(component.derivatives);
        }
    }
    bits
}

pub fn plank<T: Scalar>() -> Bits {
    let body = Plank::<T>::default();
    of(&body, |bits, time, at| {
        let (state, input) = at;
        energy(&body, bits, time, at);
        bits.add(&body.linear_momentum(state));
        bits.all([body.angular_momentum(state)]);
        planar_wrench(bits, &body.applied(time, state, input));
        for PlanarLoad {
            force,
            point,
            moment,
            ..
        } in body.loads(time, state, input)
        {
            bits.add(&force);
            bits.add(&point);
            bits.all([moment]);
        }
    })
}

pub fn slider<T: Scalar>() -> Bits {
    of(&Slider::<T>::default(), |_, _, _| {})
}

pub fn pendulum<T: Scalar>() -> Bits {
    let body = Pendulum::<T>::default();
    of(&body, |bits, time, at| {
        energy(&body, bits, time, at);
        bits.add(&body.reactions(time, &at.0, &at.1).hold);
    })
}

pub fn stick<T: Scalar>() -> Bits {
    let body = Stick::<T>::default();
    of(&body, |bits, time, at| {
        energy(&body, bits, time, at);
        bits.add(&body.linear_momentum(&at.0));
        bits.add(&body.angular_momentum(&at.0));
    })
}

pub fn quadrotor() -> Bits {
    let (body, rest) = (Quadrotor::default(), SpatialAcceleration::default());
    of_doubles(&body, |bits, time, state| {
        let drives = body.inverse(time, state, &rest, &());
        bits.add(&drives.thrust);
        bits.add(&drives.rotors);
    })
}

pub fn dipole() -> Bits {
    let body = Dipole::default();
    of_doubles(&body, |bits, time, state| {
        bits.all([body.potential_energy(time, state, &())]);
    })
}

pub fn bead() -> Bits {
    let body = Bead::default();
    of_doubles(&body, |bits, time, state| {
        let pin = body.reactions(time, state, &());
        bits.add(&pin.expect("it hangs").hinge);
        for violation in body.violations(time, state, &()).as_ref() {
            bits.all(violation.position.into_iter().chain([violation.velocity]));
        }
        let mut near = *state;
        if body.project(time, &mut near, &()).is_ok() {
            bits.add(&near);
        }
    })
}
