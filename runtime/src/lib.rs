//! The equations of motion of a rigid body, derived at compile time from a declarative description.
//!
//! [`rigid_body!`] reads the properties of a body (mass, inertia, points) and the loads on it
//! (forces, moments, fields, reactions). It derives the force balance (1.3) and the moment balance
//! (1.4), drops every term that is zero or unused, and emits straight-line Rust that `cargo expand`
//! shows like a page of a textbook. [`rigid_system!`] does the same for joined bodies. Generated
//! types implement the traits of [`body`] on the states of [`state`]; [`integrate`] moves them.
//!
//! The [`guide`] begins with the physics, the [`reference`](mod@reference) describes the language by
//! topic, and [`recipes`] has short programs for common tasks.
//!
//! ```
//! use newton_euler::prelude::*;
//!
//! rigid_body!(Plank {
//!     doc: "A plank thrown in its plane.",
//!     motion: planar,
//!     params: [length = 2.4[m]],
//!     mass: 6[kg],
//!     inertia: mass * length.powi(2) / 12,
//!     fields: [weight = mass * world(0, -9.80665[m / s ^ 2])],
//!     outputs: [energy],
//! });
//!
//! let plank = Plank::default();
//! let thrown =
//!     Planar { velocity: [4.0, 7.0].into(), angular_velocity: -5.0, ..Planar::default() };
//! let caught = plank.integrate(&thrown).to(1.5)?;
//! assert!((caught.position.y - (7.0 * 1.5 - 9.80665 * 1.5 * 1.5 / 2.0)).abs() < 1e-12);
//!
//! let energy = |state| plank.kinetic_energy(state) + plank.potential_energy(0.0, state, &());
//! assert!((energy(&caught) - energy(&thrown)).abs() < 1e-10);
//! println!("{}", Plank::EQUATIONS);
//! # Ok::<(), newton_euler::integrate::IntegrationError<Planar>>(())
//! ```
//!
//! The types and functions that the macro uses can also be used directly: [`inertia`] tensors that
//! are always possible, the [`gyroscopic`] term, [`wrench`]es, their change of pole and their
//! reduction, uniform [`field`]s on charges, steady [`precession`] of [`top`]s, maps of
//! [`attitude`]. Numbers are plain SI and axes are right-handed; the documentation of every vector
//! states its axes. No `std`, no `unsafe`.
//!
//! # An erratum
//!
//! The moment of the inertial forces is often given as (1.9): minus the inertia matrix times the
//! angular acceleration, plus a matrix times the *squares* of the angular velocities. As printed it
//! is incomplete. A second matrix, times their *products*, is missing, and with it the whole
//! gyroscopic moment in principal axes. Bodies then do not flip, precess wrongly, and do not
//! conserve energy and angular momentum. This library uses the completed equation.
//! [`gyroscopic`] has both matrices, the consequences of omitting the second, and how the gap was
//! found.
//!
//! # The same bits, no panics
//!
//! One version of this library computes the same bits in every build and on every processor, alone
//! and in an ensemble. Only series that are [integrated](integrate::TaylorSeries) have two results,
//! with fused operations and without. Evaluations propagate NaN, and integration reports it as an
//! [error](integrate::IntegrationError). Neither panics: a program that would not link otherwise
//! proves it. `docs/trust.md` of the repository gives the exact guarantees and their tests.
//!
//! # Features
//!
//! - `dispatch` (on by default): series in the widest registers of the processor, detected at run
//!   time.
//! - `serde`: serialization of states, accelerations, parameters, inputs, wrenches, inertia tensors
//!   and ensembles. A parameter that is missing has the default of the description, if there is one.
//!   Reading refuses impossible values (an attitude or an axis that is not unit, an impossible
//!   inertia). Numbers are passed on bit for bit; `serde_json` reads them so with its feature
//!   `float_roundtrip`.
//! - `ensemble`: many bodies at once, in registers of two, four or eight numbers, chosen at run
//!   time (on 64-bit ARM two); it allocates.
//! - `rayon`: ensembles on all processor cores.
//! - `progress`: a progress bar for motions that take longer than a second, in terminals.
//! - `stl`: mass, center of mass and inertia of closed meshes, from STL files
//!   ([`inertia::MassProperties`]); it needs `std`.
//! - `std`: [`columns::Csv`] writes files.
//! - `pictures`: plots of samples as SVG, and pages with moving solids; it turns on `std`.
//! - `glam`, `mint`: conversions between the vectors, attitudes and matrices of states and the types
//!   of these crates, by `From` and `Into` of nalgebra: `glam = "0.33"`, `mint = "0.5"`.
//! - `num-dual`: the numbers of the crate of that name as scalars (`scalar::NumDual`):
//!   `num-dual = "0.15"`; it needs `std`.
//! - `differential-equations`: the equations of a body for the methods of the crate of that name
//!   ([`integrate::Equations`]): `differential-equations = "0.7"`.

#![no_std]
// docs.rs shows which feature an item needs
#![cfg_attr(docsrs, feature(doc_cfg))]
#![forbid(unsafe_code)]
#![warn(missing_docs)]

#[cfg(any(feature = "ensemble", feature = "stl"))]
extern crate alloc;
#[cfg(feature = "std")]
extern crate std;

mod bodies;
#[cfg(feature = "ensemble")]
pub mod ensemble;
pub mod exact;
pub mod guide;
pub mod integrate;
mod mechanics;
mod numbers;
#[cfg(feature = "pictures")]
pub mod pictures;
pub mod prelude;
#[doc(hidden)]
pub mod private;
pub mod reference;
pub mod state;
pub mod taylor;
mod tops;

pub use bodies::{body, columns, constrained, linearization, operations, structure};
pub use mechanics::{attitude, field, gyroscopic, inertia, load, principal, wrench};
#[cfg(feature = "ensemble")]
pub use numbers::lanes;
pub use numbers::scalar;
#[cfg(rust_analyzer)]
#[doc(hidden)]
pub mod schema;
pub use tops::{precession, top};

/// The crate of the vectors, matrices and quaternions of states and outputs, version 0.35.
///
/// It is built without its features `macros` and `std`. For `vector!` and `matrix!`, and for
/// matrices printed in aligned columns, add `nalgebra = "0.35"` to your own dependencies.
pub use nalgebra;
#[doc(no_inline)]
pub use scalar::{Dual, Scalar};

/// The first page of the repository; its code runs as doctests.
#[cfg(doctest)]
#[doc = include_str!("../../README.md")]
mod first_page {}

#[doc = include_str!("recipes.md")]
#[cfg_attr(feature = "ensemble", doc = include_str!("recipes_ensemble.md"))]
pub mod recipes {}

#[doc = include_str!("rigid_system.md")]
#[macro_export]
macro_rules! rigid_system {
    ($($description:tt)*) => {
        $crate::private::rigid_system! { ($crate) $($description)* }
    };
}

#[doc = include_str!("rigid_body.md")]
#[macro_export]
macro_rules! rigid_body {
    ($($description:tt)*) => {
        $crate::private::rigid_body! { ($crate) $($description)* }
    };
}
