//! Methods that move members one by one.

use alloc::vec::Vec;
use core::ops::Range;

use super::members::{Done, MemberError, put};
use super::motions::Motions;
use super::{Moves, RunOf, Together};
use crate::bodies::columns::Generic;
use crate::ensemble::Ensemble;
use crate::ensemble::plan::Limits;
use crate::integrate::{ClosedForm, IntegrationError, Method, Projected, Tolerant, Underway};

/// Moves members one by one, by any method, each with its own steps.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct OneByOne<M>(pub M);

impl<B: Generic, M: Method<B>> Moves<B> for OneByOne<M> {
    type Alone = M;

    fn alone(&self) -> M {
        self.0
    }

    fn moved(
        &self,
        ensemble: &mut Ensemble<B>,
        motions: &mut Motions<RunOf<Self, B>>,
        times: Range<f64>,
        limits: &Limits,
        observer: impl Fn(f64) + Sync,
    ) -> Vec<MemberError<B::State>> {
        let done = Done::of(ensemble.len(), observer);
        let ends = motions.each(ensemble.len(), |index, motion| {
            let end = end_alone(ensemble, self.0, (index, motion), &times, limits);
            done.add(1);
            end
        });
        put(&mut ensemble.states, ends.into_iter().enumerate())
    }
}

/// Moves the members that are left by their lanes, each alone, from where it was before; returns
/// those that do not reach the end.
pub(super) fn moved_alone<B: Generic, M: Method<B>>(
    method: M,
    ensemble: &mut Ensemble<B>,
    motions: &mut Motions<M::Run>,
    left: &[bool],
    (times, limits): (&Range<f64>, &Limits),
) -> Vec<MemberError<B::State>> {
    if left.iter().all(|is_left| !is_left) {
        return Vec::new();
    }
    let ends = motions.each(left.len(), |index, motion| {
        let end = || end_alone(ensemble, method, (index, motion), times, limits);
        left[index].then(|| (index, end()))
    });
    put(&mut ensemble.states, ends.into_iter().flatten())
}

/// The end of a member that moves alone: from the start, or from where its motion is.
fn end_alone<B: Generic, M: Method<B>>(
    ensemble: &Ensemble<B>,
    method: M,
    (index, motion): (usize, Option<&mut Underway<M::Run>>),
    times: &Range<f64>,
    limits: &Limits,
) -> Result<B::State, IntegrationError<B::State>> {
    let Ensemble {
        states, members, ..
    } = ensemble;
    let (body, input) = (members.body(index), members.inputs.get(index));
    let pace = limits.pace();
    let situation = limits.of(&body, &input, &pace);
    if let Some(motion) = motion {
        return if motion.is_lost {
            Ok(states.get(index))
        } else {
            motion.seek(&situation, times.end)
        };
    }
    let start = (times.start, &states.get(index));
    Underway::new(&body, method, start, limits.end).seek(&situation, times.end)
}

impl<M: Tolerant> Tolerant for OneByOne<M> {
    fn with_tolerance(tolerance: f64) -> Self {
        Self(M::with_tolerance(tolerance))
    }
}

/// Lanes gain nothing.
impl<B: Generic> Together<B> for ClosedForm
where
    Self: Method<B>,
{
    type Moves = OneByOne<Self>;
}

impl<B: Generic, M: Tolerant> Together<B> for Projected<M>
where
    Self: Method<B>,
{
    type Moves = OneByOne<Self>;
}
