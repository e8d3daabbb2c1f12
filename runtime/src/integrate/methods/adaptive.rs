//! Steps as long as the tolerance permits, by DOP853.

use core::fmt;

use super::runge_kutta::{DormandPrince8, runge_kutta_step};
use crate::bodies::body::RigidBody;
use crate::bodies::switches::Stretch;
use crate::integrate::steps::chatter::{LOOK, Watch};
use crate::integrate::steps::equations::{Equations, Rates};
use crate::integrate::steps::error::IntegrationError;
use crate::integrate::steps::method::{Method, Run, Tolerant};
use crate::integrate::steps::point::Point;
use crate::integrate::steps::size::{finest, relative_size, root};
use crate::integrate::steps::stretch::Within;
use crate::state::Coordinates;

/// How much of the step that the last error permits is taken, and how much a step may change.
const SAFETY: f64 = 0.9;
pub(super) const SHRINK: f64 = 1.0 / 3.0;
const GROW: f64 = 6.0;

/// DOP853: [`DormandPrince8`] with steps as long as the tolerance permits.
///
/// For every body, smooth or not: of loads with `if`, `abs` and the like it takes short steps where
/// they switch, as far as it sees them, and ends them at the [conditions on
/// time](crate::rigid_body#conditions-on-time). A smooth load that acts for a short time only,
/// after a long time of rest, may lie between the twelve places where a step looks: say where, by
/// [`breaks`](crate::integrate::Integration::breaks) or
/// [`max_step`](crate::integrate::Integration::max_step). A motion that is driven back and forth
/// over a jump ends with [`IntegrationError::StepTooSmall`]. Between the ends of a step, states are
/// those of a shorter step from its start, where nothing switches of the same accuracy as the end.
///
/// E. Hairer, S. P. Nørsett, G. Wanner, Solving Ordinary Differential Equations I, 2nd edition,
/// 1993, II.4, II.5, II.10: the error is estimated from differences to methods of orders 5 and 3,
/// `e₅² / √(e₅² + e₃²/100)`, and the next step is 0.9 (tolerance / error)^(1/8) times as long.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DormandPrince {
    /// How large the error of a step may be: see [`Tolerant`].
    pub tolerance: f64,
}

impl Tolerant for DormandPrince {
    fn with_tolerance(tolerance: f64) -> Self {
        Self { tolerance }
    }
}

impl<B: RigidBody<Scalar = f64, State: Coordinates>> Method<B> for DormandPrince {
    type Run<'b>
        = AdaptiveRun<'b, B>
    where
        B: 'b;

    fn start<'b>(self, body: &'b B, time: f64, state: &B::State) -> AdaptiveRun<'b, B> {
        let now = Point::new(time, state);
        AdaptiveRun {
            within: Within::new(body, time),
            tolerance: finest(self.tolerance),
            before: (time, now.coordinates),
            now,
            next: None,
            watch: Watch::every(LOOK),
        }
    }
}

/// A motion in steps as long as its tolerance permits.
pub struct AdaptiveRun<'b, B: RigidBody<Scalar = f64, State: Coordinates>> {
    within: Within<'b, B>,
    tolerance: f64,
    now: Point<B::State>,
    /// Where the step taken last began.
    before: (f64, <B::State as Coordinates>::Array),
    /// How long the next step may be.
    next: Option<f64>,
    watch: Watch,
}

impl<B: RigidBody<Scalar = f64, State: Coordinates>> fmt::Debug for AdaptiveRun<'_, B> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("AdaptiveRun")
            .field("tolerance", &self.tolerance)
            .field("time", &self.now.time)
            .field("next", &self.next)
            .finish_non_exhaustive()
    }
}

impl<B: RigidBody<Scalar = f64, State: Coordinates>> Run<B> for AdaptiveRun<'_, B> {
    const PLACES: usize = 4;

    fn body(&self) -> &B {
        self.within.body
    }

    fn time(&self) -> f64 {
        self.now.time
    }

    fn state(&self) -> B::State {
        self.now.state()
    }

    fn advance(&mut self, end: f64, input: &B::Input) -> Result<(), IntegrationError<B::State>> {
        let equations = Equations {
            body: &self.within,
            input,
        };
        if self.watch.is_due() {
            let rest = self.now.rest(end);
            let chatters = self
                .watch
                .chatters(&equations, &self.now, rest, self.tolerance);
            if let Some(step) = chatters {
                return Err(self.now.step_too_small(step));
            }
        }
        self.before = (self.now.time, self.now.coordinates);
        let (time, rest) = (self.now.time, self.now.rest(end));
        let mut permitted = match self.next {
            Some(next) => next,
            None => first(&equations, &self.now, rest, self.tolerance),
        };
        let (mut longest, mut error) = (GROW, 0.0_f64);
        loop {
            let is_last = permitted >= rest.abs();
            let step = if is_last {
                rest
            } else {
                permitted.copysign(rest)
            };
            if step.is_nan() {
                return Err(self.now.not_finite());
            }
            if (time + step) - time == 0.0 && !is_last {
                return Err(if error.is_nan() {
                    self.now.not_finite()
                } else {
                    self.now.step_too_small(step)
                });
            }
            let (change, tried) = attempt(&equations, time, &self.now.coordinates, step);
            error = tried;
            let factor = shrunk(self.tolerance, error).min(longest);
            if error <= self.tolerance {
                let next = step.abs() * factor;
                // a step cut short at the end says little about the next
                self.next = Some(if is_last { next.max(permitted) } else { next });
                let is_finite = if is_last {
                    self.now.arrive(change, end)
                } else {
                    self.now.advance(change, step)
                };
                return if is_finite {
                    self.watch.saw(step, is_last);
                    Ok(())
                } else {
                    Err(self.now.not_finite())
                };
            }
            permitted = step.abs() * factor;
            longest = 1.0;
        }
    }

    fn heads_for(&mut self, end: f64) {
        self.watch.heads_for(end);
    }

    fn enter(&mut self, stretch: Stretch) {
        self.within.enter(stretch);
    }

    fn replace(&mut self, state: &B::State) {
        self.now.replace(state);
    }

    fn within(&self, time: f64, input: &B::Input) -> B::State {
        let (start, coordinates) = &self.before;
        let before = B::State::from_coordinates(coordinates);
        runge_kutta_step::<DormandPrince8, _>(&self.within, *start, &before, input, time - start)
    }
}

/// What a step changes, and its error beside the state: not a number, where a stage is out of the
/// domain, if only in one component.
#[inline(always)]
pub(super) fn attempt<E: Rates<State: Coordinates<Scalar = f64>>>(
    equations: &E,
    time: f64,
    coordinates: &<E::State as Coordinates>::Array,
    step: f64,
) -> (<E::State as Coordinates>::Array, f64) {
    let [change, fifth, third] = DormandPrince8::sums(equations, time, coordinates, step);
    if fifth.as_ref().iter().any(|part| part.is_nan()) {
        return (change, f64::NAN);
    }
    let [fifth, third] = [fifth, third].map(|part| relative_size::<E::State>(&part, coordinates));
    let squares = fifth * fifth + 0.01 * third * third;
    let error = if fifth == 0.0 {
        0.0
    } else if fifth + third == f64::INFINITY {
        f64::INFINITY
    } else if squares.is_normal() {
        fifth * (fifth / libm::sqrt(squares))
    } else {
        // squares beyond the range of numbers
        fifth * (fifth / libm::hypot(fifth, 0.1 * third))
    };
    (change, error)
}

/// The share of a step that its error permits, of no number the least.
#[inline(always)]
pub(super) fn shrunk(tolerance: f64, error: f64) -> f64 {
    let share = SAFETY * root(tolerance, error, 8);
    if share >= SHRINK { share } else { SHRINK }
}

/// A first step, from the sizes of the first and second derivatives (Hairer and others, II.4).
pub(super) fn first<E: Rates<State: Coordinates<Scalar = f64>>>(
    equations: &E,
    now: &Point<E::State>,
    rest: f64,
    tolerance: f64,
) -> f64 {
    let (time, coordinates) = (now.time, now.coordinates);
    let size = |change| relative_size::<E::State>(change, &coordinates);
    let rates = equations.rates(time, &coordinates);
    let speed = size(&rates);
    let short = (if speed > 0.0 { 1e-4 / speed } else { 1e-6 })
        .min(rest.abs())
        .copysign(rest);
    let mut there = coordinates;
    for (coordinate, rate) in there.as_mut().iter_mut().zip(rates.as_ref()) {
        *coordinate += short * rate;
    }
    let mut difference = equations.rates(time + short, &there);
    for (difference, rate) in difference.as_mut().iter_mut().zip(rates.as_ref()) {
        *difference = (*difference - rate) / short;
    }
    let curvature = libm::sqrt(size(&difference));
    let pace = if speed >= curvature { speed } else { curvature };
    // not everything at once, of what seems to be at rest
    let longest = rest.abs() / 16.0;
    if pace > 0.0 {
        longest.min(root(tolerance, 1.0, 8) / pace)
    } else if pace == 0.0 {
        longest
    } else {
        pace
    }
}
