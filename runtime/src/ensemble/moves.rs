//! Methods that move all members: each for itself, or several in lanes.

use core::fmt;
use core::ops::Range;
use core::sync::atomic::{AtomicUsize, Ordering};

use alloc::vec::Vec;
#[cfg(feature = "rayon")]
use rayon::iter::{IntoParallelIterator as _, ParallelIterator as _};

use super::Ensemble;
use super::blocks::{BLOCK, Blocks, Eight, GroupMut};
use super::evaluate::{in_chunks, read};
use super::plan::{Limits, Plan};
use super::ways::{Apart, Ways};
use crate::bodies::body::RigidBody;
use crate::bodies::columns::{Columns, Generic};
use crate::integrate::{
    Course, Equations, Fixed, Held, IntegrationError, Method, Run as _, RungeKutta, Tolerant, add,
};
use crate::numbers::count::real;
use crate::numbers::lanes::{Lanes, Register, Width, Work};
use crate::state::Coordinates;

/// A member whose motion ended before its time.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MemberError<S> {
    /// Which one, from zero.
    pub index: usize,
    /// Why, with the last state that was good.
    pub error: IntegrationError<S>,
}

impl<S> fmt::Display for MemberError<S> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "member {}: {}", self.index, self.error)
    }
}

impl<S: fmt::Debug + 'static> core::error::Error for MemberError<S> {
    fn source(&self) -> Option<&(dyn core::error::Error + 'static)> {
        Some(&self.error)
    }
}

/// A method for all members of an ensemble.
pub trait Moves<B: Generic> {
    /// Moves all members between two times \[s\], with the inputs held, and tells an observer what
    /// part of them is done.
    ///
    /// # Errors
    /// [`MemberError`] with the first of those that do not come to the end; the ensemble stays
    /// where it is.
    fn moved(
        &self,
        ensemble: &mut Ensemble<B>,
        times: Range<f64>,
        limits: &Limits,
        observer: impl Fn(f64) + Sync,
    ) -> Result<(), MemberError<B::State>>;
}

/// Every member for itself, by any method, with steps of its own.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct OneByOne<M>(pub M);

impl<B: Generic, M: Method<B>> Moves<B> for OneByOne<M> {
    fn moved(
        &self,
        ensemble: &mut Ensemble<B>,
        times: Range<f64>,
        limits: &Limits,
        observer: impl Fn(f64) + Sync,
    ) -> Result<(), MemberError<B::State>> {
        if !(times.start.is_finite() && times.end.is_finite()) {
            return ensemble.states.iter().next().map_or(Ok(()), |state| {
                let time = times.start;
                let error = IntegrationError::not_finite(time, state);
                Err(MemberError { index: 0, error })
            });
        }
        let (states, members) = (&ensemble.states, &ensemble.members);
        let done = Done::of(states.len(), observer);
        let end_of = |index: usize| {
            let (body, input) = (members.body(index), members.inputs.get(index));
            let start = (times.start, &states.get(index));
            let mut course =
                Course::new(&body, self.0, Held(input), limits.pace(), start, times.end);
            course.given = Some(limits.given);
            let reached = course.seek(times.end);
            let reached = reached.map(|()| course.run.state());
            done.add(1);
            reached.map_err(|error| MemberError { index, error })
        };
        let ends: Result<Vec<B::State>, _> = indices(states.len()).map(end_of).collect();
        ensemble.states = ends?.into_iter().collect();
        Ok(())
    }
}

/// How many of the members are done, and who hears of it.
struct Done<F> {
    count: AtomicUsize,
    all: usize,
    observer: F,
}

impl<F: Fn(f64)> Done<F> {
    fn of(all: usize, observer: F) -> Self {
        Self {
            count: AtomicUsize::new(0),
            all,
            observer,
        }
    }

    fn add(&self, members: usize) {
        let before = self.count.fetch_add(members, Ordering::Relaxed);
        (self.observer)(real((before + members).min(self.all)) / real(self.all));
    }
}

/// All members, in all threads.
#[cfg(feature = "rayon")]
pub(super) fn indices(count: usize) -> rayon::range::Iter<usize> {
    (0..count).into_par_iter()
}

/// All members.
#[cfg(not(feature = "rayon"))]
pub(super) fn indices(count: usize) -> Range<usize> {
    0..count
}

/// In lanes: each member moves as it would alone, to the bit. Of a motion that does not stay
/// finite, the error has the state at the start.
impl<B: Generic, M: RungeKutta> Moves<B> for Fixed<M> {
    fn moved(
        &self,
        ensemble: &mut Ensemble<B>,
        times: Range<f64>,
        limits: &Limits,
        observer: impl Fn(f64) + Sync,
    ) -> Result<(), MemberError<B::State>> {
        let (time, end) = (times.start, times.end);
        let before = ensemble.states.clone();
        let failed = |index: usize, step: Option<f64>| {
            let state = before.get(index);
            let error = match step {
                Some(step) => IntegrationError::StepTooSmall { time, state, step },
                None => IntegrationError::not_finite(time, state),
            };
            let (body, input) = (
                ensemble.members.body(index),
                ensemble.members.inputs.get(index),
            );
            let error = error.named(&body, &input, end >= time);
            Err(MemberError { index, error })
        };
        let is_there = end - time == 0.0;
        if before.is_empty() || is_there {
            return Ok(());
        }
        let Some(steps) = self.count(end - time) else {
            return failed(0, end.is_finite().then_some(self.step));
        };
        let pace = limits.pace();
        if pace.limit(time, end).is_none() || pace.limit(end, time).is_none() {
            return failed(0, Some(limits.max_step));
        }
        let done = Done::of(before.len(), observer);
        let plan = Plan {
            fixed: *self,
            members: &ensemble.members,
            first: 0,
            times,
            limits,
        };
        in_lanes(&plan, steps, ensemble.width, &mut ensemble.states, &done);
        let is_lost = |state: B::State| {
            let coordinates = state.coordinates();
            !coordinates.as_ref().iter().sum::<f64>().is_finite()
        };
        let lost = ensemble.states.iter().position(is_lost);
        match lost {
            None => Ok(()),
            Some(index) => {
                ensemble.states = before.clone();
                failed(index, None)
            }
        }
    }
}

/// Moves all members by this many steps, or by those that each takes on its way.
fn in_lanes<B: Generic, M: RungeKutta>(
    plan: &Plan<'_, M, B>,
    steps: usize,
    width: Width,
    states: &mut Blocks<B::State>,
    done: &Done<impl Fn(f64) + Sync>,
) {
    let columns = <B::State as Columns<f64>>::COUNT;
    let step = (plan.times.end - plan.times.start) / real(steps);
    in_chunks(states.rows_mut(), columns, |first, rows| {
        let members_here = rows.len() / columns * BLOCK;
        let plan = Plan {
            first,
            times: plan.times.clone(),
            ..*plan
        };
        let is_done = width.run(Advance {
            plan: &plan,
            step,
            steps,
            states: rows,
        });
        if !is_done {
            width.run(Apart {
                plan: &plan,
                states: rows,
            });
        }
        done.add(members_here);
    });
}

/// The members of each register that take the same steps; says whether those are all.
struct Advance<'e, M, B: Generic> {
    plan: &'e Plan<'e, M, B>,
    step: f64,
    steps: usize,
    states: &'e mut [Eight],
}

impl<M: RungeKutta, B: Generic> Work for Advance<'_, M, B> {
    type Output = bool;

    #[inline(always)]
    fn run<S: Register>(self, simd: S) -> bool {
        let columns = <B::State as Columns<f64>>::COUNT;
        let (plan, states) = (self.plan, self.states.chunks_exact_mut(columns));
        let mut is_done = true;
        for (rows, block) in states.zip(plan.members.blocks(plan.first)) {
            for group in 0..BLOCK / Lanes::<S>::COUNT {
                let (body, input) = block.group::<B, S>(simd, group);
                if !Ways::new((&body, &input), plan).are_plain() {
                    is_done = false;
                    continue;
                }
                let equations = Equations {
                    body: &body,
                    input: &input,
                };
                let (state, start) = (read(simd, rows, group), plan.times.start);
                let end = moved::<M, _, S>(simd, &equations, &state, start, self.step, self.steps);
                let rows = rows.iter_mut();
                Columns::<Lanes<S>>::write(&end, &mut GroupMut { rows, index: group });
            }
        }
        is_done
    }
}

/// As a [`FixedRun`](crate::integrate::FixedRun) does, in lanes.
#[inline(always)]
fn moved<M, L, S>(
    simd: S,
    equations: &Equations<'_, L>,
    state: &L::State,
    start: f64,
    step: f64,
    steps: usize,
) -> L::State
where
    M: RungeKutta,
    S: Register,
    L: RigidBody<Scalar = Lanes<S>, State: Coordinates<Scalar = Lanes<S>>>,
{
    let mut coordinates = state.coordinates();
    let mut lost = <L::State as Coordinates>::Array::default();
    for k in 0..steps {
        let time = Lanes::splat(simd, start + real(k) * step);
        let length = Lanes::splat(simd, step);
        let mut change = M::increment(equations, time, &coordinates, length);
        L::State::keep(&coordinates, &mut change);
        add(&mut coordinates, &mut lost, &change);
    }
    L::State::from_coordinates(&coordinates)
}

impl<M: Tolerant> Tolerant for OneByOne<M> {
    fn with_tolerance(tolerance: f64) -> Self {
        Self(M::with_tolerance(tolerance))
    }
}
