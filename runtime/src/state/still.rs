//! The state of a system that does not move by itself.

use core::marker::PhantomData;

#[cfg(feature = "serde")]
use serde::{Deserialize, Serialize};

use super::list::List;
use super::space::State;
use crate::numbers::scalar::Scalar;

/// State of a system in which nothing moves by itself, because all joints are welds or driven.
/// It has no coordinates, and its acceleration is `()`.
///
/// Such a system has loads, energy and momentum at each time, and no motion to integrate.
///
/// ```
/// use newton_euler::prelude::*;
///
/// let still = Still::default();
/// assert_eq!(still.moved(&(still.rate(&()) * 0.1)), still);
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(Serialize, Deserialize))]
#[cfg_attr(feature = "serde", serde(bound = ""))]
pub struct Still<T: Scalar> {
    #[cfg_attr(feature = "serde", serde(skip))]
    scalar: PhantomData<T>,
}

impl<T: Scalar> State for Still<T> {
    type Scalar = T;
    type Acceleration = ();
    type Rate = List<T, 0>;

    #[cfg_attr(not(unoptimized), inline(always))]
    fn rate(&self, (): &()) -> Self::Rate {
        List([])
    }

    #[cfg_attr(not(unoptimized), inline(always))]
    fn moved(&self, _displacement: &Self::Rate) -> Self {
        *self
    }
}
