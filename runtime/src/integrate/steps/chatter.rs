//! Detection of chattering: a motion oscillates about a place where its equations jump, in steps
//! that are short enough for the tolerance, but still advance.
//!
//! Friction along `velocity.normalize()` has no value at rest, and drives a motion to rest from
//! every side. The error of a step over a jump J of the rates is some fraction of J times its
//! length, so the tolerance permits steps of about tolerance / J. At 1e-9 that is a
//! billion steps per second. None is lost in rounding, and no single step distinguishes such a
//! motion from one that is long, or stiff.
//!
//! The distinction is how the step length depends on the tolerance. For a method of order p it is
//! proportional to the power 1 / (p + 1) if the equations are smooth, independent of the tolerance
//! if they are stiff, and proportional to it if they jump. So after many steps, if many more of the
//! longest of these are ahead, the motion is followed for a short way by a method of order one,
//! with its tolerance and with a finer one. It chatters if steps are short in proportion, because
//! of jumps caused by the change of the state and not of time, and no step since the last check was
//! much longer. A motion whose end is a moderate number of steps away is never checked: it reaches
//! its end.

use super::equations::Rates;
use super::point::Point;
use super::size::{larger, relative_size};
use crate::numbers::count::real;
use crate::state::Coordinates;

/// The ratio of the second tolerance to the first, and the least value of the first: so far above
/// the rounding of states that rounding does not show in the second.
const FINER: f64 = 1.0 / 1024.0;
const COARSEST: f64 = 1.0 / 17_179_869_184.0; // 2⁻³⁴
/// The largest ratio of its steps to the first ones if the equations jump; for smooth equations the
/// ratio is the root of 1/1024.
const SHORTER: f64 = 1.0 / 256.0;
/// The largest permitted ratio of an earlier step to steps that are short because of jumps.
const LONGEST: f64 = 1024.0;
/// The number of steps before lengths settle, and of steps that are examined then.
const LEADING: usize = 64;
const SEEN: usize = 128;
/// The least number of these that are over jumps.
const JUMPS: usize = SEEN / 8;
/// The least error of a step over a jump, as a fraction of the tolerance.
const SHARE: f64 = 1.0 / 8.0;
/// The least jump, as a fraction of the rates; less may be the rounding of loads that cancel.
const LEAST: f64 = 1.0 / 1_048_576.0;
/// The limit of attempted steps.
const TRIES: usize = 8 * (LEADING + SEEN);

/// The number of steps of a pair between checks.
pub(crate) const LOOK: u32 = 1 << 18;
/// The least number of steps ahead of a motion that is checked.
const AHEAD: f64 = 4_194_304.0; // 2²²

/// The steps of a motion since its last check.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Watch {
    steps: u32,
    /// The number of steps between checks.
    period: u32,
    longest: f64,
    /// The end of the motion \[s\], if it is known.
    end: f64,
}

impl Watch {
    /// For a motion by a pair of Runge–Kutta methods.
    pub(crate) const OF_A_PAIR: Self = Self::every(LOOK);

    /// For a motion that is checked after this many steps.
    pub(in crate::integrate) const fn every(period: u32) -> Self {
        Self {
            steps: 0,
            period,
            longest: 0.0,
            end: f64::NAN,
        }
    }

    /// Called with the end of the motion \[s\].
    pub(crate) fn heads_for(&mut self, end: f64) {
        self.end = end;
    }

    /// Called with each step \[s\]; a step that is cut short counts for its length only.
    #[cfg_attr(not(unoptimized), inline(always))]
    pub(crate) fn saw(&mut self, step: f64, is_cut: bool) {
        self.steps = self.steps.saturating_add(u32::from(!is_cut));
        self.longest = larger(self.longest, step.abs());
    }

    /// The number of steps that were not cut short since the last check, and the longest step \[s\].
    #[cfg(feature = "ensemble")]
    pub(crate) fn seen(&self) -> (f64, f64) {
        (f64::from(self.steps), self.longest)
    }

    /// Sets them.
    #[cfg(feature = "ensemble")]
    pub(crate) fn put(&mut self, steps: f64, longest: f64) {
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "whole, positive and at most `LOOK`"
        )]
        let steps = steps as u32;
        (self.steps, self.longest) = (steps, longest);
    }

    /// Whether a check is due.
    #[cfg_attr(not(unoptimized), inline(always))]
    pub(crate) fn is_due(&self) -> bool {
        self.steps >= self.period
    }

    /// Checks the motion, which continues for at least `rest` \[s\]. If it chatters and does not
    /// end, returns the step \[s\] that the jumps of its equations permit.
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

/// Equations integrated by Heun's method of order two, with the error of Euler's.
struct Heun<'e, E> {
    equations: &'e E,
    tolerance: f64,
}

/// The result of following a motion.
struct Way {
    /// The mean step \[s\].
    step: f64,
    /// The number of steps over jumps.
    jumps: usize,
}

type Array<E> = <<E as Rates>::State as Coordinates>::Array;

impl<E: Rates<State: Coordinates<Scalar = f64>>> Heun<'_, E> {
    /// A short way from the current point, with a given first step \[s\]; none if it fails.
    fn follow(&self, now: &Point<E::State>, first: f64) -> Option<Way> {
        let (mut time, mut here, mut step) = (now.time, now.coordinates, first);
        let mut rates = self.rates(time, &here);
        let (mut taken, mut length, mut jumps) = (0, 0.0, 0);
        for _ in 0..TRIES {
            let later = self.rates(time + step, &plus(&here, step, &rates));
            let error = 0.5 * Self::error(step, [&rates, &later], &here);
            // NaN counts as an error
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

    /// Whether a step \[s\] has an error because rates differ from state to state.
    fn is_over_jump(&self, step: f64, rates: [&Array<E>; 2], here: &Array<E>) -> bool {
        let whole = relative_size::<E::State>(rates[1], here) * step.abs();
        let error = Self::error(step, rates, here);
        error >= SHARE * self.tolerance && error >= LEAST * whole
    }

    /// The effect of the difference of two rates over a step \[s\], relative to a state.
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
