//! Lists of numbers of any length.

use core::ops::{Add, Mul, Sub};

use crate::numbers::scalar::Scalar;

/// A list of numbers, of any length: the coordinates of a system, or their rates.
///
/// ```
/// use newton_euler::state::List;
///
/// let list = List([1.0, 2.0]) * 3.0 - List([1.0, 0.0]);
/// assert_eq!(list.as_ref(), [2.0, 6.0]);
/// assert_eq!(List::<f64, 100>::default().as_ref().len(), 100);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct List<T, const N: usize>(pub [T; N]);

impl<T: Scalar, const N: usize> List<T, N> {
    /// The same number in all places.
    #[cfg_attr(not(unoptimized), inline(always))]
    #[must_use]
    pub fn repeat(number: T) -> Self {
        Self([number; N])
    }
}

impl<T: Scalar, const N: usize> Default for List<T, N> {
    #[cfg_attr(not(unoptimized), inline(always))]
    fn default() -> Self {
        Self([T::default(); N])
    }
}

impl<T, const N: usize> AsRef<[T]> for List<T, N> {
    #[cfg_attr(not(unoptimized), inline(always))]
    fn as_ref(&self) -> &[T] {
        &self.0
    }
}

impl<T, const N: usize> AsMut<[T]> for List<T, N> {
    #[cfg_attr(not(unoptimized), inline(always))]
    fn as_mut(&mut self) -> &mut [T] {
        &mut self.0
    }
}

impl<T: Scalar, const N: usize> Add for List<T, N> {
    type Output = Self;

    #[cfg_attr(not(unoptimized), inline(always))]
    fn add(mut self, other: Self) -> Self {
        for (sum, other) in self.0.iter_mut().zip(other.0) {
            *sum += other;
        }
        self
    }
}

impl<T: Scalar, const N: usize> Sub for List<T, N> {
    type Output = Self;

    #[cfg_attr(not(unoptimized), inline(always))]
    fn sub(mut self, other: Self) -> Self {
        for (difference, other) in self.0.iter_mut().zip(other.0) {
            *difference -= other;
        }
        self
    }
}

impl<T: Scalar, const N: usize> Mul<T> for List<T, N> {
    type Output = Self;

    #[cfg_attr(not(unoptimized), inline(always))]
    fn mul(mut self, factor: T) -> Self {
        for product in &mut self.0 {
            *product *= factor;
        }
        self
    }
}
