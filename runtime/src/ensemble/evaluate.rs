//! Evaluation and motion of all members, in lanes and in threads.

use core::ops::Range;

#[cfg(feature = "rayon")]
use rayon::iter::{IndexedParallelIterator as _, IntoParallelIterator as _, ParallelIterator as _};

use super::blocks::{BLOCK, Eight, Group, GroupMut};
use super::{Blocks, Ensemble, Members};
use crate::bodies::body::RigidBody;
use crate::bodies::columns::{Columns, Generic};
use crate::integrate::cf4_step;
use crate::numbers::count::real;
use crate::numbers::lanes::{Lanes, Register, Work};
use crate::state::State;

/// The acceleration of a body of this kind.
type Acceleration<B> = <<B as RigidBody>::State as State>::Acceleration;

/// The number of calls of an observer in a run.
const ROUNDS: usize = 100;

impl<B: Generic> Ensemble<B> {
    /// The accelerations of all members.
    #[must_use]
    pub fn accelerations(&self, time: f64) -> Blocks<Acceleration<B>> {
        let mut accelerations = self.states.zeros_like();
        self.accelerate(time, &mut accelerations);
        accelerations
    }

    /// The same, replacing given accelerations.
    ///
    /// # Panics
    /// If the number of accelerations differs from the number of members.
    pub fn accelerate(&self, time: f64, accelerations: &mut Blocks<Acceleration<B>>) {
        assert_eq!(
            accelerations.len(),
            self.len(),
            "one acceleration for each member"
        );
        let columns = <Acceleration<B> as Columns<f64>>::COUNT;
        in_chunks(accelerations.rows_mut(), columns, |first, rows| {
            self.width.run(Accelerate {
                members: &self.members,
                states: &self.states,
                first,
                time,
                accelerations: rows,
            });
        });
    }

    /// Moves all members by steps of [`integrate::cf4`](crate::integrate::cf4); inputs are held.
    pub fn cf4(&mut self, times: Range<f64>, steps: usize) {
        self.cf4_observed(times, steps, |_| {});
    }

    /// The same, calling an observer about a hundred times with the number of completed steps.
    pub fn cf4_observed(
        &mut self,
        times: Range<f64>,
        steps: usize,
        mut observer: impl FnMut(usize),
    ) {
        let step = (times.end - times.start) / real(steps);
        let round = steps.div_ceil(ROUNDS).max(1);
        for done in (0..steps).step_by(round) {
            let last = steps.min(done + round);
            self.advance(times.start, step, done..last);
            observer(last);
        }
    }

    fn advance(&mut self, start: f64, step: f64, steps: Range<usize>) {
        let (width, members) = (self.width, &self.members);
        let columns = <B::State as Columns<f64>>::COUNT;
        in_chunks(self.states.rows_mut(), columns, |first, rows| {
            width.run(Cf4 {
                members,
                first,
                start,
                step,
                steps: steps.clone(),
                states: rows,
            });
        });
    }
}

/// The number of blocks that one thread takes at a time.
const CHUNK: usize = 32;

/// Runs some work on all blocks, with the index of the first block of its rows.
pub(super) fn in_chunks(
    rows: &mut [Eight],
    columns: usize,
    work: impl Fn(usize, &mut [Eight]) + Sync + Send,
) {
    in_chunks_with::<()>(rows, columns, &mut [], |first, rows, _| work(first, rows));
}

/// The same, with one more value of each member, or none.
pub(super) fn in_chunks_with<V: Send>(
    rows: &mut [Eight],
    columns: usize,
    values: &mut [V],
    work: impl Fn(usize, &mut [Eight], &mut [V]) + Sync + Send,
) {
    let mut values = values.chunks_mut(BLOCK * CHUNK);
    let chunks = rows.chunks_mut(columns * CHUNK).enumerate();
    let chunks = chunks.map(|(chunk, rows)| (chunk, rows, values.next().unwrap_or_default()));
    #[cfg(feature = "rayon")]
    let chunks = chunks
        .collect::<alloc::vec::Vec<_>>()
        .into_par_iter()
        .with_max_len(1);
    chunks.for_each(|(chunk, rows, values)| work(chunk * CHUNK, rows, values));
}

/// A body over lanes.
pub(super) type Laned<B, S> = <B as Generic>::With<Lanes<S>>;

/// The members of one block, by the rows of their bodies and of their inputs.
pub(super) struct Block<'m> {
    bodies: &'m [Eight],
    inputs: &'m [Eight],
}

impl<B: Generic> Members<B> {
    /// All blocks from an index.
    #[cfg_attr(not(unoptimized), inline(always))]
    pub(super) fn blocks(&self, first: usize) -> impl Iterator<Item = Block<'_>> {
        (first..).map_while(|index| {
            Some(Block {
                bodies: self.bodies.block(if self.is_uniform { 0 } else { index })?,
                inputs: self.inputs.block(index)?,
            })
        })
    }
}

impl Block<'_> {
    /// Bodies and inputs of a group, over lanes.
    #[cfg_attr(not(unoptimized), inline(always))]
    pub(super) fn group<B: Generic, S: Register>(
        &self,
        simd: S,
        group: usize,
    ) -> (Laned<B, S>, <Laned<B, S> as RigidBody>::Input) {
        (
            read(simd, self.bodies, group),
            read(simd, self.inputs, group),
        )
    }
}

/// The values of a group in the rows of its block, over lanes.
#[cfg_attr(not(unoptimized), inline(always))]
pub(super) fn read<D: Columns<Lanes<S>>, S: Register>(simd: S, rows: &[Eight], group: usize) -> D {
    D::read(&mut Group {
        simd,
        rows,
        index: group,
    })
}

struct Accelerate<'e, B: Generic> {
    members: &'e Members<B>,
    states: &'e Blocks<B::State>,
    first: usize,
    time: f64,
    accelerations: &'e mut [Eight],
}

impl<B: Generic> Work for Accelerate<'_, B> {
    type Output = ();

    #[cfg_attr(not(unoptimized), inline(always))]
    fn run<S: Register>(self, simd: S) {
        let time = Lanes::splat(simd, self.time);
        let columns = <Acceleration<B> as Columns<f64>>::COUNT;
        let states = (self.first..).map_while(|index| self.states.block(index));
        let members = self.members.blocks(self.first).zip(states);
        let accelerations = self.accelerations.chunks_exact_mut(columns);
        for (rows, (block, states)) in accelerations.zip(members) {
            for group in 0..BLOCK / Lanes::<S>::COUNT {
                let (body, input) = block.group::<B, S>(simd, group);
                let state = read(simd, states, group);
                let acceleration = body.acceleration(time, &state, &input);
                let rows = rows.iter_mut();
                acceleration.write(&mut GroupMut { rows, index: group });
            }
        }
    }
}

struct Cf4<'e, B: Generic> {
    members: &'e Members<B>,
    first: usize,
    start: f64,
    step: f64,
    steps: Range<usize>,
    states: &'e mut [Eight],
}

impl<B: Generic> Work for Cf4<'_, B> {
    type Output = ();

    #[cfg_attr(not(unoptimized), inline(always))]
    fn run<S: Register>(self, simd: S) {
        let step = Lanes::splat(simd, self.step);
        let columns = <B::State as Columns<f64>>::COUNT;
        let states = self.states.chunks_exact_mut(columns);
        for (rows, block) in states.zip(self.members.blocks(self.first)) {
            for group in 0..BLOCK / Lanes::<S>::COUNT {
                let (body, input) = block.group::<B, S>(simd, group);
                let mut state = read(simd, rows, group);
                for k in self.steps.clone() {
                    let time = Lanes::splat(simd, self.start + real(k) * self.step);
                    let since = time - Lanes::splat(simd, self.start);
                    state = match body.input_after(&input, since) {
                        Some(moved) => cf4_step(&body, time, &state, &moved, step),
                        None => cf4_step(&body, time, &state, &input, step),
                    };
                }
                let rows = rows.iter_mut();
                Columns::<Lanes<S>>::write(&state, &mut GroupMut { rows, index: group });
            }
        }
    }
}
