//! Variable steps, as long as the tolerance permits, by pairs of Runge–Kutta methods.

use core::fmt;
use core::marker::PhantomData;

use super::runge_kutta::{DormandPrince8, Embedded, Verner9, number, runge_kutta_step};
use crate::bodies::body::RigidBody;
use crate::bodies::switches::Stretch;
use crate::integrate::steps::chatter::Watch;
use crate::integrate::steps::equations::{Equations, Rates};
use crate::integrate::steps::error::IntegrationError;
use crate::integrate::steps::method::{Method, Run, Tolerant};
use crate::integrate::steps::point::Point;
use crate::integrate::steps::size::{finest, relative_size, root};
use crate::integrate::steps::stretch::Within;
use crate::numbers::scalar::Scalar;
use crate::state::Coordinates;

/// The fraction of the step that the last error permits, and the bounds of its change.
const SAFETY: f64 = 0.9;
pub(super) const SHRINK: f64 = 1.0 / 3.0;
const GROW: f64 = 6.0;

/// DOP853: [`DormandPrince8`] with steps as long as the tolerance permits.
///
/// Suits every body, smooth or not. At the switches of loads with `if`, `abs` and the like it takes
/// short steps, if its stages detect them; it ends steps at [conditions on
/// time](crate::reference::time#conditions-on-time). A smooth load that acts only briefly
/// after a long time of rest may fall between the twelve stages of a step: state its time by
/// [`breaks`](crate::integrate::Integration::breaks) or limit steps by
/// [`max_step`](crate::integrate::Integration::max_step). A motion that is driven back and forth
/// over a jump ends with [`IntegrationError::StepTooSmall`]. States within a step come from
/// a shorter step from its start, and are as accurate as the end if nothing switches.
///
/// E. Hairer, S. P. Nørsett, G. Wanner, Solving Ordinary Differential Equations I, 2nd edition,
/// 1993, II.4, II.5, II.10: the error is estimated from differences to methods of orders 5 and 3,
/// `e₅² / √(e₅² + e₃²/100)`, and the next step is 0.9 (tolerance / error)^(1/8) times as long.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DormandPrince {
    /// The bound of the error of a step: see [`Tolerant`].
    pub tolerance: f64,
}

/// [`Verner9`] with steps as long as the tolerance permits, like [`DormandPrince`].
///
/// The error is estimated from the difference to the method of order 8 of the same pair: J. H.
/// Verner, Numerically optimal Runge–Kutta pairs with interpolants, Numerical Algorithms 53 (2010)
/// 383.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Verner {
    /// The bound of the error of a step: see [`Tolerant`].
    pub tolerance: f64,
}

/// A pair of Runge–Kutta methods with error control.
pub trait Adaptive: Copy + Tolerant + Send + Sync {
    /// The pair.
    type Pair: Embedded;

    /// The bound of the error of a step.
    fn tolerance(&self) -> f64;
}

/// Defines a method that takes the steps of a pair.
macro_rules! adaptive {
    ($name:ident by $pair:ident) => {
        impl Adaptive for $name {
            type Pair = $pair;

            fn tolerance(&self) -> f64 {
                self.tolerance
            }
        }

        impl Tolerant for $name {
            fn with_tolerance(tolerance: f64) -> Self {
                Self { tolerance }
            }
        }

        impl<B: RigidBody<Scalar = f64, State: Coordinates>> Method<B> for $name {
            type Run<'b>
                = AdaptiveRun<'b, B, $pair>
            where
                B: 'b;

            fn start<'b>(self, body: &'b B, time: f64, state: &B::State) -> Self::Run<'b> {
                AdaptiveRun::new(body, time, state, self.tolerance)
            }
        }
    };
}

adaptive!(DormandPrince by DormandPrince8);
adaptive!(Verner by Verner9);

/// A motion in steps as long as its tolerance permits.
pub struct AdaptiveRun<'b, B: RigidBody<Scalar = f64, State: Coordinates>, P = DormandPrince8> {
    within: Within<'b, B>,
    tolerance: f64,
    now: Point<B::State>,
    /// The start of the last step.
    before: (f64, <B::State as Coordinates>::Array),
    lengths: Lengths,
    watch: Watch,
    pair: PhantomData<P>,
}

impl<'b, B: RigidBody<Scalar = f64, State: Coordinates>, P> AdaptiveRun<'b, B, P> {
    fn new(body: &'b B, time: f64, state: &B::State, tolerance: f64) -> Self {
        let now = Point::new(time, state);
        Self {
            within: Within::new(body, time),
            tolerance: finest(tolerance),
            before: (time, now.coordinates),
            now,
            lengths: Lengths::NEW,
            watch: Watch::OF_A_PAIR,
            pair: PhantomData,
        }
    }
}

/// The control of step lengths.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Lengths {
    /// The permitted length of the next step \[s\]; none before the first.
    permitted: Option<f64>,
    /// The largest permitted growth.
    longest: f64,
    /// The error of the last attempt.
    error: f64,
}

impl Lengths {
    pub(crate) const NEW: Self = Self {
        permitted: None,
        longest: GROW,
        error: 0.0,
    };

    pub(crate) fn is_new(&self) -> bool {
        self.permitted.is_none()
    }

    /// Begins with a step \[s\].
    pub(crate) fn begin(&mut self, step: f64) {
        self.permitted = Some(step);
    }

    /// The next step \[s\] for a given remaining time, and whether it covers all of that.
    #[cfg_attr(not(unoptimized), inline(always))]
    pub(crate) fn next(&self, rest: f64) -> (f64, bool) {
        let permitted = self.permitted.unwrap_or(f64::NAN);
        if permitted >= rest.abs() {
            (rest, true)
        } else {
            (permitted.copysign(rest), false)
        }
    }

    /// Whether a step of a pair with this error is accepted; also sets the length of the next
    /// step.
    #[cfg_attr(not(unoptimized), inline(always))]
    pub(crate) fn is_accepted<P: Embedded>(
        &mut self,
        (step, is_last): (f64, bool),
        error: f64,
        tolerance: f64,
    ) -> bool {
        let next = step.abs() * shrunk::<P>(tolerance, error).min(self.longest);
        let is_accepted = error <= tolerance;
        (self.permitted, self.longest, self.error) = if is_accepted {
            // a step cut short at the end says little about the next
            let before = self.permitted.filter(|_| is_last);
            (
                Some(before.map_or(next, |before| next.max(before))),
                GROW,
                0.0,
            )
        } else {
            (Some(next), 1.0, error)
        };
        is_accepted
    }
}

impl<B: RigidBody<Scalar = f64, State: Coordinates>, P> fmt::Debug for AdaptiveRun<'_, B, P> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("AdaptiveRun")
            .field("tolerance", &self.tolerance)
            .field("time", &self.now.time)
            .field("lengths", &self.lengths)
            .finish_non_exhaustive()
    }
}

impl<B: RigidBody<Scalar = f64, State: Coordinates>, P: Embedded> Run<B> for AdaptiveRun<'_, B, P> {
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
        if self.lengths.is_new() {
            let coordinates = &self.now.coordinates;
            let step = first::<P, _, _>(&equations, time, coordinates, rest, self.tolerance);
            self.lengths.begin(step);
        }
        loop {
            let (step, is_last) = self.lengths.next(rest);
            if step.is_nan() {
                return Err(self.now.not_finite());
            }
            if (time + step) - time == 0.0 && !is_last {
                return Err(if self.lengths.error.is_nan() {
                    self.now.not_finite()
                } else {
                    self.now.step_too_small(step)
                });
            }
            let (change, error) = attempt::<P, _>(&equations, time, &self.now.coordinates, step);
            if self
                .lengths
                .is_accepted::<P>((step, is_last), error, self.tolerance)
            {
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
        runge_kutta_step::<P, _>(&self.within, *start, &before, input, time - start)
    }
}

/// The increment of a step and its error relative to the state. The error is NaN if a stage is out
/// of the domain, even in a single component.
#[cfg_attr(not(unoptimized), inline(always))]
pub(super) fn attempt<P: Embedded, E: Rates<State: Coordinates<Scalar = f64>>>(
    equations: &E,
    time: f64,
    coordinates: &<E::State as Coordinates>::Array,
    step: f64,
) -> (<E::State as Coordinates>::Array, f64) {
    let (change, sizes) = tried::<P, _, _>(equations, time, coordinates, step);
    (change, in_range(sizes, error(sizes)))
}

/// The increment of a step, and the sizes of its differences to methods of lower order (the second
/// is zero for a pair with one difference). The first is NaN if any component is.
#[cfg_attr(not(unoptimized), inline(always))]
pub(crate) fn tried<P: Embedded, T: Scalar, E: Rates<State: Coordinates<Scalar = T>>>(
    equations: &E,
    time: T,
    coordinates: &<E::State as Coordinates>::Array,
    step: T,
) -> (<E::State as Coordinates>::Array, [T; 2]) {
    let (change, differences) = P::sums(equations, time, coordinates, step);
    let differences = differences.as_ref();
    let mut is_number = step.equal(step);
    for part in differences[0].as_ref() {
        is_number = is_number & part.equal(*part);
    }
    // no closures: in lanes they would not be compiled for the register
    let mut sizes = [T::default(); 2];
    for (size, difference) in sizes.iter_mut().zip(differences) {
        *size = relative_size::<E::State>(difference, coordinates);
    }
    let none = step.constant(f64::NAN, f32::NAN);
    (change, [T::select(is_number, sizes[0], none), sizes[1]])
}

/// The error of a step by these sizes (only the first for a pair with one difference), and the sum
/// of squares by whose root it is divided.
#[cfg_attr(not(unoptimized), inline(always))]
pub(crate) fn error<T: Scalar>([first, second]: [T; 2]) -> [T; 2] {
    let squares = first * first + number(first, 0.01) * second * second;
    [first * (first / squares.sqrt()), squares]
}

/// The same error, even if the squares are out of range.
#[cfg_attr(not(unoptimized), inline(always))]
pub(crate) fn in_range([first, second]: [f64; 2], [error, squares]: [f64; 2]) -> f64 {
    if squares.is_normal() {
        error
    } else if first == 0.0 {
        0.0
    } else if first + second == f64::INFINITY {
        f64::INFINITY
    } else {
        first * (first / libm::hypot(first, 0.1 * second))
    }
}

/// The fraction of a step that its error permits; for NaN the smallest.
#[cfg_attr(not(unoptimized), inline(always))]
pub(super) fn shrunk<P: Embedded>(tolerance: f64, error: f64) -> f64 {
    let share = SAFETY * root(tolerance, error, P::ESTIMATE);
    if share >= SHRINK { share } else { SHRINK }
}

/// A first step, from the sizes of the first and second derivatives (Hairer and others, II.4), for
/// a given remaining time.
#[cfg_attr(not(unoptimized), inline(always))]
pub(crate) fn first<P: Embedded, T: Scalar, E: Rates<State: Coordinates<Scalar = T>>>(
    equations: &E,
    time: T,
    coordinates: &<E::State as Coordinates>::Array,
    rest: T,
    tolerance: f64,
) -> T {
    let (zero, left) = (number(rest, 0.0), rest.abs());
    let rates = equations.rates(time, coordinates);
    let speed = relative_size::<E::State>(&rates, coordinates);
    let short = T::select(
        zero.less(speed),
        number(rest, 1e-4) / speed,
        number(rest, 1e-6),
    );
    let short = T::select(left.less(short), left, short);
    let short = T::select(rest.less(zero), -short, short);
    let mut there = *coordinates;
    for (coordinate, rate) in there.as_mut().iter_mut().zip(rates.as_ref()) {
        *coordinate += short * *rate;
    }
    let mut difference = equations.rates(time + short, &there);
    for (difference, rate) in difference.as_mut().iter_mut().zip(rates.as_ref()) {
        *difference = (*difference - *rate) / short;
    }
    let curvature = relative_size::<E::State>(&difference, coordinates).sqrt();
    let pace = T::select(curvature.less_or_equal(speed), speed, curvature);
    // a motion that seems to be at rest does not get one single step
    let longest = left / number(rest, 16.0);
    let step = number(rest, root(tolerance, 1.0, P::ESTIMATE)) / pace;
    let step = T::select(step.less(longest), step, longest);
    let step = T::select(zero.less(pace), step, longest);
    // NaN gives no step
    T::select(pace.equal(pace), step, pace)
}
