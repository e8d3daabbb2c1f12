//! The steps of a few members in one register, where each may end at times of its own.

#![allow(
    clippy::float_cmp,
    reason = "a motion is at a time, or it is not: it is put there"
)]

use core::ops::Range;

use super::samples::InLanes;
use crate::bodies::body::RigidBody;
use crate::bodies::columns::{Columns, Generic};
use crate::ensemble::blocks::{BLOCK, Eight, GroupMut};
use crate::ensemble::evaluate::read;
use crate::ensemble::plan::{Limits, Plan};
use crate::integrate::{
    Equations, Fixed, FixedRun, RungeKutta, Stretch, Track, Underway, Within, add,
};
use crate::numbers::count::real;
use crate::numbers::lanes::{Lanes, Register, Work};
use crate::numbers::scalar::Scalar;
use crate::state::Coordinates;

/// The motion of a member.
type Motion<M, B> = Underway<FixedRun<M, B>>;

/// The progress of each member of a register. Steps end where the course of a single body with
/// equal steps would end them, so each member moves as it would alone, to the bit.
pub(super) struct Ways<'e, M> {
    fixed: Fixed<M>,
    limits: &'e Limits,
    times: Range<f64>,
    /// One for each member; the register has `count` of them.
    each: [Way; BLOCK],
    count: usize,
    /// Whether all members are within the same steps, so that the first stands for all.
    are_alike: bool,
    /// Whether a part of the inputs moves.
    moves: bool,
}

/// Equal steps of one member within a stretch.
#[derive(Clone, Copy, PartialEq)]
struct Way {
    stretch: Stretch,
    start: f64,
    end: f64,
    taken: usize,
    steps: usize,
    /// Whether the member has not come to the time up to which it moves, and whether it has moved.
    goes: bool,
    has_moved: bool,
}

impl<'e, M: RungeKutta> Ways<'e, M> {
    /// Where the members of a register begin, or go on with their motions.
    #[cfg_attr(not(unoptimized), inline(always))]
    pub(super) fn new<B: Generic, L: RigidBody<Scalar: Scalar>>(
        member: (&L, &L::Input),
        plan: &Plan<'e, Fixed<M>, B>,
        motions: &[Motion<M, B>],
    ) -> Self {
        let (body, input) = member;
        let way = |lane: usize| match motions.get(lane).or(motions.last()) {
            None => Way::since(plan.times.start),
            Some(motion) => Way::of(motion),
        };
        let mut ways = Self {
            fixed: plan.method,
            limits: plan.limits,
            times: plan.times.clone(),
            each: core::array::from_fn(way),
            count: L::Scalar::LANES.min(BLOCK),
            are_alike: false,
            moves: body.input_after(input, L::Scalar::default()).is_some(),
        };
        ways.all_go_on(member);
        ways
    }

    /// Whether all members take the same steps to the end, and no time is near a switch.
    pub(super) fn are_plain(&self) -> bool {
        let Range { start, end } = self.times;
        let is_plain = |way: &Way| {
            let Stretch { lower, upper, .. } = way.stretch;
            way.end == end && lower <= start.min(end) && start.max(end) <= upper
        };
        !self.moves && (0..self.count).all(|lane| is_plain(self.of(lane)))
    }

    /// The next steps of all members.
    #[cfg_attr(not(unoptimized), inline(always))]
    fn all_go_on<L: RigidBody<Scalar: Scalar>>(&mut self, member: (&L, &L::Input)) {
        let (limits, [first, ..]) = (self.limits, self.each);
        let is_over = |way: &Way| !limits.is_before(way.time(), way.stretch.next);
        // their equations may change at different times
        if !self.are_alike || is_over(&first) {
            if self.are_alike {
                self.each = [first; BLOCK];
            }
            for (lane, way) in self.each.iter_mut().enumerate().take(self.count) {
                let now = way.time();
                // a member that has arrived needs the stretch of its last step
                if way.goes && limits.is_before(now, self.times.end) {
                    limits.until(member, &mut way.stretch, now, lane);
                }
            }
            let [first, others @ ..] = &self.each;
            self.are_alike = others.iter().take(self.count - 1).all(|way| way == first);
        }
        let count = if self.are_alike { 1 } else { self.count };
        (0..count).for_each(|lane| self.go_on(member, lane));
    }

    /// The progress of a member.
    fn of(&self, lane: usize) -> &Way {
        &self.each[if self.are_alike { 0 } else { lane }]
    }

    /// The next steps of a member, if the last ones are taken.
    #[cfg_attr(not(unoptimized), inline(always))]
    fn go_on<L: RigidBody<Scalar: Scalar>>(&mut self, member: (&L, &L::Input), lane: usize) {
        let limits = self.limits;
        let way = &mut self.each[lane];
        let (now, is_under_way) = (way.time(), way.taken < way.steps);
        way.goes &= limits.is_before(now, self.times.end);
        // the longest step is counted from the end of the last step
        if !way.goes || (is_under_way && limits.max_step == f64::INFINITY) {
            return;
        }
        let until = limits.until(member, &mut way.stretch, now, lane);
        // a member whose conditions have no times is lost
        let limit = until.unwrap_or(f64::NAN);
        if !is_under_way || way.end != limit {
            (way.start, way.end, way.taken) = (now, limit, 0);
            way.steps = self.fixed.count(limit - now).unwrap_or(1);
        }
    }

    /// The state of the members at the end. Their motions are kept, if there are any, except those
    /// that are not finite: these stay where they were.
    #[cfg_attr(not(unoptimized), inline(always))]
    pub(super) fn moved<B, L, S>(
        mut self,
        simd: S,
        member: (&L, &L::Input),
        state: &L::State,
        motions: &mut [Motion<M, B>],
    ) -> L::State
    where
        S: Register,
        B: Generic,
        L: RigidBody<Scalar = Lanes<S>, State: Coordinates<Scalar = Lanes<S>>>,
    {
        let (body, input) = member;
        let are_kept = !motions.is_empty();
        let (mut coordinates, mut lost) = if are_kept {
            let lanes = InLanes::of(simd, motions);
            (
                lanes.list(|motion| &motion.run.track.now.coordinates),
                lanes.list(|motion| &motion.run.track.now.lost),
            )
        } else {
            (state.coordinates(), Default::default())
        };
        let (mut since, mut before) = (Lanes::splat(simd, 0.0), coordinates);
        while (0..self.count).any(|lane| self.of(lane).goes) {
            let time = self.register(simd, Way::time);
            let step = self.register(simd, Way::step);
            let within = Within {
                body,
                lower: self.register(simd, |way| way.stretch.lower),
                upper: self.register(simd, |way| way.stretch.upper),
                given: Lanes::splat(simd, self.limits.held.start),
            };
            let equations = Equations {
                body: &within,
                input,
            };
            let mut change = M::increment(&equations, time, &coordinates, step);
            L::State::keep(&coordinates, &mut change);
            let (mut next, mut next_lost) = (coordinates, lost);
            add(&mut next, &mut next_lost, &change);
            if self.are_alike {
                (since, before) = (time, coordinates);
                (coordinates, lost) = (next, next_lost);
            } else {
                let is_there = step.equal(Lanes::splat(simd, 0.0));
                if are_kept {
                    since = Lanes::select(is_there, since, time);
                    replace(&mut before, &coordinates, is_there);
                }
                replace(&mut coordinates, &next, is_there);
                replace(&mut lost, &next_lost, is_there);
            }
            self.stepped(member);
        }
        let zero = Lanes::splat(simd, 0.0);
        let numbers = coordinates.as_ref().iter();
        let zeros = numbers.fold(zero, |sum, number| sum + zero * *number);
        for (lane, motion) in motions.iter_mut().enumerate().take(self.count) {
            // zero, or NaN
            if zeros.lane(lane) != 0.0 {
                continue;
            }
            let way = self.of(lane);
            way.keep(motion);
            let Track {
                now, before: last, ..
            } = &mut motion.run.track;
            copy(&mut now.coordinates, &coordinates, lane);
            copy(&mut now.lost, &lost, lane);
            // a step that ends at the requested time is not interpolated
            if way.has_moved && self.limits.is_before(self.times.end, now.time) {
                last.0 = since.lane(lane);
                copy(&mut last.1, &before, lane);
            }
        }
        L::State::from_coordinates(&coordinates)
    }

    /// After a step of all members that go.
    #[cfg_attr(not(unoptimized), inline(always))]
    fn stepped<L: RigidBody<Scalar: Scalar>>(&mut self, member: (&L, &L::Input)) {
        let is_cut = self.limits.max_step < f64::INFINITY;
        let is_over = |way: &Way| way.goes && (is_cut || way.taken == way.steps);
        let count = if self.are_alike { 1 } else { self.count };
        for way in self.each.iter_mut().take(count) {
            if way.goes {
                way.taken += 1;
                way.has_moved = true;
                way.goes = self.limits.is_before(way.time(), self.times.end);
            }
        }
        if self.each.iter().take(count).any(is_over) {
            self.all_go_on(member);
        }
    }

    /// A part of the ways of all members, in a register.
    #[cfg_attr(not(unoptimized), inline(always))]
    fn register<S: Register>(&self, simd: S, part: fn(&Way) -> f64) -> Lanes<S> {
        if self.are_alike {
            return Lanes::splat(simd, part(self.of(0)));
        }
        let row: Eight = core::array::from_fn(|lane| part(self.of(lane)));
        let (registers, _) = S::as_simd_f64s(&row);
        Lanes::new(simd, registers[0])
    }
}

/// Replaces numbers of the lanes that have not come to the end.
#[cfg_attr(not(unoptimized), inline(always))]
fn replace<S: Register, A>(numbers: &mut A, next: &A, is_there: <Lanes<S> as Scalar>::Truth)
where
    A: AsRef<[Lanes<S>]> + AsMut<[Lanes<S>]>,
{
    for (number, next) in numbers.as_mut().iter_mut().zip(next.as_ref()) {
        *number = Lanes::select(is_there, *number, *next);
    }
}

/// Copies the numbers of one lane.
#[cfg_attr(not(unoptimized), inline(always))]
fn copy<S: Register>(list: &mut impl AsMut<[f64]>, lanes: &impl AsRef<[Lanes<S>]>, lane: usize) {
    for (number, lanes) in list.as_mut().iter_mut().zip(lanes.as_ref()) {
        *number = lanes.lane(lane);
    }
}

/// The members of the registers in which members take different steps, or whose motions are kept.
pub(super) struct Apart<'e, M: RungeKutta, B: Generic> {
    pub(super) plan: &'e Plan<'e, Fixed<M>, B>,
    pub(super) states: &'e mut [Eight],
    pub(super) motions: &'e mut [Motion<M, B>],
}

impl<M: RungeKutta, B: Generic> Work for Apart<'_, M, B> {
    type Output = ();

    #[cfg_attr(not(unoptimized), inline(always))]
    fn run<S: Register>(self, simd: S) {
        let columns = <B::State as Columns<f64>>::COUNT;
        let (plan, states) = (self.plan, self.states.chunks_exact_mut(columns));
        let are_kept = !self.motions.is_empty();
        let mut motions = self.motions.chunks_mut(Lanes::<S>::COUNT);
        for (rows, block) in states.zip(plan.members.blocks(plan.first)) {
            for group in 0..BLOCK / Lanes::<S>::COUNT {
                let (body, input) = block.group::<B, S>(simd, group);
                let member = (&body, &input);
                let motions = motions.next().unwrap_or_default();
                let ways = Ways::new(member, plan, motions);
                let is_done = if are_kept {
                    motions.is_empty()
                } else {
                    ways.are_plain()
                };
                if is_done {
                    continue;
                }
                let end = ways.moved(simd, member, &read(simd, rows, group), motions);
                let rows = rows.iter_mut();
                Columns::<Lanes<S>>::write(&end, &mut GroupMut { rows, index: group });
            }
        }
    }
}

impl Way {
    /// Before the first step of a motion from a time.
    fn since(time: f64) -> Self {
        Self {
            stretch: Stretch::until_now(time),
            start: time,
            end: time,
            taken: 0,
            steps: 0,
            goes: true,
            has_moved: false,
        }
    }

    /// Where a motion goes on.
    fn of<M: RungeKutta, B: Generic>(motion: &Motion<M, B>) -> Self {
        let Underway {
            run,
            stretch,
            is_lost,
        } = motion;
        Self {
            stretch: *stretch,
            start: run.span.start,
            end: run.span.end,
            taken: run.steps.start,
            steps: run.steps.end,
            goes: !is_lost,
            has_moved: false,
        }
    }

    /// Keeps the progress of a motion.
    fn keep<M: RungeKutta, B: Generic>(&self, motion: &mut Motion<M, B>) {
        let Underway { run, stretch, .. } = motion;
        (*stretch, run.track.stretch) = (self.stretch, self.stretch);
        run.span = self.start..self.end;
        run.steps = self.taken..self.steps;
        run.track.now.time = self.time();
    }

    fn time(&self) -> f64 {
        if self.taken < self.steps {
            self.start + real(self.taken) * ((self.end - self.start) / real(self.steps))
        } else {
            self.end
        }
    }

    /// Zero at the end.
    fn step(&self) -> f64 {
        if self.goes {
            (self.end - self.start) / real(self.steps)
        } else {
            0.0
        }
    }
}
