//! The course of all members from start to end, with changing inputs, and its observation.

#![allow(
    clippy::float_cmp,
    reason = "a motion is at a time, or it is not: it is put there"
)]

use alloc::vec::Vec;
use core::ops::Range;

use super::moves::{MemberError, Moves};
use super::plan::Limits;
use super::{Blocks, Ensemble};
use crate::bodies::columns::Generic;
#[cfg(feature = "progress")]
use crate::integrate::Bar;
use crate::integrate::{Instants, IntegrationError, Sample, Sampled, Setting, period_is_lost};

/// The inputs of the members over time: [`AsGiven`], or a function called at equal intervals, by
/// [`EnsembleIntegration::control`](super::EnsembleIntegration::control).
pub trait EnsembleControl<B: Generic> {
    /// Sets the inputs that act from a time \[s\] on, and returns the time until which they are
    /// held: towards `end`, or beyond.
    fn set(&mut self, ensemble: &mut Ensemble<B>, time: f64, end: f64) -> f64;

    /// The interval between inputs \[s\], if they are equal.
    fn period(&self) -> Option<f64> {
        None
    }
}

/// The current inputs of the members.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct AsGiven;

impl<B: Generic> EnsembleControl<B> for AsGiven {
    fn set(&mut self, _ensemble: &mut Ensemble<B>, time: f64, end: f64) -> f64 {
        f64::INFINITY.copysign(end - time)
    }
}

impl<B: Generic, F: FnMut(f64, usize, &B::State) -> B::Input> EnsembleControl<B> for Sampled<F> {
    fn set(&mut self, ensemble: &mut Ensemble<B>, time: f64, end: f64) -> f64 {
        let (function, until) = self.next(time, end);
        for index in 0..ensemble.len() {
            let input = function(time, index, &ensemble.states.get(index));
            ensemble.members.inputs.set(index, &input);
        }
        until
    }

    fn period(&self) -> Option<f64> {
        Some(self.period)
    }
}

/// Members between a start and an end.
#[derive(Debug)]
pub(super) struct EnsembleCourse<'e, B: Generic, M, C> {
    ensemble: &'e mut Ensemble<B>,
    method: M,
    control: C,
    limits: Limits,
    time: f64,
    end: f64,
    /// The time until which the current inputs are held.
    held_until: f64,
    /// Members that failed before, if the others continue without them.
    lost: Option<Vec<MemberError<B::State>>>,
    #[cfg(feature = "progress")]
    bar: Option<Bar>,
}

impl<'e, B: Generic, M: Moves<B>, C: EnsembleControl<B>> EnsembleCourse<'e, B, M, C> {
    pub(super) fn new(
        ensemble: &'e mut Ensemble<B>,
        method: M,
        control: C,
        limits: Limits,
        times: Range<f64>,
    ) -> Self {
        let Range { start: time, end } = times;
        Self {
            ensemble,
            method,
            control,
            limits,
            time,
            end,
            held_until: time,
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
    pub(super) fn seek(&mut self, time: f64) -> Result<(), MemberError<B::State>> {
        if self.ensemble.is_empty() {
            return Ok(());
        }
        if !(self.time.is_finite() && time.is_finite()) {
            let start = self.time;
            return Err(self.ended(|state| IntegrationError::endless(start..time, state)));
        }
        while self.time != time {
            let forwards = time > self.time;
            let is_ahead = |until: f64, now: f64| if forwards { until > now } else { until < now };
            if self.time == self.held_until {
                let until = self.control.set(self.ensemble, self.time, self.end);
                let period = self.control.period();
                if !is_ahead(until, self.time) || period_is_lost(period, self.end) {
                    let time = self.time;
                    let period = period.unwrap_or(until - time);
                    let setting = (Setting::Period, period);
                    return Err(
                        self.ended(|state| IntegrationError::too_small(setting, time, state))
                    );
                }
                (self.held_until, self.limits.given) = (until, self.time);
            }
            let next = if is_ahead(time, self.held_until) {
                self.held_until
            } else {
                time
            };
            self.moved(next)?;
        }
        Ok(())
    }

    /// Moves all members to a time, under their current inputs.
    fn moved(&mut self, next: f64) -> Result<(), MemberError<B::State>> {
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
        match &mut self.lost {
            None => {
                let before = ensemble.states.clone();
                let lost = self.method.moved(ensemble, times, limits, shown);
                if let Some(first) = lost.into_iter().next() {
                    ensemble.states = before;
                    return Err(first);
                }
            }
            Some(all) => {
                for one in self.method.moved(ensemble, times, limits, shown) {
                    if all.iter().all(|known| known.index != one.index) {
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
    pub(super) fn seek_with_each(mut self) -> Vec<MemberError<B::State>> {
        self.lost = Some(Vec::new());
        // an error of all members is recorded for each
        let _ = self.seek(self.end);
        let mut lost = self.lost.unwrap_or_default();
        lost.sort_by_key(|one| one.index);
        lost
    }

    /// The error that ended all motions, for the first member, if there is one.
    fn ended(
        &mut self,
        error: impl Fn(B::State) -> IntegrationError<B::State>,
    ) -> MemberError<B::State> {
        if let Some(lost) = &mut self.lost {
            let all = self.ensemble.states.iter().enumerate();
            let late = all.filter(|(index, _)| lost.iter().all(|known| known.index != *index));
            let late = late.map(|(index, state)| MemberError {
                index,
                error: error(state),
            });
            let late: Vec<_> = late.collect();
            lost.extend(late);
        }
        at_first(error(self.ensemble.state(0)))
    }
}

/// An error of all members is attributed to the first.
fn at_first<S>(error: IntegrationError<S>) -> MemberError<S> {
    MemberError { index: 0, error }
}

/// The states of all members at equal intervals: see
/// [`EnsembleIntegration::samples`](super::EnsembleIntegration::samples).
#[derive(Debug)]
pub struct EnsembleSamples<'e, B: Generic, M, C> {
    course: EnsembleCourse<'e, B, M, C>,
    /// None if the period is invalid.
    instants: Option<Instants>,
    period: f64,
}

impl<'e, B: Generic, M, C> EnsembleSamples<'e, B, M, C> {
    pub(super) fn new(course: EnsembleCourse<'e, B, M, C>, period: f64) -> Self {
        Self {
            instants: Instants::new(course.time, course.end, period),
            course,
            period,
        }
    }
}

impl<B: Generic, M: Moves<B>, C: EnsembleControl<B>> Iterator for EnsembleSamples<'_, B, M, C> {
    type Item = Result<Sample<Blocks<B::State>>, MemberError<B::State>>;

    fn next(&mut self) -> Option<Self::Item> {
        let course = &mut self.course;
        let Some(instants) = &mut self.instants else {
            self.instants = Some(Instants::NONE);
            let times = course.time..course.end;
            let state = course.ensemble.states.iter().next()?;
            let error = IntegrationError::uncountable(self.period, times, state);
            return Some(Err(at_first(error)));
        };
        let time = instants.next()?;
        let reached = course.seek(time);
        if reached.is_err() {
            *instants = Instants::NONE;
        }
        Some(reached.map(|()| Sample {
            time,
            state: course.ensemble.states.clone(),
        }))
    }
}
