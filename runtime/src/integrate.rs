//! Integration of the motion.
//!
//! [`Integrate::integrate`] is the one way in: from a body and a state to the state at an end, to samples, steps or events, under inputs that are
//! held or given by a controller, by the method that is best for the body or by another.
//!
//! | method | for | error, and what it keeps |
//! |---|---|---|
//! | [`ClosedForm`] | `outputs: [flow]` | rounding |
//! | [`TaylorSeries`] | `outputs: [taylor]` | below a tolerance; rounding only, if that is small enough |
//! | [`DormandPrince`] | every body | below a tolerance |
//! | [`Fixed`]`<`[`Verner9`]`>`, [`DormandPrince8`], [`Tsitouras5`], [`Classical4`] | every body, ensembles | of order 9, 8, 5, 4 in the step |
//! | [`Fixed`]`<`[`Midpoint`]`>` | games: long runs in few steps | of order 2; energy does not drift |
//! | [`Projected`] | bodies under constraints | that of the method it is given |
//!
//! Beside it are single steps and whole motions as functions: [`cf4`] on the group of rotations, for any [`RigidBody`](crate::body::RigidBody) over
//! any scalar, [`taylor()`] and [`Motion`].

#![allow(
    clippy::float_cmp,
    reason = "a motion is at a time, or it is not: it is put there"
)]

mod adaptive;
mod agreement;
mod closed_form;
mod commutator_free;
mod control;
mod course;
mod equations;
mod error;
mod event;
mod fixed;
mod instants;
mod instructions;
mod integration;
mod method;
mod passage;
mod point;
#[cfg(feature = "progress")]
mod progress;
mod projected;
mod runge_kutta;
mod series;
mod size;
mod step;
mod switches;
mod taylor;

pub use adaptive::{AdaptiveRun, DormandPrince};
pub use closed_form::{ClosedForm, PathRun};
pub use commutator_free::{cf4, cf4_step};
pub use control::{Control, Held, Sampled};
pub use course::{Events, Sample, Samples, Steps};
pub use equations::Equations;
pub use error::IntegrationError;
pub use event::Event;
pub use fixed::{Fixed, FixedRun};
pub use integration::{Integrate, Integration};
pub use method::{Method, Run, Tolerant};
pub use projected::{Projected, ProjectedRun, cf4_projected};
pub use runge_kutta::{
    Classical4, DormandPrince8, Midpoint, RungeKutta, Tsitouras5, Verner9, runge_kutta_step,
};
pub use series::{SeriesRun, TaylorSeries};
pub use step::Step;
pub use switches::{Stretch, Switches, next_switch};
pub use taylor::{Motion, taylor, taylor_step};

#[cfg(feature = "ensemble")]
pub(crate) use {
    course::{Course, Pace},
    instants::Instants,
    integration::TOLERANCE,
    point::add,
    switches::Within,
};

#[cfg(feature = "progress")]
pub(crate) use progress::Bar;

/// A number of steps: exact below 2⁵³.
#[expect(clippy::cast_precision_loss, reason = "exact below 2⁵³")]
pub(crate) fn exact(count: usize) -> f64 {
    count as f64
}

/// The same in single precision: exact below 2²⁴.
#[expect(clippy::cast_precision_loss, reason = "exact below 2²⁴")]
pub(crate) fn single(count: usize) -> f32 {
    count as f32
}
