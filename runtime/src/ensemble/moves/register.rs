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
    Adaptive, AdaptiveRun, Embedded as _, Equations, LOOK, Lengths, Rates, Stretch, Track,
    Underway, Within, add, attempt, compensated, finest, first, shrunk,
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
    /// The start of the last step.
    before: (Lanes<S>, ArrayOf<B, S>),
    /// 1 in lanes whose members move.
    going: Lanes<S>,
    time: Lanes<S>,
    /// The rounding error of the time, to be added to it.
    late: Lanes<S>,
    /// The time at which the next step must end.
    limit: Lanes<S>,
    /// The bounds of the stretch of time, and the time at which the input was given.
    stretch: [Lanes<S>; 3],
    /// The next step, zero if there is none, and whether it reaches the limit.
    step: Lanes<S>,
    is_last: Mask<S>,
    lengths: Lengths<Lanes<S>>,
    /// The number of steps that were not cut short, and the longest step.
    steps: Lanes<S>,
    longest: Lanes<S>,
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
            before: (zero, Default::default()),
            going: zero,
            time: zero,
            late: zero,
            limit: zero,
            stretch: [zero; 3],
            step: zero,
            is_last: zero.less(zero),
            lengths: Lengths::from(zero),
            steps: zero,
            longest: zero,
        }
    }

    /// Puts waiting members into empty lanes; returns 1 for each of these lanes.
    #[cfg_attr(not(unoptimized), inline(always))]
    pub(super) fn fill(
        &mut self,
        waiting: &mut Range<usize>,
        seats: &mut Seats<B>,
        states: &[Eight],
        motions: &[Underway<AdaptiveRun<B, A::Pair>>],
    ) -> Eight {
        let is_lost = |member: usize| motions.get(member).is_some_and(|motion| motion.is_lost);
        let mut fresh = [0.0; BLOCK];
        for (lane, is_fresh) in fresh.iter_mut().enumerate().take(Lanes::<S>::COUNT) {
            if self.lanes[lane].member.is_none()
                && let Some(member) = waiting.find(|member| !is_lost(*member))
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
        let [lower, upper, given] = self.stretch;
        Within {
            body: &self.member,
            lower,
            upper,
            given,
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

    /// Begins with new members, or goes on with their motions.
    #[cfg_attr(not(unoptimized), inline(always))]
    pub(super) fn begin(
        &mut self,
        seats: &Seats<B>,
        fresh: &Eight,
        motions: &[Underway<AdaptiveRun<B, A::Pair>>],
    ) {
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
        self.longest = Lanes::select(is_old, self.longest, zero);
        let mut is_first = *fresh;
        for (lane, _) in fresh.iter().enumerate().filter(|(_, new)| **new != 0.0) {
            let member = self.lanes[lane].member;
            let motion = member.and_then(|member| motions.get(member));
            let stretch = match motion {
                None => Stretch::until_now(self.plan.times.start),
                Some(motion) => motion.stretch,
            };
            self.lanes[lane] = Lane::within(member, stretch);
            if let Some(Underway { run, .. }) = motion {
                self.resume(lane, run);
                is_first[lane] = f64::from(u8::from(run.lengths.is_none()));
            }
            self.go_on(lane);
            self.check(lane);
        }
        if is_first.iter().all(|first| *first == 0.0) {
            return;
        }
        let is_old = self.row(&is_first).equal(zero);
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
        let (since, before) = &mut self.before;
        *since = Lanes::select(is_taken, self.time, *since);
        for (old, start) in before.as_mut().iter_mut().zip(self.coordinates.as_ref()) {
            *old = Lanes::select(is_taken, *start, *old);
        }
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
        let is_longest = is_taken & self.longest.less(step.abs());
        self.longest = Lanes::select(is_longest, step.abs(), self.longest);

        let is_cut = self.plan.limits.max_step < f64::INFINITY;
        let turns = is_taken
            & (if is_cut {
                is_taken
            } else {
                self.time.equal(self.limit) | !self.is_before_target()
            });
        self.each(turns, Self::go_on);
        if B::CHANGES {
            self.each(is_taken, Self::check);
        }
    }

    /// Whether members have not reached the time up to which they move.
    #[cfg_attr(not(unoptimized), inline(always))]
    fn is_before_target(&self) -> Mask<S> {
        let target = self.splat(self.plan.times.end);
        if self.plan.limits.forwards {
            self.time.less(target)
        } else {
            target.less(self.time)
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
        let (limits, now) = (self.plan.limits, self.time.lane(index));
        if !limits.is_before(now, self.plan.times.end) {
            self.stop(index, Progress::There);
            return;
        }
        let member = (&self.member, &self.input);
        let stretch = &mut self.lanes[index].stretch;
        let Some(limit) = limits.until(member, stretch, now, index) else {
            self.stop(index, Progress::Left);
            return;
        };
        let bounds = [stretch.lower, stretch.upper, stretch.given];
        for (lanes, bound) in self.stretch.iter_mut().zip(bounds) {
            lanes.put(index, bound);
        }
        self.limit.put(index, limit);
    }

    /// Goes on with a motion that is kept.
    fn resume(&mut self, index: usize, run: &AdaptiveRun<B, A::Pair>) {
        let Track { now, before, .. } = &run.track;
        let (since, start) = &mut self.before;
        let lists = [
            (&mut self.coordinates, &now.coordinates),
            (&mut self.lost, &now.lost),
            (start, &before.1),
        ];
        for (lanes, list) in lists {
            for (lanes, number) in lanes.as_mut().iter_mut().zip(list.as_ref()) {
                lanes.put(index, *number);
            }
        }
        since.put(index, before.0);
        self.time.put(index, now.time);
        self.late.put(index, now.late);
        let (steps, longest) = run.watch.seen();
        self.steps.put(index, steps);
        self.longest.put(index, longest);
        if let Some(lengths) = &run.lengths {
            self.lengths.put(index, lengths);
        }
    }

    /// Keeps the motion of a member.
    pub(super) fn keep(&self, index: usize, motion: &mut Underway<AdaptiveRun<B, A::Pair>>) {
        let Underway { run, stretch, .. } = motion;
        *stretch = self.lanes[index].stretch;
        let Track {
            stretch: within,
            now,
            before,
        } = &mut run.track;
        *within = *stretch;
        let lists = [
            (&mut now.coordinates, &self.coordinates),
            (&mut now.lost, &self.lost),
            (&mut before.1, &self.before.1),
        ];
        for (list, lanes) in lists {
            for (number, lanes) in list.as_mut().iter_mut().zip(lanes.as_ref()) {
                *number = lanes.lane(index);
            }
        }
        before.0 = self.before.0.lane(index);
        now.time = self.time.lane(index);
        now.late = self.late.lane(index);
        run.watch
            .put(self.steps.lane(index), self.longest.lane(index));
        run.lengths = Some(self.lengths.of_lane(index));
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
        by_itself!(self.simd, self.equations.rates(time, coordinates))
    }
}
