//! The settings of an integration, and its results.

use core::borrow::Borrow;
use core::fmt;
use core::iter::Empty;

use super::Course;
use super::control::{Control, Held, Sampled};
use super::observed::{Events, Samples, Steps};
use super::pace::Pace;
use crate::bodies::body::RigidBody;
use crate::integrate::steps::error::IntegrationError;
use crate::integrate::steps::method::{Method, Tolerant};
use crate::integrate::steps::setting::check_state;
use crate::state::Coordinates;

/// The default bound of the error of a step.
pub(crate) const TOLERANCE: f64 = 1e-9;

/// A body whose motion can be integrated, with the best method for it.
///
/// [`rigid_body!`](crate::rigid_body) implements it with one of these methods:
///
/// - with `outputs: [flow]`, the [`ClosedForm`](crate::integrate::ClosedForm);
/// - with `outputs: [taylor]`, [`TaylorSeries`](crate::integrate::TaylorSeries) if they are faster
///   than Runge-Kutta steps, or [`SeriesBelow`](crate::integrate::SeriesBelow) if that depends on
///   the tolerance;
/// - otherwise a [`RungeKuttaPair`](crate::integrate::RungeKuttaPair);
/// - under constraints, [`Projected`](crate::integrate::Projected) around one of these.
///
/// An implementation by hand is one line:
///
/// ```
/// use newton_euler::{integrate::RungeKuttaPair, prelude::*};
/// use newton_euler::nalgebra::Vector2;
///
/// struct Thrown { drag: f64 }
///
/// impl RigidBody for Thrown {
///     type Scalar = f64;
///     type State = PlanarTranslation;
///     type Input = ();
///
///     fn acceleration(&self, _: f64, state: &PlanarTranslation, (): &()) -> Vector2<f64> {
///         Vector2::new(0.0, -9.8) - state.velocity * (self.drag * state.velocity.norm())
///     }
/// }
///
/// impl Integrate for Thrown {
///     type Best = RungeKuttaPair;
/// }
///
/// let start = PlanarTranslation { velocity: [20.0, 20.0].into(), ..PlanarTranslation::default() };
/// let thrown = Thrown { drag: 0.01 };
/// let mut ground = thrown.integrate(&start).events(10.0, |_, state| state.position.y);
/// let landing = ground.next().expect("it falls")?;
/// assert!((3.0..4.0).contains(&landing.time) && !landing.rises);
/// # Ok::<(), newton_euler::integrate::IntegrationError<PlanarTranslation>>(())
/// ```
pub trait Integrate: RigidBody<Scalar = f64, State: Coordinates> + Sized {
    /// The best method for it.
    type Best: Method<Self> + Tolerant;

    /// Integrates the motion from a state. By default it starts at time zero, with errors of 1e-9
    /// per step, by [`Self::Best`], and all inputs are zero until [`input`](Integration::input) or
    /// [`control`](Integration::control) gives them. [`Integration`] changes these settings.
    fn integrate(
        &self,
        state: &Self::State,
    ) -> Integration<'_, Self, Self::Best, Held<Self::Input>> {
        Integration {
            body: self,
            start: 0.0,
            state: state.clone(),
            method: Self::Best::with_tolerance(TOLERANCE),
            tolerance: TOLERANCE,
            control: Held(Self::Input::default()),
            pace: Pace {
                max_step: f64::INFINITY,
                breaks: core::iter::empty(),
            },
            #[cfg(feature = "progress")]
            shows_progress: true,
        }
    }
}

/// An integration to be run.
///
/// First set its parameters ([`starting_at`](Self::starting_at), [`tolerance`](Self::tolerance),
/// [`method`](Self::method), [`input`](Self::input), [`control`](Self::control)), then choose the
/// result: the state at the end ([`to`](Self::to)), or an iterator of [`samples`](Self::samples),
/// of [`steps`](Self::steps), of [`events`](Self::events). Time may run backwards. A motion that
/// cannot reach its end gives an [`IntegrationError`] with the last good state; an iterator returns
/// it as its last item.
///
/// All settings are checked before anything moves, whatever the method, also if the start is the
/// end. The error of an impossible one is [`IntegrationError::InvalidSetting`].
///
/// ```
/// use newton_euler::prelude::*;
///
/// rigid_body!(Elevator {
///     motion: translation,
///     inputs: [pull[N]],
///     mass: 800[kg],
///     fields: [weight = mass * world(0, 0, -9.80665[m / s ^ 2])],
///     forces: [rope = world(0, 0, pull)],
///     outputs: [taylor],
/// });
///
/// // a controller that runs a hundred times a second, and drives to 12 m
/// let pull = |_time, state: &Translation| {
///     let (high, rises) = (state.position.z, state.velocity.z);
///     ElevatorInput { pull: 800.0 * (9.80665 + (12.0 - high) - 2.0 * rises) }
/// };
/// let (elevator, ground) = (Elevator::default(), Translation::default());
/// let motion = elevator.integrate(&ground).control(0.01, pull);
/// for sample in motion.samples(15.0, 1.0) {
///     let Sample { time, state } = sample?;
///     println!("{time} s: {} m", state.position.z);
/// }
/// let end = elevator.integrate(&ground).control(0.01, pull).tolerance(1e-12).to(15.0)?;
/// assert!((end.position.z - 12.0).abs() < 1e-4);
/// # Ok::<(), newton_euler::integrate::IntegrationError<Translation>>(())
/// ```
#[must_use = "nothing moves until an end is given"]
pub struct Integration<'b, B: RigidBody, M, C, L = Empty<f64>> {
    body: &'b B,
    start: f64,
    state: B::State,
    method: M,
    /// The tolerance given last, whatever the method.
    tolerance: f64,
    control: C,
    pace: Pace<L>,
    #[cfg(feature = "progress")]
    shows_progress: bool,
}

impl<B: RigidBody, M: fmt::Debug, C, L> fmt::Debug for Integration<'_, B, M, C, L> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Integration")
            .field("start", &self.start)
            .field("method", &self.method)
            .finish_non_exhaustive()
    }
}

impl<'b, B, M, C, L> Integration<'b, B, M, C, L>
where
    B: RigidBody<Scalar = f64, State: Coordinates>,
    M: Method<B>,
    C: Control<B::State, B::Input>,
    L: Iterator<Item: Borrow<f64>> + Clone,
{
    /// Begins at this time \[s\] instead of zero. The end is a time on the same clock:
    /// `starting_at(2.0).to(5.0)` moves for 3 s.
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

    /// Uses another method, such as [`Fixed`](crate::integrate::Fixed).
    pub fn method<N: Method<B>>(self, method: N) -> Integration<'b, B, N, C, L> {
        let Self { control, pace, .. } = self;
        Integration {
            body: self.body,
            start: self.start,
            state: self.state,
            method,
            tolerance: self.tolerance,
            control,
            pace,
            #[cfg(feature = "progress")]
            shows_progress: self.shows_progress,
        }
    }

    /// Limits the length of steps \[s\], for short events that a longer step could miss.
    ///
    /// # Errors
    /// By the integration: [`IntegrationError::InvalidSetting`] if the limit is not positive, or
    /// lost in the rounding of time.
    pub fn max_step(self, max_step: f64) -> Self {
        let Pace { breaks, .. } = self.pace;
        Self {
            pace: Pace { max_step, breaks },
            ..self
        }
    }

    /// Ends steps at these times \[s\] as well, in any order: times at which a load changes or
    /// begins, if they are not known otherwise. The conditions on `t` of a description are known
    /// ([`RigidBody::switches`]). Times outside the motion are skipped. At each time the whole list
    /// is searched, so the cost grows with the square of its length. Each step uses the equations
    /// of its own side, so loads may also jump there.
    ///
    /// # Errors
    /// By the integration: [`IntegrationError::InvalidSetting`] if one of them is infinite or NaN.
    ///
    /// ```
    /// use newton_euler::prelude::*;
    ///
    /// rigid_body!(Bell {
    ///     motion: planar_translation,
    ///     mass: 2[kg],
    ///     forces: [blow = world(8[N] * (-((t - 40[s]) / 0.01[s]).powi(2)).exp(), 0)],
    /// });
    ///
    /// let (bell, rest) = (Bell::default(), PlanarTranslation::default());
    /// let end = bell.integrate(&rest).breaks([39.9, 40.0, 40.1]).to(60.0)?;
    /// let momentum = 8.0 * 0.01 * std::f64::consts::PI.sqrt();
    /// assert!((2.0 * end.velocity.x - momentum).abs() < 1e-8);
    /// # Ok::<(), newton_euler::integrate::IntegrationError<PlanarTranslation>>(())
    /// ```
    pub fn breaks<N>(self, times: N) -> Integration<'b, B, M, C, N::IntoIter>
    where
        N: IntoIterator<Item: Borrow<f64>, IntoIter: Clone>,
    {
        let pace = Pace {
            max_step: self.pace.max_step,
            breaks: times.into_iter(),
        };
        Integration {
            body: self.body,
            start: self.start,
            state: self.state,
            method: self.method,
            tolerance: self.tolerance,
            control: self.control,
            pace,
            #[cfg(feature = "progress")]
            shows_progress: self.shows_progress,
        }
    }

    /// Sets an input that is held from the start to the end. Without it, all inputs are zero.
    pub fn input(self, input: B::Input) -> Integration<'b, B, M, Held<B::Input>, L> {
        self.under(Held(input))
    }

    /// Takes inputs from a function of time and state, called at the start and after every period
    /// \[s\], each held until the next (zero-order hold), like a digital controller.
    pub fn control<F: FnMut(f64, &B::State) -> B::Input>(
        self,
        period: f64,
        function: F,
    ) -> Integration<'b, B, M, Sampled<F>, L> {
        self.under(Sampled::new(period, function))
    }

    fn under<D>(self, control: D) -> Integration<'b, B, M, D, L> {
        Integration {
            body: self.body,
            start: self.start,
            state: self.state,
            method: self.method,
            tolerance: self.tolerance,
            control,
            pace: self.pace,
            #[cfg(feature = "progress")]
            shows_progress: self.shows_progress,
        }
    }

    /// Shows no bar. By default, a motion that takes longer than a second shows one on standard
    /// error, with its progress and the remaining time, if standard error is a terminal.
    #[cfg(feature = "progress")]
    pub fn quiet(self) -> Self {
        Self {
            shows_progress: false,
            ..self
        }
    }

    /// The state at this time \[s\]: not a duration, but the time of the end, which differs from it
    /// after [`starting_at`](Self::starting_at).
    ///
    /// # Errors
    /// [`IntegrationError`], if a setting is impossible, if the motion leaves the range of numbers,
    /// or if it chatters: it oscillates about a place where its equations jump, in very short
    /// steps, as under friction along `velocity.normalize()` at rest. Chattering is detected after
    /// some hundred thousand such steps, if millions are ahead. End such a motion by an
    /// [event](Self::events), or write friction that is smooth: `(v / eps).tanh()`.
    pub fn to(self, end: f64) -> Result<B::State, IntegrationError<B::State>> {
        let mut course = self.course(end);
        course.seek(end)?;
        Ok(course.state())
    }

    /// `samples(end, period)`: the states at the start and after every period \[s\], up to the end
    /// \[s\]. The end is the last sample if it is a whole number of periods away. There is none beyond
    /// the end: if the period is longer than the motion, the start is the only sample, and nothing
    /// moves. Sampling does not change the steps.
    pub fn samples(self, end: f64, period: f64) -> Samples<'b, M::Run, C, B, L> {
        Samples::new(self.course(end), period)
    }

    /// The state at the end of every step, up to the end \[s\].
    pub fn steps(self, end: f64) -> Steps<'b, M::Run, C, B, L> {
        Steps {
            course: self.course(end),
            is_over: false,
        }
    }

    /// The points where a function of time and state changes its sign, or is exactly zero where it
    /// is evaluated, up to the end \[s\], in both directions, in the order of the motion. A zero at
    /// the start does not count.
    ///
    /// The sign is evaluated at several points of every step. An even number of zeros between two
    /// such points is missed. Zeros are found to the rounding of the function and of
    /// time. A function that stays zero has one event where it becomes zero, and none if it is zero
    /// from the start.
    ///
    /// If the function is NaN, the motion ends with
    /// [`IntegrationError::EventNotANumber`].
    pub fn events<F: Fn(f64, &B::State) -> f64>(
        self,
        end: f64,
        function: F,
    ) -> Events<'b, M::Run, C, B, F, L> {
        Events {
            course: self.course(end),
            function,
            search: None,
            is_over: false,
        }
    }

    fn course(self, end: f64) -> Course<'b, M::Run, C, B, L> {
        #[cfg(feature = "progress")]
        let bar = self
            .shows_progress
            .then(|| super::progress::Bar::new(self.start..end));
        let (times, method, period) = (
            self.start..end,
            self.method.setting(),
            self.control.period(),
        );
        let checked = self.pace.check(&times, self.tolerance, method, period);
        let checked = checked.and_then(|()| check_state(&self.state));
        let start = (self.start, &self.state);
        let course = Course::new(self.body, self.method, self.control, self.pace, start, end);
        Course {
            refused: checked.err(),
            #[cfg(feature = "progress")]
            bar,
            ..course
        }
    }
}
