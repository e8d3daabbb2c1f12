//! The steps of Newton's method: free quantities change until nothing accelerates.

use core::ops::ControlFlow;

use super::conditions::Conditions;
use super::least_change::Change;
use super::point::{Here, TOLERANCE};
use super::steady::Steady;
use crate::bodies::linearization::coordinated::Coordinated;
use crate::bodies::linearization::tangent;

/// The conditions of a steady motion, a start, and what may change.
pub struct Newton<'b, B: Coordinated<N, M>, C, const N: usize, const M: usize> {
    pub steady: Steady<'b, B, C, N>,
    pub state: B::State,
    pub input: [f64; M],
    /// One for free quantities, zero for others.
    pub free: Change<N, M>,
}

/// Where the steps end.
pub struct End<B: Coordinated<N, M>, const N: usize, const M: usize> {
    pub here: Here<B, N, M>,
    /// An equation that is singular there, and the index of the free quantity with which it changes
    /// without bound.
    pub singular: Option<(&'static str, usize)>,
}

impl<B: Coordinated<N, M>, const N: usize, const M: usize> End<B, N, M> {
    /// Whether nothing accelerates there.
    pub fn is_steady(&self) -> bool {
        self.here.worst <= TOLERANCE && self.singular.is_none()
    }
}

impl<B: Coordinated<N, M>, C, const N: usize, const M: usize> Newton<'_, B, C, N, M>
where
    C: Conditions<B::State, B::Input>,
{
    pub fn start(&self) -> Here<B, N, M> {
        let state = self.state.clone();
        Here::of(&self.steady, state, self.input, &Change::zero())
    }

    /// Where the steps from a start end.
    pub fn end(&self, start: Here<B, N, M>) -> End<B, N, M> {
        let first = start.about.rows;
        let here = self.nearest(start);
        let singular = here.singular(first.list(), &self.free);
        End { here, singular }
    }

    /// Whether the steps find a steady motion.
    pub fn is_solved(&self) -> bool {
        self.end(self.start()).is_steady()
    }

    fn nearest(&self, mut here: Here<B, N, M>) -> Here<B, N, M> {
        for _ in 0..STEPS {
            if here.worst <= f64::EPSILON * TOLERANCE {
                break;
            }
            match self.step(here) {
                ControlFlow::Continue(nearer) => here = nearer,
                ControlFlow::Break(last) => return last,
            }
        }
        here
    }

    /// A step that reduces the residual; or the end, if there is none.
    fn step(&self, here: Here<B, N, M>) -> ControlFlow<Here<B, N, M>, Here<B, N, M>> {
        let change = here.least(&self.free).change;
        let angles = B::PLACES.iter().zip(change.state.iter());
        let angles = angles.filter(|(place, _)| place.is_angle());
        let turn = angles.map(|(_, turn)| turn.abs()).fold(0.0, f64::max);
        let mut part = if turn > TURN { TURN / turn } else { 1.0 };
        let merit = here.merit(&here.scales);
        for _ in 0..HALVINGS {
            let input = core::array::from_fn(|i| here.input[i] + part * change.input[i]);
            let state = tangent::moved(&here.state, &(change.state * part));
            let there = Here::of(&self.steady, state, input, &here.far);
            let is_half = there.worst <= 0.5 * here.worst;
            let is_end = there.worst <= TOLERANCE && is_half;
            if is_end || there.merit(&here.scales) < merit {
                let is_rounding = here.worst <= TOLERANCE && !is_half;
                return if is_rounding {
                    ControlFlow::Break(there)
                } else {
                    ControlFlow::Continue(there)
                };
            }
            part *= 0.5;
        }
        ControlFlow::Break(here)
    }
}

/// The limit of Newton steps: near a solution about six are needed.
const STEPS: usize = 100;

/// The limit of halvings of a step that does not reduce the residual.
const HALVINGS: usize = 40;

/// The largest angle of a step \[rad\]: beyond it, sines are far from linear.
pub const TURN: f64 = 1.0;
