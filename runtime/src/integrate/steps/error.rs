//! Errors that end an integration early.

use core::fmt;

use super::setting::{InvalidSetting, Setting, check_state};
use crate::bodies::body::{InvalidBody, RigidBody};
use crate::bodies::constrained::Inconsistent;
use crate::numbers::messages::{Brief, Number, debug_as_display};
use crate::state::{Coordinates, State};

/// The error of an integration, with the last good state and its time.
#[derive(Clone, Copy, PartialEq)]
#[non_exhaustive]
pub enum IntegrationError<S> {
    /// A given number is impossible. All are checked before the integration begins, except a period
    /// of conditions that depends on inputs: it is checked when they are given.
    InvalidSetting {
        /// \[s\]
        time: f64,
        /// The state at that time; the first, if the motion did not begin.
        state: S,
        /// The number, and what it must be.
        setting: Setting,
        /// Its value, in the unit of the setting.
        value: f64,
    },
    /// The motion is not finite from here on: a force grows without bound or has no value.
    NotFinite {
        /// \[s\]
        time: f64,
        /// The state at that time.
        state: S,
        /// A load without a value there, or just after, if it is known:
        /// [`RigidBody::lost_load`].
        load: Option<&'static str>,
    },
    /// The step is lost in the rounding of time: a singularity is near, or the tolerance is below
    /// the precision of doubles. Or steps are so short that the motion does not
    /// end: the equations jump, and drive the motion back from both sides of the jump, as friction
    /// along `velocity.normalize()` does where a point comes to rest.
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
    /// A constraint or its rate jumps, at a switch or within a step, so that bodies would have to
    /// jump: the equations of motion do not describe the shock. The motion can be continued from the
    /// state after the shock.
    Jump {
        /// \[s\]
        time: f64,
        /// The last good state.
        state: S,
        /// The violation after the jump.
        violated: Inconsistent,
    },
    /// The constraints do not determine the motion from here on: one has no gradient, or depends
    /// on the others, although not in general. This is a change point of a linkage, or a dead
    /// point of a driven joint, from which several motions continue, or none.
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
    /// The motion does not begin, or not continue, from this state: a setting is impossible.
    #[cold]
    pub(crate) fn refused(invalid: InvalidSetting, time: f64, state: S) -> Self {
        let InvalidSetting { setting, value } = invalid;
        Self::InvalidSetting {
            time,
            state,
            setting,
            value,
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
            Self::InvalidSetting { time, .. }
            | Self::NotFinite { time, .. }
            | Self::StepTooSmall { time, .. }
            | Self::StepTooLong { time, .. }
            | Self::InvalidBody { time, .. }
            | Self::Inconsistent { time, .. }
            | Self::Jump { time, .. }
            | Self::Undetermined { time, .. }
            | Self::EventNotANumber { time, .. } => *time,
        }
    }

    /// The last good state.
    #[must_use]
    pub fn state(&self) -> &S {
        match self {
            Self::InvalidSetting { state, .. }
            | Self::NotFinite { state, .. }
            | Self::StepTooSmall { state, .. }
            | Self::StepTooLong { state, .. }
            | Self::InvalidBody { state, .. }
            | Self::Inconsistent { state, .. }
            | Self::Jump { state, .. }
            | Self::Undetermined { state, .. }
            | Self::EventNotANumber { state, .. } => state,
        }
    }
}

impl<S> fmt::Display for IntegrationError<S> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::InvalidSetting { setting, value, .. } => {
                let (setting, value) = (*setting, *value);
                InvalidSetting { setting, value }.fmt(f)
            }
            Self::NotFinite { time, load, .. } => {
                write!(f, "the motion is not finite after {} s", Number(*time))?;
                load.map_or(Ok(()), |load| write!(f, ": `{load}` is not finite"))
            }
            Self::StepTooSmall { time, step, .. } => write!(
                f,
                "at {} s the step is {} s, which is lost in rounding, or too short to come to an end",
                Number(*time),
                Brief(*step)
            ),
            Self::StepTooLong { time, step, .. } => write!(
                f,
                "at {} s a step of {} s is too long: its equations are not solved, take shorter ones",
                Number(*time),
                Brief(*step)
            ),
            Self::InvalidBody { time, invalid, .. } => {
                write!(f, "after {} s: {invalid}", Number(*time))
            }
            Self::Inconsistent { time, violated, .. } => {
                write!(f, "at {} s: {violated}", Number(*time))
            }
            Self::Jump { time, violated, .. } => write!(
                f,
                "after {} s `{}` jumps, or its rate does: the equations do not describe this shock",
                Number(*time),
                violated.constraint,
            ),
            Self::Undetermined {
                time, constraint, ..
            } => write!(
                f,
                "after {} s the motion is not determined: `{constraint}` has no gradient there, or follows from the other constraints, as at a change point, or at a dead point of a driven joint",
                Number(*time)
            ),
            Self::EventNotANumber { time, .. } => {
                let time = Number(*time);
                write!(f, "at {time} s the function of the events is not a number")
            }
        }
    }
}

impl<S: Coordinates<Scalar = f64>> IntegrationError<S> {
    /// The motion from this state is not finite, or the state itself is not.
    #[cold]
    pub(crate) fn lost(time: f64, state: S) -> Self {
        match check_state(&state) {
            Err(invalid) => Self::refused(invalid, time, state),
            Ok(()) => Self::not_finite(time, state),
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
        let nearest = f64::EPSILON * time.abs().max(1e-6);
        let towards = if forwards { nearest } else { -nearest };
        let ahead = Ahead::new((body, input), (time, &state), towards);
        let ran_out = ahead.impossible(0.0);
        let load = if too_small.is_none() && ran_out.is_none() {
            ahead.lost_load()
        } else {
            None
        };
        if load.is_some() {
            return Self::NotFinite { time, state, load };
        }
        let within_a_step = too_small.map_or(WITHIN_A_STEP, |_| 0);
        let farthest = too_small.map_or(f64::INFINITY, |step| nearest + AHEAD * step.abs());
        let later = || {
            let times = ahead.times(DOUBLINGS + within_a_step);
            let mut times = times.take_while(|after| after.abs() <= farthest);
            times.find_map(|after| ahead.impossible(after))
        };
        let ran_out = ran_out.or_else(later);
        match (ran_out, too_small) {
            (Some(invalid), _) => Self::InvalidBody {
                time,
                state,
                invalid,
            },
            (None, Some(step)) => Self::StepTooSmall { time, state, step },
            (None, None) => Self::NotFinite { time, state, load },
        }
    }

    /// A step \[s\] without an end: because of a load without a value on its way, if there is one,
    /// whatever the length of the step.
    #[cold]
    pub(crate) fn of_step<B: RigidBody<Scalar = f64, State = S>>(
        self,
        step: f64,
        (body, input): (&B, &B::Input),
    ) -> Self {
        let (Self::NotFinite {
            time, ref state, ..
        }
        | Self::StepTooLong {
            time, ref state, ..
        }) = self
        else {
            return self;
        };
        let ahead = Ahead::new(
            (body, input),
            (time, state),
            libm::scalbn(step, 1 - DOUBLINGS),
        );
        match ahead.lost_load() {
            None => self,
            load => Self::NotFinite {
                time,
                state: state.clone(),
                load,
            },
        }
    }
}

/// Where the motion leads from a state, at the rate that it has there.
struct Ahead<'b, B: RigidBody> {
    body: &'b B,
    input: &'b B::Input,
    time: f64,
    state: &'b B::State,
    rate: <B::State as State>::Rate,
    /// The nearest time ahead \[s\], negative backwards.
    nearest: f64,
}

impl<'b, B: RigidBody<Scalar = f64, State: State<Scalar = f64>>> Ahead<'b, B> {
    fn new(
        (body, input): (&'b B, &'b B::Input),
        (time, state): (f64, &'b B::State),
        nearest: f64,
    ) -> Self {
        Self {
            body,
            input,
            time,
            state,
            rate: state.rate(&body.acceleration(time, state, input)),
            nearest,
        }
    }

    /// Doubled again and again, from the nearest on \[s\].
    fn times(&self, doublings: i32) -> impl Iterator<Item = f64> {
        let nearest = self.nearest;
        (0..doublings).map(move |power| nearest * libm::exp2(f64::from(power)))
    }

    fn after(&self, after: f64) -> (f64, B::State) {
        (self.time + after, self.state.moved(&(self.rate * after)))
    }

    /// The reason why there is no such body, if there is none.
    fn impossible(&self, after: f64) -> Option<InvalidBody> {
        let (time, state) = self.after(after);
        let invalid = self.body.possible(time, &state, self.input).err();
        invalid.filter(|invalid| !invalid.is_of_no_number())
    }

    /// A load without a value; an impossible body is not the fault of a load.
    fn lost(&self, after: f64) -> Option<&'static str> {
        if self.impossible(after).is_some() {
            return None;
        }
        let (time, state) = self.after(after);
        self.body.lost_load(time, &state, self.input)
    }

    /// A load without a value here, or just ahead.
    fn lost_load(&self) -> Option<&'static str> {
        let here = self.body.lost_load(self.time, self.state, self.input);
        // a NaN rate leads nowhere
        let leads = || self.lost(0.0).is_none();
        let ahead = || self.times(DOUBLINGS).find_map(|after| self.lost(after));
        here.or_else(|| leads().then(ahead).flatten())
    }
}

/// The number of doublings of the time ahead in the search for a load without a value, starting
/// from the rounding of time.
const DOUBLINGS: i32 = 32;
/// A body that becomes impossible later than after this many steps is not the reason why these are
/// too small: late on the clock, the rounding of time is long.
const AHEAD: f64 = 16384.0;
/// Further doublings, for a fixed step that may end where the body is impossible.
const WITHIN_A_STEP: i32 = 12;

debug_as_display!(IntegrationError<S>);

impl<S> core::error::Error for IntegrationError<S> {}
