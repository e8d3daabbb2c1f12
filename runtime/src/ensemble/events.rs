//! Zeros of functions of time and state along the motions of members.

use alloc::vec::Vec;
#[cfg(feature = "rayon")]
use rayon::iter::ParallelIterator as _;

use super::Ensemble;
use super::course::AsGiven;
use super::integration::EnsembleIntegration;
use super::moves::{EnsembleError, MemberError, Moves, indices};
use crate::bodies::columns::Generic;
use crate::integrate::{Event, Integrate};

/// An event in the motion of a member.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MemberEvent<S> {
    /// The index of the member, from zero.
    pub index: usize,
    /// The time of the event, and the state of the member at that time.
    pub event: Event<S>,
}

impl<B: Generic + Integrate, M: Moves<B>> EnsembleIntegration<'_, B, M, AsGiven> {
    /// Moves all members to the end \[s\]. Returns the events of a function of time, member and
    /// state as [`Integration::events`](crate::integrate::Integration::events) finds them: those of
    /// the first member in order of time, then those of the second, and so on.
    ///
    /// Members move one by one, under their current inputs. No progress bar is shown.
    ///
    /// # Errors
    /// [`EnsembleError`], if a setting is impossible, or with a member that does not reach the end,
    /// or whose function is NaN; the ensemble then keeps its states.
    pub fn events<F>(
        self,
        end: f64,
        function: F,
    ) -> Result<Vec<MemberEvent<B::State>>, EnsembleError<B::State>>
    where
        F: Fn(f64, usize, &B::State) -> f64 + Sync,
    {
        self.checked(end, None)?;
        let Self {
            ensemble,
            start,
            method,
            limits,
            ..
        } = self;
        let method = method.alone();
        let Ensemble {
            states, members, ..
        } = &*ensemble;
        let flown = |index: usize| {
            let body = members.body(index);
            let motion = body
                .integrate(&states.get(index))
                .starting_at(start)
                .method(method)
                .max_step(limits.max_step)
                .breaks(&limits.breaks)
                .input(members.inputs.get(index));
            let mut events = motion.events(end, |time, state| function(time, index, state));
            let seen: Result<Vec<_>, _> = events
                .by_ref()
                .map(|event| event.map(|event| MemberEvent { index, event }))
                .collect();
            let seen = seen.map_err(|error| MemberError { index, error })?;
            Ok((seen, events.state()))
        };
        let flown: Result<Vec<_>, MemberError<_>> = indices(states.len()).map(flown).collect();
        let (seen, ends): (Vec<_>, Vec<_>) = flown?.into_iter().unzip();
        ensemble.states = ends.into_iter().collect();
        Ok(seen.into_iter().flatten().collect())
    }
}
