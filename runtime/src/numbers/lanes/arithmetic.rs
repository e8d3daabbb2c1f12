//! Numbers in a register, masks of their comparisons, and the four operations.

use core::fmt;
use core::ops::{
    Add, AddAssign, BitAnd, BitOr, Div, DivAssign, Mul, MulAssign, Neg, Not, Sub, SubAssign,
};

use pulp::bytemuck::{cast_slice, cast_slice_mut};

use super::register::Register;

/// As many doubles as a register holds, as one [`Scalar`](crate::Scalar).
///
/// The default can only be created if the processor has the register.
#[derive(Clone, Copy)]
pub struct Lanes<S: Register> {
    pub(super) simd: S,
    pub(super) numbers: S::f64s,
    /// Empty, but aligned for a register.
    _place: [S::Aligned; 0],
}

impl<S: Register> Lanes<S> {
    /// The number of lanes.
    pub const COUNT: usize = S::F64_LANES;

    /// The numbers of a register.
    #[cfg_attr(not(unoptimized), inline(always))]
    pub fn new(simd: S, numbers: S::f64s) -> Self {
        Self {
            simd,
            numbers,
            _place: [],
        }
    }

    /// The same number in all lanes.
    #[cfg_attr(not(unoptimized), inline(always))]
    pub fn splat(simd: S, number: f64) -> Self {
        Self::new(simd, simd.splat_f64s(number))
    }

    /// The register.
    #[cfg_attr(not(unoptimized), inline(always))]
    #[must_use]
    pub fn numbers(self) -> S::f64s {
        self.numbers
    }

    /// The numbers as a slice.
    #[cfg_attr(not(unoptimized), inline(always))]
    pub(super) fn as_slice(&self) -> &[f64] {
        cast_slice(core::slice::from_ref(&self.numbers))
    }

    /// The same, to be changed.
    #[cfg_attr(not(unoptimized), inline(always))]
    pub(super) fn as_mut_slice(&mut self) -> &mut [f64] {
        cast_slice_mut(core::slice::from_mut(&mut self.numbers))
    }

    /// Replaces the number in a lane.
    pub(crate) fn put(&mut self, lane: usize, number: f64) {
        self.as_mut_slice()[lane] = number;
    }

    /// A function of each number.
    #[cfg_attr(not(unoptimized), inline(always))]
    pub(crate) fn map(mut self, function: impl Fn(f64) -> f64) -> Self {
        for number in self.as_mut_slice() {
            *number = function(*number);
        }
        self
    }

    /// A function of each pair of numbers.
    #[cfg_attr(not(unoptimized), inline(always))]
    pub(super) fn zip(mut self, other: Self, function: impl Fn(f64, f64) -> f64) -> Self {
        for (number, second) in self.as_mut_slice().iter_mut().zip(other.as_slice()) {
            *number = function(*number, *second);
        }
        self
    }
}

impl<S: Register> fmt::Debug for Lanes<S> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.as_slice().fmt(f)
    }
}

impl<S: Register> PartialEq for Lanes<S> {
    fn eq(&self, other: &Self) -> bool {
        self.as_slice() == other.as_slice()
    }
}

impl<S: Register> Default for Lanes<S> {
    fn default() -> Self {
        let simd = S::detected().expect("the processor has the register");
        Self::splat(simd, 0.0)
    }
}

/// An operator and its assigning form.
macro_rules! operators {
    ($($operator:ident $method:ident $assign:ident $method_assign:ident $function:ident;)*) => {$(
        impl<S: Register> $operator for Lanes<S> {
            type Output = Self;

            #[cfg_attr(not(unoptimized), inline(always))]
            fn $method(self, other: Self) -> Self {
                Self::new(self.simd, self.simd.$function(self.numbers, other.numbers))
            }
        }

        impl<S: Register> $assign for Lanes<S> {
            #[cfg_attr(not(unoptimized), inline(always))]
            fn $method_assign(&mut self, other: Self) {
                self.numbers = self.simd.$function(self.numbers, other.numbers);
            }
        }
    )*};
}

operators! {
    Add add AddAssign add_assign add_f64s;
    Sub sub SubAssign sub_assign sub_f64s;
    Mul mul MulAssign mul_assign mul_f64s;
    Div div DivAssign div_assign div_f64s;
}

impl<S: Register> Neg for Lanes<S> {
    type Output = Self;

    #[cfg_attr(not(unoptimized), inline(always))]
    fn neg(self) -> Self {
        Self::new(self.simd, self.simd.neg_f64s(self.numbers))
    }
}

/// The result of comparisons of [`Lanes`]: true or false in each lane.
#[derive(Clone, Copy)]
pub struct Mask<S: Register> {
    pub(super) simd: S,
    pub(super) lanes: S::m64s,
}

impl<S: Register> BitAnd for Mask<S> {
    type Output = Self;

    #[cfg_attr(not(unoptimized), inline(always))]
    fn bitand(self, other: Self) -> Self {
        let lanes = self.simd.and_m64s(self.lanes, other.lanes);
        Self { lanes, ..self }
    }
}

impl<S: Register> BitOr for Mask<S> {
    type Output = Self;

    #[cfg_attr(not(unoptimized), inline(always))]
    fn bitor(self, other: Self) -> Self {
        let lanes = self.simd.or_m64s(self.lanes, other.lanes);
        Self { lanes, ..self }
    }
}

impl<S: Register> Not for Mask<S> {
    type Output = Self;

    #[cfg_attr(not(unoptimized), inline(always))]
    fn not(self) -> Self {
        let lanes = self.simd.not_m64s(self.lanes);
        Self { lanes, ..self }
    }
}
