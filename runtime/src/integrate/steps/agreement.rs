//! The check of a polynomial against the motion: its derivative is compared with the rates of the
//! equations.

use super::equations::{Equations, Rates};
use super::point::Point;
use super::size::{larger, largest_of};
use crate::bodies::body::RigidBody;
use crate::numbers::count::real;
use crate::state::{Coordinates, group};
use crate::taylor::{Axes, after, increment, slope};

/// The permitted error of a step, in tolerances, if rates were off throughout by as much as at its
/// end. In a series of order n they are off by a power of the time, so this estimate is about n
/// times the actual error.
const END: f64 = 8.0;
/// The same for the average over points throughout the step.
const MEAN: f64 = 2.0;
/// The rounding of a rate, relative to the rate.
const ROUNDING: f64 = 32.0 * f64::EPSILON;
/// The number of checked points in a step that is longer than those before it.
const PLACES: usize = 16;

/// The equations of a body in axes that may differ from its own.
pub(in crate::integrate) struct Seen<'e, B: RigidBody> {
    pub(in crate::integrate) equations: Equations<'e, B>,
    pub(in crate::integrate) axes: &'e Axes,
}

impl<B: RigidBody<Scalar = f64, State: Coordinates<Scalar = f64>>> Rates for Seen<'_, B> {
    type State = B::State;

    #[cfg_attr(not(unoptimized), inline(always))]
    fn rates(
        &self,
        time: f64,
        coordinates: &<B::State as Coordinates>::Array,
    ) -> <B::State as Coordinates>::Array {
        let mut rates = self.equations.rates(time, coordinates);
        self.axes.turn_rates::<B::State>(coordinates, &mut rates);
        rates
    }
}

/// A motion as a polynomial in the time since its start, to be checked against its equations.
///
/// Only velocities are compared: positions and attitudes follow from them in the same way in every
/// motion.
pub(in crate::integrate) struct Agreement<'e, E: Rates, const N: usize> {
    pub(in crate::integrate) equations: &'e E,
    pub(in crate::integrate) start: f64,
    pub(in crate::integrate) coefficients: &'e [<E::State as Coordinates>::Array; N],
    pub(in crate::integrate) tolerance: f64,
}

impl<E: Rates<State: Coordinates<Scalar = f64>>, const N: usize> Agreement<'_, E, N> {
    /// The increment of the coordinates over a step \[s\], if the equations agree at its end.
    #[cfg_attr(not(unoptimized), inline(always))]
    pub(in crate::integrate) fn holds(
        &self,
        now: &Point<E::State>,
        step: f64,
    ) -> Option<<E::State as Coordinates>::Array> {
        let mut change = increment::<E::State>(self.coefficients, step);
        let end = now.moved(&mut change)?;
        let rates = self.equations.rates(self.start + step, &end);
        self.holds_to(&rates, step, &end).then_some(change)
    }

    /// Whether these rates at the end of a step \[s\] agree.
    #[cfg_attr(not(unoptimized), inline(always))]
    pub(in crate::integrate) fn holds_to(
        &self,
        rates: &<E::State as Coordinates>::Array,
        step: f64,
        end: &<E::State as Coordinates>::Array,
    ) -> bool {
        self.difference(rates, step, end, step, None) <= END * self.tolerance
    }

    /// The same, if they agree throughout, on the average of many points and up to
    /// rounding; otherwise the time \[s\] of disagreement.
    #[cfg_attr(not(unoptimized), inline(always))]
    pub(in crate::integrate) fn holds_throughout(
        &self,
        now: &Point<E::State>,
        step: f64,
    ) -> Result<<E::State as Coordinates>::Array, f64> {
        let mut change = increment::<E::State>(self.coefficients, step);
        let Some(end) = now.moved(&mut change) else {
            return Err(step);
        };
        let (noise, mut sum) = (self.noise(step, &end), 0.0);
        for place in 1..=PLACES {
            let time = step * (real(place) / real(PLACES));
            let coordinates = if place < PLACES {
                after::<E::State>(self.coefficients, time)
            } else {
                end
            };
            let rates = self.equations.rates(self.start + time, &coordinates);
            sum += self.difference(&rates, time, &coordinates, step, Some(&noise));
            let holds = sum <= MEAN * real(PLACES) * self.tolerance;
            if !holds {
                return Err(time);
            }
        }
        Ok(change)
    }

    /// The error of a step of this length \[s\], relative to the state, if rates were off
    /// throughout by as much as these are after a time \[s\], apart from rounding.
    #[cfg_attr(not(unoptimized), inline(always))]
    fn difference(
        &self,
        rates: &<E::State as Coordinates>::Array,
        time: f64,
        coordinates: &<E::State as Coordinates>::Array,
        length: f64,
        noise: Option<&<E::State as Coordinates>::Array>,
    ) -> f64 {
        let (positions, velocities) = E::State::GROUPS.split_at(E::State::GROUPS.len() / 2);
        let first = positions.iter().sum();
        let slopes = slope::<E::State, N>(self.coefficients, time, first);
        let (mut rates, mut slopes) = (from(rates, first), from(&slopes, first));
        let (mut wholes, mut noise) = (
            from(coordinates, first),
            noise.map(|noise| from(noise, first)),
        );
        let mut largest = 0.0;
        for count in velocities {
            let [rates, slopes] = [&mut rates, &mut slopes].map(|list| group(list, *count));
            let mut difference = 0.0;
            for (rate, slope) in rates.iter().zip(slopes) {
                difference += (rate - slope).abs();
            }
            let mut rounding = ROUNDING * largest_of(slopes);
            if let Some(noise) = &mut noise {
                rounding += largest_of(group(noise, *count));
            }
            let whole = larger(largest_of(group(&mut wholes, *count)), 1.0);
            let share = length.abs() * (difference - rounding) / whole;
            // NaN stays NaN
            if share > largest || share.is_nan() {
                largest = share;
            }
        }
        largest
    }

    /// The rounding of the rates, as far as it is visible: at the start, where the polynomial is
    /// exact, and at an end that is off by rounding.
    #[cfg_attr(not(unoptimized), inline(always))]
    fn noise(
        &self,
        step: f64,
        end: &<E::State as Coordinates>::Array,
    ) -> <E::State as Coordinates>::Array {
        let [start, slopes, ..] = self.coefficients.as_slice() else {
            return <E::State as Coordinates>::Array::default();
        };
        let mut noise = self.equations.rates(self.start, start);
        for (noise, slope) in noise.as_mut().iter_mut().zip(slopes.as_ref()) {
            *noise = (*noise - slope).abs();
        }
        let time = self.start + step;
        let rates = self.equations.rates(time, end);
        for off in [2.0 * f64::EPSILON, -3.0 * f64::EPSILON] {
            let (mut near, mut off) = (*end, off);
            for coordinate in near.as_mut() {
                *coordinate += *coordinate * off;
                off = -off;
            }
            let others = self.equations.rates(time + time * off, &near);
            let pairs = rates.as_ref().iter().zip(others.as_ref());
            for (noise, (rate, other)) in noise.as_mut().iter_mut().zip(pairs) {
                *noise += (rate - other).abs();
            }
        }
        for noise in noise.as_mut() {
            *noise *= 8.0;
        }
        noise
    }
}

/// The rest of a list from an index.
#[cfg_attr(not(unoptimized), inline(always))]
fn from<A: AsRef<[f64]>>(list: &A, place: usize) -> &[f64] {
    list.as_ref().get(place..).unwrap_or_default()
}
