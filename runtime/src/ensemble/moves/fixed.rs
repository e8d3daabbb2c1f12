//! Fixed steps in lanes.

use alloc::vec::Vec;
use core::ops::Range;

use super::members::{Done, MemberError};
use super::motions::Motions;
use super::one_by_one::{OneByOne, moved_alone};
use super::register_steps::{Apart, Ways};
use super::samples::sample;
use super::{Moves, RunOf};
use crate::bodies::body::RigidBody;
use crate::bodies::columns::{Columns, Generic};
use crate::ensemble::Ensemble;
use crate::ensemble::blocks::{BLOCK, Blocks, Eight, GroupMut};
use crate::ensemble::evaluate::{in_chunks_with, read};
use crate::ensemble::plan::{Limits, Plan};
use crate::integrate::{Equations, Fixed, FixedRun, RungeKutta, Underway, add};
use crate::numbers::count::real;
use crate::numbers::lanes::{Lanes, Register, Width, Work};
use crate::state::Coordinates;

/// In lanes: each member moves as it would alone, to the bit. Bodies whose mass or inertia changes
/// move one by one, because each step checks these. A member that fails in lanes is moved again
/// alone to find its error.
impl<B: Generic, M: RungeKutta> Moves<B> for Fixed<M> {
    type Alone = Self;

    fn alone(&self) -> Self {
        *self
    }

    fn moved(
        &self,
        ensemble: &mut Ensemble<B>,
        motions: &mut Motions<RunOf<Self, B>>,
        times: Range<f64>,
        limits: &Limits,
        observer: impl Fn(f64) + Sync,
    ) -> Vec<MemberError<B::State>> {
        // at each step the mass must be possible
        if B::CHANGES {
            return OneByOne(*self).moved(ensemble, motions, times, limits, observer);
        }
        let is_there = times.end - times.start == 0.0;
        if ensemble.is_empty() || is_there {
            return Vec::new();
        }
        let before = ensemble.states.clone();
        let done = Done::of(before.len(), observer);
        let plan = Plan {
            method: *self,
            members: &ensemble.members,
            first: 0,
            times: times.clone(),
            limits,
        };
        let kept = motions.as_mut_slice();
        in_lanes(&plan, kept, ensemble.width, &mut ensemble.states, &done);
        let left = if kept.is_empty() {
            ensemble.states.lost()
        } else {
            // a motion that does not reach the end stays where it was
            let is_left = |motion: &Underway<RunOf<Self, B>>| {
                !motion.is_lost && limits.is_before(motion.run.track.now.time, times.end)
            };
            kept.iter().map(is_left).collect()
        };
        for (index, _) in left.iter().enumerate().filter(|(_, is_left)| **is_left) {
            ensemble.states.set(index, &before.get(index));
        }
        moved_alone(*self, ensemble, motions, &left, (&times, limits))
    }
}

/// Moves all members, by equal steps if their motions are not kept, or by those of each.
fn in_lanes<B: Generic, M: RungeKutta>(
    plan: &Plan<'_, Fixed<M>, B>,
    motions: &mut [Underway<FixedRun<M, B>>],
    width: Width,
    states: &mut Blocks<B::State>,
    done: &Done<impl Fn(f64) + Sync>,
) {
    let columns = <B::State as Columns<f64>>::COUNT;
    let span = plan.times.end - plan.times.start;
    let steps = plan.method.count(span).unwrap_or(1);
    let step = span / real(steps);
    in_chunks_with(
        states.rows_mut(),
        columns,
        motions,
        |first, rows, motions| {
            let members_here = rows.len() / columns * BLOCK;
            let plan = Plan {
                first,
                times: plan.times.clone(),
                ..*plan
            };
            let is_done = motions.is_empty()
                && width.run(Advance {
                    plan: &plan,
                    step,
                    steps,
                    states: rows,
                });
            if !is_done {
                width.run(Apart {
                    plan: &plan,
                    states: rows,
                    motions,
                });
            }
            let tracks = motions.iter().map(|motion| &motion.run.track);
            sample::<M, _, _>(width, &plan, rows, tracks);
            done.add(members_here);
        },
    );
}

/// Advances the members of each register that take the same steps; returns whether these are all of
/// them.
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
                if !Ways::new((&body, &input), plan, &[]).are_plain() {
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
