//! Many bodies of one kind.
//!
//! Their states, inputs and parameters are stored in columns. They are evaluated and moved several
//! at a time, in the widest registers of the processor. These are detected at run time, so the
//! build needs no flags. A member moves as it would alone, to the bit, whatever its neighbors, the
//! width of registers and the number of threads, also under a controller and between samples.
//!
//! The feature `rayon` uses all processor cores; `progress` shows a bar for long runs, in terminals.

use alloc::vec::Vec;
use core::fmt;

use crate::bodies::body::InvalidBody;
use crate::bodies::columns::Generic;
use crate::numbers::lanes::Width;
use crate::numbers::messages::debug_as_display;

mod blocks;
mod course;
mod evaluate;
mod events;
mod integration;
mod moves;
mod plan;
#[cfg(feature = "progress")]
mod progress;
#[cfg(feature = "serde")]
mod serialized;
mod statistics;

pub use blocks::{Blocks, Values};
pub use course::{AsGiven, EnsembleControl, EnsembleSamples};
pub use events::MemberEvent;
pub use integration::EnsembleIntegration;
pub use moves::{EnsembleError, MemberError, Motions, Moves, OneByOne, RunOf, Together};
pub use plan::Limits;
pub use statistics::{Moments, Statistics, shard};

/// Bodies of one kind that move independently of each other.
///
/// A register holds eight members with AVX-512, four with AVX2, two with SSE4.2 or with the NEON of
/// 64-bit ARM; elsewhere it holds one. [`Ensemble::set_width`] chooses fewer.
///
/// ```
/// use newton_euler::{ensemble::Ensemble, prelude::*};
/// use newton_euler::nalgebra::Vector3;
///
/// rigid_body!(Stone::<T> {
///     motion: spatial,
///     mass: 2[kg],
///     inertia: principal(0.1, 0.2, 0.3)[kg * m ^ 2],
///     fields: [weight = mass * world(0, 0, -9.80665[m / s ^ 2])],
/// });
///
/// let thrown = |i: u32| Spatial {
///     velocity: Vector3::new(f64::from(i), 0.0, 10.0),
///     angular_velocity: Vector3::new(0.01, 1.0, 0.1 * f64::from(i)),
///     ..Spatial::default()
/// };
/// let mut stones = Ensemble::new(&Stone::default(), (0..1000).map(thrown));
/// stones.cf4(0.0..1.0, 100);
/// assert!((stones.state(500).position.x - 500.0).abs() < 1e-10);
///
/// // as it would move alone
/// let alone = newton_euler::integrate::cf4(&Stone::default(), &thrown(500), &(), 0.0..1.0, 100);
/// assert_eq!(stones.state(500), alone);
/// ```
#[derive(Clone, Debug)]
pub struct Ensemble<B: Generic> {
    states: Blocks<B::State>,
    members: Members<B>,
    width: Width,
}

/// The members without their states.
#[derive(Clone, Debug)]
struct Members<B: Generic> {
    /// One body per member, or one for all.
    bodies: Blocks<B>,
    is_uniform: bool,
    inputs: Blocks<B::Input>,
}

/// A member that cannot be built.
#[derive(Clone, Copy, PartialEq)]
pub struct InvalidMember {
    /// The index of the member, from zero.
    pub index: usize,
    /// The reason.
    pub error: InvalidBody,
}

impl fmt::Display for InvalidMember {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "member {}: {}", self.index, self.error)
    }
}

debug_as_display!(InvalidMember);

impl core::error::Error for InvalidMember {
    fn source(&self) -> Option<&(dyn core::error::Error + 'static)> {
        Some(&self.error)
    }
}

impl<B: Generic> Ensemble<B> {
    /// The same body in several states; inputs are zero.
    #[must_use]
    pub fn new(body: &B, states: impl IntoIterator<Item = B::State>) -> Self {
        let states: Blocks<B::State> = states.into_iter().collect();
        let members = Members {
            bodies: Blocks::repeat(body, 1),
            is_uniform: true,
            inputs: Blocks::repeat(&B::Input::default(), states.len()),
        };
        Self::made(states, members)
    }

    /// Bodies with individual parameters, each in a state; inputs are zero.
    ///
    /// # Errors
    /// [`InvalidMember`] with the first member that cannot be built.
    pub fn with_params(
        members: impl IntoIterator<Item = (B::Params, B::State)>,
    ) -> Result<Self, InvalidMember> {
        let (mut bodies, mut states) = (Vec::new(), Vec::new());
        for (index, (params, state)) in members.into_iter().enumerate() {
            let body = B::build(params).map_err(|error| InvalidMember { index, error })?;
            bodies.push(body);
            states.push(state);
        }
        let members = Members {
            bodies: bodies.into_iter().collect(),
            is_uniform: false,
            inputs: Blocks::repeat(&B::Input::default(), states.len()),
        };
        Ok(Self::made(states.into_iter().collect(), members))
    }

    fn made(states: Blocks<B::State>, members: Members<B>) -> Self {
        Self {
            states,
            members,
            width: Width::widest(),
        }
    }

    /// The number of members.
    #[must_use]
    pub fn len(&self) -> usize {
        self.states.len()
    }

    /// Whether there are none.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.states.is_empty()
    }

    /// The states of all members.
    #[must_use]
    pub fn states(&self) -> &Blocks<B::State> {
        &self.states
    }

    /// The same, mutable.
    #[must_use]
    pub fn states_mut(&mut self) -> &mut Blocks<B::State> {
        &mut self.states
    }

    /// The state of a member.
    ///
    /// # Panics
    /// If there is no such member.
    #[must_use]
    pub fn state(&self, index: usize) -> B::State {
        self.states.get(index)
    }

    /// The inputs of all members.
    #[must_use]
    pub fn inputs(&self) -> &Blocks<B::Input> {
        &self.members.inputs
    }

    /// The same, mutable.
    #[must_use]
    pub fn inputs_mut(&mut self) -> &mut Blocks<B::Input> {
        &mut self.members.inputs
    }

    /// A member without its state.
    ///
    /// # Panics
    /// If there is no such member.
    #[must_use]
    pub fn body(&self, index: usize) -> B {
        assert!(index < self.len(), "there is no member {index}");
        self.members.body(index)
    }

    /// The width of the registers for computing members.
    #[must_use]
    pub fn width(&self) -> Width {
        self.width
    }

    /// Sets the width of registers, or the next narrower one that the processor has. The results do
    /// not depend on it.
    pub fn set_width(&mut self, width: Width) {
        let narrower = Width::ALL.into_iter().rev();
        let mut there = narrower.filter(|other| *other <= width && other.is_there());
        self.width = there.next().unwrap_or(Width::One);
    }
}

impl<B: Generic> Members<B> {
    fn body(&self, index: usize) -> B {
        self.bodies.get(if self.is_uniform { 0 } else { index })
    }
}
