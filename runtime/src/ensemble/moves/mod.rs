//! Methods that move all members: one by one, or in lanes.

use alloc::vec::Vec;
use core::ops::Range;

use super::Ensemble;
use super::plan::Limits;
use crate::bodies::columns::Generic;
use crate::integrate::{Method, Tolerant};

mod adaptive;
mod fixed;
mod lane;
mod members;
mod motions;
mod one_by_one;
mod register;
mod register_steps;
mod samples;
mod seats;

pub(super) use members::indices;
pub use members::{EnsembleError, MemberError};
pub use motions::Motions;
pub use one_by_one::OneByOne;

/// A method for all members of an ensemble.
pub trait Moves<B: Generic> {
    /// The method that moves a single body identically, to the bit.
    type Alone: Method<B>;

    /// That method.
    fn alone(&self) -> Self::Alone;

    /// Moves all members between two times \[s\], with the inputs held and settings that are
    /// possible, and calls an observer with the completed fraction. Motions that are kept go on; others
    /// begin. Members that do not reach the end keep their states, and are returned, in order.
    fn moved(
        &self,
        ensemble: &mut Ensemble<B>,
        motions: &mut Motions<RunOf<Self, B>>,
        times: Range<f64>,
        limits: &Limits,
        observer: impl Fn(f64) + Sync,
    ) -> Vec<MemberError<B::State>>;
}

/// The run of a member that moves alone.
pub type RunOf<M, B> = <<M as Moves<B>>::Alone as Method<B>>::Run;

/// A method for one body, and the default method of an ensemble of bodies for which it is the best.
pub trait Together<B: Generic> {
    /// In lanes, or one by one.
    type Moves: Moves<B> + Tolerant;
}
