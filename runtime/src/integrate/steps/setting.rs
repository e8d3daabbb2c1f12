//! Settings of an integration, and the check of their values.

use core::fmt;
use core::ops::Range;

use crate::numbers::messages::{Number, debug_as_display};
use crate::state::Coordinates;

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
    /// The step of a method with equal steps \[s\]: positive, and above the rounding of time.
    Step,
    /// The limit of the length of steps \[s\]: positive, and above the rounding of time.
    MaxStep,
    /// The period of a controller or of samples \[s\]: positive, and above the rounding of time.
    Period,
    /// The period of a condition on time, as a load has it \[s\]: far above the rounding of time.
    PeriodOfCondition,
    /// A time at which a step must end \[s\]: finite.
    Break,
}

impl Setting {
    /// Its unit, after a space, if it has one.
    fn unit(self) -> &'static str {
        match self {
            Self::InitialState | Self::Tolerance => "",
            _ => " s",
        }
    }

    /// What it must be, and what this value is not.
    fn must_be(self, value: f64) -> &'static str {
        match self {
            Self::Start | Self::End | Self::InitialState | Self::Break => "finite",
            Self::Tolerance => "positive and finite",
            Self::Step | Self::MaxStep | Self::Period if value > 0.0 => {
                "above the rounding of time"
            }
            Self::Step | Self::MaxStep | Self::Period => "positive",
            Self::PeriodOfCondition => "far above the rounding of time",
        }
    }

    /// Whether a motion between these times can have this value.
    fn permits(self, value: f64, times: &Range<f64>) -> bool {
        match self {
            Self::Start | Self::End | Self::InitialState | Self::Break => value.is_finite(),
            Self::Tolerance => value > 0.0 && value < f64::INFINITY,
            Self::Step | Self::MaxStep | Self::Period => {
                value > f64::EPSILON * times.start.abs().max(times.end.abs())
            }
            // switches nearer than a few roundings are one
            Self::PeriodOfCondition => {
                value > 64.0 * f64::EPSILON * times.start.abs().max(times.end.abs())
            }
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
            Self::PeriodOfCondition => "the period of a condition on time",
            Self::Break => "a break",
        })
    }
}

/// A setting with an impossible value.
#[derive(Clone, Copy, PartialEq)]
pub struct InvalidSetting {
    /// The setting.
    pub setting: Setting,
    /// Its value, in the unit of the setting.
    pub value: f64,
}

impl fmt::Display for InvalidSetting {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { setting, value } = *self;
        let (unit, must_be) = (setting.unit(), setting.must_be(value));
        write!(
            f,
            "{setting} is {}{unit}: it must be {must_be}",
            Number(value)
        )
    }
}

debug_as_display!(InvalidSetting);

impl core::error::Error for InvalidSetting {}

/// Checks the times of a motion and its other settings; the first impossible one is the error.
pub(crate) fn check(
    times: &Range<f64>,
    settings: impl IntoIterator<Item = (Setting, f64)>,
) -> Result<(), InvalidSetting> {
    let ends = [(Setting::Start, times.start), (Setting::End, times.end)];
    let mut all = ends.into_iter().chain(settings);
    let invalid = all.find(|(setting, value)| !setting.permits(*value, times));
    match invalid {
        Some((setting, value)) => Err(InvalidSetting { setting, value }),
        None => Ok(()),
    }
}

/// Checks that all coordinates of an initial state are finite.
pub(crate) fn check_state<S: Coordinates<Scalar = f64>>(state: &S) -> Result<(), InvalidSetting> {
    let coordinates = state.coordinates();
    let invalid = coordinates.as_ref().iter().find(|one| !one.is_finite());
    match invalid {
        Some(&value) => Err(InvalidSetting {
            setting: Setting::InitialState,
            value,
        }),
        None => Ok(()),
    }
}
