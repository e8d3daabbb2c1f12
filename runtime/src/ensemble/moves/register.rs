//! The members of a register in progress, and the steps that they take together.

#![allow(
    clippy::float_cmp,
    reason = "a motion is at a time, or it is not: it is put there"
)]

use core::ops::Range;

use super::lane::{Lane, Progress};
use super::seats::Seats;
use crate::bodies::body::RigidBody;
use crate::bodies::columns::Generic;
use crate::ensemble::blocks::{BLOCK, Eight};
use crate::ensemble::evaluate::{Laned, read};
use crate::ensemble::plan::Plan;
use crate::integrate::{
    Adaptive, Equations, Rates, Within, add, error, finest, first, in_range, tried,
};
use crate::numbers::lanes::{Lanes, Register, by_itself};
use crate::numbers::scalar::Scalar;
use crate::state::Coordinates;

type InputOf<B, S> = <Laned<B, S> as RigidBody>::Input;
type StateOf<B, S> = <Laned<B, S> as RigidBody>::State;
type ArrayOf<B, S> = <StateOf<B, S> as Coordinates>::Array;

/// The members of a register in progress.
pub(super) struct InRegister<'e, A, B: Generic, S: Register> {
    simd: S,
    plan: &'e Plan<'e, A, B>,
    tolerance: f64,
    pub(super) lanes: [Lane; BLOCK],
    member: Laned<B, S>,
    input: InputOf<B, S>,
    coordinates: ArrayOf<B, S>,
    lost: ArrayOf<B, S>,
}

impl<'e, A: Adaptive, B: Generic, S: Register> InRegister<'e, A, B, S> {
    /// All lanes are empty.
    #[cfg_attr(not(unoptimized), inline(always))]
    pub(super) fn new(simd: S, plan: &'e Plan<'e, A, B>, seats: &Seats<B>) -> Self {
        Self {
            simd,
            plan,
            tolerance: finest(plan.method.tolerance()),
            lanes: [Lane::EMPTY; BLOCK],
            member: read(simd, &seats.bodies, 0),
            input: read(simd, &seats.inputs, 0),
            coordinates: Default::default(),
            lost: Default::default(),
        }
    }

    /// Puts waiting members into empty lanes; returns 1 for each of these lanes.
    #[cfg_attr(not(unoptimized), inline(always))]
    pub(super) fn fill(
        &mut self,
        waiting: &mut Range<usize>,
        seats: &mut Seats<B>,
        states: &[Eight],
    ) -> Eight {
        let mut fresh = [0.0; BLOCK];
        for (lane, is_fresh) in fresh.iter_mut().enumerate().take(Lanes::<S>::COUNT) {
            if self.lanes[lane].member.is_none()
                && let Some(member) = waiting.next()
            {
                seats.sit(self.plan, states, member, lane);
                self.lanes[lane].member = Some(member);
                *is_fresh = 1.0;
            }
        }
        fresh
    }

    #[cfg_attr(not(unoptimized), inline(always))]
    fn register(&self, part: impl Fn(&Lane) -> f64) -> Lanes<S> {
        let row: Eight = core::array::from_fn(|lane| part(&self.lanes[lane]));
        self.row(&row)
    }

    #[cfg_attr(not(unoptimized), inline(always))]
    fn row(&self, row: &Eight) -> Lanes<S> {
        let (registers, _) = S::as_simd_f64s(row);
        Lanes::new(self.simd, registers[0])
    }

    /// The members, each within its current stretch of time.
    #[cfg_attr(not(unoptimized), inline(always))]
    fn within(&self) -> Within<'_, Laned<B, S>> {
        Within {
            body: &self.member,
            lower: self.register(|lane| lane.stretch.lower),
            upper: self.register(|lane| lane.stretch.upper),
            given: Lanes::splat(self.simd, self.plan.limits.given),
        }
    }

    #[cfg_attr(not(unoptimized), inline(always))]
    fn equations<'w>(
        &'w self,
        within: &'w Within<'w, Laned<B, S>>,
    ) -> Called<'w, S, Within<'w, Laned<B, S>>> {
        let (body, input) = (within, &self.input);
        let equations = Equations { body, input };
        Called {
            simd: self.simd,
            equations,
        }
    }

    /// Begins with new members.
    #[cfg_attr(not(unoptimized), inline(always))]
    pub(super) fn begin(&mut self, seats: &Seats<B>, fresh: &Eight) {
        let simd = self.simd;
        self.member = read(simd, &seats.bodies, 0);
        self.input = read(simd, &seats.inputs, 0);
        let state: StateOf<B, S> = read(simd, &seats.states, 0);
        let begun = state.coordinates();
        let is_old = self.row(fresh).equal(Lanes::splat(simd, 0.0));
        let zero = Lanes::splat(simd, 0.0);
        let places = self.coordinates.as_mut().iter_mut();
        let lost = self.lost.as_mut().iter_mut();
        for ((old, lost), new) in places.zip(lost).zip(begun.as_ref()) {
            *old = Lanes::select(is_old, *old, *new);
            *lost = Lanes::select(is_old, *lost, zero);
        }
        for (lane, _) in fresh.iter().enumerate().filter(|(_, new)| **new != 0.0) {
            self.lanes[lane] = Lane::at(self.lanes[lane].member, &self.plan.times);
            self.go_on(lane);
        }
        let time = self.register(|lane| lane.time);
        let rest = self.register(Lane::rest);
        let within = self.within();
        let equations = self.equations(&within);
        let (from, tolerance) = (&self.coordinates, self.tolerance);
        let steps = first::<A::Pair, _, _>(&equations, time, from, rest, tolerance);
        for (lane, _) in fresh.iter().enumerate().filter(|(_, new)| **new != 0.0) {
            self.lanes[lane].lengths.begin(steps.lane(lane));
        }
    }

    /// Chooses the next step of each member.
    #[cfg_attr(not(unoptimized), inline(always))]
    pub(super) fn choose(&mut self) {
        self.lanes.iter_mut().for_each(Lane::choose);
    }

    /// Attempts these steps, and takes those that are accepted.
    #[cfg_attr(not(unoptimized), inline(always))]
    pub(super) fn step(&mut self) {
        let time = self.register(|lane| lane.time);
        let step = self.register(|lane| lane.step);
        let within = self.within();
        let equations = self.equations(&within);
        let from = &self.coordinates;
        let (mut change, sizes) = tried::<A::Pair, _, _>(&equations, time, from, step);
        <StateOf<B, S>>::keep(&self.coordinates, &mut change);
        let (mut next, mut next_lost) = (self.coordinates, self.lost);
        let zero = Lanes::splat(self.simd, 0.0);
        let mut is_finite = zero.equal(zero);
        for (place, change) in next.as_ref().iter().zip(change.as_ref()) {
            let moved = *place + *change;
            is_finite = is_finite & (moved * zero).equal(zero);
        }
        let finite = Lanes::select(is_finite, Lanes::splat(self.simd, 1.0), zero);
        let [errors, squares] = error(sizes);
        let mut accepted = [0.0; BLOCK];
        for (lane, is_taken) in accepted.iter_mut().enumerate().take(Lanes::<S>::COUNT) {
            let here = &mut self.lanes[lane];
            let sizes = [sizes[0].lane(lane), sizes[1].lane(lane)];
            let error = in_range(sizes, [errors.lane(lane), squares.lane(lane)]);
            let step = (here.step, here.is_last);
            if here.is_going()
                && here
                    .lengths
                    .is_accepted::<A::Pair>(step, error, self.tolerance)
            {
                if finite.lane(lane) == 0.0 {
                    here.state = Progress::Left;
                } else {
                    *is_taken = 1.0;
                }
            }
        }
        add(&mut next, &mut next_lost, &change);
        let is_refused = self.row(&accepted).equal(zero);
        for (old, next) in [(&mut self.coordinates, &next), (&mut self.lost, &next_lost)] {
            for (old, next) in old.as_mut().iter_mut().zip(next.as_ref()) {
                *old = Lanes::select(is_refused, *old, *next);
            }
        }
        for (lane, _) in accepted.iter().enumerate().filter(|(_, new)| **new != 0.0) {
            let here = &mut self.lanes[lane];
            here.follow();
            if here.time == here.limit || self.plan.limits.max_step < f64::INFINITY {
                self.go_on(lane);
            }
        }
    }

    /// Sets the end of the next steps of a member, as a course does for a run.
    fn go_on(&mut self, index: usize) {
        let (Range { start, end }, limits) = (self.plan.times.clone(), self.plan.limits);
        let forwards = end >= start;
        let lane = &mut self.lanes[index];
        if lane.time == end {
            lane.state = Progress::There;
            return;
        }
        let member = (&self.member, &self.input);
        let from = (lane.time, end, forwards);
        let limit = limits.until(member, &mut lane.stretch, from, index);
        match limits.pace().limit(lane.time, limit) {
            Some(limit) => lane.limit = limit,
            None => lane.state = Progress::Left,
        }
    }

    /// The state of a member.
    pub(super) fn end_of(&self, lane: usize) -> B::State {
        let mut coordinates = <B::State as Coordinates>::Array::default();
        let places = coordinates.as_mut().iter_mut();
        for (place, lanes) in places.zip(self.coordinates.as_ref()) {
            *place = lanes.lane(lane);
        }
        B::State::from_coordinates(&coordinates)
    }
}

/// Equations in a register, in a separate function: a step evaluates them many times.
struct Called<'e, S, L: RigidBody> {
    simd: S,
    equations: Equations<'e, L>,
}

impl<S, L> Rates for Called<'_, S, L>
where
    S: Register,
    L: RigidBody<Scalar = Lanes<S>, State: Coordinates<Scalar = Lanes<S>>>,
{
    type State = L::State;

    #[cfg_attr(not(unoptimized), inline(always))]
    fn rates(
        &self,
        time: Lanes<S>,
        coordinates: &<L::State as Coordinates>::Array,
    ) -> <L::State as Coordinates>::Array {
        by_itself(
            self.simd,
            #[cfg_attr(not(unoptimized), inline(always))]
            || self.equations.rates(time, coordinates),
        )
    }
}
