//! Settings of an integration.

use core::fmt;

/// A number that an integration is given.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Setting {
    /// The time at which it begins \[s\]: finite.
    Start,
    /// The time at which it ends \[s\]: finite.
    End,
    /// A coordinate of the initial state, SI units: finite.
    InitialState,
    /// The tolerance of a step: positive and finite.
    Tolerance,
    /// The step of a method with equal steps \[s\]: positive.
    Step,
    /// The limit of the length of steps \[s\]: positive.
    MaxStep,
    /// The period of a controller or of samples \[s\]: positive.
    Period,
}

impl Setting {
    /// Its unit, after a space, if it has one.
    pub(super) fn unit(self) -> &'static str {
        match self {
            Self::InitialState | Self::Tolerance => "",
            _ => " s",
        }
    }

    /// What it must be.
    pub(super) fn must_be(self) -> &'static str {
        match self {
            Self::Start | Self::End | Self::InitialState => "finite",
            Self::Tolerance => "positive and finite",
            _ => "positive",
        }
    }
}

impl fmt::Display for Setting {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Start => "the start",
            Self::End => "the end",
            Self::InitialState => "a coordinate of the initial state",
            Self::Tolerance => "the tolerance",
            Self::Step => "the step",
            Self::MaxStep => "the longest step",
            Self::Period => "the period",
        })
    }
}
