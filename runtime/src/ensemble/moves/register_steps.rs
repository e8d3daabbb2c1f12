//! The steps of a few members in one register, where each may end at times of its own.

#![allow(
    clippy::float_cmp,
    reason = "a motion is at a time, or it is not: it is put there"
)]

use core::ops::Range;

use crate::bodies::body::RigidBody;
use crate::bodies::columns::{Columns, Generic};
use crate::ensemble::blocks::{BLOCK, Eight, GroupMut};
use crate::ensemble::evaluate::read;
use crate::ensemble::plan::{Limits, Plan};
use crate::integrate::{Equations, Fixed, RungeKutta, Stretch, Within, add};
use crate::numbers::count::real;
use crate::numbers::lanes::{Lanes, Register, Work};
use crate::numbers::scalar::Scalar;
use crate::state::Coordinates;

/// The progress of each member of a register. Steps end where the course of a single body with
/// equal steps would end them, so each member moves as it would alone, to the bit.
pub(super) struct Ways<'e, M> {
    fixed: Fixed<M>,
    limits: &'e Limits,
    times: Range<f64>,
    /// One for each member; the register has `count` of them.
    each: [Way; BLOCK],
    count: usize,
    /// Whether a part of the inputs moves.
    moves: bool,
}

/// Equal steps of one member within a stretch; none at the end.
#[derive(Clone, Copy)]
struct Way {
    stretch: Stretch,
    start: f64,
    end: f64,
    taken: usize,
    steps: usize,
}

impl<'e, M: RungeKutta> Ways<'e, M> {
    /// Where the members of a register begin.
    #[cfg_attr(not(unoptimized), inline(always))]
    pub(super) fn new<B: Generic, L: RigidBody<Scalar: Scalar>>(
        (body, input): (&L, &L::Input),
        plan: &Plan<'e, Fixed<M>, B>,
    ) -> Self {
        let (times, limits) = (plan.times.clone(), plan.limits);
        let start = times.start;
        let way = Way {
            stretch: Stretch {
                next: start,
                ..Stretch::ALL
            },
            start,
            end: start,
            taken: 0,
            steps: 0,
        };
        let mut ways = Self {
            fixed: plan.method,
            limits,
            times,
            each: [way; BLOCK],
            count: L::Scalar::LANES.min(BLOCK),
            moves: body.input_after(input, L::Scalar::default()).is_some(),
        };
        (0..ways.count).for_each(|lane| ways.go_on((body, input), lane));
        ways
    }

    /// Whether all members take the same steps to the end, and no time is near a switch.
    pub(super) fn are_plain(&self) -> bool {
        let Range { start, end } = self.times;
        let is_plain = |way: &Way| {
            let Stretch { lower, upper, .. } = way.stretch;
            way.end == end && lower <= start.min(end) && start.max(end) <= upper
        };
        !self.moves && self.each.iter().take(self.count).all(is_plain)
    }

    /// The next steps of a member.
    #[cfg_attr(not(unoptimized), inline(always))]
    fn go_on<L: RigidBody<Scalar: Scalar>>(&mut self, (body, input): (&L, &L::Input), lane: usize) {
        let end = self.times.end;
        let forwards = end >= self.times.start;
        let Some(way) = self.each.get_mut(lane) else {
            return;
        };
        let is_under_way = way.taken < way.steps;
        let now = if is_under_way { way.time() } else { way.end };
        if now == end || now.is_nan() {
            way.steps = 0;
            return;
        }
        let from = (now, end, forwards);
        let until = self
            .limits
            .until((body, input), &mut way.stretch, from, lane);
        // a member whose conditions have no times is lost
        let limit = until.map_or(f64::NAN, |until| self.limits.pace().limit(now, until));
        if is_under_way && way.end == limit {
            return;
        }
        (way.start, way.end, way.taken) = (now, limit, 0);
        way.steps = self.fixed.count(limit - now).unwrap_or(1);
    }

    /// The state at the end.
    #[cfg_attr(not(unoptimized), inline(always))]
    pub(super) fn moved<L, S>(
        mut self,
        simd: S,
        (body, input): (&L, &L::Input),
        state: &L::State,
    ) -> L::State
    where
        S: Register,
        L: RigidBody<Scalar = Lanes<S>, State: Coordinates<Scalar = Lanes<S>>>,
    {
        let given = Lanes::splat(simd, self.limits.given);
        let mut coordinates = state.coordinates();
        let mut lost = <L::State as Coordinates>::Array::default();
        while self.each.iter().take(self.count).any(|way| way.steps > 0) {
            let [time, step, lower, upper] = [Way::time, Way::step, Way::lower, Way::upper]
                .map(|part| self.register(simd, part));
            let within = Within {
                body,
                lower,
                upper,
                given,
            };
            let equations = Equations {
                body: &within,
                input,
            };
            let mut change = M::increment(&equations, time, &coordinates, step);
            L::State::keep(&coordinates, &mut change);
            let (mut next, mut next_lost) = (coordinates, lost);
            add(&mut next, &mut next_lost, &change);
            let is_there = step.equal(Lanes::splat(simd, 0.0));
            for (old, next) in [(&mut coordinates, &next), (&mut lost, &next_lost)] {
                for (old, next) in old.as_mut().iter_mut().zip(next.as_ref()) {
                    *old = Lanes::select(is_there, *old, *next);
                }
            }
            for lane in 0..self.count {
                let way = &mut self.each[lane];
                way.taken += 1;
                // the longest step is counted from the end of the last step
                if way.taken >= way.steps || self.limits.max_step < f64::INFINITY {
                    self.go_on((body, input), lane);
                }
            }
        }
        L::State::from_coordinates(&coordinates)
    }

    /// A part of the ways of all members, in a register.
    #[cfg_attr(not(unoptimized), inline(always))]
    fn register<S: Register>(&self, simd: S, part: fn(&Way) -> f64) -> Lanes<S> {
        let row: Eight = core::array::from_fn(|lane| part(&self.each[lane]));
        let (registers, _) = S::as_simd_f64s(&row);
        Lanes::new(simd, registers[0])
    }
}

/// The members of the registers in which members take different steps.
pub(super) struct Apart<'e, M, B: Generic> {
    pub(super) plan: &'e Plan<'e, Fixed<M>, B>,
    pub(super) states: &'e mut [Eight],
}

impl<M: RungeKutta, B: Generic> Work for Apart<'_, M, B> {
    type Output = ();

    #[cfg_attr(not(unoptimized), inline(always))]
    fn run<S: Register>(self, simd: S) {
        let columns = <B::State as Columns<f64>>::COUNT;
        let (plan, states) = (self.plan, self.states.chunks_exact_mut(columns));
        for (rows, block) in states.zip(plan.members.blocks(plan.first)) {
            for group in 0..BLOCK / Lanes::<S>::COUNT {
                let (body, input) = block.group::<B, S>(simd, group);
                let member = (&body, &input);
                let ways = Ways::new(member, plan);
                if ways.are_plain() {
                    continue;
                }
                let end = ways.moved(simd, member, &read(simd, rows, group));
                let rows = rows.iter_mut();
                Columns::<Lanes<S>>::write(&end, &mut GroupMut { rows, index: group });
            }
        }
    }
}

impl Way {
    fn time(&self) -> f64 {
        self.start + real(self.taken) * self.step()
    }

    /// Zero at the end.
    fn step(&self) -> f64 {
        if self.steps == 0 {
            0.0
        } else {
            (self.end - self.start) / real(self.steps)
        }
    }

    fn lower(&self) -> f64 {
        self.stretch.lower
    }

    fn upper(&self) -> f64 {
        self.stretch.upper
    }
}
