//! Closed forms: motions that are functions of time.
//!
//! `outputs: [flow]` writes them for a body that has one, as [`Flow`](crate::body::Flow); here they
//! are for use by hand. Each is a [`Path`], set up once from a state and then evaluated at any
//! times, past or far ahead.
//!
//! | what | from |
//! |---|---|
//! | [`FreeRotation`] | an inertia tensor and a state that turns |
//! | [`LagrangeTop`] | moments of inertia and axis of a symmetric body, a couple, and a state that turns |
//! | [`AxialTorque`] | moments of inertia and axis of a symmetric body, a constant couple along it, and a state that turns |
//! | [`GreatCircle`] | the axis of a rod |
//! | [`Pendulum`] | its rate of small oscillations, where it hangs at rest, and a state |
//! | [`Gyrostat`] | the axis of a symmetric body with rotors, and the rates that its rotors leave it |
//! | [`Parabola`] | constant acceleration |
//! | [`Accelerated`] | the state of a joint, and its constant acceleration |
//! | [`Flight`] | a [`Parabola`] of G, and one of the rotations |
//! | [`FlyingPoint`] | the same, seen from another point of the body |
//!
//! Elliptic functions are [`Jacobi`]'s, integrals of the third kind are [`r_j`]. They are our own:
//! of the libraries that there are, none has elliptic functions from the complementary modulus,
//! which carries the digits near a separatrix.

mod accelerated;
mod axial_torque;
mod elliptic;
mod flight;
mod flying_point;
mod free_rotation;
mod great_circle;
mod gyrostat;
mod lagrange_top;
mod parabola;
mod pendulum;

pub use crate::bodies::path::Path;
pub use accelerated::Accelerated;
pub use axial_torque::AxialTorque;
pub use elliptic::carlson::r_j;
pub use elliptic::jacobi::{Elliptic, Jacobi};
pub use flight::Flight;
pub use flying_point::FlyingPoint;
pub use free_rotation::FreeRotation;
pub use great_circle::GreatCircle;
pub use gyrostat::Gyrostat;
pub use lagrange_top::LagrangeTop;
pub use parabola::Parabola;
pub use pendulum::Pendulum;
