//! Variable steps, as long as the tolerance permits. A register holds several members, each with
//! its own steps; when one is done, the next takes its place.

#![allow(
    clippy::float_cmp,
    reason = "a motion is at a time, or it is not: it is put there"
)]

use alloc::vec::Vec;
use core::ops::Range;
use core::sync::atomic::{AtomicBool, Ordering};

use super::blocks::{BLOCK, Eight, write};
use super::evaluate::read;
use super::plan::Plan;
use crate::bodies::body::RigidBody;
use crate::bodies::columns::{Columns, Generic};
use crate::integrate::{
    Adaptive, Equations, Lengths, Rates, Stretch, Watch, Within, add, compensated, error, finest,
    first, in_range, tried,
};
use crate::numbers::lanes::{Lanes, Register, Work, by_itself};
use crate::numbers::scalar::Scalar;
use crate::state::Coordinates;

/// Integrates the members of some blocks, each as it would alone, to the bit. Members that do not
/// reach the end, or take very many steps, keep their states and are marked for separate
/// integration.
pub(super) struct Stream<'e, A, B: Generic> {
    pub(super) plan: &'e Plan<'e, A, B>,
    pub(super) states: &'e mut [Eight],
    /// The number of members in the blocks.
    pub(super) count: usize,
    /// Which of them are left.
    pub(super) left: &'e [AtomicBool],
}

impl<A: Adaptive, B: Generic> Work for Stream<'_, A, B> {
    type Output = ();

    #[cfg_attr(not(unoptimized), inline(always))]
    fn run<S: Register>(self, simd: S) {
        let Self {
            plan,
            states,
            count,
            left,
        } = self;
        let mut waiting = 0..count;
        let mut seats = Seats::new(plan, states);
        let mut register = InRegister {
            simd,
            plan,
            tolerance: finest(plan.method.tolerance()),
            lanes: [Lane::EMPTY; BLOCK],
            member: read(simd, &seats.bodies, 0),
            input: read(simd, &seats.inputs, 0),
            coordinates: Default::default(),
            lost: Default::default(),
        };
        let lanes = Lanes::<S>::COUNT;
        loop {
            let mut fresh = [0.0; BLOCK];
            for (lane, is_fresh) in fresh.iter_mut().enumerate().take(lanes) {
                if register.lanes[lane].member.is_none()
                    && let Some(member) = waiting.next()
                {
                    seats.sit(plan, states, member, lane);
                    register.lanes[lane].member = Some(member);
                    *is_fresh = 1.0;
                }
            }
            if fresh != [0.0; BLOCK] {
                by_itself(
                    simd,
                    #[cfg_attr(not(unoptimized), inline(always))]
                    || register.begin(&seats, &fresh),
                );
            }
            if register.lanes.iter().all(|lane| lane.member.is_none()) {
                return;
            }
            register.choose();
            by_itself(
                simd,
                #[cfg_attr(not(unoptimized), inline(always))]
                || register.step(),
            );
            for lane in 0..lanes {
                match register.lanes[lane].state {
                    Progress::Going => {}
                    Progress::There => {
                        let end = register.end_of(lane);
                        if let Some(member) = register.lanes[lane].member.take() {
                            write(states, member / BLOCK, member % BLOCK, &end);
                        }
                    }
                    Progress::Left => {
                        if let Some(member) = register.lanes[lane].member.take() {
                            left[member].store(true, Ordering::Relaxed);
                        }
                    }
                }
            }
        }
    }
}

/// A member in progress.
#[derive(Clone, Copy)]
struct Lane {
    /// Its index in the blocks; none for an empty lane.
    member: Option<usize>,
    state: Progress,
    stretch: Stretch,
    time: f64,
    /// The rounding error of the time.
    late: f64,
    /// The time at which the next step must end.
    limit: f64,
    /// The next step, zero if there is none, and whether it reaches the limit.
    step: f64,
    is_last: bool,
    lengths: Lengths,
    watch: Watch,
}

/// The progress of a member.
#[derive(Clone, Copy, PartialEq)]
enum Progress {
    Going,
    There,
    Left,
}

impl Lane {
    const EMPTY: Self = Self {
        member: None,
        state: Progress::Going,
        stretch: Stretch::ALL,
        time: 0.0,
        late: 0.0,
        limit: 0.0,
        step: 0.0,
        is_last: false,
        lengths: Lengths::NEW,
        watch: Watch::OF_A_PAIR,
    };

    /// The progress at the start.
    fn at(member: Option<usize>, times: &Range<f64>) -> Self {
        let (time, limit) = (times.start, times.start);
        let mut watch = Watch::OF_A_PAIR;
        watch.heads_for(times.end);
        Self {
            member,
            stretch: Stretch {
                next: time,
                ..Stretch::ALL
            },
            time,
            limit,
            watch,
            ..Self::EMPTY
        }
    }

    fn is_going(&self) -> bool {
        self.member.is_some() && self.state == Progress::Going
    }

    fn rest(&self) -> f64 {
        (self.limit - self.time) + self.late
    }

    /// Chooses the next step; marks a member without a valid step as left.
    fn choose(&mut self) {
        (self.step, self.is_last) = (0.0, false);
        if !self.is_going() {
            return;
        }
        let (step, is_last) = self.lengths.next(self.rest());
        let is_lost = step.is_nan() || (self.time + step) - self.time == 0.0 && !is_last;
        if is_lost || self.watch.is_due() {
            self.state = Progress::Left;
        } else {
            (self.step, self.is_last) = (step, is_last);
        }
    }

    /// Records an accepted step.
    fn follow(&mut self) {
        self.watch.saw(self.step, self.is_last);
        (self.time, self.late) = if self.is_last {
            (self.limit, 0.0)
        } else {
            compensated(self.time, self.late, self.step)
        };
    }
}

/// The bodies of the members in the lanes of a register.
struct Seats<B: Generic> {
    bodies: Vec<Eight>,
    inputs: Vec<Eight>,
    states: Vec<Eight>,
    kind: core::marker::PhantomData<B>,
}

impl<B: Generic> Seats<B> {
    /// The first member in all lanes, so that every lane has a body.
    fn new<A>(plan: &Plan<'_, A, B>, states: &[Eight]) -> Self {
        let bodies = if plan.members.is_uniform {
            0
        } else {
            plan.first
        };
        let rows = |rows: Option<&[Eight]>| rows.unwrap_or_default().to_vec();
        Self {
            bodies: rows(plan.members.bodies.block(bodies)),
            inputs: rows(plan.members.inputs.block(plan.first)),
            states: states[..<B::State as Columns<f64>>::COUNT].to_vec(),
            kind: core::marker::PhantomData,
        }
    }

    /// Puts a member into a lane.
    fn sit<A>(&mut self, plan: &Plan<'_, A, B>, states: &[Eight], member: usize, lane: usize) {
        let (block, from) = (member / BLOCK, member % BLOCK);
        let copy = |seats: &mut [Eight], rows: Option<&[Eight]>| {
            for (seat, row) in seats.iter_mut().zip(rows.unwrap_or_default()) {
                seat[lane] = row[from];
            }
        };
        if !plan.members.is_uniform {
            copy(
                &mut self.bodies,
                plan.members.bodies.block(plan.first + block),
            );
        }
        copy(
            &mut self.inputs,
            plan.members.inputs.block(plan.first + block),
        );
        let columns = <B::State as Columns<f64>>::COUNT;
        copy(
            &mut self.states,
            states.get(columns * block..columns * (block + 1)),
        );
    }
}

type Laned<B, S> = super::evaluate::Laned<B, S>;
type InputOf<B, S> = <Laned<B, S> as RigidBody>::Input;
type StateOf<B, S> = <Laned<B, S> as RigidBody>::State;
type ArrayOf<B, S> = <StateOf<B, S> as Coordinates>::Array;

/// The members of a register in progress.
struct InRegister<'e, A, B: Generic, S: Register> {
    simd: S,
    plan: &'e Plan<'e, A, B>,
    tolerance: f64,
    lanes: [Lane; BLOCK],
    member: Laned<B, S>,
    input: InputOf<B, S>,
    coordinates: ArrayOf<B, S>,
    lost: ArrayOf<B, S>,
}

impl<A: Adaptive, B: Generic, S: Register> InRegister<'_, A, B, S> {
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

    /// Begins with new members.
    #[cfg_attr(not(unoptimized), inline(always))]
    fn begin(&mut self, seats: &Seats<B>, fresh: &Eight) {
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
        let equations = Called {
            simd: self.simd,
            equations: Equations {
                body: &within,
                input: &self.input,
            },
        };
        let (from, tolerance) = (&self.coordinates, self.tolerance);
        let steps = first::<A::Pair, _, _>(&equations, time, from, rest, tolerance);
        for (lane, _) in fresh.iter().enumerate().filter(|(_, new)| **new != 0.0) {
            self.lanes[lane].lengths.begin(steps.lane(lane));
        }
    }

    /// Chooses the next step of each member.
    #[cfg_attr(not(unoptimized), inline(always))]
    fn choose(&mut self) {
        self.lanes.iter_mut().for_each(Lane::choose);
    }

    /// Attempts these steps, and takes those that are accepted.
    #[cfg_attr(not(unoptimized), inline(always))]
    fn step(&mut self) {
        let time = self.register(|lane| lane.time);
        let step = self.register(|lane| lane.step);
        let within = self.within();
        let equations = Called {
            simd: self.simd,
            equations: Equations {
                body: &within,
                input: &self.input,
            },
        };
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
        let Range { start, end } = self.plan.times;
        let forwards = end >= start;
        let lane = &mut self.lanes[index];
        if lane.time == end {
            lane.state = Progress::There;
            return;
        }
        let is_before = |time: f64| {
            if forwards {
                lane.time < time
            } else {
                lane.time > time
            }
        };
        if !is_before(lane.stretch.next) {
            let from = (lane.time, forwards, index);
            let breaks = self.plan.limits.breaks.iter();
            lane.stretch = Stretch::of(&self.member, &self.input, from, breaks);
        }
        let next = lane.stretch.next;
        let limit = if forwards {
            next.min(end)
        } else {
            next.max(end)
        };
        match self.plan.limits.pace().limit(lane.time, limit) {
            Some(limit) => lane.limit = limit,
            None => lane.state = Progress::Left,
        }
    }

    /// The state of a member.
    fn end_of(&self, lane: usize) -> B::State {
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
