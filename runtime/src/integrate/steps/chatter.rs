//! Whether a motion chatters: whether it is driven to and fro about a place where its equations
//! jump, by steps that are short enough for the tolerance, and that advance all the same.
//!
//! Friction along `velocity.normalize()` has no value at rest, and from every side drives a motion
//! there. A step over a jump J of the rates goes wrong by some part of J times its length; so the
//! tolerance permits steps of about tolerance / J, of which it takes a thousand million for a
//! second at 1e-9. None is lost in rounding, and no step alone tells such a motion from one that is
//! long, or stiff.
//!
//! What tells is how the length of steps goes with the tolerance. By a method of order p it goes
//! with the power 1 / (p + 1) where the equations are smooth, not at all where they are stiff, and
//! in proportion where they jump. So where many steps are behind, and with steps as long as the
//! longest of these many more are ahead, the motion is followed for a little way by a method of
//! order one, with its tolerance and with a finer one. Where steps are short in proportion, for
//! jumps that the change of the state makes and not that of time, and no step since the last look
//! was much longer, all of them were spent there. A motion whose end is near in steps is never
//! looked at: it comes to its end.

use super::equations::Rates;
use super::point::Point;
use super::size::{larger, relative_size};
use crate::numbers::count::real;
use crate::state::Coordinates;

/// How much finer the second tolerance is, and how coarse the first is at least: so much above the
/// rounding of states that this does not show in the second.
const FINER: f64 = 1.0 / 1024.0;
const COARSEST: f64 = 1.0 / 17_179_869_184.0; // 2⁻³⁴
/// How much shorter its steps are, at least, where the equations jump: where they are smooth it is
/// the root of 1024.
const SHORTER: f64 = 1.0 / 256.0;
/// How much longer than steps that are short for jumps no step may have been.
const LONGEST: f64 = 1024.0;
/// How many steps lead to where steps are as they will be, and how many are looked at from there.
const LEADING: usize = 64;
const SEEN: usize = 128;
/// How many of these are over jumps, at least.
const JUMPS: usize = SEEN / 8;
/// What part of the tolerance a step over a jump goes wrong, at least.
const SHARE: f64 = 1.0 / 8.0;
/// What part of the rates a jump is, at least; less may be the rounding of loads that cancel.
const LEAST: f64 = 1.0 / 1_048_576.0;
/// How often steps are tried, at most.
const TRIES: usize = 8 * (LEADING + SEEN);

/// After how many steps of a pair a motion is looked at.
pub(in crate::integrate) const LOOK: u32 = 1 << 18;
/// How many steps are ahead, at least, of a motion that is looked at.
const AHEAD: f64 = 4_194_304.0; // 2²²

/// The steps of a motion since it was looked at last.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Watch {
    steps: u32,
    /// After how many steps it is looked at.
    period: u32,
    longest: f64,
    /// Where the motion is to end \[s\], if that is known.
    end: f64,
}

impl Watch {
    /// Of a motion by a pair of Runge–Kutta methods.
    pub(crate) const OF_A_PAIR: Self = Self::every(LOOK);

    /// Of a motion that is looked at after so many steps.
    pub(in crate::integrate) const fn every(period: u32) -> Self {
        Self {
            steps: 0,
            period,
            longest: 0.0,
            end: f64::NAN,
        }
    }

    /// Hears where the motion is to end \[s\].
    pub(crate) fn heads_for(&mut self, end: f64) {
        self.end = end;
    }

    /// Hears of a step \[s\]; one that is cut short counts for its length only.
    #[inline(always)]
    pub(crate) fn saw(&mut self, step: f64, is_cut: bool) {
        self.steps = self.steps.saturating_add(u32::from(!is_cut));
        self.longest = larger(self.longest, step.abs());
    }

    /// Whether it is time to look at the motion.
    #[inline(always)]
    pub(crate) fn is_due(&self) -> bool {
        self.steps >= self.period
    }

    /// Looks at the motion, which goes on for `rest` \[s\] at least: the step \[s\] that jumps of
    /// its equations leave it, if it chatters and comes to no end.
    #[cold]
    #[inline(never)]
    pub(in crate::integrate) fn chatters<E: Rates<State: Coordinates<Scalar = f64>>>(
        &mut self,
        equations: &E,
        now: &Point<E::State>,
        rest: f64,
        tolerance: f64,
    ) -> Option<f64> {
        let longest = self.longest;
        (self.steps, self.longest) = (0, 0.0);
        let ahead = larger((self.end - now.time).abs(), rest.abs());
        if ahead < AHEAD * longest {
            return None;
        }
        let coarse = larger(tolerance, COARSEST);
        let [way, finer] = [coarse, FINER * coarse].map(|tolerance| {
            let heun = Heun {
                equations,
                tolerance,
            };
            heun.follow(now, longest.copysign(rest))
        });
        let (way, finer) = (way?, finer?);
        let is_for_jumps = finer.jumps >= JUMPS && finer.step.abs() <= SHORTER * way.step.abs();
        let step = way.step * (tolerance / coarse);
        (is_for_jumps && longest <= LONGEST * step.abs()).then_some(step)
    }
}

/// Equations that are followed by Heun's method of order two, with the error of Euler's.
struct Heun<'e, E> {
    equations: &'e E,
    tolerance: f64,
}

/// What is seen of a motion that is followed.
struct Way {
    /// The mean step \[s\].
    step: f64,
    /// How many of the steps were over jumps.
    jumps: usize,
}

type Array<E> = <<E as Rates>::State as Coordinates>::Array;

impl<E: Rates<State: Coordinates<Scalar = f64>>> Heun<'_, E> {
    /// A little way from here on, by a first step \[s\]; none, if it leads nowhere.
    fn follow(&self, now: &Point<E::State>, first: f64) -> Option<Way> {
        let (mut time, mut here, mut step) = (now.time, now.coordinates, first);
        let mut rates = self.rates(time, &here);
        let (mut taken, mut length, mut jumps) = (0, 0.0, 0);
        for _ in 0..TRIES {
            let later = self.rates(time + step, &plus(&here, step, &rates));
            let error = 0.5 * Self::error(step, [&rates, &later], &here);
            // what is not a number is an error
            if error.is_nan() || error > self.tolerance {
                step *= 0.5;
                continue;
            }
            if taken >= LEADING {
                let still = self.rates(time + step, &here);
                jumps += usize::from(self.is_over_jump(step, [&still, &later], &here));
                length += step;
            }
            let end = plus(&plus(&here, 0.5 * step, &rates), 0.5 * step, &later);
            rates = self.rates(time + step, &end);
            (time, here, taken) = (time + step, end, taken + 1);
            if taken == LEADING + SEEN {
                let step = length / real(SEEN);
                return Some(Way { step, jumps });
            }
            if error <= 0.25 * self.tolerance {
                step *= 2.0;
            }
        }
        None
    }

    /// Whether a step \[s\] goes wrong for rates that differ from state to state.
    fn is_over_jump(&self, step: f64, rates: [&Array<E>; 2], here: &Array<E>) -> bool {
        let whole = relative_size::<E::State>(rates[1], here) * step.abs();
        let error = Self::error(step, rates, here);
        error >= SHARE * self.tolerance && error >= LEAST * whole
    }

    /// What the difference of two rates makes in a step \[s\], beside a state.
    fn error(step: f64, [one, other]: [&Array<E>; 2], beside: &Array<E>) -> f64 {
        let difference = plus(other, -1.0, one);
        if difference.as_ref().iter().any(|part| part.is_nan()) {
            return f64::NAN;
        }
        relative_size::<E::State>(&difference, beside) * step.abs()
    }

    #[inline(never)]
    fn rates(&self, time: f64, coordinates: &Array<E>) -> Array<E> {
        self.equations.rates(time, coordinates)
    }
}

/// `start + factor change`, coordinate by coordinate.
fn plus<A: Copy + AsRef<[f64]> + AsMut<[f64]>>(start: &A, factor: f64, change: &A) -> A {
    let mut sum = *start;
    for (sum, change) in sum.as_mut().iter_mut().zip(change.as_ref()) {
        *sum += factor * change;
    }
    sum
}
