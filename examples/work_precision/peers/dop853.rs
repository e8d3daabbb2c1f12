//! The Dormand-Prince pair of order 8 of the crate `differential-equations`, with error control and a right-hand side of plain numbers.
//!
//! E. Hairer, S. P. Nørsett, G. Wanner, Solving Ordinary Differential Equations I, 2nd edition, Springer (1993), II.5 and II.10.

use std::hint::black_box;

use differential_equations::control::ControlFlag;
use differential_equations::interpolate::Interpolation;
use differential_equations::prelude::{ExplicitRungeKutta, IVP, ODE, Solout, Solution};
use differential_equations::traits::State as Numbers;
use newton_euler::prelude::*;
use newton_euler::state::Coordinates;

use super::runge_kutta::rates;
use crate::method::Method;
use crate::problem::Problem;

/// N is the number of coordinates.
pub fn method<'p, B, const N: usize>(
    name: &'static str,
    problem: &'p Problem<B>,
) -> Method<'p, B::State>
where
    B: RigidBody<Scalar = f64, Input = (), State: Coordinates<Scalar = f64>>,
{
    Method::adaptive(name, |tolerance| {
        let start = black_box(&problem.start).coordinates();
        let start: [f64; N] = start.as_ref().try_into().ok()?;
        let pair = ExplicitRungeKutta::dop853().max_steps(usize::MAX);
        let solution = IVP::ode(&Motion(&problem.body), 0.0, problem.seconds, start)
            .solout(Last(problem.seconds))
            .method(pair.rtol(tolerance).atol(tolerance))
            .solve();
        let solution = solution.ok()?;
        let (_, end) = solution.last().ok()?;
        Some(B::State::from_coordinates(&list::<B, N>(end)))
    })
}

/// The motion of a body as an equation of plain numbers.
struct Motion<'p, B>(&'p B);

impl<B, const N: usize> ODE<f64, [f64; N]> for Motion<'_, B>
where
    B: RigidBody<Scalar = f64, Input = (), State: Coordinates<Scalar = f64>>,
{
    #[inline(always)]
    fn diff(&self, time: f64, numbers: &[f64; N], derivatives: &mut [f64; N]) {
        let rates = rates(self.0, time, &list::<B, N>(numbers));
        derivatives.copy_from_slice(rates.as_ref());
    }
}

/// Plain numbers as the coordinates of a state.
#[inline(always)]
fn list<B, const N: usize>(numbers: &[f64; N]) -> <B::State as Coordinates>::Array
where
    B: RigidBody<State: Coordinates<Scalar = f64>>,
{
    let mut list = <B::State as Coordinates>::Array::default();
    list.as_mut().copy_from_slice(numbers);
    list
}

/// Keeps the end and nothing of the way.
struct Last(f64);

impl<Y: Numbers<f64>> Solout<f64, Y> for Last {
    #[inline(always)]
    fn solout<I: Interpolation<f64, Y> + ?Sized>(
        &mut self,
        time: f64,
        _: f64,
        state: &Y,
        _: &Y,
        _: &mut I,
        solution: &mut Solution<f64, Y>,
    ) -> ControlFlag<f64, Y> {
        if time >= self.0 {
            solution.push(time, state.clone());
        }
        ControlFlag::Continue
    }
}
