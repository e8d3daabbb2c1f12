//! Methods that move all members: one by one, or in lanes.

use core::fmt;
use core::ops::Range;
use core::sync::atomic::{AtomicBool, AtomicUsize, Ordering};

use alloc::vec::Vec;
#[cfg(feature = "rayon")]
use rayon::iter::{IntoParallelIterator as _, ParallelIterator as _};

use super::adaptive::Stream;
use super::blocks::{BLOCK, Blocks, Eight, GroupMut};
use super::evaluate::{in_chunks, read};
use super::plan::{Limits, Plan};
use super::ways::{Apart, Ways};
use super::{Ensemble, Members};
use crate::bodies::body::RigidBody;
use crate::bodies::columns::{Columns, Generic};
use crate::integrate::{
    Adaptive, ClosedForm, Course, DormandPrince, Equations, Fixed, Held, IntegrationError, Method,
    Projected, Run as _, RungeKutta, RungeKuttaPair, TaylorSeries, Tolerant, Verner, add,
};
use crate::numbers::count::real;
use crate::numbers::lanes::{Lanes, Register, Width, Work};
use crate::state::Coordinates;

/// A member whose motion ended early.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MemberError<S> {
    /// The index of the member, from zero.
    pub index: usize,
    /// The reason, with the last good state.
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
    /// The method that moves a single body identically, to the bit.
    type Alone: Method<B>;

    /// That method.
    fn alone(&self) -> Self::Alone;

    /// Moves all members between two times \[s\], with the inputs held, and calls an observer with
    /// the completed fraction. Members that do not reach the end keep their states, and are
    /// returned, in order.
    fn moved(
        &self,
        ensemble: &mut Ensemble<B>,
        times: Range<f64>,
        limits: &Limits,
        observer: impl Fn(f64) + Sync,
    ) -> Vec<MemberError<B::State>>;
}

/// A method for one body, and the default method of an ensemble of bodies for which it is the best.
pub trait Together<B: Generic> {
    /// In lanes, or one by one.
    type Moves: Moves<B> + Tolerant;
}

/// Lanes gain nothing.
impl<B: Generic> Together<B> for ClosedForm
where
    Self: Method<B>,
{
    type Moves = OneByOne<Self>;
}

/// Steps of a pair in lanes are faster than series one by one.
impl<B: Generic> Together<B> for TaylorSeries {
    type Moves = Verner;
}

/// In lanes, the higher order is at least as fast.
impl<B: Generic> Together<B> for RungeKuttaPair {
    type Moves = Verner;
}

impl<B: Generic, M: Tolerant> Together<B> for Projected<M>
where
    Self: Method<B>,
{
    type Moves = OneByOne<Self>;
}

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
fn end_alone<B: Generic, M: Method<B>>(
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

/// Whether a member's mass and inertia are possible at a time.
fn is_possible<B: Generic>(ensemble: &Ensemble<B>, index: usize, time: f64) -> bool {
    let Ensemble {
        states, members, ..
    } = ensemble;
    let (body, input) = (members.body(index), members.inputs.get(index));
    body.possible(time, &states.get(index), &input).is_ok()
}

/// Stores the ends of members; returns the members that reached no end.
fn put<S: Columns<f64>>(
    states: &mut Blocks<S>,
    ends: impl Iterator<Item = (usize, Result<S, IntegrationError<S>>)>,
) -> Vec<MemberError<S>> {
    let mut lost = Vec::new();
    for (index, end) in ends {
        match end {
            Ok(end) => states.set(index, &end),
            Err(error) => lost.push(MemberError { index, error }),
        }
    }
    lost
}

/// In lanes, each member with its own steps: it moves as it would alone, to the bit.
macro_rules! moves_in_lanes {
    ($name:ident) => {
        impl<B: Generic> Moves<B> for $name {
            type Alone = Self;

            fn alone(&self) -> Self {
                *self
            }

            fn moved(
                &self,
                ensemble: &mut Ensemble<B>,
                times: Range<f64>,
                limits: &Limits,
                observer: impl Fn(f64) + Sync,
            ) -> Vec<MemberError<B::State>> {
                stream(*self, ensemble, &times, limits, observer)
            }
        }

        impl<B: Generic> Together<B> for $name {
            type Moves = Self;
        }
    };
}

moves_in_lanes!(DormandPrince);
moves_in_lanes!(Verner);

/// Moves all members in lanes, and those that are left alone.
fn stream<B: Generic, A: Adaptive + Method<B>>(
    method: A,
    ensemble: &mut Ensemble<B>,
    times: &Range<f64>,
    limits: &Limits,
    observer: impl Fn(f64) + Sync,
) -> Vec<MemberError<B::State>> {
    let count = ensemble.len();
    let before = B::CHANGES.then(|| ensemble.states.clone());
    let left: Vec<_> = (0..count).map(|_| AtomicBool::new(false)).collect();
    let done = Done::of(count, observer);
    if times.start.is_finite() && times.end.is_finite() {
        let columns = <B::State as Columns<f64>>::COUNT;
        let (members, width) = (&ensemble.members, ensemble.width);
        in_chunks(ensemble.states.rows_mut(), columns, |first, rows| {
            let here = BLOCK * first..count.min(BLOCK * (first + rows.len() / columns));
            let plan = Plan {
                method,
                members,
                first,
                times: times.clone(),
                limits,
            };
            width.run(Stream {
                plan: &plan,
                states: rows,
                count: here.len(),
                left: &left[here.clone()],
            });
            done.add(here.len());
        });
    } else {
        for one in &left {
            one.store(true, Ordering::Relaxed);
        }
    }
    let mut left: Vec<usize> = (0..count)
        .filter(|index| left[*index].load(Ordering::Relaxed))
        .collect();
    if let Some(before) = before {
        let ended = (0..count).filter(|index| !is_possible(ensemble, *index, times.end));
        left.extend(ended);
        left.sort_unstable();
        left.dedup();
        for index in &left {
            ensemble.states.set(*index, &before.get(*index));
        }
    }
    let ends = indices(left.len()).map(|number| {
        let index = left[number];
        (index, end_alone(ensemble, method, index, times, limits))
    });
    let ends: Vec<_> = ends.collect();
    put(&mut ensemble.states, ends.into_iter())
}

/// The number of completed members, and the observer.
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

/// In lanes: each member moves as it would alone, to the bit. If a motion becomes non-finite,
/// the error has the state at the start.
impl<B: Generic, M: RungeKutta> Moves<B> for Fixed<M> {
    type Alone = Self;

    fn alone(&self) -> Self {
        *self
    }

    fn moved(
        &self,
        ensemble: &mut Ensemble<B>,
        times: Range<f64>,
        limits: &Limits,
        observer: impl Fn(f64) + Sync,
    ) -> Vec<MemberError<B::State>> {
        let (time, end) = (times.start, times.end);
        let before = ensemble.states.clone();
        let failed = |members: &Members<B>, index: usize, step: Option<f64>| {
            let state = before.get(index);
            let error = match step {
                Some(step) => IntegrationError::StepTooSmall { time, state, step },
                None => IntegrationError::not_finite(time, state),
            };
            let (body, input) = (members.body(index), members.inputs.get(index));
            let error = error.named(&body, &input, end >= time);
            MemberError { index, error }
        };
        let none_moves = |members: &Members<B>, step: Option<f64>| {
            let all = 0..before.len();
            all.map(|index| failed(members, index, step)).collect()
        };
        let is_there = end - time == 0.0;
        if before.is_empty() || is_there {
            return Vec::new();
        }
        let Some(steps) = self.count(end - time) else {
            return none_moves(&ensemble.members, end.is_finite().then_some(self.step));
        };
        let pace = limits.pace();
        if pace.limit(time, end).is_none() || pace.limit(end, time).is_none() {
            return none_moves(&ensemble.members, Some(limits.max_step));
        }
        let done = Done::of(before.len(), observer);
        let plan = Plan {
            method: *self,
            members: &ensemble.members,
            first: 0,
            times,
            limits,
        };
        in_lanes(&plan, steps, ensemble.width, &mut ensemble.states, &done);
        let is_lost = |index: &usize| {
            let coordinates = ensemble.states.get(*index).coordinates();
            let is_finite = coordinates.as_ref().iter().sum::<f64>().is_finite();
            !is_finite || B::CHANGES && !is_possible(ensemble, *index, end)
        };
        let lost: Vec<usize> = (0..before.len()).filter(is_lost).collect();
        for index in &lost {
            ensemble.states.set(*index, &before.get(*index));
        }
        let lost = lost.into_iter();
        lost.map(|index| failed(&ensemble.members, index, None))
            .collect()
    }
}

/// Moves all members by this many steps, or by as many as each needs.
fn in_lanes<B: Generic, M: RungeKutta>(
    plan: &Plan<'_, Fixed<M>, B>,
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

/// Advances the members of each register that take the same steps; returns whether those are all.
struct Advance<'e, M, B: Generic> {
    plan: &'e Plan<'e, Fixed<M>, B>,
    step: f64,
    steps: usize,
    states: &'e mut [Eight],
}

impl<M: RungeKutta, B: Generic> Work for Advance<'_, M, B> {
    type Output = bool;

    #[cfg_attr(not(unoptimized), inline(always))]
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

/// Like a [`FixedRun`](crate::integrate::FixedRun), in lanes.
#[cfg_attr(not(unoptimized), inline(always))]
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
