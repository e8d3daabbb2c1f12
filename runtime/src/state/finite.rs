//! Checks of coordinates and rates on reading: finite, or refused.

use nalgebra::SVector;
use serde::{Deserialize, Deserializer, de::Error};

use crate::numbers::scalar::Scalar;

pub(super) fn scalar<'de, T: Scalar + Deserialize<'de>, D: Deserializer<'de>>(
    deserializer: D,
) -> Result<T, D::Error> {
    let value = T::deserialize(deserializer)?;
    check(&[value]).map_err(D::Error::custom)?;
    Ok(value)
}

pub(super) fn vector<'de, T, D, const N: usize>(deserializer: D) -> Result<SVector<T, N>, D::Error>
where
    T: Scalar + Deserialize<'de>,
    D: Deserializer<'de>,
    SVector<T, N>: Deserialize<'de>,
{
    let vector = SVector::<T, N>::deserialize(deserializer)?;
    check(vector.as_slice()).map_err(D::Error::custom)?;
    Ok(vector)
}

/// The reason for the refusal.
pub(crate) struct NotFinite(f64);

impl core::fmt::Display for NotFinite {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        write!(f, "a state is finite, and one of its numbers is {}", self.0)
    }
}

pub(crate) fn check<T: Scalar>(components: &[T]) -> Result<(), NotFinite> {
    for component in components {
        for lane in 0..T::LANES {
            let value = component.lane(lane);
            if !value.is_finite() {
                return Err(NotFinite(value));
            }
        }
    }
    Ok(())
}
