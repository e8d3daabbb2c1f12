//! wrenfold, a code generator in Python. It prints Rust for the same equations, which are written
//! for it in `generate.py`.

use nalgebra::Vector3;
use newton_euler::prelude::*;
use wrenfold_traits::{OutputSpan2D, Span2D};

use crate::bodies::{General, GeneralInput};
use crate::pair::{Pair, Side};
use crate::state;
use crate::table::Table;

#[rustfmt::skip]
mod generated;

/// The body as wrenfold generated it. Its input is the force.
struct Wrenfold;

/// A column vector for wrenfold's traits, which use another version of nalgebra.
struct Column<const N: usize>([f64; N]);

impl<const N: usize> Span2D<N, 1> for Column<N> {
    type ValueType = f64;

    #[inline(always)]
    fn get(&self, row: usize, _: usize) -> f64 {
        self.0[row]
    }
}

impl<const N: usize> OutputSpan2D<N, 1> for Column<N> {
    type ValueType = f64;

    #[inline(always)]
    fn set(&mut self, row: usize, _: usize, value: f64) {
        self.0[row] = value;
    }
}

impl RigidBody for Wrenfold {
    type Scalar = f64;
    type State = Spatial;
    type Input = Vector3<f64>;

    #[inline(always)]
    fn acceleration(&self, _: f64, state: &Spatial, force: &Vector3<f64>) -> SpatialAcceleration {
        let (mut linear, mut angular) = (Column([0.0; 3]), Column([0.0; 3]));
        generated::acceleration(
            &Column(state.attitude.coords.into()),
            &Column(state.angular_velocity.into()),
            &Column((*force).into()),
            &mut linear,
            &mut angular,
        );
        SpatialAcceleration {
            linear: linear.0.into(),
            angular: angular.0.into(),
        }
    }
}

pub fn measure(table: &mut Table) {
    let case = |x| (state(x), state(x).angular_velocity * 3.0);
    let ours = Side::new(General::<f64>::default(), |x| {
        let (state, force) = case(x);
        (state, GeneralInput { force })
    });
    let theirs = Side::new(Wrenfold, case);
    let what = "acceleration, against wrenfold";
    let pair = Pair::checked(what, &ours, &theirs, |one, other| {
        (one.linear - other.linear).norm() + (one.angular - other.angular).norm()
    });
    pair.independent(table, [None, None]);
    let by_hand = |state: &mut Spatial, force: &mut Vector3<f64>, a: &SpatialAcceleration| {
        state.angular_velocity += a.angular * 1e-6;
        *force += a.linear * 1e-9;
    };
    let ours = |state: &mut Spatial, input: &mut GeneralInput<f64>, a: &SpatialAcceleration| {
        by_hand(state, &mut input.force, a);
    };
    pair.chain(table, None, ours, by_hand);
}
