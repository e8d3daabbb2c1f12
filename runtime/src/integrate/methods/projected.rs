//! Methods for bodies under constraints: each step ends with a projection.

use core::fmt;
use core::marker::PhantomData;
use core::ops::Range;

use super::commutator_free::cf4_step;
use crate::bodies::constrained::{Constrained, Inconsistent};
use crate::bodies::switches::Stretch;
use crate::integrate::steps::error::IntegrationError;
use crate::integrate::steps::method::{Method, Run, Tolerant};
use crate::integrate::steps::setting::Setting;
use crate::integrate::steps::size::relative_size;
use crate::integrate::steps::stretch::Within;
use crate::numbers::count::real;
use crate::numbers::scalar::Scalar;
use crate::state::Coordinates;

/// A method for bodies under constraints: [`Constrained::project`] corrects the end of every
/// step. Violations do not grow, and the order is that of the method.
///
/// A start with violations above rounding ([`Constrained::check`]) is an error: correct it, or
/// `project` it first. If an input in a constraint changes, the state jumps to the nearest consistent
/// one: the velocities, and also the positions if a `.moving` input does not go on where its last
/// value led. If a constraint or its rate jumps for another reason, the motion ends with
/// [`IntegrationError::Jump`]: at a condition on time, or within a step if the method has a tolerance.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Projected<M>(pub M);

impl<M: Tolerant> Tolerant for Projected<M> {
    fn with_tolerance(tolerance: f64) -> Self {
        Self(M::with_tolerance(tolerance))
    }
}

impl<B: Constrained<Scalar = f64, State: Coordinates>, M: Method<B>> Method<B> for Projected<M> {
    type Run = ProjectedRun<B, M::Run>;

    fn start(self, body: &B, time: f64, state: &B::State) -> Self::Run {
        ProjectedRun {
            stretch: Stretch::since(time),
            run: self.0.start(body, time, state),
            is_checked: false,
            is_on_constraints: false,
            has_switched: false,
            longest: 0.0,
            short: 0,
            kind: PhantomData,
        }
    }

    fn setting(&self) -> Option<(Setting, f64)> {
        self.0.setting()
    }
}

/// A motion that is projected onto its constraints after every step.
pub struct ProjectedRun<B, R> {
    stretch: Stretch,
    run: R,
    /// Whether the start was checked.
    is_checked: bool,
    is_on_constraints: bool,
    /// Whether a condition on time has switched since then.
    has_switched: bool,
    /// The longest step so far \[s\].
    longest: f64,
    /// The number of consecutive short steps where constraints depend on each other.
    short: usize,
    kind: PhantomData<fn(&B)>,
}

/// A step is short if it is at most this fraction of the longest.
const SHORT: f64 = 1e-3;
/// After this many consecutive short steps the motion ends: rounding would decide how it continues.
const MANY: usize = 20;

/// If a method has no tolerance, constraints jump at a switch if states move this far.
const FAR: f64 = 1e-6;
/// How often the place of a jump within a step is halved.
const HALVINGS: usize = 40;

impl<B, R: fmt::Debug> fmt::Debug for ProjectedRun<B, R> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("ProjectedRun")
            .field("run", &self.run)
            .finish_non_exhaustive()
    }
}

impl<B: Constrained<Scalar = f64>> Within<'_, B> {
    /// Whether a state satisfies the constraints at this time.
    fn check(&self, time: f64, state: &B::State, input: &B::Input) -> Result<(), Inconsistent> {
        let side = self.side(time);
        match self.moved(input, time) {
            Some(moved) => self.body.check(side, state, &moved),
            None => self.body.check(side, state, input),
        }
    }

    /// The constraint that depends on others in a state, if all loads have values.
    fn dependent(&self, time: f64, state: &B::State, input: &B::Input) -> Option<&'static str> {
        let side = self.side(time);
        let moved = self.moved(input, time);
        let input = moved.as_ref().unwrap_or(input);
        if self.body.lost_load(side, state, input).is_some() {
            return None;
        }
        self.body.dependent(side, state, input)
    }

    /// Projects a state onto the constraints at this time.
    fn project(
        &self,
        time: f64,
        state: &mut B::State,
        input: &B::Input,
    ) -> Result<(), Inconsistent> {
        let side = self.side(time);
        match self.moved(input, time) {
            Some(moved) => self.body.project(side, state, &moved),
            None => self.body.project(side, state, input),
        }
    }
}

impl<B: Constrained<Scalar = f64, State: Coordinates>, R: Run<B>> ProjectedRun<B, R> {
    /// Projects the state of the motion, if it is then no further than `far` from where it was;
    /// `good` is the last good state.
    fn project(
        &mut self,
        within: &Within<'_, B>,
        input: &B::Input,
        good: &(f64, B::State),
        far: Option<f64>,
    ) -> Result<(), IntegrationError<B::State>> {
        let (found, at) = (self.run.state(), self.run.time());
        let mut state = found.clone();
        let projected = within.project(at, &mut state, input);
        let moved = distance(&found, &state);
        if let Some(far) = far
            && moved > far
            && (at == good.0 || self.jumps(within, input, good.0, [far, moved]))
            && let Err(violated) = within.check(at, &found, input)
        {
            let (time, state) = good.clone();
            return Err(IntegrationError::Jump {
                time,
                state,
                violated,
            });
        }
        projected.map_err(|violated| {
            let (time, state) = good.clone();
            IntegrationError::Inconsistent {
                time,
                state,
                violated,
            }
        })?;
        self.run.replace(within.body, &state);
        Ok(())
    }

    /// Whether the last step, which ends far from the constraints, passes a jump. If its length is
    /// the cause, shorter and shorter steps end nearer and nearer to them. At a jump, two steps of
    /// almost the same length end near and far.
    #[cold]
    fn jumps(
        &self,
        within: &Within<'_, B>,
        input: &B::Input,
        start: f64,
        [far, moved]: [f64; 2],
    ) -> bool {
        let length = self.run.time() - start;
        let (mut near, mut beyond, mut last) = (0.0, 1.0, moved);
        for _ in 0..HALVINGS {
            let middle = 0.5 * (near + beyond);
            let time = start + middle * length;
            let found = self.run.within(within.body, time, input);
            let mut state = found.clone();
            // a state that cannot be projected moves as far as it can
            let _ = within.project(time, &mut state, input);
            let distance = distance(&found, &state);
            if distance > far {
                (beyond, last) = (middle, distance);
            } else {
                near = middle;
            }
        }
        last > 2.0 * far
    }

    /// Whether the motion passes a place where constraints depend on each other, after a step from
    /// the last good state.
    fn passes(
        &mut self,
        within: &Within<'_, B>,
        input: &B::Input,
        (since, state): &(f64, B::State),
    ) -> Result<(), IntegrationError<B::State>> {
        let step = (self.run.time() - since).abs();
        self.longest = self.longest.max(step);
        let found = if step < SHORT * self.longest {
            within.dependent(self.run.time(), &self.run.state(), input)
        } else {
            None
        };
        self.short = if found.is_some() { self.short + 1 } else { 0 };
        match found.filter(|_| self.short > MANY) {
            None => Ok(()),
            Some(constraint) => Err(IntegrationError::Undetermined {
                time: *since,
                state: state.clone(),
                constraint,
            }),
        }
    }

    /// The error of a motion that ended where constraints depend on each other, if no load caused
    /// it.
    #[cold]
    fn explained(
        within: &Within<'_, B>,
        error: IntegrationError<B::State>,
        input: &B::Input,
    ) -> IntegrationError<B::State> {
        let is_undetermined = match &error {
            IntegrationError::NotFinite { load, .. } => load.is_none(),
            IntegrationError::Inconsistent { violated, .. } => !violated.is_start,
            _ => false,
        };
        let (time, state) = (error.time(), error.state().clone());
        let found = is_undetermined.then(|| within.dependent(time, &state, input));
        match found.flatten() {
            Some(constraint) => IntegrationError::Undetermined {
                time,
                state,
                constraint,
            },
            None => error,
        }
    }
}

impl<B: Constrained<Scalar = f64, State: Coordinates>, R: Run<B>> Run<B> for ProjectedRun<B, R> {
    const PLACES: usize = R::PLACES;

    fn time(&self) -> f64 {
        self.run.time()
    }

    fn state(&self) -> B::State {
        self.run.state()
    }

    fn advance(
        &mut self,
        body: &B,
        end: f64,
        input: &B::Input,
    ) -> Result<(), IntegrationError<B::State>> {
        let within = &Within::new(body, &self.stretch);
        let good = (self.run.time(), self.run.state());
        if !self.is_checked {
            let (time, state) = good.clone();
            let checked = within.check(time, &state, input);
            checked.map_err(|violated| IntegrationError::Inconsistent {
                time,
                state,
                violated,
            })?;
            self.is_checked = true;
        }
        // what follows the equations to a tolerance is nearer to its constraints than this
        let far = self.run.tolerance().map(Scalar::sqrt);
        if !self.is_on_constraints {
            let far = self.has_switched.then_some(far.unwrap_or(FAR));
            self.project(within, input, &good, far)?;
            (self.is_on_constraints, self.has_switched) = (true, false);
        }
        let reached = self.run.advance(body, end, input);
        let reached = reached.and_then(|()| self.project(within, input, &good, far));
        reached.map_err(|error| Self::explained(within, error, input))?;
        self.passes(within, input, &good)
    }

    /// The projected state, if there is one nearby.
    fn within(&self, body: &B, time: f64, input: &B::Input) -> B::State {
        let along = self.run.within(body, time, input);
        let mut state = along.clone();
        match Within::new(body, &self.stretch).project(time, &mut state, input) {
            Ok(()) => state,
            Err(_) => along,
        }
    }

    fn heads_for(&mut self, end: f64) {
        self.run.heads_for(end);
    }

    fn tolerance(&self) -> Option<f64> {
        self.run.tolerance()
    }

    /// Constraints may contain inputs.
    fn renew(&mut self) {
        self.run.renew();
        (self.is_on_constraints, self.has_switched) = (false, false);
    }

    /// Constraints may change at a switch.
    fn enter(&mut self, stretch: Stretch) {
        self.run.enter(stretch);
        self.stretch = stretch;
        self.has_switched |= self.is_on_constraints;
        self.is_on_constraints = false;
    }

    fn replace(&mut self, body: &B, state: &B::State) {
        self.run.replace(body, state);
        self.is_checked = false;
        (self.is_on_constraints, self.has_switched) = (false, false);
    }
}

/// The distance of two states, as steps measure their errors. NaN if one is not finite.
fn distance<S: Coordinates<Scalar = f64>>(from: &S, to: &S) -> f64 {
    let (from, mut change) = (from.coordinates(), to.coordinates());
    for (change, from) in change.as_mut().iter_mut().zip(from.as_ref()) {
        *change -= from;
    }
    relative_size::<S>(&change, &from)
}

/// Like [`cf4`](crate::integrate::cf4), with [`Constrained::project`] at the end of each step:
/// violations do not grow, and the order is that of CF4.
///
/// # Errors
/// [`Inconsistent`] if a state is too far from its constraints: the first by more than rounding,
/// a later one after a step that is too long, or a NaN state after a configuration in
/// which the constraints do not determine their reactions.
pub fn cf4_projected<B: Constrained<Scalar = f64>>(
    body: &B,
    state: &B::State,
    input: &B::Input,
    times: Range<f64>,
    steps: usize,
) -> Result<B::State, Inconsistent> {
    let step = (times.end - times.start) / real(steps);
    let (mut state, within) = (
        state.clone(),
        Within::new(body, &Stretch::since(times.start)),
    );
    within.check(times.start, &state, input)?;
    within.project(times.start, &mut state, input)?;
    for k in 0..steps {
        let (time, next) = (
            times.start + real(k) * step,
            times.start + real(k + 1) * step,
        );
        state = match within.moved(input, time) {
            Some(moved) => cf4_step(body, time, &state, &moved, step),
            None => cf4_step(body, time, &state, input, step),
        };
        within.project(next, &mut state, input)?;
    }
    Ok(state)
}
