//! Steady motions by Newton's method: free quantities change until nothing accelerates.

use core::ops::ControlFlow;

use nalgebra::{SMatrix, Vector3};

use super::conditions::{Condition, Conditions};
use super::error::{FEW, TrimError};
use super::least_change::Change;
use super::point::{Here, TOLERANCE, few};
use super::steady::{About, Steady};
use super::trimmed::Trimmed;
use crate::bodies::linearization::coordinated::Coordinated;
use crate::bodies::linearization::matrices::Linearized;
use crate::bodies::linearization::tangent;
use crate::state::Coordinates as _;

/// Steady motions and equilibria of bodies and systems with `outputs: [linearization]`.
///
/// A motion is *steady* if nothing accelerates: rates stay constant, and so do user-defined states,
/// except those that may be [`changing`](Search::changing). With zero rates it is an equilibrium.
/// With [`Search::turning`] it is a steady turn: velocities rotate with the world at a given rate,
/// and so does the body.
pub trait Trim<const STATES: usize, const INPUTS: usize>: Coordinated<STATES, INPUTS> {
    /// Begins the search for a steady motion near a state. Quantities that are not made
    /// [`free`](Search::free) keep their values.
    ///
    /// ```
    /// use newton_euler::prelude::*;
    ///
    /// rigid_body!(Quadrotor {
    ///     motion: spatial,
    ///     inputs: [thrust_1[N], thrust_2[N], thrust_3[N], thrust_4[N]],
    ///     mass: 0.5[kg],
    ///     inertia: principal(2.3e-3, 2.3e-3, 4e-3)[kg * m ^ 2],
    ///     points: [front = (0.17, 0, 0), left = (0, 0.17, 0), back = (-0.17, 0, 0), right = (0, -0.17, 0)],
    ///     fields: [weight = mass * world(0, 0, -9.80665[m / s ^ 2])],
    ///     forces: [
    ///         lift_1 = body(0, 0, thrust_1).at(front),
    ///         lift_2 = body(0, 0, thrust_2).at(left),
    ///         lift_3 = body(0, 0, thrust_3).at(back),
    ///         lift_4 = body(0, 0, thrust_4).at(right),
    ///     ],
    ///     moments: [drag = body(0, 0, 0.016[m] * (thrust_1 - thrust_2 + thrust_3 - thrust_4))],
    ///     outputs: [linearization],
    /// });
    ///
    /// let quadrotor = Quadrotor::default();
    /// let search = quadrotor.trim(&Spatial::default());
    /// let hover = search.free(["thrust_1", "thrust_2", "thrust_3", "thrust_4"]).solve()?;
    /// assert!((hover.input.thrust_1 - 0.5 * 9.80665 / 4.0).abs() < 1e-15);
    /// # Ok::<(), newton_euler::linearization::TrimError>(())
    /// ```
    fn trim(&self, state: &Self::State) -> Search<'_, Self, (), STATES, INPUTS>
    where
        Self: Sized,
    {
        Search {
            steady: Steady {
                body: self,
                time: 0.0,
                turning: None,
                changing: [false; STATES],
                conditions: (),
            },
            state: state.clone(),
            input: Self::components(&Self::Input::default()),
            free: Change::zero(),
            unknown: None,
        }
    }
}

impl<B: Coordinated<N, M>, const N: usize, const M: usize> Trim<N, M> for B {}

/// A search for a steady motion, [`Trim::trim`].
#[must_use = "a search begins with `solve`"]
pub struct Search<'b, B: Coordinated<N, M>, C, const N: usize, const M: usize> {
    steady: Steady<'b, B, C, N>,
    state: B::State,
    input: [f64; M],
    /// One for free quantities, zero for others.
    free: Change<N, M>,
    unknown: Option<&'static str>,
}

impl<'b, B: Coordinated<N, M>, C, const N: usize, const M: usize> Search<'b, B, C, N, M> {
    /// The initial input, whose values also stand for held components; zero by default.
    pub fn input(self, input: &B::Input) -> Self {
        let input = B::components(input);
        Self { input, ..self }
    }

    /// The time \[s\]; zero by default.
    pub fn at(mut self, time: f64) -> Self {
        self.steady.time = time;
        self
    }

    /// The quantities that may change, by their names in [`Linearized::STATES`] and
    /// [`Linearized::INPUTS`]; or a whole vector, as `"attitude"`. If there are more than the
    /// equations determine, the change from the start is least in mean square, each unknown
    /// weighted by its effect.
    pub fn free<const K: usize>(mut self, names: [&'static str; K]) -> Self {
        let states = <B::Linearization as Linearized<N, M>>::STATES;
        let inputs = <B::Linearization as Linearized<N, M>>::INPUTS;
        for name in names {
            let mut is_known = false;
            let known = states.iter().chain(&inputs);
            for (to, known) in self.free.iter_mut().zip(known) {
                if is_of(known, name) {
                    *to = 1.0;
                    is_known = true;
                }
            }
            if !is_known {
                self.unknown = self.unknown.or(Some(name));
            }
        }
        self
    }

    /// A steady turn. With this angular velocity \[rad/s\], in world axes or in the plane along z,
    /// freely moving bodies rotate with the world about an axis through the center of the turn.
    /// Velocities change by `turning × velocity`, and bodies have the angular velocity `turning`.
    /// The center is found with the rest. Joints between bodies, and hinges, stay constant.
    ///
    /// The turn is steady if the loads rotate as well: for example a turn about the vertical, under
    /// weight.
    pub fn turning(mut self, angular_velocity: impl Into<Vector3<f64>>) -> Self {
        self.steady.turning = Some(angular_velocity.into());
        for (place, kind) in B::PLACES.iter().enumerate() {
            if kind.turns() {
                self.free.state[place + B::PLACES.len()] = 1.0;
            }
        }
        self
    }

    /// Quantities that need not stay constant, by their names in [`Linearized::STATES`]: fuel that
    /// burns, a battery that is drained, a velocity that grows. They keep their values in the
    /// search, unless they are free. The motion is steady except for them. Coordinates, such as
    /// positions, may change in any case.
    pub fn changing<const K: usize>(mut self, names: [&'static str; K]) -> Self {
        let states = <B::Linearization as Linearized<N, M>>::STATES;
        for name in names {
            let rates = states.iter().enumerate().skip(B::PLACES.len());
            let mut is_known = false;
            for (row, _) in rates.filter(|(_, known)| is_of(known, name)) {
                self.steady.changing[row] = true;
                is_known = true;
            }
            if !is_known {
                self.unknown = self.unknown.or(Some(name));
            }
        }
        self
    }

    /// An additional condition: a smooth function of state and input that must be zero, such as a
    /// sideslip, or a bank angle minus its target.
    pub fn hold<F: Fn(&B::State, &B::Input) -> f64>(
        self,
        name: &'static str,
        value: F,
    ) -> Search<'b, B, Condition<C, F>, N, M> {
        let Steady {
            body,
            time,
            turning,
            changing,
            conditions: others,
        } = self.steady;
        Search {
            steady: Steady {
                body,
                time,
                turning,
                changing,
                conditions: Condition {
                    others,
                    name,
                    value,
                },
            },
            state: self.state,
            input: self.input,
            free: self.free,
            unknown: self.unknown,
        }
    }

    /// Runs Newton's method, with steps that are halved until they reduce the residual.
    ///
    /// # Errors
    /// [`TrimError`]: the residual, and which quantities would have to be free or changing.
    pub fn solve(mut self) -> Result<Trimmed<B, N, M>, TrimError>
    where
        C: Conditions<B::State, B::Input>,
    {
        if let Some(name) = self.unknown {
            return Err(TrimError::Unknown { name });
        }
        if self.steady.turning.is_some() && !B::PLACES.iter().any(|place| place.turns()) {
            return Err(TrimError::NothingTurns);
        }
        if !self.is_finite() {
            return Err(TrimError::NotFinite { load: None });
        }
        let start = self.start();
        if start.about.rows.is_full() || start.about.kept.len() > N {
            return Err(TrimError::TooMany);
        }
        if !start.worst.is_finite() {
            let Steady { body, time, .. } = self.steady;
            let load = body.lost_load(time, &start.state, &B::input(start.input));
            return Err(TrimError::NotFinite { load });
        }
        let end = self.nearest(start);
        if end.worst <= TOLERANCE {
            return Ok(self.trimmed(end));
        }
        Err(self.lacking(&end))
    }

    /// Whether all given numbers are.
    fn is_finite(&self) -> bool {
        let (coordinates, turning) = (self.state.coordinates(), self.steady.turning);
        let turning = turning.unwrap_or_default();
        let numbers = coordinates.as_ref().iter().chain(&self.input);
        let mut all = numbers.chain(&turning).chain([&self.steady.time]);
        all.all(|number| number.is_finite())
    }

    fn start(&self) -> Here<B, N, M>
    where
        C: Conditions<B::State, B::Input>,
    {
        Here::of(&self.steady, self.state.clone(), self.input)
    }

    /// Where the steps end.
    fn nearest(&self, mut here: Here<B, N, M>) -> Here<B, N, M>
    where
        C: Conditions<B::State, B::Input>,
    {
        for _ in 0..STEPS {
            if here.worst <= 4.0 * f64::EPSILON {
                break;
            }
            match self.step(here) {
                ControlFlow::Continue(nearer) => here = nearer,
                ControlFlow::Break(last) => return last,
            }
        }
        here
    }

    /// A step that reduces the residual; or the end, if there is none.
    fn step(&self, here: Here<B, N, M>) -> ControlFlow<Here<B, N, M>, Here<B, N, M>>
    where
        C: Conditions<B::State, B::Input>,
    {
        let change = here.least(&self.free).change;
        let angles = B::PLACES.iter().zip(change.state.iter());
        let angles = angles.filter(|(place, _)| place.is_angle());
        let turn = angles.map(|(_, turn)| turn.abs()).fold(0.0, f64::max);
        let mut part = if turn > TURN { TURN / turn } else { 1.0 };
        let merit = here.merit(&here.sizes);
        for _ in 0..HALVINGS {
            let input = core::array::from_fn(|i| here.input[i] + part * change.input[i]);
            let state = tangent::moved(&here.state, &(change.state * part));
            let there = Here::of(&self.steady, state, input);
            if there.merit(&here.sizes) < merit {
                let is_rounding = here.worst <= TOLERANCE && there.worst > 0.5 * here.worst;
                return if is_rounding {
                    ControlFlow::Break(there)
                } else {
                    ControlFlow::Continue(there)
                };
            }
            part *= 0.5;
        }
        ControlFlow::Break(here)
    }

    fn trimmed(&self, here: Here<B, N, M>) -> Trimmed<B, N, M> {
        let least = here.least(&self.free);
        let About {
            rows, kept, matrix, ..
        } = &here.about;
        let mut constraints = SMatrix::<f64, N, N>::zeros();
        for (to, row) in rows.list()[kept.clone()].iter().enumerate() {
            constraints.set_row(to, &row.equation.by.state.transpose());
        }
        let free = self.free.iter().filter(|free| *free > 0.0).count();
        Trimmed {
            state: here.state,
            input: B::input(here.input),
            matrix: *matrix,
            rate: here.about.rate,
            constraints,
            undetermined: free - least.rank,
            linearization: here.about.linearization,
        }
    }

    /// Why the steps ended here, and what to do: free some inputs if that helps; otherwise let
    /// states change; otherwise what helps to first order.
    fn lacking(&mut self, end: &Here<B, N, M>) -> TrimError
    where
        C: Conditions<B::State, B::Input>,
    {
        let residual = end.residual();
        let missing = self.missing(end);
        let given = self.free.input;
        self.free.input.fill(1.0);
        let there = self.nearest(self.start());
        if there.worst <= TOLERANCE {
            let effects = there.effects();
            let inputs = <B::Linearization as Linearized<N, M>>::INPUTS;
            let changes = (0..M).map(|i| {
                let change = (there.input[i] - self.input[i]).abs() * (1.0 - given[i]);
                (inputs[i], change * effects.input[i])
            });
            let held = few(changes);
            return TrimError::Unbalanced { residual, held };
        }
        self.drifting()
            .map_or(missing, |states| TrimError::Drifting { residual, states })
    }

    /// What the free quantities lack, to first order.
    fn missing(&self, here: &Here<B, N, M>) -> TrimError {
        let residual = here.residual();
        let least = here.least(&self.free);
        // a solution that needs large rotations is not found
        let mut free = self.free;
        for (place, kind) in B::PLACES.iter().enumerate() {
            if kind.is_angle() && least.change.state[place].abs() > 10.0 * TURN {
                free.state[place] = 0.0;
            }
        }
        let least = here.least(&free);
        if least.left < 0.1 * here.merit(&here.sizes) {
            return TrimError::NotConverged { residual };
        }
        let states = <B::Linearization as Linearized<N, M>>::STATES;
        let inputs = <B::Linearization as Linearized<N, M>>::INPUTS;
        let names = states.into_iter().chain(inputs);
        let held = few(names.zip(least.helps.iter()));
        TrimError::Unbalanced { residual, held }
    }

    /// The user-defined states without whose equations the motion is steady; all of these are needed.
    /// Those that are held come first: nothing but their equations was asked of the free ones.
    fn drifting(&mut self) -> Option<[Option<&'static str>; FEW]>
    where
        C: Conditions<B::State, B::Input>,
    {
        let (free, changing) = (self.free.state, self.steady.changing);
        let own = |is_free: bool| {
            let rows = 2 * B::PLACES.len()..N;
            rows.filter(move |row| !changing[*row] && (free[*row] > 0.0) == is_free)
        };
        let own = own(true).chain(own(false));
        for row in own.clone() {
            self.steady.changing[row] = true;
        }
        if !self.is_solved() {
            return None;
        }
        let needed = own.filter(|row| {
            self.steady.changing[*row] = false;
            self.steady.changing[*row] = !self.is_solved();
            self.steady.changing[*row]
        });
        let states = <B::Linearization as Linearized<N, M>>::STATES;
        Some(few(needed.map(|row| (states[row], 1.0))))
    }

    fn is_solved(&self) -> bool
    where
        C: Conditions<B::State, B::Input>,
    {
        self.nearest(self.start()).worst <= TOLERANCE
    }
}

/// Whether a component is this quantity, or one of this vector.
fn is_of(component: &str, name: &str) -> bool {
    let rest = component.strip_prefix(name);
    rest.is_some_and(|rest| matches!(rest, "" | "_x" | "_y" | "_z"))
}

/// The limit of Newton steps: near a solution about six are needed.
const STEPS: usize = 100;

/// The limit of halvings of a step that does not reduce the residual.
const HALVINGS: usize = 40;

/// The largest angle of a step \[rad\]: beyond it, sines are far from linear.
const TURN: f64 = 1.0;
