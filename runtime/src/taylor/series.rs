//! The coefficients of a motion.

use super::{Arithmetic, Axes, Products};
use crate::numbers::count::real;
use crate::state::Coordinates;

/// A motion as a polynomial in the time since its start, coordinate by coordinate.
#[derive(Clone, Debug)]
pub struct Series<S: Coordinates<Scalar = f64>, const N: usize> {
    coefficients: [S::Array; N],
}

impl<S: Coordinates<Scalar = f64>, const N: usize> Default for Series<S, N> {
    fn default() -> Self {
        Self {
            coefficients: [S::Array::default(); N],
        }
    }
}

impl<S: Coordinates<Scalar = f64>, const N: usize> Series<S, N> {
    /// The coefficients, lowest first: row n has those of timeⁿ, in the order of [`Coordinates`].
    #[inline]
    #[must_use]
    pub fn coefficients(&self) -> &[S::Array; N] {
        &self.coefficients
    }

    /// The state at this time after the start \[s\].
    #[inline]
    #[must_use]
    pub fn after(&self, time: f64) -> S {
        S::from_coordinates(&after::<S>(&self.coefficients, time))
    }

    /// Whether all coefficients are finite.
    pub(crate) fn is_finite(&self) -> bool {
        let mut rows = self.coefficients.iter();
        rows.all(|row| row.as_ref().iter().all(|number| number.is_finite()))
    }

    /// Transforms series from other axes into body axes.
    pub(crate) fn turn(&mut self, axes: &Axes) {
        axes.turn::<S, N>(&mut self.coefficients);
    }

    /// Begins at a state.
    #[cfg_attr(not(unoptimized), inline(always))]
    pub fn start(&mut self, state: &S) {
        self.coefficients[0] = state.coordinates();
    }

    /// Coefficient n of the coordinates, and the padding of their last register, from coefficient n
    /// - 1 of the rates.
    #[cfg_attr(not(unoptimized), inline(always))]
    pub fn extend<A: Arithmetic, const WIDTH: usize, const COUNT: usize>(
        &mut self,
        products: &Products<A, WIDTH, N>,
        n: usize,
        rates: [f64; COUNT],
    ) -> [f64; COUNT] {
        let next = products.times(rates, 1.0 / real(n));
        let row = self.coefficients[n].as_mut();
        row.copy_from_slice(&next[..row.len()]);
        next
    }
}

/// The coordinates given by a polynomial, at this time after its start.
#[cfg_attr(not(unoptimized), inline(always))]
pub(crate) fn after<S: Coordinates<Scalar = f64>>(
    coefficients: &[S::Array],
    time: f64,
) -> S::Array {
    let mut coordinates = evaluate::<S>(coefficients, time);
    let mut change = S::Array::default();
    S::keep(&coordinates, &mut change);
    for (coordinate, change) in coordinates.as_mut().iter_mut().zip(change.as_ref()) {
        *coordinate += change;
    }
    coordinates
}

/// A polynomial, by Horner's rule for even and odd powers separately: neither waits for the other.
#[cfg_attr(not(unoptimized), inline(always))]
fn evaluate<S: Coordinates<Scalar = f64>>(coefficients: &[S::Array], time: f64) -> S::Array {
    let square = time * time;
    let (mut even, mut odd) = (S::Array::default(), S::Array::default());
    let climb = |sum: &mut S::Array, row: S::Array| {
        for (sum, coefficient) in sum.as_mut().iter_mut().zip(row.as_ref()) {
            *sum = *sum * square + coefficient;
        }
    };
    for rows in coefficients.chunks(2).rev() {
        climb(&mut even, rows[0]);
        climb(&mut odd, rows.get(1).copied().unwrap_or_default());
    }
    for (even, odd) in even.as_mut().iter_mut().zip(odd.as_ref()) {
        *even += odd * time;
    }
    even
}

/// The rates of coordinates given by a polynomial, starting at a place in their list; zero before
/// it. As in [`evaluate`], neither half waits for the other.
#[cfg_attr(not(unoptimized), inline(always))]
pub(crate) fn slope<S: Coordinates<Scalar = f64>, const N: usize>(
    coefficients: &[S::Array; N],
    time: f64,
    place: usize,
) -> S::Array {
    let square = time * time;
    let (mut even, mut odd) = (S::Array::default(), S::Array::default());
    let climb = |sum: &mut S::Array, row: &S::Array, order: f64| {
        let sums = sum.as_mut().get_mut(place..).unwrap_or_default();
        let coefficients = row.as_ref().get(place..).unwrap_or_default();
        for (sum, coefficient) in sums.iter_mut().zip(coefficients) {
            *sum = *sum * square + order * coefficient;
        }
    };
    for (pair, rows) in coefficients[1..].chunks(2).enumerate().rev() {
        let order = real(2 * pair + 1);
        climb(&mut even, &rows[0], order);
        if let Some(row) = rows.get(1) {
            climb(&mut odd, row, order + 1.0);
        }
    }
    for (even, odd) in even.as_mut().iter_mut().zip(odd.as_ref()) {
        *even += odd * time;
    }
    even
}

/// The increment of a polynomial over its start.
#[cfg_attr(not(unoptimized), inline(always))]
pub(crate) fn increment<S: Coordinates<Scalar = f64>>(
    coefficients: &[S::Array],
    time: f64,
) -> S::Array {
    let mut value = evaluate::<S>(&coefficients[1..], time);
    for part in value.as_mut() {
        *part *= time;
    }
    value
}
