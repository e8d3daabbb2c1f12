//! Integration of the motion.
//!
//! [`Integrate::integrate`] is the entry point: from a body and a state it gives the end state,
//! samples, steps or events, under inputs that are held or given by a controller, with the best
//! method for the body or with another.
//!
//! | method | for | error, and conserved quantities |
//! |---|---|---|
//! | [`ClosedForm`] | `outputs: [flow]` | rounding |
//! | [`TaylorSeries`] | `outputs: [taylor]` | below a tolerance; rounding only, at small tolerances |
//! | [`RungeKuttaPair`]: [`DormandPrince`] or [`Verner`] | every body | below a tolerance |
//! | [`SeriesBelow`]`<N>`: series or a pair | `outputs: [taylor]` | below a tolerance |
//! | [`Fixed`]`<`[`Verner9`]`>`, [`DormandPrince8`], [`Tsitouras5`], [`Classical4`] | every body, ensembles | of order 9, 8, 5, 4 in the step |
//! | [`Fixed`]`<`[`Midpoint`]`>` | games: long runs with few steps | of order 2; energy does not drift |
//! | [`Projected`] | bodies under constraints | that of the wrapped method |
//!
//! There are also functions for single steps and whole motions: [`cf4`] on the rotation group,
//! for any [`RigidBody`](crate::body::RigidBody) over any scalar, [`taylor()`] and [`Motion`].

#![allow(
    clippy::float_cmp,
    reason = "a motion is at a time, or it is not: it is put there"
)]

mod course;
mod methods;
mod steps;

pub use crate::bodies::switches::{Stretch, Switches};
pub use course::control::{Control, Held, Sampled};
pub use course::integration::{Integrate, Integration};
pub use course::observed::{Events, Sample, Samples, Steps};
pub use methods::adaptive::{Adaptive, AdaptiveRun, DormandPrince, Verner};
pub use methods::by_tolerance::{PairRun, RungeKuttaPair, SeriesBelow};
pub use methods::closed_form::{ClosedForm, PathRun};
pub use methods::commutator_free::{cf4, cf4_step};
pub use methods::either::EitherRun;
pub use methods::fixed::{Fixed, FixedRun};

pub use methods::projected::{Projected, ProjectedRun, cf4_projected};
pub use methods::runge_kutta::{
    Classical4, DormandPrince8, Embedded, Midpoint, RungeKutta, Tsitouras5, Verner9,
    runge_kutta_step,
};
pub use methods::series::functions::{taylor, taylor_step};
pub use methods::series::motion::Motion;
pub use methods::series::{SeriesRun, TaylorSeries};
pub use steps::equations::Equations;
pub use steps::error::IntegrationError;
pub use steps::event::Event;
pub use steps::method::{Method, Run, Tolerant};
pub use steps::setting::{InvalidSetting, Setting};
pub use steps::step::Step;
pub use steps::stretch::next_switch;

#[cfg(feature = "ensemble")]
pub(crate) use {
    course::control::Closed,
    course::instants::Instants,
    course::integration::TOLERANCE,
    course::pace::Pace,
    course::underway::{Situation, Underway},
    methods::adaptive::{attempt, first},
    methods::runge_kutta::track::Track,
    steps::chatter::LOOK,
    steps::equations::Rates,
    steps::lengths::{Lengths, shrunk},
    steps::point::{add, compensated},
    steps::setting::{check, check_state},
    steps::size::finest,
    steps::stretch::Within,
};

#[cfg(feature = "progress")]
pub(crate) use course::progress::Bar;
