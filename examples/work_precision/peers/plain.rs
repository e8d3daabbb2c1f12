//! Lists of numbers as arrays, of which other crates know more.

use differential_equations::traits::State as Numbers;
use newton_euler::state::List;

/// A list that is an array, or can be one.
pub trait Plain: Copy {
    type Array: Numbers<f64>;

    fn plain(self) -> Self::Array;

    fn listed(array: &Self::Array) -> Self;
}

impl<const N: usize> Plain for [f64; N] {
    type Array = Self;

    #[inline(always)]
    fn plain(self) -> Self {
        self
    }

    #[inline(always)]
    fn listed(array: &Self) -> Self {
        *array
    }
}

impl<const N: usize> Plain for List<f64, N> {
    type Array = [f64; N];

    #[inline(always)]
    fn plain(self) -> [f64; N] {
        self.0
    }

    #[inline(always)]
    fn listed(array: &[f64; N]) -> Self {
        Self(*array)
    }
}
