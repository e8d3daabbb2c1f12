//! Methods that move members one by one.

use alloc::vec::Vec;
use core::ops::Range;

#[cfg(feature = "rayon")]
use rayon::iter::ParallelIterator as _;

use super::members::{Done, MemberError, indices, put};
use super::{Moves, Together};
use crate::bodies::columns::Generic;
use crate::ensemble::Ensemble;
use crate::ensemble::plan::Limits;
use crate::integrate::{
    ClosedForm, Course, Held, IntegrationError, Method, Projected, Run as _, Tolerant,
};

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
        times: Range<f64>,
        limits: &Limits,
        observer: impl Fn(f64) + Sync,
    ) -> Vec<MemberError<B::State>> {
        let all = indices(ensemble.len());
        let done = Done::of(ensemble.len(), observer);
        let ends = all.map(|index| {
            let end = end_alone(ensemble, self.0, index, &times, limits);
            done.add(1);
            end
        });
        let ends: Vec<Result<_, _>> = ends.collect();
        put(&mut ensemble.states, ends.into_iter().enumerate())
    }
}

/// The end of a member that moves alone.
pub(super) fn end_alone<B: Generic, M: Method<B>>(
    ensemble: &Ensemble<B>,
    method: M,
    index: usize,
    times: &Range<f64>,
    limits: &Limits,
) -> Result<B::State, IntegrationError<B::State>> {
    let Ensemble {
        states, members, ..
    } = ensemble;
    let (body, input) = (members.body(index), members.inputs.get(index));
    let (start, pace) = ((times.start, &states.get(index)), limits.pace());
    let mut course = Course::new(&body, method, Held(input), pace, start, times.end);
    course.given = Some(limits.given);
    course.seek(times.end)?;
    Ok(course.run.state())
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
