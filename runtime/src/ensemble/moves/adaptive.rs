//! Variable steps in lanes, as long as the tolerance permits. A register holds several members,
//! each with its own steps; when one is done, the next takes its place.

use alloc::vec::Vec;
use core::ops::Range;
use core::sync::atomic::{AtomicBool, Ordering};

#[cfg(feature = "rayon")]
use rayon::iter::ParallelIterator as _;

use super::lane::{Lane, Progress};
use super::members::{Done, MemberError, indices, put};
use super::one_by_one::end_alone;
use super::register::InRegister;
use super::seats::Seats;
use super::{Moves, Together};
use crate::bodies::columns::{Columns, Generic};
use crate::ensemble::Ensemble;
use crate::ensemble::blocks::{BLOCK, Eight, write};
use crate::ensemble::evaluate::in_chunks;
use crate::ensemble::plan::{Limits, Plan};
use crate::integrate::{
    Adaptive, DormandPrince, Method, RungeKuttaPair, SeriesBelow, TaylorSeries, Verner,
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
                times: Range<f64>,
                limits: &Limits,
                observer: impl Fn(f64) + Sync,
            ) -> Vec<MemberError<B::State>> {
                stream(*self, ensemble, &times, limits, observer)
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
fn stream<B: Generic, A: Adaptive + Method<B>>(
    method: A,
    ensemble: &mut Ensemble<B>,
    times: &Range<f64>,
    limits: &Limits,
    observer: impl Fn(f64) + Sync,
) -> Vec<MemberError<B::State>> {
    let count = ensemble.len();
    let left: Vec<_> = (0..count).map(|_| AtomicBool::new(false)).collect();
    let done = Done::of(count, observer);
    let columns = <B::State as Columns<f64>>::COUNT;
    let (members, width) = (&ensemble.members, ensemble.width);
    in_chunks(ensemble.states.rows_mut(), columns, |first, rows| {
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
            count: here.len(),
            left: &left[here.clone()],
        });
        done.add(here.len());
    });
    let left: Vec<usize> = (0..count)
        .filter(|index| left[*index].load(Ordering::Relaxed))
        .collect();
    let ends = indices(left.len()).map(|number| {
        let index = left[number];
        (index, end_alone(ensemble, method, index, times, limits))
    });
    let ends: Vec<_> = ends.collect();
    put(&mut ensemble.states, ends.into_iter())
}

/// Integrates the members of some blocks, each as it would alone, to the bit. Members that do not
/// reach the end, or take very many steps, keep their states and are marked for separate
/// integration.
struct Stream<'e, A, B: Generic> {
    plan: &'e Plan<'e, A, B>,
    states: &'e mut [Eight],
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
                let fresh = register.fill(&mut waiting, &mut seats, self.states);
                if fresh.iter().any(|one| *one != 0.0) {
                    by_itself(
                        simd,
                        #[cfg_attr(not(unoptimized), inline(always))]
                        || register.begin(&seats, &fresh),
                    );
                }
                if register.lanes.iter().all(|lane| lane.member.is_none()) {
                    return;
                }
            }
            by_itself(
                simd,
                #[cfg_attr(not(unoptimized), inline(always))]
                || {
                    register.choose();
                    register.step();
                },
            );
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
            } else {
                self.left[member].store(true, Ordering::Relaxed);
            }
        }
    }
}
