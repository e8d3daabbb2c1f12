//! The equations of a steady motion, linearized about a state and an input.

use core::ops::Range;

use nalgebra::{SMatrix, SVector, Vector3};

use super::conditions::Conditions;
use super::least_change::{Change, Equation};
use super::slopes::{STEPS, Slope};
use crate::bodies::constrained::Violation;
use crate::bodies::linearization::coordinated::Coordinated;
use crate::bodies::linearization::matrices::Linearized;
use crate::bodies::linearization::place::Place;
use crate::bodies::linearization::tangent;

/// The conditions of a steady motion.
pub struct Steady<'b, B, C, const N: usize> {
    pub body: &'b B,
    pub time: f64,
    /// The angular velocity of the turn \[rad/s\], world axes, if there is one.
    pub turning: Option<Vector3<f64>>,
    /// The rates that need not vanish.
    pub changing: [bool; N],
    pub conditions: C,
}

/// A list with room for the rows of a state, and twice as many for constraints and conditions.
#[derive(Clone, Copy)]
pub struct Rows<T, const N: usize> {
    room: [[T; 3]; N],
    count: usize,
}

impl<T: Copy, const N: usize> Rows<T, N> {
    fn new(any: T) -> Self {
        let room = [[any; 3]; N];
        Self { room, count: 0 }
    }

    /// Entries beyond the capacity are dropped.
    fn push(&mut self, row: T) {
        if let Some(to) = self.room.as_flattened_mut().get_mut(self.count) {
            *to = row;
            self.count += 1;
        }
    }

    pub fn list(&self) -> &[T] {
        &self.room.as_flattened()[..self.count]
    }

    /// Whether entries may have been dropped.
    pub fn is_full(&self) -> bool {
        self.count == 3 * N
    }
}

/// One equation of a steady motion.
#[derive(Clone, Copy)]
pub struct Asked<const N: usize, const M: usize> {
    pub name: &'static str,
    /// Whether it is an equation of an angle, for those of a coordinate; equations with the same
    /// unit are compared.
    pub is_angle: Option<bool>,
    /// Its row in the tangent space, unless it is a constraint or a condition.
    pub row: Option<usize>,
    /// The size of its terms, if it is known.
    pub terms: Option<f64>,
    pub equation: Equation<N, M>,
}

impl<const N: usize, const M: usize> Asked<N, M> {
    /// An equation without derivatives.
    fn new(name: &'static str, value: f64) -> Self {
        Self {
            name,
            is_angle: None,
            row: None,
            terms: None,
            equation: Equation {
                value,
                by: Change::zero(),
            },
        }
    }
}

/// The equations about one state and input.
pub struct About<L, const N: usize, const M: usize> {
    pub rows: Rows<Asked<N, M>, N>,
    /// The equations of constraints among them: every motion satisfies these.
    pub kept: Range<usize>,
    pub linearization: L,
    /// A, as seen by an observer that turns with the motion.
    pub matrix: SMatrix<f64, N, N>,
    pub rate: SVector<f64, N>,
    /// The plausible size of a change of each coordinate and each input.
    pub reach: Change<N, M>,
}

/// A value that must be zero; for a position constraint, with its rate.
#[derive(Clone, Copy)]
struct Measured {
    name: &'static str,
    value: f64,
    rate: Option<f64>,
}

impl<B, C, const N: usize> Steady<'_, B, C, N> {
    /// The equations about a state and an input.
    pub fn about<const M: usize>(
        &self,
        state: &B::State,
        components: &[f64; M],
    ) -> About<B::Linearization, N, M>
    where
        B: Coordinated<N, M>,
        C: Conditions<B::State, B::Input>,
    {
        let input = B::input(*components);
        let linearization = self.body.linearize(self.time, state, &input);
        let acceleration = self.body.acceleration(self.time, state, &input);
        let values = tangent::values(state, &self.turning.unwrap_or_default());
        let (matrix, b) = (linearization.a(), linearization.b());
        let mut about = About {
            rows: Rows::new(Asked::new("", 0.0)),
            kept: 0..0,
            linearization,
            matrix,
            rate: tangent::rate(state, &acceleration),
            reach: Change {
                state: SVector::from_fn(|row, _| {
                    if row < B::PLACES.len() {
                        1.0
                    } else {
                        libm::fabs(values[row])
                    }
                }),
                input: SVector::from(components.map(f64::abs)),
            },
        };
        let mut terms = SVector::from(self.body.terms(self.time, state, &input));
        let excess = self.excess(&values, &mut about, &mut terms);
        let places = B::PLACES.len();
        for row in 0..N {
            let is_steady = row >= places && !self.changing[row];
            if is_steady || row < places && self.turning.is_some() && B::PLACES[row].turns() {
                let by = Change {
                    state: about.matrix.row(row).transpose(),
                    input: b.row(row).transpose(),
                };
                let value = excess[row];
                let terms = terms[row];
                about.rows.push(Asked {
                    name: <B::Linearization as Linearized<N, M>>::STATES[row],
                    is_angle: (row < 2 * places).then(|| B::PLACES[row % places].is_angle()),
                    row: Some(row),
                    // where a slope has no value, that of the residual remains
                    terms: Some(if terms.is_finite() { terms } else { 0.0 }),
                    equation: Equation { value, by },
                });
            }
        }
        let first = about.rows.count;
        axes::<B, _, N, M>(&values, &mut about);
        let kept = self.measured(state, components, &mut about);
        about.kept = first..kept;
        about
    }

    /// The rate of a state minus that of the turn of the world; likewise A. `terms` becomes the
    /// size of the terms of that difference.
    fn excess<const M: usize>(
        &self,
        values: &SVector<f64, N>,
        about: &mut About<B::Linearization, N, M>,
        terms: &mut SVector<f64, N>,
    ) -> SVector<f64, N>
    where
        B: Coordinated<N, M>,
    {
        let mut excess = about.rate;
        let Some(turning) = self.turning else {
            return excess;
        };
        let (cross, a) = (turning.cross_matrix(), about.matrix);
        let mut subtract = |row: usize, turn: f64| {
            excess[row] -= turn;
            terms[row] = terms[row].max(turn.abs());
        };
        for (row, place) in B::PLACES.iter().enumerate() {
            match place {
                Place::Position(part) | Place::Axis(part) => {
                    let (place, size) = (row - part, vector(&B::PLACES[row - part..]));
                    // in turning axes, positions rotate the other way; if nothing depends on them,
                    // they may stay fixed
                    let is_seen = a.columns(place, size).amax() > 0.0;
                    for other in 0..size {
                        let turn = cross[(*part, other)];
                        for first in [place, place + B::PLACES.len()] {
                            subtract(first + part, turn * values[first + other]);
                            if is_seen || first > place {
                                about.matrix[(first + part, first + other)] -= turn;
                            }
                        }
                    }
                }
                Place::Attitude(_) => subtract(row, values[row]),
                Place::Heading => subtract(row, turning.z),
                Place::Relative(_) | Place::Angle | Place::Length => {}
            }
        }
        excess
    }

    /// The residuals of constraints and conditions, and their derivatives; also the number of rows
    /// of constraints. Constraints are linear in the rates. Unit rates therefore give their
    /// derivatives by rates, and those of positions by coordinates, to rounding; all other
    /// derivatives are finite differences.
    fn measured<const M: usize>(
        &self,
        state: &B::State,
        components: &[f64; M],
        about: &mut About<B::Linearization, N, M>,
    ) -> usize
    where
        B: Coordinated<N, M>,
        C: Conditions<B::State, B::Input>,
    {
        let (here, kept) = self.measure(state, components);
        let first = about.rows.count;
        for one in here.list() {
            about.rows.push(Asked::new(one.name, one.value));
        }
        let rows = &mut about.rows.room.as_flattened_mut()[first..about.rows.count];
        for column in 0..N + M {
            let Some(reach) = about.reach.iter().nth(column) else {
                continue;
            };
            let reach = reach.max(1.0);
            let moved = |by: f64| {
                let mut change = Change::<N, M>::zero();
                if let Some(to) = change.iter_mut().nth(column) {
                    *to = by;
                }
                let there = core::array::from_fn(|i| components[i] + change.input[i]);
                self.measure(&tangent::moved(state, &change.state), &there)
                    .0
            };
            let mut slopes = Rows::<_, N>::new(Slope::UNKNOWN);
            let slopes = &mut slopes.room.as_flattened_mut()[..rows.len()];
            for step in STEPS.map(|part| part * reach) {
                let pairs = [1.0, 2.0, 3.0, 4.0]
                    .map(|times| [1.0, -1.0].map(|sign| moved(sign * times * step)));
                let mut is_exact = true;
                for (number, slope) in slopes.iter_mut().enumerate() {
                    let values = pairs.each_ref().map(|pair| {
                        pair.each_ref()
                            .map(|rows| rows.list().get(number).map_or(0.0, |row| row.value))
                    });
                    is_exact &= slope.refine(values, step);
                }
                if is_exact {
                    break;
                }
            }
            for (row, slope) in rows.iter_mut().zip(slopes) {
                if let Some(to) = row.equation.by.iter_mut().nth(column) {
                    *to = slope.value;
                }
            }
        }
        self.measured_by_rates(state, components, &mut rows[..kept]);
        first + kept
    }

    /// The derivatives of constraints by rates, and those of position constraints by coordinates.
    fn measured_by_rates<const M: usize>(
        &self,
        state: &B::State,
        components: &[f64; M],
        rows: &mut [Asked<N, M>],
    ) where
        B: Coordinated<N, M>,
        C: Conditions<B::State, B::Input>,
    {
        let places = B::PLACES.len();
        let mut rest = SVector::<f64, N>::zeros();
        let values = tangent::values::<_, N>(state, &Vector3::zeros());
        rest.rows_mut(places, places)
            .copy_from(&values.rows(places, places));
        let rest = tangent::moved(state, &-rest);
        let (still, _) = self.measure(&rest, components);
        for place in 0..places {
            let rate =
                SVector::<f64, N>::from_fn(|row, _| f64::from(u8::from(row == place + places)));
            let (moving, _) = self.measure(&tangent::moved(&rest, &rate), components);
            let pairs = moving.list().iter().zip(still.list());
            for (row, (moving, still)) in rows.iter_mut().zip(pairs) {
                match moving.rate.zip(still.rate) {
                    Some((moving, still)) => row.equation.by.state[place] = moving - still,
                    None => {
                        row.equation.by.state[place + places] = moving.value - still.value;
                    }
                }
            }
        }
    }

    /// Constraints, followed by conditions; also the number of constraints.
    fn measure<const M: usize>(
        &self,
        state: &B::State,
        components: &[f64; M],
    ) -> (Rows<Measured, N>, usize)
    where
        B: Coordinated<N, M>,
        C: Conditions<B::State, B::Input>,
    {
        let input = B::input(*components);
        let mut rows = Rows::new(Measured {
            name: "",
            value: 0.0,
            rate: None,
        });
        self.body
            .each_violation(self.time, state, &input, &mut |violation| {
                let Violation {
                    name,
                    position,
                    velocity,
                } = violation;
                if let Some(value) = position {
                    rows.push(Measured {
                        name,
                        value,
                        rate: Some(velocity),
                    });
                }
                rows.push(Measured {
                    name,
                    value: velocity,
                    rate: None,
                });
            });
        let kept = rows.count;
        self.conditions.each(state, &input, &mut |name, value| {
            rows.push(Measured {
                name,
                value,
                rate: None,
            });
        });
        (rows, kept)
    }
}

/// Restricts changes of the axes of rods, and of their rates, to those perpendicular to the axis.
fn axes<B, L, const N: usize, const M: usize>(values: &SVector<f64, N>, about: &mut About<L, N, M>)
where
    B: Coordinated<N, M>,
{
    for (row, place) in B::PLACES.iter().enumerate() {
        if *place == Place::Axis(0) {
            let [mut length, mut level] = [Asked::new("axis", 0.0); 2];
            let [along, rates] = [&mut length.equation.by, &mut level.equation.by];
            for part in row..row + vector(&B::PLACES[row..]) {
                let rate = part + B::PLACES.len();
                along.state[part] = values[part];
                rates.state[part] = values[rate];
                rates.state[rate] = values[part];
            }
            about.rows.push(length);
            about.rows.push(level);
        }
    }
}

/// The number of leading coordinates that form one vector.
fn vector(places: &[Place]) -> usize {
    let parts = places.iter().enumerate();
    parts
        .take_while(|(number, place)| place.component() == *number)
        .count()
        .min(3)
}
