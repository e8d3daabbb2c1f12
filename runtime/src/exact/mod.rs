//! Closed forms: motions as functions of time.
//!
//! `outputs: [flow]` provides them as [`Flow`](crate::body::Flow) for a body that has one; here
//! they can be used directly. Each is a [`Path`], set up once from a state and then evaluated at
//! any times, past or future.
//!
//! | path | constructed from |
//! |---|---|
//! | [`FreeRotation`] | an inertia tensor and a rotation state |
//! | [`LagrangeTop`] | moments of inertia and axis of a symmetric body, a couple, and a rotation state |
//! | [`AxialTorque`] | moments of inertia and axis of a symmetric body, a constant couple along it, and a rotation state |
//! | [`GreatCircle`] | the axis of a rod |
//! | [`Pendulum`] | its rate of small oscillations, where it hangs at rest, and a state |
//! | [`Gyrostat`] | the axis of a symmetric body with rotors, and the rates that its rotors leave it |
//! | [`Parabola`] | constant acceleration |
//! | [`Accelerated`] | the state of a joint, and its constant acceleration |
//! | [`CounterSwing`] | a [`Pendulum`], and the state of a wheel on it |
//! | [`Flight`] | a [`Parabola`] of G, and one of the rotations |
//! | [`FlyingPoint`] | the same, seen from another point of the body |
//!
//! [`Jacobi`] has elliptic functions, [`r_j`] integrals of the third kind. This library implements
//! them itself, because no existing library takes the complementary modulus, which carries the
//! digits near a separatrix.

mod accelerated;
mod axial_torque;
mod counter_swing;
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
pub use counter_swing::CounterSwing;
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
