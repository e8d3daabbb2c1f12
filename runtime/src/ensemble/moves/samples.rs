//! The states of members at a time within their last steps, in lanes.

use alloc::vec::Vec;
use core::marker::PhantomData;

use crate::bodies::columns::{Columns, Generic};
use crate::ensemble::blocks::{BLOCK, Eight, GroupMut};
use crate::ensemble::evaluate::Laned;
use crate::ensemble::plan::Plan;
use crate::integrate::{RungeKutta, Track, Within, runge_kutta_step};
use crate::numbers::lanes::{Lanes, Register, Width, Work};
use crate::state::Coordinates;

/// Sets the states of members whose last steps by a Runge–Kutta method end beyond the time up to which
/// they move.
pub(super) fn sample<'e, M: RungeKutta, A, B: Generic>(
    width: Width,
    plan: &Plan<'_, A, B>,
    states: &mut [Eight],
    tracks: impl Iterator<Item = &'e Track<B::State>> + Clone,
) where
    B::State: 'e,
{
    // no step passes a change of inputs, or the end
    let (limits, time) = (plan.limits, plan.times.end);
    if !limits.is_before(time, limits.held.end) || !limits.is_before(time, limits.end) {
        return;
    }
    let is_beyond = |track: &Track<_>| limits.is_before(time, track.now.time);
    if tracks.clone().any(is_beyond) {
        width.run(Samples::<M, A, B> {
            plan,
            states,
            tracks: &tracks.collect::<Vec<_>>(),
            method: PhantomData,
        });
    }
}

struct Samples<'e, M, A, B: Generic> {
    plan: &'e Plan<'e, A, B>,
    states: &'e mut [Eight],
    tracks: &'e [&'e Track<B::State>],
    method: PhantomData<M>,
}

impl<M: RungeKutta, A, B: Generic> Work for Samples<'_, M, A, B> {
    type Output = ();

    #[cfg_attr(not(unoptimized), inline(always))]
    fn run<S: Register>(self, simd: S) {
        let (plan, columns) = (self.plan, <B::State as Columns<f64>>::COUNT);
        let time = plan.times.end;
        let blocks = self.tracks.chunks(BLOCK);
        let states = self.states.chunks_exact_mut(columns);
        let mut sampled = alloc::vec![Eight::default(); columns];
        for ((rows, block), tracks) in states.zip(plan.members.blocks(plan.first)).zip(blocks) {
            for (group, tracks) in tracks.chunks(Lanes::<S>::COUNT).enumerate() {
                let is_beyond = |track: &&Track<_>| plan.limits.is_before(time, track.now.time);
                if !tracks.iter().any(is_beyond) {
                    continue;
                }
                let (body, input) = block.group::<B, S>(simd, group);
                let lanes = InLanes::of(simd, tracks);
                let within = Within::<Laned<B, S>> {
                    body: &body,
                    lower: lanes.row(|track| track.stretch.lower),
                    upper: lanes.row(|track| track.stretch.upper),
                    given: lanes.row(|track| track.stretch.given),
                };
                let start = lanes.row(|track| track.before.0);
                let before = lanes.list(|track| &track.before.1);
                let before = Coordinates::from_coordinates(&before);
                let step = Lanes::splat(simd, time) - start;
                let state = runge_kutta_step::<M, _>(&within, start, &before, &input, step);
                let places = sampled.iter_mut();
                Columns::<Lanes<S>>::write(
                    &state,
                    &mut GroupMut {
                        rows: places,
                        index: group,
                    },
                );
                let lanes = tracks.iter().enumerate();
                for (lane, _) in lanes.filter(|(_, track)| is_beyond(track)) {
                    let lane = Lanes::<S>::COUNT * group + lane;
                    for (row, sampled) in rows.iter_mut().zip(&sampled) {
                        row[lane] = sampled[lane];
                    }
                }
            }
        }
    }
}

/// The tracks of the members in a register; the last one stands for missing ones, and zeros for all
/// if there are none.
pub(super) struct InLanes<'e, S, T> {
    simd: S,
    tracks: Option<[&'e T; BLOCK]>,
}

impl<'e, S: Register, T> InLanes<'e, S, T> {
    #[cfg_attr(not(unoptimized), inline(always))]
    pub(super) fn of(simd: S, tracks: &'e [T]) -> Self {
        let last = tracks.last();
        let tracks = last.map(|last| core::array::from_fn(|lane| tracks.get(lane).unwrap_or(last)));
        Self { simd, tracks }
    }

    /// A number of each track.
    #[cfg_attr(not(unoptimized), inline(always))]
    pub(super) fn row(&self, number: impl Fn(&T) -> f64) -> Lanes<S> {
        let row: Eight = match &self.tracks {
            None => [0.0; BLOCK],
            Some(tracks) => tracks.map(number),
        };
        let (registers, _) = S::as_simd_f64s(&row);
        Lanes::new(self.simd, registers[0])
    }

    /// A list of each track.
    #[cfg_attr(not(unoptimized), inline(always))]
    pub(super) fn list<D, A: AsRef<[f64]>>(&self, list: impl Fn(&T) -> &A) -> D
    where
        D: Default + AsMut<[Lanes<S>]>,
    {
        let mut lanes = D::default();
        for (place, lanes) in lanes.as_mut().iter_mut().enumerate() {
            *lanes = self.row(|track| list(track).as_ref()[place]);
        }
        lanes
    }
}
