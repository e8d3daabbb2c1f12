//! A user-defined state: a scalar.

use nalgebra::Vector1;

use super::coordinates::Coordinates;
use super::space::State;
use crate::numbers::scalar::Scalar;

/// A scalar is a state with its own rate, such as the speed of a motor. This rate takes the place
/// of the acceleration of a motion.
///
/// ```
/// use newton_euler::prelude::*;
///
/// let fuel = 2.0;
/// assert_eq!(fuel.moved(&(fuel.rate(&-0.5) * 3.0)), 0.5);
/// ```
impl<T: Scalar> State for T {
    type Scalar = T;
    type Acceleration = T;
    type Rate = Vector1<T>;

    #[cfg_attr(not(unoptimized), inline(always))]
    fn rate(&self, rate: &T) -> Vector1<T> {
        Vector1::new(*rate)
    }

    #[cfg_attr(not(unoptimized), inline(always))]
    fn moved(&self, displacement: &Vector1<T>) -> T {
        *self + displacement.x
    }
}

/// It is a rate, but not of a coordinate.
impl<T: Scalar> Coordinates for T {
    type Array = [T; 1];
    const GROUPS: &'static [usize] = &[0, 1];

    #[cfg_attr(not(unoptimized), inline(always))]
    fn coordinates(&self) -> [T; 1] {
        [*self]
    }

    #[cfg_attr(not(unoptimized), inline(always))]
    fn from_coordinates(&[scalar]: &[T; 1]) -> T {
        scalar
    }

    #[cfg_attr(not(unoptimized), inline(always))]
    fn rates(&self, rate: &T) -> [T; 1] {
        [*rate]
    }
}
