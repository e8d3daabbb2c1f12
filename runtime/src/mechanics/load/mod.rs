//! A single load on the body, as the balances (1.3) and (1.4) list them.

mod family;
pub mod generic;

pub use family::Family;

/// A force at a point, or a couple, or both.
pub type Load = generic::Load<f64>;

/// A [`Load`] in the plane.
pub type PlanarLoad = generic::PlanarLoad<f64>;
