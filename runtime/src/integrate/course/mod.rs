//! A motion from its start to its end, with changing inputs, and its observation.

use core::borrow::Borrow;

use crate::bodies::body::RigidBody;
use crate::integrate::steps::error::IntegrationError;
use crate::integrate::steps::method::{Method, Run};
use crate::integrate::steps::setting::{InvalidSetting, Setting};

pub mod control;
pub mod instants;
pub mod integration;
pub mod observed;
pub mod pace;
#[cfg(feature = "progress")]
pub mod progress;
pub mod underway;

use control::Control;
use pace::Pace;
#[cfg(feature = "progress")]
use progress::Bar;
use underway::{Outcome, Situation, Underway};

/// A motion between its start and its end.
pub(crate) struct Course<'b, R, C, B: RigidBody, L> {
    body: &'b B,
    underway: Underway<R>,
    control: C,
    /// The current input, and the time until which it is held.
    input: B::Input,
    held_until: f64,
    pace: Pace<L>,
    end: f64,
    forwards: bool,
    /// Why the motion cannot begin.
    refused: Option<InvalidSetting>,
    #[cfg(feature = "progress")]
    bar: Option<Bar>,
}

impl<'b, B, R, C, L> Course<'b, R, C, B, L>
where
    B: RigidBody<Scalar = f64>,
    R: Run<B>,
    C: Control<B::State, B::Input>,
    L: Iterator<Item: Borrow<f64>> + Clone,
{
    /// A motion before its first step, with settings that are possible.
    fn new<M: Method<B, Run = R>>(
        body: &'b B,
        method: M,
        control: C,
        pace: Pace<L>,
        start: (f64, &B::State),
        end: f64,
    ) -> Self {
        Self {
            body,
            underway: Underway::new(body, method, start, end),
            control,
            input: B::Input::default(),
            held_until: start.0,
            pace,
            end,
            forwards: end >= start.0,
            refused: None,
            #[cfg(feature = "progress")]
            bar: None,
        }
    }

    /// The current time.
    fn time(&self) -> f64 {
        self.underway.run.time()
    }

    /// The current state.
    fn state(&self) -> B::State {
        self.underway.run.state()
    }

    /// The error of a motion that cannot begin.
    fn begin(&self) -> Outcome<(), B> {
        match self.refused {
            None => Ok(()),
            Some(invalid) => Err(IntegrationError::refused(
                invalid,
                self.time(),
                self.state(),
            )),
        }
    }

    /// Gets a new input where the last one ends.
    fn take_input(&mut self) -> Outcome<(), B> {
        let time = self.time();
        if time != self.held_until {
            return Ok(());
        }
        let state = self.state();
        let (input, until) = self.control.input(time, &state, self.end);
        (self.input, self.held_until) = (input, until);
        self.underway.renew();
        let ahead = if self.forwards {
            until - time
        } else {
            time - until
        };
        if ahead > 0.0 {
            return Ok(());
        }
        let (setting, value) = (Setting::Period, ahead);
        let invalid = InvalidSetting { setting, value };
        Err(IntegrationError::refused(invalid, time, state))
    }

    /// What the run is subject to, and the run.
    fn parts(&mut self) -> (Situation<'_, B, L>, &mut Underway<R>) {
        let situation = Situation {
            body: self.body,
            input: &self.input,
            pace: &self.pace,
            held_until: self.held_until,
            end: self.end,
            forwards: self.forwards,
        };
        (situation, &mut self.underway)
    }

    /// Takes a step; false if the end is reached.
    fn step(&mut self) -> Outcome<bool, B> {
        self.begin()?;
        if self.time() == self.end {
            return Ok(false);
        }
        self.take_input()?;
        let (situation, underway) = self.parts();
        underway.step(&situation)?;
        self.show();
        Ok(true)
    }

    /// Advances until a time, not beyond the end, lies within the last step.
    fn seek(&mut self, time: f64) -> Outcome<(), B> {
        self.begin()?;
        let is_before = |now: f64, forwards: bool| if forwards { now < time } else { now > time };
        while is_before(self.time(), self.forwards) {
            self.take_input()?;
            let (situation, underway) = self.parts();
            underway.approach(&situation, time)?;
            self.show();
        }
        Ok(())
    }

    /// The state at a time within the last step.
    fn at(&self, time: f64) -> B::State {
        self.underway.at(self.body, time, &self.input)
    }

    #[cfg_attr(
        not(feature = "progress"),
        expect(clippy::unused_self, reason = "nothing to show")
    )]
    fn show(&self) {
        #[cfg(feature = "progress")]
        if let Some(bar) = &self.bar {
            bar.show(self.time());
        }
    }
}
