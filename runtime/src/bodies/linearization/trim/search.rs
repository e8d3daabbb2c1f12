//! Steady motions by Newton's method: free quantities change until nothing accelerates.

use nalgebra::{SMatrix, Vector3};

use super::conditions::{Condition, Conditions};
use super::error::TrimError;
use super::lacking::lacking;
use super::least_change::Change;
use super::newton::Newton;
use super::point::Here;
use super::steady::{About, Steady};
use super::trimmed::Trimmed;
use crate::bodies::linearization::coordinated::Coordinated;
use crate::bodies::linearization::matrices::Linearized;
use crate::bodies::linearization::place::Place;
use crate::bodies::linearization::tangent;

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
            newton: Newton {
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
            },
            unknown: None,
        }
    }
}

impl<B: Coordinated<N, M>, const N: usize, const M: usize> Trim<N, M> for B {}

/// A search for a steady motion, [`Trim::trim`].
#[must_use = "a search begins with `solve`"]
pub struct Search<'b, B: Coordinated<N, M>, C, const N: usize, const M: usize> {
    newton: Newton<'b, B, C, N, M>,
    unknown: Option<&'static str>,
}

impl<'b, B: Coordinated<N, M>, C, const N: usize, const M: usize> Search<'b, B, C, N, M> {
    /// The initial input, whose values also stand for held components; zero by default.
    pub fn input(mut self, input: &B::Input) -> Self {
        self.newton.input = B::components(input);
        self
    }

    /// The time \[s\]; zero by default.
    pub fn at(mut self, time: f64) -> Self {
        self.newton.steady.time = time;
        self
    }

    /// The quantities that may change, by their names in [`Linearized::STATES`] and
    /// [`Linearized::INPUTS`]; or a whole vector, as `"attitude"`. If there are more than the
    /// equations determine, the change from the start is least in mean square, each unknown
    /// weighted by its effect. A quantity changes only if it has an effect to first order: a rotor
    /// whose thrust is proportional to the square of its speed needs a start other than zero.
    pub fn free<const K: usize>(mut self, names: [&'static str; K]) -> Self {
        let states = <B::Linearization as Linearized<N, M>>::STATES;
        let inputs = <B::Linearization as Linearized<N, M>>::INPUTS;
        for name in names {
            let mut is_known = false;
            let which = are_of(states.iter().chain(&inputs), name);
            for (to, is_free) in self.newton.free.iter_mut().zip(which) {
                if is_free {
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
        self.newton.steady.turning = Some(angular_velocity.into());
        for (place, kind) in B::PLACES.iter().enumerate() {
            if kind.turns() {
                self.newton.free.state[place + B::PLACES.len()] = 1.0;
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
            let mut is_known = false;
            let rates = are_of(states.iter().skip(B::PLACES.len()), name);
            let rows = self.newton.steady.changing.iter_mut();
            for (to, is_changing) in rows.skip(B::PLACES.len()).zip(rates) {
                if is_changing {
                    *to = true;
                    is_known = true;
                }
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
        let Newton {
            steady,
            state,
            input,
            free,
        } = self.newton;
        let conditions = Condition {
            others: steady.conditions,
            name,
            value,
        };
        Search {
            newton: Newton {
                steady: Steady {
                    body: steady.body,
                    time: steady.time,
                    turning: steady.turning,
                    changing: steady.changing,
                    conditions,
                },
                state,
                input,
                free,
            },
            unknown: self.unknown,
        }
    }

    /// Runs Newton's method, with steps that are halved until they reduce the residual. They continue
    /// to rounding. The motion counts as steady if each acceleration, and each rate of a user-defined
    /// state, is below the sum of
    ///
    /// - 1e-11 times the largest term that it sums, and
    /// - the effect of rounding on state and input: of 64 units of rounding of their largest values in
    ///   the search, for positions and angles of no less than 1 m and 1 rad.
    ///
    /// The terms of constraints and of conditions are not known: derivatives times values are used
    /// in their place, for positions and angles times 1 m and 1 rad.
    ///
    /// A solution is refused if an acceleration has no value there: if it varies within the rounding
    /// of a free quantity by a tenth of its terms, and a million times as much as at the start.
    ///
    /// # Errors
    /// [`TrimError`]: the residual, and which quantities would have to be free or changing.
    pub fn solve(self) -> Result<Trimmed<B, N, M>, TrimError>
    where
        C: Conditions<B::State, B::Input>,
    {
        if let Some(name) = self.unknown {
            return Err(TrimError::Unknown { name });
        }
        let mut newton = self.newton;
        let Steady {
            body,
            time,
            turning,
            ..
        } = newton.steady;
        if turning.is_some() && !B::PLACES.iter().any(|place| place.turns()) {
            return Err(TrimError::NothingTurns);
        }
        if let Some(name) = not_finite(&newton) {
            return Err(TrimError::NotFinite { name: Some(name) });
        }
        let leaves_plane = |turning: &Vector3<f64>| turning.x != 0.0 || turning.y != 0.0;
        if B::PLACES.contains(&Place::Heading) && turning.as_ref().is_some_and(leaves_plane) {
            return Err(TrimError::OutOfPlane);
        }
        let start = newton.start();
        if start.about.rows.is_full() || start.about.kept.len() > N {
            return Err(TrimError::TooMany);
        }
        if !start.worst.is_finite() {
            let load = body.lost_load(time, &start.state, &B::input(start.input));
            let name = load.or_else(|| start.lost_condition());
            return Err(TrimError::NotFinite { name });
        }
        let residual = start.residual();
        let end = newton.end(start);
        if end.is_steady() {
            return Ok(trimmed(end.here, &newton.free));
        }
        Err(lacking(&mut newton, residual, &end))
    }
}

/// The name of a given number that is not finite.
fn not_finite<B: Coordinated<N, M>, C, const N: usize, const M: usize>(
    newton: &Newton<'_, B, C, N, M>,
) -> Option<&'static str> {
    let states = <B::Linearization as Linearized<N, M>>::STATES;
    let inputs = <B::Linearization as Linearized<N, M>>::INPUTS;
    let values = tangent::values::<_, N>(&newton.state, &Vector3::zeros());
    let turning = newton.steady.turning.unwrap_or_default();
    let numbers = states.iter().zip(values.iter());
    let numbers = numbers.chain(inputs.iter().zip(&newton.input));
    let numbers = numbers.chain(turning.iter().map(|rate| (&"turning", rate)));
    let mut numbers = numbers.chain([(&"time", &newton.steady.time)]);
    numbers.find_map(|(name, number)| (!number.is_finite()).then_some(*name))
}

fn trimmed<B: Coordinated<N, M>, const N: usize, const M: usize>(
    here: Here<B, N, M>,
    free: &Change<N, M>,
) -> Trimmed<B, N, M> {
    let least = here.least(free);
    let About {
        rows, kept, matrix, ..
    } = &here.about;
    let mut constraints = SMatrix::<f64, N, N>::zeros();
    for (to, row) in rows.list()[kept.clone()].iter().enumerate() {
        constraints.set_row(to, &row.equation.by.state.transpose());
    }
    let free = free.iter().filter(|free| *free > 0.0).count();
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

/// Which components are this quantity; if none has this name, which are those of this vector.
fn are_of<'n>(
    components: impl Iterator<Item = &'n &'static str> + Clone,
    name: &'static str,
) -> impl Iterator<Item = bool> {
    let is_vector = components.clone().all(|component| *component != name);
    components.map(move |component| match component.strip_prefix(name) {
        Some("") => true,
        Some("_x" | "_y" | "_z") => is_vector,
        _ => false,
    })
}
