//! What ends an integration before its time.

use core::fmt;

/// The error of an integration, with the last state that is good and its time.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum IntegrationError<S> {
    /// The motion is not finite from here on: a force grows beyond bounds, or is none.
    NotFinite {
        /// \[s\]
        time: f64,
        /// The state then.
        state: S,
    },
    /// The step that the tolerance asks for is lost in the rounding of time: a singularity is near, or the tolerance is below
    /// what doubles can hold.
    StepTooSmall {
        /// \[s\]
        time: f64,
        /// The state then.
        state: S,
        /// The step \[s\].
        step: f64,
    },
}

impl<S> fmt::Display for IntegrationError<S> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::NotFinite { time, .. } => write!(f, "the motion is not finite after {time} s"),
            Self::StepTooSmall { time, step, .. } => write!(
                f,
                "at {time} s the tolerance asks for a step of {step:e} s, which is lost in rounding"
            ),
        }
    }
}

impl<S: fmt::Debug> core::error::Error for IntegrationError<S> {}
