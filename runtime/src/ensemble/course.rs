//! The course of all members from start to end, with changing inputs, and its observation.

#![allow(
    clippy::float_cmp,
    reason = "a motion is at a time, or it is not: it is put there"
)]

use alloc::vec::Vec;
use core::ops::Range;

use super::moves::{EnsembleError, MemberError, Motions, Moves, RunOf};
use super::plan::Limits;
use super::{Blocks, Ensemble};
use crate::bodies::columns::Generic;
#[cfg(feature = "progress")]
use crate::integrate::Bar;
use crate::integrate::{
    Closed, Instants, IntegrationError, InvalidSetting, Sample, Sampled, Setting, check,
    check_state,
};

/// The inputs of the members over time: [`AsGiven`], or a function called at equal intervals, by
/// [`EnsembleIntegration::control`](super::EnsembleIntegration::control). Other types cannot implement
/// it, as for one body ([`Control`](crate::integrate::Control)).
pub trait EnsembleControl<B: Generic>: Closed {
    /// Sets the inputs of members in these states, which act from a time \[s\] on, and returns the
    /// time until which they are held: towards `end`, or beyond.
    fn set(
        &mut self,
        states: &Blocks<B::State>,
        inputs: &mut Blocks<B::Input>,
        time: f64,
        end: f64,
    ) -> f64;

    /// The interval between inputs \[s\], if they are equal.
    fn period(&self) -> Option<f64> {
        None
    }
}

/// The current inputs of the members.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct AsGiven;

impl Closed for AsGiven {}

impl<B: Generic> EnsembleControl<B> for AsGiven {
    fn set(
        &mut self,
        _states: &Blocks<B::State>,
        _inputs: &mut Blocks<B::Input>,
        time: f64,
        end: f64,
    ) -> f64 {
        f64::INFINITY.copysign(end - time)
    }
}

impl<B: Generic, F: FnMut(f64, usize, &B::State) -> B::Input> EnsembleControl<B> for Sampled<F> {
    fn set(
        &mut self,
        states: &Blocks<B::State>,
        inputs: &mut Blocks<B::Input>,
        time: f64,
        end: f64,
    ) -> f64 {
        let (function, until) = self.next(time, end);
        for (index, state) in states.iter().enumerate() {
            inputs.set(index, &function(time, index, &state));
        }
        until
    }

    fn period(&self) -> Option<f64> {
        Some(self.period)
    }
}

/// Members between a start and an end.
#[derive(Debug)]
pub(super) struct EnsembleCourse<'e, B: Generic, M: Moves<B>, C> {
    ensemble: &'e mut Ensemble<B>,
    method: M,
    control: C,
    limits: Limits,
    time: f64,
    motions: Motions<RunOf<M, B>>,
    /// Whether the settings are possible, and whether the initial states were checked.
    checked: Result<(), InvalidSetting>,
    is_begun: bool,
    /// Members that failed before, if the others continue without them.
    lost: Option<Vec<MemberError<B::State>>>,
    #[cfg(feature = "progress")]
    bar: Option<Bar>,
}

impl<'e, B: Generic, M: Moves<B>, C: EnsembleControl<B>> EnsembleCourse<'e, B, M, C> {
    pub(super) fn new(
        ensemble: &'e mut Ensemble<B>,
        (method, control): (M, C),
        limits: Limits,
        times: Range<f64>,
        checked: Result<(), InvalidSetting>,
    ) -> Self {
        let Range { start: time, end } = times;
        Self {
            ensemble,
            method,
            control,
            limits: Limits {
                held: time..time,
                end,
                forwards: end >= time,
                ..limits
            },
            time,
            motions: Motions::NOT_KEPT,
            checked,
            is_begun: false,
            lost: None,
            #[cfg(feature = "progress")]
            bar: None,
        }
    }

    #[cfg(feature = "progress")]
    pub(super) fn shown_on(self, bar: Option<Bar>) -> Self {
        Self { bar, ..self }
    }

    /// Advances to a time, not beyond the end.
    pub(super) fn seek(&mut self, time: f64) -> Result<(), EnsembleError<B::State>> {
        self.begin()?;
        if self.ensemble.is_empty() {
            return Ok(());
        }
        while self.time != time {
            self.take_inputs()?;
            let held_until = self.limits.held.end;
            let next = if self.limits.is_before(held_until, time) {
                held_until
            } else {
                time
            };
            if next != self.limits.end && !self.motions.are_kept() {
                let (ensemble, method) = (&*self.ensemble, self.method.alone());
                self.motions = Motions::of(ensemble, method, self.time, self.limits.end);
                for one in self.lost.iter().flatten() {
                    self.motions.lose(one.index);
                }
            }
            self.moved(next)?;
        }
        Ok(())
    }

    /// Gets new inputs where the last ones end.
    fn take_inputs(&mut self) -> Result<(), InvalidSetting> {
        let (time, end) = (self.time, self.limits.end);
        if time != self.limits.held.end {
            return Ok(());
        }
        let Ensemble {
            states, members, ..
        } = &mut *self.ensemble;
        let until = self.control.set(states, &mut members.inputs, time, end);
        if !self.limits.is_before(time, until) {
            let (setting, ahead) = (Setting::Period, until - time);
            let value = if self.limits.forwards { ahead } else { -ahead };
            return Err(InvalidSetting { setting, value });
        }
        self.limits.held = time..until;
        self.motions.renew();
        Ok(())
    }

    /// Before the motion begins, checks its settings and all states.
    fn begin(&mut self) -> Result<(), EnsembleError<B::State>> {
        self.checked?;
        if self.is_begun {
            return Ok(());
        }
        self.is_begun = true;
        let time = self.time;
        for (index, state) in self.ensemble.states.iter().enumerate() {
            if let Err(invalid) = check_state(&state) {
                let error = IntegrationError::refused(invalid, time, state);
                let member = MemberError { index, error };
                match &mut self.lost {
                    None => return Err(member.into()),
                    Some(lost) => lost.push(member),
                }
            }
        }
        Ok(())
    }

    /// Moves all members to a time, under their current inputs.
    fn moved(&mut self, next: f64) -> Result<(), EnsembleError<B::State>> {
        let times = self.time..next;
        #[cfg(not(feature = "progress"))]
        let shown = |_part: f64| {};
        #[cfg(feature = "progress")]
        let shown = |part: f64| {
            if let Some(bar) = &self.bar {
                bar.show(self.time + part * (next - self.time));
            }
        };
        let (ensemble, limits) = (&mut *self.ensemble, &self.limits);
        let motions = &mut self.motions;
        match &mut self.lost {
            None => {
                let before = ensemble.states.clone();
                let lost = self.method.moved(ensemble, motions, times, limits, shown);
                if let Some(first) = lost.into_iter().next() {
                    ensemble.states = before;
                    return Err(first.into());
                }
            }
            Some(all) => {
                for one in self.method.moved(ensemble, motions, times, limits, shown) {
                    if all.iter().all(|known| known.index != one.index) {
                        motions.lose(one.index);
                        all.push(one);
                    }
                }
                for one in all {
                    ensemble.states.set(one.index, one.error.state());
                }
            }
        }
        self.time = next;
        Ok(())
    }

    /// Advances the members that can reach the end; returns the others, in order.
    pub(super) fn seek_with_each(mut self) -> Result<Vec<MemberError<B::State>>, InvalidSetting> {
        self.lost = Some(Vec::new());
        if let Err(EnsembleError::Setting(invalid)) = self.seek(self.limits.end) {
            return Err(invalid);
        }
        let mut lost = self.lost.unwrap_or_default();
        lost.sort_by_key(|one| one.index);
        Ok(lost)
    }
}

/// The states of all members at equal intervals: see
/// [`EnsembleIntegration::samples`](super::EnsembleIntegration::samples).
#[derive(Debug)]
pub struct EnsembleSamples<'e, B: Generic, M: Moves<B>, C> {
    course: EnsembleCourse<'e, B, M, C>,
    instants: Instants,
}

impl<'e, B: Generic, M: Moves<B>, C> EnsembleSamples<'e, B, M, C> {
    pub(super) fn new(mut course: EnsembleCourse<'e, B, M, C>, period: f64) -> Self {
        let times = course.time..course.limits.end;
        let checked = check(&times, [(Setting::Period, period)]);
        course.checked = course.checked.and(checked);
        let instants = Instants::new(times, period);
        Self { course, instants }
    }
}

impl<B: Generic, M: Moves<B>, C: EnsembleControl<B>> Iterator for EnsembleSamples<'_, B, M, C> {
    type Item = Result<Sample<Blocks<B::State>>, EnsembleError<B::State>>;

    fn next(&mut self) -> Option<Self::Item> {
        let course = &mut self.course;
        let time = self.instants.next()?;
        let reached = course.seek(time);
        if reached.is_err() {
            self.instants = Instants::NONE;
        }
        Some(reached.map(|()| Sample {
            time,
            state: course.ensemble.states.clone(),
        }))
    }
}
