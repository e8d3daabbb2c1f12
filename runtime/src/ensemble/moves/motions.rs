//! The motions of all members, from one time to the next.

use alloc::vec::Vec;
use core::fmt;

#[cfg(feature = "rayon")]
use rayon::iter::{
    IndexedParallelIterator as _, IntoParallelRefMutIterator as _, ParallelIterator as _,
};

use super::members::indices;
use crate::bodies::columns::Generic;
use crate::ensemble::Ensemble;
use crate::integrate::{Method, Run, Underway};

/// The motions of all members between two calls of [`Moves::moved`](super::Moves::moved): the lengths
/// of their steps, and their sums with the rounding errors of these. Steps need not end
/// where samples are taken.
///
/// They are not kept if all members move from the start to the end at once.
pub struct Motions<R>(Vec<Underway<R>>);

impl<R> fmt::Debug for Motions<R> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_tuple("Motions").field(&self.0.len()).finish()
    }
}

impl<R> Motions<R> {
    /// No motions are kept.
    pub(in crate::ensemble) const NOT_KEPT: Self = Self(Vec::new());

    /// Motions of all members from a time to an end, before their first steps.
    pub(in crate::ensemble) fn of<B: Generic, M: Method<B, Run = R>>(
        ensemble: &Ensemble<B>,
        method: M,
        time: f64,
        end: f64,
    ) -> Self
    where
        R: Run<B>,
    {
        let states = ensemble.states.iter().enumerate();
        let begun = states.map(|(index, state)| {
            let body = ensemble.members.body(index);
            Underway::new(&body, method, (time, &state), end)
        });
        Self(begun.collect())
    }

    /// Whether there are any.
    pub(in crate::ensemble) fn are_kept(&self) -> bool {
        !self.0.is_empty()
    }

    /// Ends the motion of a member, if it is kept.
    pub(in crate::ensemble) fn lose(&mut self, index: usize) {
        if let Some(motion) = self.0.get_mut(index) {
            motion.is_lost = true;
        }
    }

    /// Called when inputs are given.
    pub(in crate::ensemble) fn renew<B: Generic>(&mut self)
    where
        R: Run<B>,
    {
        for motion in &mut self.0 {
            motion.renew();
        }
    }

    pub(in crate::ensemble) fn as_mut_slice(&mut self) -> &mut [Underway<R>] {
        &mut self.0
    }

    /// The results of a function of each of so many members, and of its motion if that is kept.
    pub(super) fn each<T: Send>(
        &mut self,
        count: usize,
        function: impl Fn(usize, Option<&mut Underway<R>>) -> T + Sync + Send,
    ) -> Vec<T>
    where
        R: Send,
    {
        if !self.are_kept() {
            return indices(count).map(|index| function(index, None)).collect();
        }
        #[cfg(feature = "rayon")]
        let motions = self.0.par_iter_mut();
        #[cfg(not(feature = "rayon"))]
        let motions = self.0.iter_mut();
        let motions = motions.enumerate();
        motions
            .map(|(index, motion)| function(index, Some(motion)))
            .collect()
    }
}
