//! Steps along Taylor series, of any order and with the error that is asked for.
//!
//! À. Jorba, M. Zou, A software package for the numerical integration of ODEs by means of
//! high-order Taylor methods, Experimental Mathematics 14 (2005) 99. The last coefficients tell how
//! far a series holds: the step is the longest of which the last two terms are below the tolerance,
//!
//! ```text
//! step = 0.9 min (tolerance / |c_k|)^(1/k),   k = N - 1, N - 2
//! ```
//!
//! The last coefficients know nothing of what begins later than they see: a wall, a motor that is
//! switched on, a root that changes its sign. So no step is taken unseen: at its end the derivative
//! of the polynomial is held against the rates that the equations give there; in a step that is
//! half as long again as those before it, in sixteen places. A step that disagrees by more than the
//! tolerance is halved, and no later step passes by the time at which it disagreed. Where a motion
//! has no series (a norm, root or power at zero), or steps shrink to an eighth since such a place
//! is near, a step of DOP853 goes over it, with a polynomial of degree 7 that is held against the
//! equations alike. What acts for so short a time that no such place falls on it is not seen by any
//! test of this kind: say it by [`max_step`](crate::integrate::Integration::max_step),
//! [`breaks`](crate::integrate::Integration::breaks) or a condition on time.
//!
//! A symmetric body is followed in [`Axes`] that do not spin with it, from the start of a motion to
//! its end; only what is handed out is turned back, so that this costs the steps nothing and no
//! rounding adds up.
//!
//! What a step adds is summed with compensation, so that over long runs rounding grows with the
//! square root of the number of steps and not with the number.

use core::fmt;

use crate::bodies::switches::Stretch;
use crate::integrate::steps::error::IntegrationError;
use crate::integrate::steps::point::Point;
use crate::integrate::steps::size::{finest, relative_size, root};
use crate::integrate::steps::step::Step;
use crate::integrate::steps::stretch::Within;
use crate::state::Coordinates;
use crate::taylor::{Axes, Taylor, increment};

pub mod crossing;
mod expansions;
mod seen;

use expansions::Expansions;

/// How much of the permitted step is taken: roots are known to a few parts in a hundred.
const SAFETY: f64 = 0.9;
/// A step that is longer than the one before by more than this is looked at twice.
const GROWTH: f64 = 1.5;

/// A motion under way, by series of N coefficients: of order N - 1.
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
    within: Within<'b, B>,
    /// From start to end the coordinates are those in these axes.
    axes: Axes,
    now: Point<B::State>,
    /// How long the last step was that a tolerance permitted.
    length: f64,
    /// How long a step was, of those before, that was looked at throughout.
    looked_at: f64,
    /// A time at which the equations did not agree, and which no step may pass by \[s\].
    doubt: Option<f64>,
    /// A step that is shorter than this may be at a place where the motion is not smooth.
    rough: f64,
    expansions: Expansions<B, N>,
    /// The polynomial of a step over such a place, and whether the last step was one.
    crossing: [<B::State as Coordinates>::Array; crossing::ROWS],
    is_crossing: bool,
    /// Whether each step goes on from where the last one ended.
    goes_on: bool,
}

impl<B: Taylor, const N: usize> fmt::Debug for Motion<'_, B, N> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Motion")
            .field("time", &self.now.time)
            .field("coordinates", &self.now.coordinates)
            .finish_non_exhaustive()
    }
}

impl<'b, B: Taylor, const N: usize> Motion<'b, B, N> {
    /// A motion that begins at a state.
    #[must_use]
    pub fn new(body: &'b B, time: f64, state: &B::State) -> Self {
        // at no time nothing turns
        let axes = if time.is_finite() {
            body.axes(time, state)
        } else {
            Axes::BODY
        };
        Self {
            within: Within::new(body, time),
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
        }
    }

    pub(super) fn body(&self) -> &'b B {
        self.within.body
    }

    pub(super) fn enter(&mut self, stretch: Stretch) {
        self.within.enter(stretch);
        self.renew();
    }

    /// Hears that equations or state are others than the last step saw at its end.
    pub(super) fn renew(&mut self) {
        self.expansions.forget();
    }

    /// Goes on from another state at the same time.
    pub(super) fn replace(&mut self, state: &B::State) {
        self.axes = self.body().axes(self.now.time, state);
        self.now.replace(state);
        self.goes_on = false;
        self.renew();
    }

    /// The time that the motion has come to \[s\].
    #[must_use]
    pub fn time(&self) -> f64 {
        self.now.time
    }

    /// The state that it has come to.
    #[must_use]
    pub fn state(&self) -> B::State {
        self.axes.state(&self.now.coordinates, self.now.time)
    }

    /// Takes the longest step towards `end` \[s\] that `tolerance` permits (as in
    /// [`taylor`](crate::integrate::taylor())), with the input held; none if it is reached.
    ///
    /// # Errors
    /// [`IntegrationError`]; the motion stays where it is.
    pub fn step_towards(
        &mut self,
        end: f64,
        input: &B::Input,
        tolerance: f64,
    ) -> Result<Option<Step<'_, B::State>>, IntegrationError<B::State>> {
        // who steps by hand may give another input each time, if there is any
        let is_held = size_of::<B::Input>() == 0;
        if !is_held {
            self.renew();
        }
        self.advance_towards(end, input, tolerance, is_held)
    }

    /// The same, with the input of the step before, or after [`renew`](Self::renew); `is_held` if
    /// the next step is likely to have it, too.
    pub(super) fn advance_towards(
        &mut self,
        end: f64,
        input: &B::Input,
        tolerance: f64,
        is_held: bool,
    ) -> Result<Option<Step<'_, B::State>>, IntegrationError<B::State>> {
        let rest = self.now.rest(end);
        if rest == 0.0 {
            return Ok(None);
        }
        if rest.is_nan() {
            let (time, state) = (self.now.time, self.state());
            return Err(IntegrationError::not_finite(time, state));
        }
        self.expand(input);
        let (time, tolerance) = (self.now.time, finest(tolerance));
        let end = match self.doubt {
            Some(doubt) if (doubt - time) * rest > 0.0 && (doubt - end) * rest < 0.0 => doubt,
            _ => end,
        };
        let permitted = self.permitted(tolerance);
        let passed = if permitted >= self.rough && permitted > 0.0 {
            None
        } else {
            self.pass(permitted, end, input, tolerance)
        };
        let step = match passed {
            Some(step) => step,
            None => self.follow(permitted, end, input, (tolerance, is_held && self.goes_on))?,
        };
        Ok(Some(self.taken(time, step)))
    }

    /// Takes a step of this length \[s\], with the input held, of whatever error.
    ///
    /// # Errors
    /// [`IntegrationError::NotFinite`]; the motion stays where it is.
    pub fn step(
        &mut self,
        step: f64,
        input: &B::Input,
    ) -> Result<Step<'_, B::State>, IntegrationError<B::State>> {
        let time = self.now.time;
        self.renew();
        self.expand(input);
        self.advance(step)?;
        Ok(self.taken(time, step))
    }

    /// The series from here.
    #[inline(always)]
    fn expand(&mut self, input: &B::Input) {
        self.is_crossing = false;
        self.expansions.expand(&self.within, &self.now, input);
    }

    /// The step that was taken last.
    #[inline(always)]
    pub(super) fn taken(&self, start: f64, length: f64) -> Step<'_, B::State> {
        let coefficients = if self.is_crossing {
            self.crossing.as_slice()
        } else {
            self.expansions.series().coefficients()
        };
        Step::new(start, length, self.axes, coefficients)
    }

    /// The longest step of which the last two terms are below `tolerance`.
    ///
    /// They may vanish, or nearly, where the series goes on: cos t² has every fourth term. A step
    /// that grows is therefore held against the terms before as well, which tell the same radius.
    #[inline(always)]
    fn permitted(&self, tolerance: f64) -> f64 {
        let (last, before) = (
            self.within_order(N - 1, tolerance),
            self.within_order(N - 2, tolerance),
        );
        let step = SAFETY * if last <= before { last } else { before };
        if step > GROWTH * self.length {
            self.within_radius(step, tolerance)
        } else {
            step
        }
    }

    /// The step of which the term of this order is as large as `tolerance`.
    #[inline(always)]
    fn within_order(&self, order: usize, tolerance: f64) -> f64 {
        let size = self.relative(order);
        if size == 0.0 {
            f64::INFINITY
        } else {
            root(tolerance, size, order)
        }
    }

    /// A step, or what the radius of convergence leaves of it by the upper half of the orders.
    #[cold]
    fn within_radius(&self, step: f64, tolerance: f64) -> f64 {
        let share = SAFETY * root(tolerance, 1.0, N - 1);
        let radii = (N / 2..N - 2).filter_map(|order| {
            let size = self.relative(order);
            (size > 0.0 && order > 0).then(|| share / root(size, 1.0, order))
        });
        radii.fold(
            step,
            |step, radius| if radius < step { radius } else { step },
        )
    }

    /// The size of a coefficient beside the state.
    #[inline(always)]
    fn relative(&self, order: usize) -> f64 {
        let coefficients = self.expansions.series().coefficients();
        relative_size::<B::State>(&coefficients[order], &coefficients[0])
    }

    /// Moves on by the series.
    #[inline(always)]
    fn advance(&mut self, step: f64) -> Result<(), IntegrationError<B::State>> {
        let change = increment::<B::State>(self.expansions.series().coefficients(), step);
        if self.now.advance(change, step) {
            return Ok(());
        }
        let (time, state) = (self.now.time, self.state());
        Err(IntegrationError::not_finite(time, state))
    }
}
