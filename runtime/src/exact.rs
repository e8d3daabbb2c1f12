//! Closed forms: motions that are functions of time.
//!
//! `outputs: [flow]` writes them for a body that has one, as [`Flow`](crate::body::Flow); here they are for use by hand. Each is a
//! [`Path`], set up once from a state and then evaluated at any times, past or far ahead.
//!
//! | what | from |
//! |---|---|
//! | [`FreeRotation`] | an inertia tensor and a state that turns |
//! | [`LagrangeTop`] | moments of inertia and axis of a symmetric body, a couple, and a state that turns |
//! | [`AxialTorque`] | moments of inertia and axis of a symmetric body, a constant couple along it, and a state that turns |
//! | [`GreatCircle`] | the axis of a rod |
//! | [`Pendulum`] | its rate of small oscillations, where it hangs at rest, and a state |
//! | [`Parabola`] | constant acceleration |
//! | [`Flight`] | a [`Parabola`] of G, and one of the rotations |
//!
//! Elliptic functions are [`Jacobi`]'s, integrals of the third kind are [`r_j`]. They are our own: of the libraries that there are,
//! none has elliptic functions from the complementary modulus, which carries the digits near a separatrix.

mod axial_torque;
mod carlson;
mod flight;
mod free_rotation;
mod great_circle;
mod jacobi;
mod lagrange_top;
mod parabola;
mod pendulum;
mod phase;
mod third_kind;

pub use axial_torque::AxialTorque;
pub use carlson::r_j;
pub use flight::Flight;
pub use free_rotation::FreeRotation;
pub use great_circle::GreatCircle;
pub use jacobi::{Elliptic, Jacobi};
pub use lagrange_top::LagrangeTop;
pub use parabola::Parabola;
pub use pendulum::Pendulum;

/// A motion in closed form: the state at any time.
///
/// ```
/// use newton_euler::exact::{Parabola, Path};
/// use newton_euler::prelude::*;
///
/// let stone = Parabola::<2> { position: [0.0, 8.0].into(), velocity: [1.0, 0.0].into(), acceleration: [0.0, -4.0].into() };
/// let landed: PlanarTranslation = stone.at(2.0);
/// assert_eq!((landed.position.x, landed.position.y), (2.0, 0.0));
/// ```
pub trait Path {
    /// The kind of state.
    type State;

    /// The state at a time \[s\]; the path began at time zero, and negative times are before.
    fn at(&self, time: f64) -> Self::State;

    /// From a time on \[s\], or before it, a time in which the motion does not change its course more than a few times: about that of a radian;
    /// infinite where it never does.
    fn pace(&self, time: f64) -> f64;
}
