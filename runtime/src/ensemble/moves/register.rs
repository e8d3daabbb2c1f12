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
    Adaptive, Embedded as _, Equations, LOOK, Lengths, Rates, Within, add, attempt, compensated,
    finest, first, shrunk,
};
use crate::numbers::lanes::{Lanes, Mask, Register, by_itself};
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
    /// Whether any lane has come to a stop, or is empty.
    pub(super) has_stopped: bool,
    member: Laned<B, S>,
    input: InputOf<B, S>,
    coordinates: ArrayOf<B, S>,
    lost: ArrayOf<B, S>,
    /// 1 in lanes whose members move.
    going: Lanes<S>,
    time: Lanes<S>,
    /// The rounding error of the time, to be added to it.
    late: Lanes<S>,
    /// The time at which the next step must end.
    limit: Lanes<S>,
    /// The bounds of the stretch of time.
    stretch: [Lanes<S>; 2],
    /// The next step, zero if there is none, and whether it reaches the limit.
    step: Lanes<S>,
    is_last: Mask<S>,
    lengths: Lengths<Lanes<S>>,
    /// The number of steps that were not cut short.
    steps: Lanes<S>,
}

impl<'e, A: Adaptive, B: Generic, S: Register> InRegister<'e, A, B, S> {
    /// All lanes are empty.
    #[cfg_attr(not(unoptimized), inline(always))]
    pub(super) fn new(simd: S, plan: &'e Plan<'e, A, B>, seats: &Seats<B>) -> Self {
        let zero = Lanes::splat(simd, 0.0);
        Self {
            simd,
            plan,
            tolerance: finest(plan.method.tolerance()),
            lanes: [Lane::EMPTY; BLOCK],
            has_stopped: true,
            member: read(simd, &seats.bodies, 0),
            input: read(simd, &seats.inputs, 0),
            coordinates: Default::default(),
            lost: Default::default(),
            going: zero,
            time: zero,
            late: zero,
            limit: zero,
            stretch: [zero; 2],
            step: zero,
            is_last: zero.less(zero),
            lengths: Lengths::from(zero),
            steps: zero,
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
    fn row(&self, row: &Eight) -> Lanes<S> {
        let (registers, _) = S::as_simd_f64s(row);
        Lanes::new(self.simd, registers[0])
    }

    #[cfg_attr(not(unoptimized), inline(always))]
    fn splat(&self, number: f64) -> Lanes<S> {
        Lanes::splat(self.simd, number)
    }

    #[cfg_attr(not(unoptimized), inline(always))]
    fn is_going(&self) -> Mask<S> {
        self.going.equal(self.splat(1.0))
    }

    /// The members, each within its current stretch of time.
    #[cfg_attr(not(unoptimized), inline(always))]
    fn within(&self) -> Within<'_, Laned<B, S>> {
        let [lower, upper] = self.stretch;
        Within {
            body: &self.member,
            lower,
            upper,
            given: self.splat(self.plan.limits.given),
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

    #[cfg_attr(not(unoptimized), inline(always))]
    fn rest(&self) -> Lanes<S> {
        (self.limit - self.time) - self.late
    }

    /// Begins with new members.
    #[cfg_attr(not(unoptimized), inline(always))]
    pub(super) fn begin(&mut self, seats: &Seats<B>, fresh: &Eight) {
        let simd = self.simd;
        self.member = read(simd, &seats.bodies, 0);
        self.input = read(simd, &seats.inputs, 0);
        let state: StateOf<B, S> = read(simd, &seats.states, 0);
        let begun = state.coordinates();
        let zero = self.splat(0.0);
        let is_old = self.row(fresh).equal(zero);
        let places = self.coordinates.as_mut().iter_mut();
        let lost = self.lost.as_mut().iter_mut();
        for ((old, lost), new) in places.zip(lost).zip(begun.as_ref()) {
            *old = Lanes::select(is_old, *old, *new);
            *lost = Lanes::select(is_old, *lost, zero);
        }
        let start = self.splat(self.plan.times.start);
        self.going = Lanes::select(is_old, self.going, self.splat(1.0));
        self.time = Lanes::select(is_old, self.time, start);
        self.late = Lanes::select(is_old, self.late, zero);
        self.limit = Lanes::select(is_old, self.limit, start);
        self.steps = Lanes::select(is_old, self.steps, zero);
        for (lane, _) in fresh.iter().enumerate().filter(|(_, new)| **new != 0.0) {
            self.lanes[lane] = Lane::at(self.lanes[lane].member, self.plan.times.start);
            self.go_on(lane);
            self.check(lane);
        }
        let within = self.within();
        let equations = self.equations(&within);
        let (from, rest, tolerance) = (&self.coordinates, self.rest(), self.tolerance);
        let step = first::<A::Pair, _, _>(&equations, self.time, from, rest, tolerance);
        self.lengths = Lengths::select(is_old, self.lengths, Lengths::from(step));
    }

    /// Chooses the next step of each member; those without a valid step are left.
    #[cfg_attr(not(unoptimized), inline(always))]
    pub(super) fn choose(&mut self) {
        let zero = self.splat(0.0);
        let (step, is_last) = self.lengths.next(self.rest());
        let stays = ((self.time + step) - self.time).equal(zero) & !is_last;
        let is_due = self.splat(f64::from(LOOK)).less_or_equal(self.steps);
        let is_finite = (step * zero).equal(zero);
        let is_lost = !is_finite | stays | is_due;
        self.leave(is_lost);
        self.step = Lanes::select(self.is_going(), step, zero);
        self.is_last = is_last;
    }

    /// Attempts these steps, and takes those that are accepted.
    #[cfg_attr(not(unoptimized), inline(always))]
    pub(super) fn step(&mut self) {
        let within = self.within();
        let equations = self.equations(&within);
        let (from, step, is_last) = (&self.coordinates, self.step, self.is_last);
        let (mut change, error) = attempt::<A::Pair, _, _>(&equations, self.time, from, step);
        <StateOf<B, S>>::keep(from, &mut change);
        let (mut next, mut next_lost) = (self.coordinates, self.lost);
        add(&mut next, &mut next_lost, &change);

        let share = error.map(
            #[cfg_attr(not(unoptimized), inline(always))]
            |error| shrunk(self.tolerance, error, A::Pair::ESTIMATE),
        );
        let tolerance = self.splat(self.tolerance);
        let is_accepted = self.is_going()
            & self
                .lengths
                .is_accepted((step, is_last), (error, share), tolerance);
        let zero = self.splat(0.0);
        let mut is_finite = zero.equal(zero);
        for place in next.as_ref() {
            is_finite = is_finite & (*place * zero).equal(zero);
        }
        self.leave(is_accepted & !is_finite);

        let is_taken = is_accepted & is_finite;
        for (old, next) in [(&mut self.coordinates, &next), (&mut self.lost, &next_lost)] {
            for (old, next) in old.as_mut().iter_mut().zip(next.as_ref()) {
                *old = Lanes::select(is_taken, *next, *old);
            }
        }
        let (time, late) = compensated(self.time, self.late, step);
        let time = Lanes::select(is_last, self.limit, time);
        let late = Lanes::select(is_last, zero, late);
        self.time = Lanes::select(is_taken, time, self.time);
        self.late = Lanes::select(is_taken, late, self.late);
        self.steps += Lanes::select(is_taken & !is_last, self.splat(1.0), zero);

        let is_cut = self.plan.limits.max_step < f64::INFINITY;
        let turns = is_taken
            & (if is_cut {
                is_taken
            } else {
                self.time.equal(self.limit)
            });
        self.each(turns, Self::go_on);
        if B::CHANGES {
            self.each(is_taken, Self::check);
        }
    }

    /// Calls a function with each lane in which a truth holds.
    #[cfg_attr(not(unoptimized), inline(always))]
    fn each(&mut self, truth: Mask<S>, act: impl Fn(&mut Self, usize)) {
        if Lanes::agreed(truth) == Some(false) {
            return;
        }
        let chosen = Lanes::select(truth, self.splat(1.0), self.splat(0.0));
        for lane in (0..Lanes::<S>::COUNT).filter(|lane| chosen.lane(*lane) != 0.0) {
            act(self, lane);
        }
    }

    /// Leaves moving members for separate integration.
    #[cfg_attr(not(unoptimized), inline(always))]
    fn leave(&mut self, truth: Mask<S>) {
        let truth = truth & self.is_going();
        self.each(truth, |register, lane| register.stop(lane, Progress::Left));
    }

    fn stop(&mut self, lane: usize, state: Progress) {
        self.lanes[lane].state = state;
        self.going.put(lane, 0.0);
        self.has_stopped = true;
    }

    /// Sets the end of the next steps of a member, as a course does for a run.
    fn go_on(&mut self, index: usize) {
        let (Range { start, end }, limits) = (self.plan.times.clone(), self.plan.limits);
        let (now, forwards) = (self.time.lane(index), end >= start);
        if now == end {
            self.stop(index, Progress::There);
            return;
        }
        let member = (&self.member, &self.input);
        let stretch = &mut self.lanes[index].stretch;
        let Some(limit) = limits.until(member, stretch, (now, end, forwards), index) else {
            self.stop(index, Progress::Left);
            return;
        };
        self.stretch[0].put(index, stretch.lower);
        self.stretch[1].put(index, stretch.upper);
        self.limit.put(index, limits.pace().limit(now, limit));
    }

    /// Leaves a member whose mass or inertia is impossible now.
    fn check(&mut self, lane: usize) {
        let (true, Some(member)) = (B::CHANGES, self.lanes[lane].member) else {
            return;
        };
        let (members, index) = (self.plan.members, BLOCK * self.plan.first + member);
        let (body, input) = (members.body(index), members.inputs.get(index));
        let (time, state) = (self.time.lane(lane), self.end_of(lane));
        if body.possible(time, &state, &input).is_err() {
            self.stop(lane, Progress::Left);
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
