//! Errors that end an integration early.

use core::fmt;
use core::ops::Range;

use crate::bodies::body::{InvalidBody, RigidBody};
use crate::bodies::constrained::Inconsistent;
use crate::state::State;

/// The error of an integration, with the last good state and its time.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum IntegrationError<S> {
    /// The motion is not finite from here on: a force grows without bound or has no value, or start
    /// or end are not finite.
    NotFinite {
        /// \[s\]
        time: f64,
        /// The state at that time.
        state: S,
        /// A load without a value there, or just after, if it is known:
        /// [`RigidBody::lost_load`].
        load: Option<&'static str>,
    },
    /// The step is lost in the rounding of time, or is NaN: a singularity is near, the tolerance is
    /// below the precision of doubles, or a given step or period is not positive. Or steps are so
    /// short that the motion does not end: the equations jump, and drive the motion back from both
    /// sides of the jump, as friction along `velocity.normalize()` does where a point comes to
    /// rest.
    StepTooSmall {
        /// \[s\]
        time: f64,
        /// The state at that time.
        state: S,
        /// The step \[s\].
        step: f64,
    },
    /// The equations of an implicit step were not solved: it is too long for the motion (a third of
    /// a turn or more), or a singularity is near.
    StepTooLong {
        /// \[s\]
        time: f64,
        /// The state at that time.
        state: S,
        /// The step \[s\].
        step: f64,
    },
    /// Mass or inertia change, and just after this state no body can have them: a tank is empty.
    InvalidBody {
        /// \[s\]
        time: f64,
        /// The state at that time.
        state: S,
        /// The impossible property.
        invalid: InvalidBody,
    },
    /// The state violates its constraints: the first state by more than rounding, or a state after
    /// a step that is too long, with no consistent state nearby.
    Inconsistent {
        /// \[s\]
        time: f64,
        /// The last good state; the first, if there was none.
        state: S,
        /// The violated constraint.
        violated: Inconsistent,
    },
    /// The constraints do not determine the motion from here on: one depends on the others,
    /// although not in general. This is a dead point or a change point of a linkage, from which
    /// several motions continue, or none.
    Undetermined {
        /// \[s\]
        time: f64,
        /// The last good state; the first, if there was none.
        state: S,
        /// The constraint, or the joint that closes a loop with the index of its constraint.
        constraint: &'static str,
    },
    /// The function of events is NaN.
    EventNotANumber {
        /// \[s\]
        time: f64,
        /// The state at that time.
        state: S,
    },
}

impl<S> IntegrationError<S> {
    /// The number of instants at this period between these times is not representable; the state is
    /// that at the first.
    pub(crate) fn uncountable(period: f64, times: Range<f64>, state: S) -> Self {
        let Range { start: time, end } = times;
        if time.is_finite() && end.is_finite() {
            let step = period;
            Self::StepTooSmall { time, state, step }
        } else {
            Self::not_finite(time, state)
        }
    }

    pub(crate) fn not_finite(time: f64, state: S) -> Self {
        let load = None;
        Self::NotFinite { time, state, load }
    }

    /// The time of the last good state \[s\].
    #[must_use]
    pub fn time(&self) -> f64 {
        match self {
            Self::NotFinite { time, .. }
            | Self::StepTooSmall { time, .. }
            | Self::StepTooLong { time, .. }
            | Self::InvalidBody { time, .. }
            | Self::Inconsistent { time, .. }
            | Self::Undetermined { time, .. }
            | Self::EventNotANumber { time, .. } => *time,
        }
    }

    /// The last good state.
    #[must_use]
    pub fn state(&self) -> &S {
        match self {
            Self::NotFinite { state, .. }
            | Self::StepTooSmall { state, .. }
            | Self::StepTooLong { state, .. }
            | Self::InvalidBody { state, .. }
            | Self::Inconsistent { state, .. }
            | Self::Undetermined { state, .. }
            | Self::EventNotANumber { state, .. } => state,
        }
    }
}

impl<S> fmt::Display for IntegrationError<S> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::NotFinite { time, load, .. } => {
                write!(f, "the motion is not finite after {time} s")?;
                load.map_or(Ok(()), |load| write!(f, ": `{load}` is not a number"))
            }
            Self::StepTooSmall { time, step, .. } => write!(
                f,
                "at {time} s the step or period is {step:e} s, which is not positive, lost in rounding, or too short to come to an end"
            ),
            Self::StepTooLong { time, step, .. } => write!(
                f,
                "at {time} s a step of {step:e} s is too long: its equations are not solved, take shorter ones"
            ),
            Self::InvalidBody { time, invalid, .. } => write!(f, "after {time} s: {invalid}"),
            Self::Inconsistent { time, violated, .. } => write!(f, "at {time} s: {violated}"),
            Self::Undetermined {
                time, constraint, ..
            } => write!(
                f,
                "after {time} s the motion is not determined: `{constraint}` follows from the other constraints there, as at a dead point or a change point"
            ),
            Self::EventNotANumber { time, .. } => {
                write!(f, "at {time} s the function of the events is not a number")
            }
        }
    }
}

impl<S: State<Scalar = f64>> IntegrationError<S> {
    /// Adds which load of a body has no value, or that the body is impossible, in the last state or
    /// where the motion leads from there.
    #[cold]
    pub(crate) fn named<B: RigidBody<Scalar = f64, State = S>>(
        self,
        body: &B,
        input: &B::Input,
        forwards: bool,
    ) -> Self {
        let (time, state, too_small) = match self {
            Self::NotFinite {
                time,
                state,
                load: None,
            } => (time, state, None),
            Self::StepTooSmall { time, state, step } => (time, state, Some(step)),
            other => return other,
        };
        let rate = state.rate(&body.acceleration(time, &state, input));
        let there = |after: f64| (time + after, state.moved(&(rate * after)));
        let nearest = f64::EPSILON * time.abs().max(1e-6);
        let nearest = if forwards { nearest } else { -nearest };
        let ahead =
            |doublings: i32| (0..doublings).map(|power| nearest * libm::exp2(f64::from(power)));
        let impossible = |after: f64| {
            let (time, there) = there(after);
            let invalid = body.possible(time, &there, input).err();
            invalid.filter(|invalid| !invalid.is_of_no_number())
        };
        let lost = |after: f64| {
            let (time, there) = there(after);
            // an impossible body is not the fault of a load
            let invalid = body.possible(time, &there, input).err();
            if invalid.is_some_and(|invalid| !invalid.is_of_no_number()) {
                return None;
            }
            body.lost_load(time, &there, input)
        };
        let ran_out = impossible(0.0);
        let load = match (too_small, ran_out) {
            (None, None) => {
                let here = body.lost_load(time, &state, input);
                // a NaN rate leads nowhere
                here.or_else(|| {
                    let leads = lost(0.0).is_none();
                    leads.then(|| ahead(DOUBLINGS).find_map(lost)).flatten()
                })
            }
            _ => None,
        };
        if load.is_some() {
            return Self::NotFinite { time, state, load };
        }
        let reach = DOUBLINGS
            + if too_small.is_none() {
                WITHIN_A_STEP
            } else {
                0
            };
        match (
            ran_out.or_else(|| ahead(reach).find_map(impossible)),
            too_small,
        ) {
            (Some(invalid), _) => Self::InvalidBody {
                time,
                state,
                invalid,
            },
            (None, Some(step)) => Self::StepTooSmall { time, state, step },
            (None, None) => Self::NotFinite { time, state, load },
        }
    }
}

/// The number of doublings of the time ahead in the search for a load without a value, starting
/// from the rounding of time.
const DOUBLINGS: i32 = 32;
/// Further doublings, for a fixed step that may end where the body is impossible.
const WITHIN_A_STEP: i32 = 12;

impl<S: fmt::Debug> core::error::Error for IntegrationError<S> {}
