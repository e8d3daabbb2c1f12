//! The distance to the constraints, and the correction: Newton's method in the metric of the
//! kinetic energy.

use crate::bodies::body::RigidBody;
use crate::bodies::constrained::Inconsistent;
use crate::bodies::facing::face;
use crate::state::{Coordinates, State};

/// A body whose motion is kept to `N` constraints.
pub trait Kept<const N: usize>: RigidBody {
    /// The constraints in a state.
    fn rows(
        &self,
        time: Self::Scalar,
        state: &Self::State,
        input: &Self::Input,
    ) -> [Row<<Self::State as State>::Rate, N>; N];
}

/// One constraint in one state, as generated code provides it.
#[derive(Clone, Copy, Debug)]
pub struct Row<R, const N: usize> {
    /// Its name.
    pub name: &'static str,
    /// Its value, and the size of the terms of its sum.
    pub position: Option<(f64, f64)>,
    /// A cosine that is one in the assembly that is meant, and less in others where the value is
    /// zero.
    pub facing: f64,
    /// Its rate, likewise.
    pub velocity: (f64, f64),
    /// `M⁻¹ Aᵀ` as a displacement of the coordinates.
    pub shift: R,
    /// `M⁻¹ Aᵀ` as a displacement of the velocities.
    pub push: R,
    /// Its row of `A M⁻¹ Aᵀ`.
    pub coupling: [f64; N],
    /// The index of the first row of the same joint that has the same dimension.
    pub part: usize,
    /// Whether it follows from the others in all states in which all hold.
    pub follows: bool,
}

/// The value of a constraint and its rate, each with its typical size in such a state.
#[derive(Clone, Copy, Debug)]
pub struct Size {
    /// Its name.
    pub name: &'static str,
    /// None for a velocity constraint.
    pub position: Option<(f64, f64)>,
    /// The cosine as of [`Row`].
    pub facing: f64,
    /// For a velocity constraint, its value.
    pub velocity: (f64, f64),
}

/// Checks that all values are rounding.
///
/// # Errors
/// [`Inconsistent`] with the constraint of the largest violation; positions come first.
pub fn check(sizes: &[Size]) -> Result<(), Inconsistent> {
    for is_velocity in [false, true] {
        let mut worst = (Inconsistent::ROUNDING, None);
        for row in sizes {
            let measured = if is_velocity {
                Some(row.velocity)
            } else {
                row.position
            };
            let Some((value, size)) = measured else {
                continue;
            };
            let value = if is_velocity {
                value
            } else {
                off(value, row.facing)
            };
            let relative = relative(value, size);
            if relative.is_nan() || relative > worst.0 {
                let (constraint, violation) = (row.name, value);
                let is_start = true;
                worst = (
                    relative,
                    Some(Inconsistent {
                        constraint,
                        violation,
                        is_velocity,
                        is_start,
                    }),
                );
            }
        }
        if let Some(inconsistent) = worst.1 {
            return Err(inconsistent);
        }
    }
    Ok(())
}

/// The value of a constraint of an angle, given the cosine of the angle by which the assembly is
/// turned from the one that is meant. Beyond 60 degrees the value may be zero again: then `1 - cosine`
/// takes its place.
#[must_use]
pub fn off(value: f64, cosine: f64) -> f64 {
    if cosine < 0.5 { 1.0 - cosine } else { value }
}

/// Values whose squares underflow, which are part of sizes; with a margin for rounding.
const NOTHING: f64 = 1e-138;

/// A value as a fraction of its size; zero is zero at any size.
fn relative(value: f64, size: f64) -> f64 {
    if value.abs() <= NOTHING {
        0.0
    } else {
        value.abs() / size
    }
}

/// The limit of Newton steps: an error of the size of the body takes about six.
const STEPS: usize = 20;

/// The shortest share of a step of Newton's method that is tried.
const SHORTEST: f64 = 1.0 / 64.0;

/// The number of steps that may leave more than half of their initial error.
const SLOW: usize = 4;

/// Projects a state onto its constraints; `rows` evaluates them.
///
/// # Errors
/// [`Inconsistent`].
pub fn project<S, const N: usize>(
    state: &mut S,
    rows: impl Fn(&S) -> [Row<S::Rate, N>; N],
) -> Result<(), Inconsistent>
where
    S: Coordinates<Scalar = f64, Acceleration: Default>,
{
    let mut start = state.clone();
    let place =
        |state: &mut S, pace| newton(state, &rows, pace, |row| row.position, |row| row.shift);
    if place(state, Pace::Near).is_err() {
        face(&mut start, |state| rows(state).map(|row| row.facing));
        *state = start.clone();
        if place(state, Pace::Full).is_err() {
            *state = start;
            place(state, Pace::Damped)?;
        }
    }
    let velocity = |row: &Row<S::Rate, N>| Some(row.velocity);
    newton(state, &rows, Pace::Velocity, velocity, |row| row.push)
}

/// The mode of Newton's method.
#[derive(Clone, Copy, PartialEq)]
enum Pace {
    /// Full steps, unless the state is nearer to another assembly than the one that is meant.
    Near,
    Full,
    /// Shorter steps, each of which reduces the error. Far from the constraints, rows contradict
    /// each other if they are dependent where all constraints hold.
    Damped,
    /// Velocities, which are linear.
    Velocity,
}

/// Takes steps until the error is rounding, or no step reduces it.
fn newton<S: State<Scalar = f64>, const N: usize>(
    state: &mut S,
    rows: &impl Fn(&S) -> [Row<S::Rate, N>; N],
    pace: Pace,
    measured: impl Fn(&Row<S::Rate, N>) -> Option<(f64, f64)>,
    direction: impl Fn(&Row<S::Rate, N>) -> S::Rate,
) -> Result<(), Inconsistent> {
    // terms may vanish together with their sum: the largest size so far is used
    let mut sizes = [0.0_f64; N];
    let (mut previous, mut slow) = (f64::INFINITY, 0);
    let (steps, most) = match pace {
        Pace::Damped => (16 * STEPS, 16 * STEPS),
        Pace::Near | Pace::Full | Pace::Velocity => (STEPS, SLOW),
    };
    for step in 0..=steps {
        let system = rows(state);
        if pace == Pace::Near {
            assembled(&system, pace)?;
        }
        let mut values = [None; N];
        // sizes on the way may be those of a distant state, which say nothing here
        let mut is_close = true;
        let mut worst = 0.0_f64;
        // if all velocities have to vanish, what is left is large among its own terms
        let mut is_left = false;
        let all = sizes.iter_mut().zip(&mut values);
        for (row, (seen, kept)) in system.iter().zip(all) {
            let Some((value, size)) = measured(row) else {
                continue;
            };
            is_close &= relative(value, size) <= Inconsistent::TOLERANCE;
            *seen = seen.max(size);
            *kept = Some(value);
            is_left |= pace == Pace::Velocity && relative(value, size) > Inconsistent::ROUNDING;
            let relative = relative(value, *seen);
            if relative.is_nan() || relative > worst {
                worst = relative;
            }
        }
        if worst <= 4.0 * f64::EPSILON && !is_left {
            return assembled(&system, pace);
        }
        let is_last = step == steps;
        if worst.is_nan() || worst > 0.5 * previous || is_last {
            if is_close || is_rounding(&system, &measured) {
                return assembled(&system, pace);
            }
            // far from the constraints, some steps overshoot
            slow += 1;
            if worst.is_nan() || slow > most || is_last {
                let (constraint, violation) = farthest(&system, &values);
                let is_velocity = pace == Pace::Velocity;
                return Err(Inconsistent {
                    constraint,
                    violation,
                    is_velocity,
                    is_start: false,
                });
            }
        }
        previous = worst;
        let damping = match pace {
            Pace::Damped => worst.min(1.0),
            Pace::Near | Pace::Full | Pace::Velocity => 0.0,
        };
        let factors = solve(&system, values, damping);
        // one displacement: rotations one after another would depend on the order of the rows
        let parts = system
            .iter()
            .zip(factors)
            .filter(|(_, factor)| *factor != 0.0);
        let parts = parts.map(|(row, factor)| direction(row) * -factor);
        let Some(correction) = parts.reduce(|sum, part| sum + part) else {
            continue;
        };
        let moved = |share: f64| state.moved(&(correction * share));
        let mut next = moved(1.0);
        if pace == Pace::Damped && worst > Inconsistent::TOLERANCE {
            let off = |state: &S| {
                let rows = rows(state);
                let values = rows.iter().zip(&sizes).filter_map(|(row, size)| {
                    let (value, _) = measured(row)?;
                    Some(relative(value, *size))
                });
                values.fold(0.0, f64::max)
            };
            let mut share = 1.0;
            while share > SHORTEST && off(&next) > (1.0 - 0.25 * share) * worst {
                share *= 0.5;
                next = moved(share);
            }
        }
        *state = next;
    }
    Ok(())
}

/// An error if the values are zero in another assembly than the one that is meant.
fn assembled<R, const N: usize>(system: &[Row<R, N>; N], pace: Pace) -> Result<(), Inconsistent> {
    let reversed = system.iter().find(|row| row.facing < 0.5);
    match reversed.filter(|_| pace != Pace::Velocity) {
        Some(row) => Err(Inconsistent {
            constraint: row.name,
            violation: off(0.0, row.facing),
            is_velocity: false,
            is_start: false,
        }),
        None => Ok(()),
    }
}

/// Whether all values are rounding, compared with the motion given by the largest terms of any row.
/// All terms of one row may vanish where those of another do not.
fn is_rounding<R, const N: usize>(
    system: &[Row<R, N>; N],
    measured: impl Fn(&Row<R, N>) -> Option<(f64, f64)>,
) -> bool {
    let natural = natural(system);
    let rows = || {
        let rows = system.iter().zip(natural);
        rows.filter_map(|(row, natural)| Some((measured(row)?, natural)))
    };
    // twice the kinetic energy, or the equivalent for positions, of a motion across one row alone
    let across = rows().filter(|(_, natural)| *natural > 0.0);
    let across = across.map(|((_, size), natural)| size * size / natural);
    let most = across.fold(0.0, f64::max);
    rows().all(|((value, _), natural)| {
        value.is_finite() && value.abs() <= Inconsistent::TOLERANCE * libm::sqrt(natural * most)
    })
}

/// The name and the value of the row that takes the largest displacement to satisfy alone; among
/// rows that no displacement satisfies, of the largest value.
fn farthest<R, const N: usize>(
    system: &[Row<R, N>; N],
    values: &[Option<f64>; N],
) -> (&'static str, f64) {
    let rows = system.iter().zip(values).zip(natural(system));
    let rows = rows.filter_map(|((row, value), natural)| Some((row.name, (*value)?, natural)));
    let measured = rows.filter(|(_, value, _)| *value != 0.0);
    let measured = measured.map(|(name, value, natural)| (value * value / natural, name, value));
    let farther = |a: &(f64, _, f64), b: &(f64, _, f64)| {
        a.0.total_cmp(&b.0).then(a.2.abs().total_cmp(&b.2.abs()))
    };
    let farthest = measured.max_by(farther);
    farthest.map_or(("", 0.0), |(_, name, value)| (name, value))
}

/// Typical couplings for rows of these sizes: a row may be flat where all hold.
fn natural<R, const N: usize>(system: &[Row<R, N>; N]) -> [f64; N] {
    let square = |row: &Row<R, N>| row.position.map_or(0.0, |(_, size)| size * size);
    // terms that vanish together give no size
    let most = system.iter().map(square).fold(0.0, f64::max);
    let largest = system
        .iter()
        .enumerate()
        .filter(|(_, row)| square(row) > 1e-6 * most)
        .map(|(own, row)| row.coupling[own] / square(row))
        .fold(0.0, f64::max);
    core::array::from_fn(|own| {
        let row = &system[own];
        row.coupling[own].max(largest * square(row))
    })
}

/// A row depends on those before it if at most this fraction of its square remains: an angle of a
/// millionth, below which the remainder is rounding, or vanishes with the next steps.
const DEPENDENT: f64 = 1e-12;

/// Solves `(A M⁻¹ Aᵀ + damping) λ = g` by elimination along the diagonal, which is positive; a row
/// that depends on others in this state gets no load.
fn solve<R, const N: usize>(
    system: &[Row<R, N>; N],
    kept: [Option<f64>; N],
    damping: f64,
) -> [f64; N] {
    let mut matrix: [[f64; N]; N] = core::array::from_fn(|row| system[row].coupling);
    let natural = natural(system);
    for (own, natural) in natural.iter().enumerate() {
        matrix[own][own] += damping * natural;
    }
    let mut values = kept.map(Option::unwrap_or_default);
    let places = eliminate(system, &mut matrix, &mut values, |pivot, divisor| {
        kept[pivot].is_some() && divisor > DEPENDENT * natural[pivot]
    });
    let mut factors = [0.0; N];
    for place in (1..=N).rev() {
        for pivot in (0..N).filter(|row| places[*row] == place) {
            let later = (0..N).filter(|column| places[*column] > place);
            let known: f64 = later
                .map(|column| matrix[pivot][column] * factors[column])
                .sum();
            factors[pivot] = (values[pivot] - known) / matrix[pivot][pivot];
        }
    }
    factors
}

/// A row waits for the others if at most this fraction of the largest square among the rows of its
/// joint remains: where it is flat, its value is the rounding error of others.
const WEAK: f64 = 1e-12;

/// Subtracts each row that `can_be_used`, given by its index and its divisor, from those that are
/// left. Returns the place of each row in the order of their use, from one; zero if it is not used.
fn eliminate<R, const N: usize>(
    system: &[Row<R, N>; N],
    matrix: &mut [[f64; N]; N],
    values: &mut [f64; N],
    can_be_used: impl Fn(usize, f64) -> bool,
) -> [usize; N] {
    let strongest: [f64; N] = core::array::from_fn(|own| {
        let alike = (0..N).filter(|other| system[*other].part == system[own].part);
        alike
            .map(|other| system[other].coupling[other])
            .fold(0.0, f64::max)
    });
    let (mut places, mut count) = ([0; N], 0);
    for least in [WEAK, 0.0] {
        for pivot in 0..N {
            let divisor = matrix[pivot][pivot];
            let is_strong = divisor > least * strongest[pivot];
            if places[pivot] > 0 || !is_strong || !can_be_used(pivot, divisor) {
                continue;
            }
            count += 1;
            places[pivot] = count;
            let known = matrix[pivot];
            for row in (0..N).filter(|row| places[*row] == 0) {
                let factor = matrix[row][pivot] / divisor;
                for (entry, part) in matrix[row].iter_mut().zip(known) {
                    *entry -= factor * part;
                }
                values[row] -= factor * values[pivot];
            }
        }
    }
    places
}

/// The same fraction for the reason of a failure, which may occur just before: an angle of a
/// thousandth.
const NEARLY_DEPENDENT: f64 = 1e-6;

/// The first constraint that depends on those before it in this state, if fewer constraints are
/// independent here than in other consistent states.
pub fn dependent<R, const N: usize>(system: &[Row<R, N>; N]) -> Option<&'static str> {
    let mut matrix: [[f64; N]; N] = core::array::from_fn(|row| system[row].coupling);
    let natural = natural(system);
    let places = eliminate(system, &mut matrix, &mut [0.0; N], |pivot, divisor| {
        divisor > NEARLY_DEPENDENT * natural[pivot]
    });
    let count = places.iter().filter(|place| **place > 0).count();
    let expected = system.iter().filter(|row| !row.follows).count();
    if count >= expected {
        return None;
    }
    let rows = system.iter().enumerate();
    let mut rows = rows.filter(|(own, _)| places[*own] == 0);
    let others = rows.clone().find(|(_, row)| !row.follows);
    others.or_else(|| rows.next()).map(|(_, row)| row.name)
}
