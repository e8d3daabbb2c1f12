//! A motion from its start to its end, with changing inputs, and its observation.

use core::borrow::Borrow;
use core::ops::Range;

use crate::bodies::body::RigidBody;
use crate::bodies::switches::Stretch;
use crate::integrate::steps::error::IntegrationError;
use crate::integrate::steps::method::{Method, Run};
use crate::integrate::steps::setting::{self, InvalidSetting, Setting};

pub mod control;
pub mod instants;
pub mod integration;
pub mod observed;
#[cfg(feature = "progress")]
pub mod progress;

use control::Control;
#[cfg(feature = "progress")]
use progress::Bar;

/// The limit of the length of steps, and additional times at which they end.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Pace<L> {
    /// \[s\]
    pub(crate) max_step: f64,
    /// Times \[s\], in any order.
    pub(crate) breaks: L,
}

impl<L> Pace<L> {
    /// The time at which a step from a given time must end, if other reasons end it at `limit`.
    pub(crate) fn limit(&self, time: f64, limit: f64) -> f64 {
        let rest = limit - time;
        if self.max_step < rest.abs() {
            time + self.max_step.copysign(rest)
        } else {
            limit
        }
    }
}

impl<L: Iterator<Item: Borrow<f64>> + Clone> Pace<L> {
    /// Checks all settings of an integration, before it begins: the times, the tolerance, the
    /// setting of the method, the period of the controller, the longest step and the breaks.
    pub(crate) fn check(
        &self,
        times: &Range<f64>,
        tolerance: f64,
        method: Option<(Setting, f64)>,
        period: Option<f64>,
    ) -> Result<(), InvalidSetting> {
        let own = [
            (Setting::Tolerance, tolerance),
            (Setting::MaxStep, self.max_step),
        ];
        let period = period.map(|period| (Setting::Period, period));
        let breaks = self.breaks.clone();
        let breaks = breaks.map(|time| (Setting::Break, *time.borrow()));
        let settings = own.into_iter().chain(method).chain(period).chain(breaks);
        setting::check(times, settings)
    }
}

/// A motion between its start and its end.
pub(crate) struct Course<R, C, B: RigidBody, L> {
    pub(crate) run: R,
    pub(crate) control: C,
    /// The current input, and the time until which it is held.
    pub(crate) input: B::Input,
    pub(crate) held_until: f64,
    /// The time at which the input was given, if that was earlier.
    pub(crate) given: Option<f64>,
    /// The current stretch.
    pub(crate) stretch: Stretch,
    pub(crate) pace: Pace<L>,
    pub(crate) end: f64,
    pub(crate) forwards: bool,
    /// Why the motion cannot begin.
    pub(crate) refused: Option<InvalidSetting>,
    #[cfg(feature = "progress")]
    pub(crate) bar: Option<Bar>,
}

/// A value, or the error that ended the motion.
type Outcome<T, B> = Result<T, IntegrationError<<B as RigidBody>::State>>;

impl<B, R, C, L> Course<R, C, B, L>
where
    B: RigidBody<Scalar = f64>,
    R: Run<B>,
    C: Control<B::State, B::Input>,
    L: Iterator<Item: Borrow<f64>> + Clone,
{
    /// A motion before its first step, with settings that are possible.
    pub(crate) fn new<'b, M: Method<B, Run<'b> = R>>(
        body: &'b B,
        method: M,
        control: C,
        pace: Pace<L>,
        start: (f64, &B::State),
        end: f64,
    ) -> Self
    where
        B: 'b,
    {
        let (time, state) = start;
        let mut run = method.start(body, time, state);
        run.heads_for(end);
        Self {
            run,
            control,
            input: B::Input::default(),
            given: None,
            held_until: time,
            stretch: Stretch {
                next: time,
                ..Stretch::ALL
            },
            pace,
            end,
            forwards: end >= time,
            refused: None,
            #[cfg(feature = "progress")]
            bar: None,
        }
    }

    /// Whether the motion has not reached a time yet.
    fn is_before(&self, time: f64) -> bool {
        let now = self.run.time();
        if self.forwards {
            now < time
        } else {
            now > time
        }
    }

    /// The nearer of two times ahead.
    fn nearer(&self, one: f64, other: f64) -> f64 {
        if self.forwards {
            one.min(other)
        } else {
            one.max(other)
        }
    }

    /// The error of a motion that cannot begin.
    fn begin(&self) -> Outcome<(), B> {
        match self.refused {
            None => Ok(()),
            Some(invalid) => {
                let (time, state) = (self.run.time(), self.run.state());
                Err(IntegrationError::refused(invalid, time, state))
            }
        }
    }

    /// Gets a new input where the last one ends, determines how long the equations do not change,
    /// and returns the end of the next step.
    fn limit(&mut self) -> Outcome<f64, B> {
        let time = self.run.time();
        let is_given = time == self.held_until;
        if is_given {
            let state = self.run.state();
            let (input, until) = self.control.input(time, &state, self.end);
            (self.input, self.held_until) = (input, until);
            self.run.renew();
            if !self.is_before(until) {
                let (setting, ahead) = (Setting::Period, until - time);
                let value = if self.forwards { ahead } else { -ahead };
                let invalid = InvalidSetting { setting, value };
                return Err(IntegrationError::refused(invalid, time, state));
            }
        }
        if is_given || !self.is_before(self.stretch.next) {
            let given = if is_given {
                self.given.unwrap_or(time)
            } else {
                self.stretch.given
            };
            let (from, breaks) = ((time, self.forwards, 0), self.pace.breaks.clone());
            let stretch = Stretch::of(self.run.body(), &self.input, from, breaks);
            let checked = stretch.check(&(time..self.end));
            checked
                .map_err(|invalid| IntegrationError::refused(invalid, time, self.run.state()))?;
            self.stretch = Stretch { given, ..stretch };
            self.run.enter(self.stretch);
        }
        let limit = self.nearer(self.nearer(self.held_until, self.end), self.stretch.next);
        Ok(self.pace.limit(time, limit))
    }

    /// Takes a step; false if the end is reached.
    fn step(&mut self) -> Outcome<bool, B> {
        self.begin()?;
        if self.run.time() == self.end {
            return Ok(false);
        }
        let limit = self.limit()?;
        let reached = self.run.step(limit, &self.input);
        self.named(reached)?;
        self.show();
        Ok(true)
    }

    /// Advances until a time, not beyond the end, lies within the last step.
    pub(crate) fn seek(&mut self, time: f64) -> Outcome<(), B> {
        self.begin()?;
        while self.is_before(time) {
            let limit = self.limit()?;
            let reached = if self.pace.max_step < f64::INFINITY {
                self.run.step(limit, &self.input)
            } else {
                let aim = self.nearer(time, limit);
                self.run.seek(aim, limit, &self.input)
            };
            self.named(reached)?;
            self.show();
        }
        Ok(())
    }

    /// Adds the name of a load without a value, if there is one, to an error.
    fn named(&self, reached: Outcome<(), B>) -> Outcome<(), B> {
        reached.map_err(|error| {
            let (body, since) = (self.run.body(), error.time() - self.stretch.given);
            let moved = body.input_after(&self.input, since);
            error.named(body, moved.as_ref().unwrap_or(&self.input), self.forwards)
        })
    }

    /// The state at a time within the last step.
    fn at(&self, time: f64) -> B::State {
        if time == self.run.time() {
            self.run.state()
        } else {
            self.run.within(time, &self.input)
        }
    }

    #[cfg_attr(
        not(feature = "progress"),
        expect(clippy::unused_self, reason = "nothing to show")
    )]
    fn show(&self) {
        #[cfg(feature = "progress")]
        if let Some(bar) = &self.bar {
            bar.show(self.run.time());
        }
    }
}
