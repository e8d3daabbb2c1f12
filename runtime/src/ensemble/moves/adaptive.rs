//! Variable steps in lanes, as long as the tolerance permits. A register holds several members,
//! each with its own steps; when one is done, the next takes its place.

use alloc::vec::Vec;
use core::ops::Range;
use core::sync::atomic::{AtomicBool, Ordering};

use super::lane::{Lane, Progress};
use super::members::{Done, MemberError};
use super::motions::Motions;
use super::one_by_one::moved_alone;
use super::register::InRegister;
use super::samples::sample;
use super::seats::Seats;
use super::{Moves, RunOf, Together};
use crate::bodies::columns::{Columns, Generic};
use crate::ensemble::Ensemble;
use crate::ensemble::blocks::{BLOCK, Eight, write};
use crate::ensemble::evaluate::in_chunks_with;
use crate::ensemble::plan::{Limits, Plan};
use crate::integrate::{
    Adaptive, AdaptiveRun, DormandPrince, Method, RungeKuttaPair, SeriesBelow, TaylorSeries,
    Underway, Verner,
};
use crate::numbers::lanes::{Lanes, Register, Work, by_itself};

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
                motions: &mut Motions<RunOf<Self, B>>,
                times: Range<f64>,
                limits: &Limits,
                observer: impl Fn(f64) + Sync,
            ) -> Vec<MemberError<B::State>> {
                stream(*self, ensemble, motions, (&times, limits), observer)
            }
        }

        impl<B: Generic> Together<B> for $name {
            type Moves = Self;
        }
    };
}

moves_in_lanes!(DormandPrince);
moves_in_lanes!(Verner);

/// Steps of a pair in lanes are faster than series one by one.
impl<B: Generic> Together<B> for TaylorSeries {
    type Moves = Verner;
}

impl<B: Generic, const N: u32> Together<B> for SeriesBelow<N> {
    type Moves = Verner;
}

/// In lanes, the higher order is at least as fast.
impl<B: Generic> Together<B> for RungeKuttaPair {
    type Moves = Verner;
}

/// Moves all members in lanes, and those that are left alone.
fn stream<B: Generic, A>(
    method: A,
    ensemble: &mut Ensemble<B>,
    motions: &mut Motions<RunIn<A, B>>,
    (times, limits): (&Range<f64>, &Limits),
    observer: impl Fn(f64) + Sync,
) -> Vec<MemberError<B::State>>
where
    A: Adaptive + Method<B, Run = RunIn<A, B>>,
{
    let count = ensemble.len();
    let left: Vec<_> = (0..count).map(|_| AtomicBool::new(false)).collect();
    let done = Done::of(count, observer);
    let columns = <B::State as Columns<f64>>::COUNT;
    let (members, width) = (&ensemble.members, ensemble.width);
    let (rows, kept) = (ensemble.states.rows_mut(), motions.as_mut_slice());
    in_chunks_with(rows, columns, kept, |first, rows, motions| {
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
            motions,
            count: here.len(),
            left: &left[here.clone()],
        });
        let tracks = motions.iter().map(|motion| &motion.run.track);
        sample::<A::Pair, _, _>(width, &plan, rows, tracks);
        done.add(here.len());
    });
    let left: Vec<bool> = left.into_iter().map(AtomicBool::into_inner).collect();
    moved_alone(method, ensemble, motions, &left, (times, limits))
}

/// The run of one member.
type RunIn<A, B> = AdaptiveRun<B, <A as Adaptive>::Pair>;

/// Integrates the members of some blocks, each as it would alone, to the bit. Members that do not
/// reach the end, or take very many steps, keep their states and are marked for separate
/// integration.
struct Stream<'e, A: Adaptive, B: Generic> {
    plan: &'e Plan<'e, A, B>,
    states: &'e mut [Eight],
    /// The motions of the members, if they are kept.
    motions: &'e mut [Underway<RunIn<A, B>>],
    /// The number of members in the blocks.
    count: usize,
    /// Whether each of them is left for separate integration.
    left: &'e [AtomicBool],
}

impl<A: Adaptive, B: Generic> Work for Stream<'_, A, B> {
    type Output = ();

    #[cfg_attr(not(unoptimized), inline(always))]
    fn run<S: Register>(mut self, simd: S) {
        let mut waiting = 0..self.count;
        let mut seats = Seats::new(self.plan, self.states);
        let mut register = InRegister::new(simd, self.plan, &seats);
        loop {
            if register.has_stopped {
                self.clear(&mut register);
                let fresh = register.fill(&mut waiting, &mut seats, self.states, self.motions);
                if fresh.iter().any(|one| *one != 0.0) {
                    by_itself!(simd, register.begin(&seats, &fresh, self.motions));
                }
                if register.lanes.iter().all(|lane| lane.member.is_none()) {
                    return;
                }
                if register.has_stopped {
                    continue;
                }
            }
            by_itself!(simd, {
                register.choose();
                register.step();
            });
        }
    }
}

impl<A: Adaptive, B: Generic> Stream<'_, A, B> {
    /// Clears the lanes of members that are done, and stores their states.
    fn clear<S: Register>(&mut self, register: &mut InRegister<'_, A, B, S>) {
        register.has_stopped = false;
        for lane in 0..Lanes::<S>::COUNT {
            let Lane { member, state, .. } = register.lanes[lane];
            let Some(member) = member.filter(|_| state != Progress::Going) else {
                continue;
            };
            register.lanes[lane].member = None;
            if state == Progress::There {
                let end = register.end_of(lane);
                write(self.states, member / BLOCK, member % BLOCK, &end);
                if let Some(motion) = self.motions.get_mut(member) {
                    register.keep(lane, motion);
                }
            } else {
                self.left[member].store(true, Ordering::Relaxed);
            }
        }
    }
}
