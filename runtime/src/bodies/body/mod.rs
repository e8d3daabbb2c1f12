//! The interface of a rigid body: its acceleration, its balance, its reactions, its energy, its
//! momenta, its motion.
//!
//! [`rigid_body!`](crate::rigid_body) implements these traits; you can also implement them by hand.
//!
//! The balance is D'Alembert's: loads of the four families and the inertial load sum to zero,
//!
//! ```text
//! (1.3)  Σ R_v + Σ F_s + Σ F_ext + Σ F_f + F_iG = 0
//! (1.4)  Σ (P - O) × (R_v, F_s, F_ext, F_f) + (G - O) × F_iG
//!        + Σ M_v + Σ M_s + Σ M_ext + Σ M_f + M_i = 0
//! ```
//!
//! with `F_iG = -m a_G`, and `M_i` of the completed (1.9): see [`gyroscopic`](crate::gyroscopic).
//! The pole O is any point, moving in any way: (1.4) is an identity between vectors at one instant
//! and has no term with the velocity of O. The source prints `R_s` for `F_s` in the second sum of
//! (1.4). This is a misprint: no such symbol exists.

mod invalid;
mod of_systems;
mod outputs;
mod rigid_body;
mod singular;
mod unrequested;

pub use invalid::{Impossible, InvalidBody};
pub use of_systems::{DrivenEnergy, DrivenMomentum, Jacobian, MassMatrix};
pub use outputs::{Balance, Energy, Flow, Inverse, Momentum, Reactions, Regressor};
pub use rigid_body::RigidBody;
pub use singular::Singular;
pub(crate) use unrequested::{Unrequested, unrequested};
