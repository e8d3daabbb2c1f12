//! Steps along Taylor series, of any order and with a given error.
//!
//! À. Jorba, M. Zou, A software package for the numerical integration of ODEs by means of
//! high-order Taylor methods, Experimental Mathematics 14 (2005) 99. The last coefficients give the
//! range of a series: the step is the longest whose last two terms are below the tolerance,
//!
//! ```text
//! step = 0.9 min (tolerance / |c_k|)^(1/k),   k = N - 1, N - 2
//! ```
//!
//! The last coefficients do not see later changes: a wall, a motor that is switched on, a root that
//! changes its sign. So every step is checked. At its end the derivative of the polynomial is
//! compared with the rates of the equations; a step at least half as long again as those before it
//! is checked at sixteen points. A step that disagrees by more than the tolerance is halved, and no
//! later step passes the time at which it disagreed. If a motion has no series (a norm, root or
//! power at zero), or steps shrink to an eighth near such a place, a step of DOP853 crosses it,
//! with a polynomial of degree 7 that is checked against the equations in the same way. No such
//! test sees a load so short that no checked point falls on it: state it by
//! [`max_step`](crate::integrate::Integration::max_step),
//! [`breaks`](crate::integrate::Integration::breaks) or a condition on time.
//!
//! A symmetric body is integrated in [`Axes`] that do not spin with it, from the start of a motion
//! to its end. Only output is transformed back, so this costs the steps nothing and
//! adds no accumulated rounding.
//!
//! Increments are summed with compensation, so over long runs rounding grows with the
//! square root of the number of steps instead of the number.

use core::fmt;

use crate::bodies::switches::Stretch;
use crate::integrate::steps::chatter::{LOOK, Watch};
use crate::integrate::steps::error::IntegrationError;
use crate::integrate::steps::point::Point;
use crate::integrate::steps::step::Step;
use crate::state::Coordinates;
use crate::taylor::{Axes, Taylor};

mod advance;
mod checked_steps;
pub mod crossing;
mod expansions;
mod permitted;

use expansions::Expansions;

/// A motion in progress, by series of N coefficients: of order N - 1.
///
/// ```
/// use newton_euler::{integrate::Motion, prelude::*};
///
/// rigid_body!(Stone {
///     motion: translation,
///     mass: 2[kg],
///     forces: [drag = -0.1 * velocity.norm() * velocity],
///     fields: [weight = mass * world(0, 0, -9.80665[m / s ^ 2])],
///     outputs: [taylor],
/// });
///
/// let thrown = Translation { velocity: [8.0, 0.0, 12.0].into(), ..Translation::default() };
/// let stone = Stone::default();
/// let mut flight = Motion::<_, 17>::new(&stone, 0.0, &thrown);
/// let mut landing = None;
/// while let Some(step) = flight.step_towards(10.0, &(), 1e-10)? {
///     // the motion between the ends of the step, and where it crosses the ground
///     if let Some(event) = step.zeros(|_, stone| stone.position.z).next() {
///         landing = Some(event?.time);
///         break;
///     }
/// }
/// assert!((1.9..24.0 / 9.80665).contains(&landing.unwrap())); // sooner than without drag
/// # Ok::<(), newton_euler::integrate::IntegrationError<Translation>>(())
/// ```
pub struct Motion<'b, B: Taylor, const N: usize> {
    body: &'b B,
    along: Along<B, N>,
}

impl<B: Taylor, const N: usize> fmt::Debug for Motion<'_, B, N> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Motion")
            .field("time", &self.along.now.time)
            .field("coordinates", &self.along.now.coordinates)
            .finish_non_exhaustive()
    }
}

impl<'b, B: Taylor, const N: usize> Motion<'b, B, N> {
    /// A motion that begins at a state.
    #[must_use]
    pub fn new(body: &'b B, time: f64, state: &B::State) -> Self {
        let along = Along::new(body, time, state);
        Self { body, along }
    }

    /// The current time \[s\].
    #[must_use]
    pub fn time(&self) -> f64 {
        self.along.now.time
    }

    /// The current state.
    #[must_use]
    pub fn state(&self) -> B::State {
        self.along.state()
    }

    /// Takes the longest step towards `end` \[s\] that `tolerance` permits (as in
    /// [`taylor`](crate::integrate::taylor())), with the given input from here on; none if
    /// the end is reached.
    ///
    /// # Errors
    /// [`IntegrationError`]; the motion stays where it is.
    pub fn step_towards(
        &mut self,
        end: f64,
        input: &B::Input,
        tolerance: f64,
    ) -> Result<Option<Step<'_, B::State>>, IntegrationError<B::State>> {
        // a caller that steps by hand may give another input each time, if there is any
        let is_held = size_of::<B::Input>() == 0;
        if !is_held {
            self.along.take_input();
        }
        self.along
            .advance_towards(self.body, end, input, (tolerance, is_held))
    }

    /// Takes a step of this length \[s\], with the given input from here on, whatever its
    /// error.
    ///
    /// # Errors
    /// [`IntegrationError::NotFinite`]; the motion stays where it is.
    pub fn step(
        &mut self,
        step: f64,
        input: &B::Input,
    ) -> Result<Step<'_, B::State>, IntegrationError<B::State>> {
        self.along.take_input();
        self.along.advance_by(self.body, step, input)
    }
}

/// A motion along its series, apart from the body.
pub(super) struct Along<B: Taylor, const N: usize> {
    stretch: Stretch,
    /// The axes of the coordinates, for the whole motion.
    axes: Axes,
    now: Point<B::State>,
    /// The length of the last step that a tolerance permitted.
    length: f64,
    /// The length of an earlier step that was checked throughout.
    looked_at: f64,
    /// A time at which the equations disagreed \[s\]; no step may pass it.
    doubt: Option<f64>,
    /// A shorter step than this may be at a place where the motion is not smooth.
    rough: f64,
    expansions: Expansions<B, N>,
    /// The polynomial of a step over such a place; the next field tells whether the last step was
    /// one.
    crossing: [<B::State as Coordinates>::Array; crossing::ROWS],
    is_crossing: bool,
    /// Whether each step continues from the end of the last one.
    goes_on: bool,
    watch: Watch,
}

impl<B: Taylor, const N: usize> Along<B, N> {
    /// A motion that begins at a state.
    pub(super) fn new(body: &B, time: f64, state: &B::State) -> Self {
        // at an invalid time nothing rotates
        let axes = if time.is_finite() {
            body.axes(time, state)
        } else {
            Axes::BODY
        };
        Self {
            stretch: Stretch::since(time),
            axes,
            now: Point::new(time, state),
            length: 0.0,
            looked_at: 0.0,
            doubt: None,
            rough: 0.0,
            expansions: Expansions::default(),
            crossing: [<B::State as Coordinates>::Array::default(); crossing::ROWS],
            is_crossing: false,
            goes_on: true,
            // in a chattering motion, each step costs about four of DOP853
            watch: Watch::every(LOOK / 4),
        }
    }

    pub(super) fn heads_for(&mut self, end: f64) {
        self.watch.heads_for(end);
    }

    pub(super) fn enter(&mut self, stretch: Stretch) {
        self.stretch = stretch;
        self.renew();
    }

    /// Called when equations or state differ from those at the end of the last step.
    pub(super) fn renew(&mut self) {
        self.expansions.forget();
    }

    /// Continues from another state at the same time.
    pub(super) fn replace(&mut self, body: &B, state: &B::State) {
        self.axes = body.axes(self.now.time, state);
        self.now.replace(state);
        self.goes_on = false;
        self.renew();
    }

    /// The current time \[s\].
    pub(super) fn time(&self) -> f64 {
        self.now.time
    }

    /// The current state.
    pub(super) fn state(&self) -> B::State {
        self.axes.state(&self.now.coordinates, self.now.time)
    }

    /// The last step, from its start.
    #[cfg_attr(not(unoptimized), inline(always))]
    pub(super) fn taken(&self, start: f64) -> Step<'_, B::State> {
        let coefficients = if self.is_crossing {
            self.crossing.as_slice()
        } else {
            self.expansions.series().coefficients()
        };
        let times = start..self.now.time;
        Step::new(times, self.axes, coefficients, &self.now.coordinates)
    }
}
