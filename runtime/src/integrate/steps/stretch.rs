//! A body within a stretch of time in which its equations do not change.

use core::borrow::Borrow;
use core::ops::Range;

use super::setting::{self, InvalidSetting, Setting};
use crate::bodies::body::RigidBody;
use crate::bodies::switches::{Stretch, Switches};
use crate::numbers::scalar::Scalar;
use crate::state::State;

impl Stretch {
    /// The stretch of a body from a time on, with a list of additional known times.
    pub(crate) fn of<B: RigidBody>(
        body: &B,
        input: &B::Input,
        (now, forwards, lane): (f64, bool, usize),
        breaks: impl Iterator<Item: Borrow<f64>>,
    ) -> Self {
        let mut switches = Switches::new(now, forwards, lane);
        body.switches(input, &mut switches);
        breaks.for_each(|time| switches.put(*time.borrow(), 0.0));
        switches.stretch
    }

    /// Checks the periods of conditions in a motion between these times.
    #[inline]
    pub(crate) fn check(&self, times: &Range<f64>) -> Result<(), InvalidSetting> {
        if self.period == f64::INFINITY {
            return Ok(());
        }
        setting::check(times, [(Setting::PeriodOfCondition, self.period)])
    }
}

/// The time \[s\] at which the equations of a body change next on the way from a time to an end, if
/// they do, for solvers that must be told where to stop.
/// [`integrate`](crate::integrate::Integrate::integrate) stops there by itself.
///
/// ```
/// use newton_euler::{integrate::next_switch, prelude::*};
///
/// rigid_body!(Rocket {
///     motion: translation,
///     params: [ignition = 2[s], burn = 1.5[s]],
///     mass: 3[kg],
///     forces: [
///         thrust = if t > ignition && t < ignition + burn {
///             world(0, 0, 60[N])
///         } else {
///             world(0, 0, 0)
///         },
///     ],
/// });
///
/// let rocket = Rocket::default();
/// assert_eq!(next_switch(&rocket, &(), 0.0, 10.0), Some(2.0));
/// assert_eq!(next_switch(&rocket, &(), 2.0, 10.0), Some(3.5));
/// assert_eq!(next_switch(&rocket, &(), 3.5, 10.0), None);
/// // coasting, burning, coasting
/// let end = rocket.integrate(&Translation::default()).to(10.0)?;
/// assert!((end.velocity.z - 30.0).abs() < 1e-12);
/// # Ok::<(), newton_euler::integrate::IntegrationError<Translation>>(())
/// ```
pub fn next_switch<B: RigidBody>(body: &B, input: &B::Input, time: f64, end: f64) -> Option<f64> {
    let from = (time, end >= time, 0);
    let next = Stretch::of(body, input, from, core::iter::empty::<f64>()).next;
    let is_before_end = if end >= time { next < end } else { next > end };
    is_before_end.then_some(next)
}

/// A body whose input was given at a time, and may move since then.
pub(crate) struct Given<'b, B: RigidBody> {
    pub(crate) body: &'b B,
    pub(crate) at: B::Scalar,
}

impl<B: RigidBody<Scalar: Scalar>> RigidBody for Given<'_, B> {
    type Scalar = B::Scalar;
    type State = B::State;
    type Input = B::Input;

    const CHANGES: bool = B::CHANGES;

    #[cfg_attr(not(unoptimized), inline(always))]
    fn acceleration(
        &self,
        time: B::Scalar,
        state: &B::State,
        input: &B::Input,
    ) -> <B::State as State>::Acceleration {
        match self.body.input_after(input, time - self.at) {
            Some(moved) => self.body.acceleration(time, state, &moved),
            None => self.body.acceleration(time, state, input),
        }
    }
}

/// A body within a stretch of time, as a step evaluates it.
pub(crate) struct Within<'b, B: RigidBody> {
    pub(crate) body: &'b B,
    pub(crate) lower: B::Scalar,
    pub(crate) upper: B::Scalar,
    /// The time at which the input was given.
    pub(crate) given: B::Scalar,
}

impl<'b, B: RigidBody<Scalar = f64>> Within<'b, B> {
    #[cfg_attr(not(unoptimized), inline(always))]
    pub(crate) fn new(body: &'b B, stretch: &Stretch) -> Self {
        let Stretch {
            lower,
            upper,
            given,
            ..
        } = *stretch;
        Self {
            body,
            lower,
            upper,
            given,
        }
    }
}

impl<B: RigidBody<Scalar: Scalar>> Within<'_, B> {
    /// A time of a step, on the step's side of a switch.
    #[cfg_attr(not(unoptimized), inline(always))]
    pub(crate) fn side(&self, time: B::Scalar) -> B::Scalar {
        let time = B::Scalar::select(time.less(self.lower), self.lower, time);
        B::Scalar::select(self.upper.less(time), self.upper, time)
    }

    /// The input at a time, if it moves.
    #[cfg_attr(not(unoptimized), inline(always))]
    pub(crate) fn moved(&self, input: &B::Input, time: B::Scalar) -> Option<B::Input> {
        self.body.input_after(input, time - self.given)
    }
}

impl<B: RigidBody<Scalar: Scalar>> RigidBody for Within<'_, B> {
    type Scalar = B::Scalar;
    type State = B::State;
    type Input = B::Input;

    const CHANGES: bool = B::CHANGES;

    #[cfg_attr(not(unoptimized), inline(always))]
    fn acceleration(
        &self,
        time: B::Scalar,
        state: &B::State,
        input: &B::Input,
    ) -> <B::State as State>::Acceleration {
        let side = self.side(time);
        match self.moved(input, time) {
            Some(moved) => self.body.acceleration(side, state, &moved),
            None => self.body.acceleration(side, state, input),
        }
    }
}
