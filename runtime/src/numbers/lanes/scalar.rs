//! Lanes as a scalar.

use super::arithmetic::{Lanes, Mask};
use super::register::Register;
use super::sines;
use crate::numbers::scalar::Scalar;

/// A comparison.
macro_rules! compare {
    ($($name:ident $function:ident;)*) => {$(
        #[cfg_attr(not(unoptimized), inline(always))]
        fn $name(self, other: Self) -> Mask<S> {
            Mask { simd: self.simd, lanes: self.simd.$function(self.numbers, other.numbers) }
        }
    )*};
}

/// Functions that are computed lane by lane.
macro_rules! by_lane {
    ($($name:ident)*) => {$(
        #[cfg_attr(not(unoptimized), inline(always))]
        fn $name(self) -> Self {
            self.map(<f64 as Scalar>::$name)
        }
    )*};
}

/// The same for two numbers.
macro_rules! by_pair {
    ($($name:ident)*) => {$(
        #[cfg_attr(not(unoptimized), inline(always))]
        fn $name(self, other: Self) -> Self {
            self.zip(other, <f64 as Scalar>::$name)
        }
    )*};
}

impl<S: Register> Scalar for Lanes<S> {
    type Truth = Mask<S>;
    const EPSILON: f64 = f64::EPSILON;
    const LANES: usize = S::F64_LANES;

    #[cfg_attr(not(unoptimized), inline(always))]
    fn constant(self, double: f64, _: f32) -> Self {
        Self::splat(self.simd, double)
    }

    #[cfg_attr(not(unoptimized), inline(always))]
    fn lane(self, index: usize) -> f64 {
        self.as_slice()[index]
    }

    compare! {
        less less_than_f64s;
        less_or_equal less_than_or_equal_f64s;
        equal equal_f64s;
    }

    #[cfg_attr(not(unoptimized), inline(always))]
    fn select(truth: Mask<S>, first: Self, second: Self) -> Self {
        let simd = truth.simd;
        Self::new(
            simd,
            simd.select_f64s(truth.lanes, first.numbers, second.numbers),
        )
    }

    #[cfg_attr(not(unoptimized), inline(always))]
    fn agreed(truth: Mask<S>) -> Option<bool> {
        let first = |mask: Mask<S>| mask.simd.first_true_m64s(mask.lanes);
        if first(!truth) >= Self::COUNT {
            Some(true)
        } else if first(truth) >= Self::COUNT {
            Some(false)
        } else {
            None
        }
    }

    #[cfg_attr(not(unoptimized), inline(always))]
    fn sin_cos(self) -> (Self, Self) {
        sines::sin_cos(self)
    }

    #[cfg_attr(not(unoptimized), inline(always))]
    fn sin(self) -> Self {
        self.sin_cos().0
    }

    #[cfg_attr(not(unoptimized), inline(always))]
    fn cos(self) -> Self {
        self.sin_cos().1
    }

    #[cfg_attr(not(unoptimized), inline(always))]
    fn sqrt(self) -> Self {
        Self::new(self.simd, self.simd.sqrt_f64s(self.numbers))
    }

    #[cfg_attr(not(unoptimized), inline(always))]
    fn abs(self) -> Self {
        Self::new(self.simd, self.simd.abs_f64s(self.numbers))
    }

    by_lane! { tan asin acos atan sinh cosh tanh exp ln cbrt signum floor ceil }
    by_pair! { atan2 powf hypot min max }
}
