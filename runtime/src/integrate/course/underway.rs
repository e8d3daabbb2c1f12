//! A run on its way to a time, through stretches in which the equations do not change.

use core::borrow::Borrow;

use super::pace::Pace;
use crate::bodies::body::RigidBody;
use crate::bodies::switches::Stretch;
use crate::integrate::steps::error::IntegrationError;
use crate::integrate::steps::method::{Method, Run};

/// A value, or the error that ended the motion.
pub(crate) type Outcome<T, B> = Result<T, IntegrationError<<B as RigidBody>::State>>;

/// The moving body, its input, and the limits of its steps.
pub(crate) struct Situation<'s, B: RigidBody, L> {
    pub(crate) body: &'s B,
    pub(crate) input: &'s B::Input,
    pub(crate) pace: &'s Pace<L>,
    /// The time until which the input is held, and the end of the motion \[s\].
    pub(crate) held_until: f64,
    pub(crate) end: f64,
    pub(crate) forwards: bool,
}

/// A run, and the stretch of time that it is in.
#[derive(Debug)]
pub(crate) struct Underway<R> {
    pub(crate) run: R,
    pub(crate) stretch: Stretch,
    /// Whether it failed, so that it does not go on.
    #[cfg(feature = "ensemble")]
    pub(crate) is_lost: bool,
}

impl<B: RigidBody, L> Situation<'_, B, L> {
    /// Whether a time comes before another.
    fn is_before(&self, time: f64, other: f64) -> bool {
        if self.forwards {
            time < other
        } else {
            time > other
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
}

impl<R> Underway<R> {
    /// Before the first step of a motion from a time and a state to an end.
    pub(crate) fn new<B, M>(body: &B, method: M, (time, state): (f64, &B::State), end: f64) -> Self
    where
        B: RigidBody<Scalar = f64>,
        M: Method<B, Run = R>,
        R: Run<B>,
    {
        let mut run = method.start(body, time, state);
        run.heads_for(end);
        let stretch = Stretch::until_now(time);
        Self {
            run,
            stretch,
            #[cfg(feature = "ensemble")]
            is_lost: false,
        }
    }

    /// Called when an input is given.
    pub(crate) fn renew<B: RigidBody<Scalar = f64>>(&mut self)
    where
        R: Run<B>,
    {
        self.run.renew();
        self.stretch = Stretch::until_now(self.run.time());
    }

    /// The end of the next step. Determines how long the equations do not change, if the last
    /// stretch is over.
    pub(crate) fn limit<B, L>(&mut self, situation: &Situation<'_, B, L>) -> Outcome<f64, B>
    where
        B: RigidBody<Scalar = f64>,
        R: Run<B>,
        L: Iterator<Item: Borrow<f64>> + Clone,
    {
        let Situation {
            body,
            input,
            pace,
            end,
            forwards,
            held_until,
        } = *situation;
        let time = self.run.time();
        if !situation.is_before(time, self.stretch.next) {
            let given = self.stretch.given;
            let stretch = Stretch::of(body, input, (time, forwards, 0), pace.breaks.clone());
            let checked = stretch.check(&(time..end));
            checked
                .map_err(|invalid| IntegrationError::refused(invalid, time, self.run.state()))?;
            self.stretch = Stretch { given, ..stretch };
            self.run.enter(self.stretch);
        }
        let limit = situation.nearer(situation.nearer(held_until, end), self.stretch.next);
        Ok(pace.limit(time, limit))
    }

    /// Takes a step.
    pub(crate) fn step<B, L>(&mut self, situation: &Situation<'_, B, L>) -> Outcome<(), B>
    where
        B: RigidBody<Scalar = f64>,
        R: Run<B>,
        L: Iterator<Item: Borrow<f64>> + Clone,
    {
        let limit = self.limit(situation)?;
        let Situation { body, input, .. } = *situation;
        let reached = self.run.step(body, limit, input);
        self.named(situation, reached)
    }

    /// Takes steps until a time lies within the last one, but not beyond a change of the equations.
    pub(crate) fn approach<B, L>(
        &mut self,
        situation: &Situation<'_, B, L>,
        time: f64,
    ) -> Outcome<(), B>
    where
        B: RigidBody<Scalar = f64>,
        R: Run<B>,
        L: Iterator<Item: Borrow<f64>> + Clone,
    {
        if situation.pace.max_step < f64::INFINITY {
            return self.step(situation);
        }
        let limit = self.limit(situation)?;
        let Situation { body, input, .. } = *situation;
        let aim = situation.nearer(time, limit);
        let reached = self.run.seek(body, aim, limit, input);
        self.named(situation, reached)
    }

    /// Advances until a time, not beyond the change of the input, lies within the last step; returns
    /// the state at that time.
    #[cfg(feature = "ensemble")]
    pub(crate) fn seek<B, L>(
        &mut self,
        situation: &Situation<'_, B, L>,
        time: f64,
    ) -> Outcome<B::State, B>
    where
        B: RigidBody<Scalar = f64>,
        R: Run<B>,
        L: Iterator<Item: Borrow<f64>> + Clone,
    {
        while situation.is_before(self.run.time(), time) {
            self.approach(situation, time)?;
        }
        Ok(self.at(situation.body, time, situation.input))
    }

    /// The state at a time within the last step.
    pub(crate) fn at<B>(&self, body: &B, time: f64, input: &B::Input) -> B::State
    where
        B: RigidBody<Scalar = f64>,
        R: Run<B>,
    {
        if time == self.run.time() {
            self.run.state()
        } else {
            self.run.within(body, time, input)
        }
    }

    /// Adds the name of a load without a value, if there is one, to an error.
    fn named<B, L>(
        &self,
        situation: &Situation<'_, B, L>,
        reached: Outcome<(), B>,
    ) -> Outcome<(), B>
    where
        B: RigidBody<Scalar = f64>,
    {
        reached.map_err(|error| {
            let Situation {
                body,
                input,
                forwards,
                ..
            } = *situation;
            let moved = body.input_after(input, error.time() - self.stretch.given);
            error.named(body, moved.as_ref().unwrap_or(input), forwards)
        })
    }
}
