//! Moving all members by the methods of [`integrate`](crate::integrate).

use core::fmt;
use core::marker::PhantomData;
use core::ops::Range;

use alloc::vec::Vec;
#[cfg(feature = "rayon")]
use rayon::iter::{IntoParallelIterator as _, ParallelIterator as _};

use super::blocks::{BLOCK, GroupMut, Row};
use super::evaluate::{in_chunks, read};
use super::{Ensemble, Members};
use crate::body::RigidBody;
use crate::columns::{Columns, Generic};
use crate::integrate::{
    Equations, Fixed, Integrate, IntegrationError, Method, RungeKutta, Tolerant, add, exact,
};
use crate::lanes::{Lanes, Register, Work};
use crate::state::Coordinates;

/// A member whose motion ended before its time.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MemberError<S> {
    /// Which one, from zero.
    pub index: usize,
    /// Why, with the last state that was good.
    pub error: IntegrationError<S>,
}

impl<S> fmt::Display for MemberError<S> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "member {}: {}", self.index, self.error)
    }
}

impl<S: fmt::Debug + 'static> core::error::Error for MemberError<S> {
    fn source(&self) -> Option<&(dyn core::error::Error + 'static)> {
        Some(&self.error)
    }
}

/// A method for all members of an ensemble.
pub trait Moves<B: Generic> {
    /// Moves all members between two times \[s\], with the inputs held.
    ///
    /// # Errors
    /// [`MemberError`] with the first of those that do not come to the end; the ensemble stays where it is.
    fn moved(
        &self,
        ensemble: &mut Ensemble<B>,
        times: Range<f64>,
    ) -> Result<(), MemberError<B::State>>;
}

/// Every member for itself, by any method, with steps of its own.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct OneByOne<M>(pub M);

impl<B: Generic, M: Method<B>> Moves<B> for OneByOne<M> {
    fn moved(
        &self,
        ensemble: &mut Ensemble<B>,
        times: Range<f64>,
    ) -> Result<(), MemberError<B::State>> {
        if !times.end.is_finite() {
            return ensemble.states.iter().next().map_or(Ok(()), |state| {
                let time = times.start;
                let error = IntegrationError::NotFinite { time, state };
                Err(MemberError { index: 0, error })
            });
        }
        let (states, members) = (&ensemble.states, &ensemble.members);
        let end_of = |index: usize| {
            use crate::integrate::Run;
            let (body, input) = (members.body(index), members.inputs.get(index));
            let state = states.get(index);
            let mut run = self.0.start(&body, times.start, &state);
            let reached = run.seek(times.end, times.end, &input);
            let reached = reached.map(|()| run.state());
            reached.map_err(|error| MemberError { index, error })
        };
        let ends: Result<Vec<B::State>, _> = indices(states.len()).map(end_of).collect();
        ensemble.states = ends?.into_iter().collect();
        Ok(())
    }
}

/// All members, in all threads.
#[cfg(feature = "rayon")]
fn indices(count: usize) -> rayon::range::Iter<usize> {
    (0..count).into_par_iter()
}

/// All members.
#[cfg(not(feature = "rayon"))]
fn indices(count: usize) -> Range<usize> {
    0..count
}

/// In lanes: each member moves as it would alone, to the bit. Of a motion that does not stay finite, the error has the state at the start.
impl<B: Generic, M: RungeKutta> Moves<B> for Fixed<M> {
    fn moved(
        &self,
        ensemble: &mut Ensemble<B>,
        times: Range<f64>,
    ) -> Result<(), MemberError<B::State>> {
        let Range { start: time, end } = times;
        let before = ensemble.states.clone();
        let failed = |index: usize, step: Option<f64>| {
            let state = before.get(index);
            let error = match step {
                Some(step) => IntegrationError::StepTooSmall { time, state, step },
                None => IntegrationError::NotFinite { time, state },
            };
            Err(MemberError { index, error })
        };
        let is_there = end - time == 0.0;
        if before.is_empty() || is_there {
            return Ok(());
        }
        let Some(steps) = self.count(end - time) else {
            return failed(0, end.is_finite().then_some(self.step));
        };
        let (width, members) = (ensemble.width, &ensemble.members);
        let columns = <B::State as Columns<f64>>::COUNT;
        in_chunks(ensemble.states.rows_mut(), columns, |first, rows| {
            width.run(Advance {
                method: PhantomData::<M>,
                members,
                first,
                start: time,
                step: (end - time) / exact(steps),
                steps,
                states: rows,
            });
        });
        let is_lost = |state: B::State| {
            let coordinates = state.coordinates();
            !coordinates.as_ref().iter().sum::<f64>().is_finite()
        };
        let lost = ensemble.states.iter().position(is_lost);
        match lost {
            None => Ok(()),
            Some(index) => {
                ensemble.states = before.clone();
                failed(index, None)
            }
        }
    }
}

struct Advance<'e, M, B: Generic> {
    method: PhantomData<M>,
    members: &'e Members<B>,
    first: usize,
    start: f64,
    step: f64,
    steps: usize,
    states: &'e mut [Row],
}

impl<M: RungeKutta, B: Generic> Work for Advance<'_, M, B> {
    type Output = ();

    #[inline(always)]
    fn run<S: Register>(self, simd: S) {
        let columns = <B::State as Columns<f64>>::COUNT;
        for (index, rows) in self.states.chunks_exact_mut(columns).enumerate() {
            let block = self.first + index;
            for group in 0..BLOCK / Lanes::<S>::COUNT {
                let body = self.members.bodies_of(simd, block, group);
                let input = self.members.inputs_of(simd, block, group);
                let equations = Equations {
                    body: &body,
                    input: &input,
                };
                let state = read::<B::State, _, S>(simd, rows, 0, group);
                let end =
                    moved::<M, _, S>(simd, &equations, &state, self.start, self.step, self.steps);
                let rows = rows.iter_mut();
                Columns::<Lanes<S>>::write(&end, &mut GroupMut { rows, index: group });
            }
        }
    }
}

/// As a [`FixedRun`](crate::integrate::FixedRun) does, in lanes.
#[inline(always)]
fn moved<M, L, S>(
    simd: S,
    equations: &Equations<'_, L>,
    state: &L::State,
    start: f64,
    step: f64,
    steps: usize,
) -> L::State
where
    M: RungeKutta,
    S: Register,
    L: RigidBody<Scalar = Lanes<S>, State: Coordinates<Scalar = Lanes<S>>>,
{
    let mut coordinates = state.coordinates();
    let mut lost = <L::State as Coordinates>::Array::default();
    for k in 0..steps {
        let time = Lanes::splat(simd, start + exact(k) * step);
        let length = Lanes::splat(simd, step);
        let mut change = M::increment(equations, time, &coordinates, length);
        L::State::keep(&coordinates, &mut change);
        add(&mut coordinates, &mut lost, &change);
    }
    L::State::from_coordinates(&coordinates)
}

/// A motion of all members that is to be integrated, as one body's by [`Integration`](crate::integrate::Integration).
///
/// ```
/// use newton_euler::integrate::{DormandPrince8, Fixed};
/// use newton_euler::{ensemble::Ensemble, prelude::*};
///
/// rigid_body!(Handle::<T> {
///     motion: rotation,
///     inertia: principal(1, 2, 3)[kg * m ^ 2],
/// });
///
/// let thrown = |i: u32| Rotation { angular_velocity: [0.01, 1.0, 0.001 * f64::from(i)].into(), ..Rotation::default() };
/// let mut handles = Ensemble::new(&Handle::default(), (0..100).map(thrown));
///
/// // several in a register, in steps of equal length; or each with its own steps, as long as the tolerance permits
/// handles.integrate().method(Fixed { method: DormandPrince8, step: 0.25 }).to(10.0)?;
/// handles.integrate().starting_at(10.0).tolerance(1e-12).to(20.0)?;
///
/// let alone = Handle::default().integrate(&thrown(70)).tolerance(1e-12).to(20.0)?;
/// assert!((handles.state(70).angular_velocity - alone.angular_velocity).norm() < 1e-6);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[must_use = "nothing moves until an end is given"]
#[derive(Debug)]
pub struct EnsembleIntegration<'e, B: Generic, M> {
    ensemble: &'e mut Ensemble<B>,
    start: f64,
    method: M,
}

impl<B: Generic + Integrate> Ensemble<B> {
    /// Integrates the motion of all members: from time zero, under their inputs, each by the method that is best for it
    /// ([`Integrate::Best`]) with steps of its own, all of which [`EnsembleIntegration`] can change.
    pub fn integrate(&mut self) -> EnsembleIntegration<'_, B, OneByOne<B::Best>> {
        EnsembleIntegration {
            ensemble: self,
            start: 0.0,
            method: OneByOne(B::Best::with_tolerance(crate::integrate::TOLERANCE)),
        }
    }
}

impl<'e, B: Generic, M> EnsembleIntegration<'e, B, M> {
    /// Begins at this time \[s\] and not at zero.
    pub fn starting_at(self, time: f64) -> Self {
        Self {
            start: time,
            ..self
        }
    }

    /// With this tolerance: see [`Tolerant::with_tolerance`].
    pub fn tolerance(self, tolerance: f64) -> Self
    where
        M: Tolerant,
    {
        self.method(M::with_tolerance(tolerance))
    }

    /// By another method: [`Fixed`] in lanes, or [`OneByOne`] of any.
    pub fn method<N>(self, method: N) -> EnsembleIntegration<'e, B, N> {
        EnsembleIntegration {
            ensemble: self.ensemble,
            start: self.start,
            method,
        }
    }

    /// Moves all members to the end \[s\].
    ///
    /// # Errors
    /// [`MemberError`] with the first member that does not come there; the ensemble stays where it is.
    pub fn to(self, end: f64) -> Result<(), MemberError<B::State>>
    where
        M: Moves<B>,
    {
        self.method.moved(self.ensemble, self.start..end)
    }

    /// The same under inputs that a function of time, member and its state gives at the start and every so many seconds after, each held until
    /// the next (zero-order hold), as by a controller of each.
    ///
    /// # Errors
    /// As [`to`](Self::to), after the last instant to which all members came; a period that is not positive is one as well.
    pub fn controlled_to(
        self,
        end: f64,
        period: f64,
        mut function: impl FnMut(f64, usize, &B::State) -> B::Input,
    ) -> Result<(), MemberError<B::State>>
    where
        M: Moves<B>,
    {
        let Self {
            ensemble,
            start,
            method,
        } = self;
        if ensemble.is_empty() {
            return Ok(());
        }
        if !end.is_finite() {
            let (time, state) = (start, ensemble.state(0));
            let error = IntegrationError::NotFinite { time, state };
            return Err(MemberError { index: 0, error });
        }
        let direction = 1.0_f64.copysign(end - start);
        let mut time = start;
        for count in 1.. {
            if (end - time) * direction <= 0.0 {
                break;
            }
            let next = start + exact(count) * period * direction;
            let next = if (end - next) * direction > 0.0 {
                next
            } else {
                end
            };
            let is_ahead = (next - time) * direction > 0.0 && period > 0.0;
            if !is_ahead {
                let (state, step) = (ensemble.state(0), period);
                let error = IntegrationError::StepTooSmall { time, state, step };
                return Err(MemberError { index: 0, error });
            }
            for index in 0..ensemble.len() {
                let input = function(time, index, &ensemble.states.get(index));
                ensemble.members.inputs.set(index, &input);
            }
            method.moved(ensemble, time..next)?;
            time = next;
        }
        Ok(())
    }
}

impl<M: Tolerant> Tolerant for OneByOne<M> {
    fn with_tolerance(tolerance: f64) -> Self {
        Self(M::with_tolerance(tolerance))
    }
}
