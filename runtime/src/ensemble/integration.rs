//! The settings of an integration of all members, and its results.

use alloc::vec::Vec;
use core::borrow::Borrow;

use super::course::{AsGiven, EnsembleControl, EnsembleCourse, EnsembleSamples};
#[cfg(doc)]
use super::moves::OneByOne;
use super::moves::{EnsembleError, MemberError, Moves, Together};
use super::plan::Limits;
use super::{Blocks, Ensemble};
use crate::bodies::columns::Generic;
#[cfg(doc)]
use crate::integrate::{DormandPrince, Fixed, Verner};
use crate::integrate::{Integrate, InvalidSetting, Method as _, Sampled, TOLERANCE, Tolerant};

/// An integration of all members, like [`Integration`](crate::integrate::Integration) for one
/// body. All settings are checked before anything moves, even if there are no members.
///
/// ```
/// use newton_euler::integrate::{DormandPrince8, Fixed, Sample};
/// use newton_euler::{ensemble::Ensemble, prelude::*};
///
/// rigid_body!(Handle::<T> {
///     motion: rotation,
///     inertia: principal(1, 2, 3)[kg * m ^ 2],
/// });
///
/// let thrown = |i: u32| Rotation {
///     angular_velocity: [0.01, 1.0, 0.001 * f64::from(i)].into(),
///     ..Rotation::default()
/// };
/// let mut handles = Ensemble::new(&Handle::default(), (0..100).map(thrown));
///
/// // several in a register, in steps of equal length;
/// // or each with its own steps, as long as the tolerance permits
/// handles.integrate().method(Fixed { method: DormandPrince8, step: 0.25 }).to(10.0)?;
/// handles.integrate().starting_at(10.0).tolerance(1e-12).to(20.0)?;
///
/// let alone = Handle::default().integrate(&thrown(70)).tolerance(1e-12).to(20.0)?;
/// assert!((handles.state(70).angular_velocity - alone.angular_velocity).norm() < 1e-6);
///
/// // the states of all, every tenth of a second
/// for sample in handles.integrate().starting_at(20.0).samples(21.0, 0.1) {
///     let Sample { time, state: states } = sample?;
///     println!("{time} s: {}", states.get(70).angular_velocity);
/// }
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[must_use = "nothing moves until an end is given"]
#[derive(Debug)]
pub struct EnsembleIntegration<'e, B: Generic, M, C> {
    pub(super) ensemble: &'e mut Ensemble<B>,
    pub(super) start: f64,
    pub(super) method: M,
    /// The tolerance given last, whatever the method.
    tolerance: f64,
    pub(super) limits: Limits,
    control: C,
    #[cfg(feature = "progress")]
    shows_progress: bool,
}

impl<B: Generic + Integrate<Best: Together<B>>> Ensemble<B> {
    /// Integrates the motion of all members. By default it starts at time zero, under the current
    /// inputs, each member with its own steps; in closed form if there is one
    /// ([`Integrate::Best`]), otherwise by [`Verner`] in lanes. [`EnsembleIntegration`] changes
    /// these settings.
    pub fn integrate(
        &mut self,
    ) -> EnsembleIntegration<'_, B, <B::Best as Together<B>>::Moves, AsGiven> {
        EnsembleIntegration {
            ensemble: self,
            start: 0.0,
            method: Tolerant::with_tolerance(TOLERANCE),
            tolerance: TOLERANCE,
            control: AsGiven,
            limits: Limits {
                max_step: f64::INFINITY,
                breaks: Vec::new(),
                held: 0.0..0.0,
                end: 0.0,
                forwards: true,
            },
            #[cfg(feature = "progress")]
            shows_progress: true,
        }
    }
}

impl<'e, B: Generic, M, C> EnsembleIntegration<'e, B, M, C> {
    /// Begins at this time \[s\] instead of zero.
    pub fn starting_at(self, time: f64) -> Self {
        Self {
            start: time,
            ..self
        }
    }

    /// Sets the tolerance: see [`Tolerant::with_tolerance`].
    pub fn tolerance(self, tolerance: f64) -> Self
    where
        M: Tolerant,
    {
        let method = M::with_tolerance(tolerance);
        Self {
            method,
            tolerance,
            ..self
        }
    }

    /// Uses another method: [`Verner`], [`DormandPrince`] and [`Fixed`] in lanes, or [`OneByOne`]
    /// with any method.
    pub fn method<N>(self, method: N) -> EnsembleIntegration<'e, B, N, C> {
        EnsembleIntegration {
            ensemble: self.ensemble,
            start: self.start,
            method,
            tolerance: self.tolerance,
            control: self.control,
            limits: self.limits,
            #[cfg(feature = "progress")]
            shows_progress: self.shows_progress,
        }
    }

    /// Limits the length of steps \[s\]: see
    /// [`Integration::max_step`](crate::integrate::Integration::max_step).
    pub fn max_step(mut self, max_step: f64) -> Self {
        self.limits.max_step = max_step;
        self
    }

    /// Ends steps of all members at these times \[s\] as well: see
    /// [`Integration::breaks`](crate::integrate::Integration::breaks). Conditions on time with
    /// parameters of a member end its steps in any case, and do not affect
    /// others.
    pub fn breaks(mut self, times: impl IntoIterator<Item: Borrow<f64>>) -> Self {
        let times = times.into_iter();
        self.limits.breaks = times.map(|time| *time.borrow()).collect();
        self
    }

    /// Sets the same input for every member, held from the start to the end. The members keep it.
    /// Without it, each has its own of [`Ensemble::inputs`].
    pub fn input(self, input: &B::Input) -> EnsembleIntegration<'e, B, M, AsGiven> {
        let members = self.ensemble.len();
        *self.ensemble.inputs_mut() = Blocks::repeat(input, members);
        EnsembleIntegration {
            ensemble: self.ensemble,
            start: self.start,
            method: self.method,
            tolerance: self.tolerance,
            limits: self.limits,
            control: AsGiven,
            #[cfg(feature = "progress")]
            shows_progress: self.shows_progress,
        }
    }

    /// Takes inputs from a function of time, member and state, called at the start and after every
    /// period \[s\], each held until the next (zero-order hold), like a digital controller per
    /// member. The members keep their last inputs. The motion of each member is kept between calls,
    /// in the memory of three states or more. [`OneByOne`] also keeps the workspace of its method,
    /// tens of kB for series.
    pub fn control<F>(self, period: f64, function: F) -> EnsembleIntegration<'e, B, M, Sampled<F>>
    where
        F: FnMut(f64, usize, &B::State) -> B::Input,
    {
        EnsembleIntegration {
            ensemble: self.ensemble,
            start: self.start,
            method: self.method,
            tolerance: self.tolerance,
            limits: self.limits,
            control: Sampled::new(period, function),
            #[cfg(feature = "progress")]
            shows_progress: self.shows_progress,
        }
    }

    /// Shows no progress bar. By default, a motion that takes longer than a second shows one on
    /// standard error, with the remaining time, if standard error is a terminal.
    #[cfg(feature = "progress")]
    pub fn quiet(self) -> Self {
        Self {
            shows_progress: false,
            ..self
        }
    }

    /// Moves all members to this time \[s\]: not a duration, but the time of the end.
    ///
    /// # Errors
    /// [`EnsembleError`], if a setting is impossible, or with a member that does not reach the end;
    /// the ensemble keeps its states from the last change of inputs.
    pub fn to(self, end: f64) -> Result<(), EnsembleError<B::State>>
    where
        M: Moves<B>,
        C: EnsembleControl<B>,
    {
        self.course(end).seek(end)
    }

    /// Moves the members that can reach the end \[s\], and returns the errors of the others, in
    /// order. Members that fail keep their last valid states, and do not delay the others. A
    /// controller is called for them as well.
    ///
    /// # Errors
    /// [`InvalidSetting`], if a setting is impossible: no member moves.
    pub fn each_to(self, end: f64) -> Result<Vec<MemberError<B::State>>, InvalidSetting>
    where
        M: Moves<B>,
        C: EnsembleControl<B>,
    {
        self.course(end).seek_with_each()
    }

    /// `samples(end, period)`: the states of all members at the start and after every period \[s\],
    /// up to the end \[s\]. The end is the last sample if it is a whole number of periods away. There
    /// is none beyond the end: if the period is longer than the motion, the start is the only
    /// sample. The ensemble itself moves along, and ends at the last sample. Sampling does not change
    /// the steps. An error is the last item.
    pub fn samples(self, end: f64, period: f64) -> EnsembleSamples<'e, B, M, C>
    where
        M: Moves<B>,
        C: EnsembleControl<B>,
    {
        EnsembleSamples::new(self.course(end), period)
    }

    /// Checks the settings, which are those of all members.
    pub(super) fn checked(&self, end: f64, period: Option<f64>) -> Result<(), InvalidSetting>
    where
        M: Moves<B>,
    {
        let (times, method) = (self.start..end, self.method.alone().setting());
        let pace = self.limits.pace();
        pace.check(&times, self.tolerance, method, period)
    }

    fn course(self, end: f64) -> EnsembleCourse<'e, B, M, C>
    where
        M: Moves<B>,
        C: EnsembleControl<B>,
    {
        let times = self.start..end;
        let checked = self.checked(end, self.control.period());
        #[cfg(feature = "progress")]
        let bar = self
            .shows_progress
            .then(|| crate::integrate::Bar::new(times.clone()));
        let (method, control, limits) = (self.method, self.control, self.limits);
        let course = EnsembleCourse::new(self.ensemble, (method, control), limits, times, checked);
        #[cfg(feature = "progress")]
        let course = course.shown_on(bar);
        course
    }
}
