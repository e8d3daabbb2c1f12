//! Variable steps, as long as the tolerance permits, by pairs of Runge–Kutta methods.

use core::fmt;
use core::marker::PhantomData;

use super::runge_kutta::track::Track;
use super::runge_kutta::{DormandPrince8, Embedded, Verner9};
use crate::bodies::body::RigidBody;
use crate::bodies::switches::Stretch;
use crate::integrate::steps::chatter::Watch;
use crate::integrate::steps::equations::{Equations, Rates};
use crate::integrate::steps::error::IntegrationError;
use crate::integrate::steps::lengths::{Lengths, combined, shrunk};
use crate::integrate::steps::method::{Method, Run, Tolerant};
use crate::integrate::steps::setting::Setting;
use crate::integrate::steps::size::{finest, relative_size, root};
use crate::integrate::steps::stretch::Within;

use crate::numbers::scalar::{Scalar, number};
use crate::state::Coordinates;

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
            type Run = AdaptiveRun<B, $pair>;

            fn start(self, _body: &B, time: f64, state: &B::State) -> Self::Run {
                AdaptiveRun::new(time, state, self.tolerance)
            }

            fn setting(&self) -> Option<(Setting, f64)> {
                Some((Setting::Tolerance, self.tolerance))
            }
        }
    };
}

adaptive!(DormandPrince by DormandPrince8);
adaptive!(Verner by Verner9);

/// A motion in steps as long as its tolerance permits.
pub struct AdaptiveRun<B: RigidBody<Scalar = f64, State: Coordinates>, P = DormandPrince8> {
    pub(crate) track: Track<B::State>,
    tolerance: f64,
    /// None before the first step.
    pub(crate) lengths: Option<Lengths<f64>>,
    pub(crate) watch: Watch,
    pair: PhantomData<P>,
}

impl<B: RigidBody<Scalar = f64, State: Coordinates>, P> AdaptiveRun<B, P> {
    fn new(time: f64, state: &B::State, tolerance: f64) -> Self {
        Self {
            track: Track::new(time, state),
            tolerance: finest(tolerance),
            lengths: None,
            watch: Watch::OF_A_PAIR,
            pair: PhantomData,
        }
    }
}

impl<B: RigidBody<Scalar = f64, State: Coordinates>, P> fmt::Debug for AdaptiveRun<B, P> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("AdaptiveRun")
            .field("tolerance", &self.tolerance)
            .field("time", &self.track.now.time)
            .field("lengths", &self.lengths)
            .finish_non_exhaustive()
    }
}

impl<B: RigidBody<Scalar = f64, State: Coordinates>, P: Embedded> Run<B> for AdaptiveRun<B, P> {
    const PLACES: usize = 4;

    fn time(&self) -> f64 {
        self.track.now.time
    }

    fn state(&self) -> B::State {
        self.track.now.state()
    }

    fn advance(
        &mut self,
        body: &B,
        end: f64,
        input: &B::Input,
    ) -> Result<(), IntegrationError<B::State>> {
        let Track {
            stretch,
            now,
            before,
        } = &mut self.track;
        let equations = Equations {
            body: &Within::new(body, stretch),
            input,
        };
        if self.watch.is_due() {
            let rest = now.rest(end);
            let chatters = self.watch.chatters(&equations, now, rest, self.tolerance);
            if let Some(step) = chatters {
                return Err(now.step_too_small(step));
            }
        }
        *before = (now.time, now.coordinates);
        let (time, rest) = (now.time, now.rest(end));
        let lengths = self.lengths.get_or_insert_with(|| {
            let step = first::<P, _, _>(&equations, time, &now.coordinates, rest, self.tolerance);
            Lengths::from(step)
        });
        loop {
            let (step, is_last) = lengths.next(rest);
            if !step.is_finite() {
                return Err(now.not_finite());
            }
            if (time + step) - time == 0.0 && !is_last {
                return Err(if lengths.error().is_nan() {
                    now.not_finite()
                } else {
                    now.step_too_small(step)
                });
            }
            let (change, error) = attempt::<P, _, _>(&equations, time, &now.coordinates, step);
            let share = shrunk(self.tolerance, error, P::ESTIMATE);
            if lengths.is_accepted((step, is_last), (error, share), self.tolerance) {
                let is_finite = if is_last {
                    now.arrive(change, end)
                } else {
                    now.advance(change, step)
                };
                return if is_finite {
                    self.watch.saw(step, is_last);
                    Ok(())
                } else {
                    Err(now.not_finite())
                };
            }
        }
    }

    fn tolerance(&self) -> Option<f64> {
        Some(self.tolerance)
    }

    fn heads_for(&mut self, end: f64) {
        self.watch.heads_for(end);
    }

    fn enter(&mut self, stretch: Stretch) {
        self.track.stretch = stretch;
    }

    fn replace(&mut self, _body: &B, state: &B::State) {
        self.track.now.replace(state);
    }

    fn within(&self, body: &B, time: f64, input: &B::Input) -> B::State {
        self.track.within::<P, B>(body, time, input)
    }
}

/// The increment of a step and its error relative to the state. The error is NaN if a stage is out
/// of the domain, even in a single component.
#[cfg_attr(not(unoptimized), inline(always))]
pub(crate) fn attempt<P: Embedded, T: Scalar, E: Rates<State: Coordinates<Scalar = T>>>(
    equations: &E,
    time: T,
    coordinates: &<E::State as Coordinates>::Array,
    step: T,
) -> (<E::State as Coordinates>::Array, T) {
    let (change, differences) = P::sums(equations, time, coordinates, step);
    let differences = differences.as_ref();
    let mut is_number = step.equal(step);
    for part in differences[0].as_ref() {
        is_number = is_number & part.equal(*part);
    }
    // no closures: in lanes they would not be compiled for the register
    let mut error = relative_size::<E::State>(&differences[0], coordinates);
    if let [_, second] = differences {
        error = combined(error, relative_size::<E::State>(second, coordinates));
    }
    (change, T::select(is_number, error, number(step, f64::NAN)))
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
    // a motion that seems to be at rest does not get one single step, unless a part of it is lost in
    // the rounding of time
    let part = rest / number(rest, 16.0);
    let is_lost = ((time + part) - time).equal(zero);
    let longest = T::select(is_lost, left, part.abs());
    let step = number(rest, root(tolerance, 1.0, P::ESTIMATE)) / pace;
    let step = T::select(step.less(longest), step, longest);
    let step = T::select(zero.less(pace), step, longest);
    // NaN gives no step
    T::select(pace.equal(pace), step, pace)
}
