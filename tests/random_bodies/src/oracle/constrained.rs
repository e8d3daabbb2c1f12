//! Motion under constraints: the reactions for which the second derivatives of the constraints
//! vanish, by finite differences along the motion.
//!
//! ```text
//! a(u) = a_0 + sum of u_j D_j        u_j: the unknown reactions
//! g'' = A a + b = 0                   A D_j and b: differences in 106 bits
//! ```

use crate::description::body::{Constraint, Motion, What};
use crate::description::expression::Scalar;
use crate::given::Given;
use crate::wide::Wide;

use super::arithmetic::Values;
use super::constants::Constants;
use super::differences::settled;
use super::law::{Motions, acceleration};
use super::loads::{Wrench, acting};
use super::number::Number;
use super::scene::{Instant, Scene};
use super::step::Step;
use super::vector::Vector;

/// Accelerations, and the reactions by the place of their load.
pub struct Solved {
    pub motions: Motions,
    pub reactions: Vec<Vector>,
    /// How far linear and angular acceleration may be off by the differences.
    pub errors: [f64; 2],
    /// What reactions carry into them of the terms that cancel.
    pub carried: [f64; 2],
    /// The norm of the matrix times that of its inverse.
    pub condition: f64,
    pub is_near_switch: bool,
}

/// One unknown: the load that it is of, and its direction.
struct Unknown {
    load: usize,
    direction: Vector,
}

struct Problem<'a> {
    constants: &'a Constants<'a>,
    given: &'a Given,
    instant: &'a Instant,
    unknowns: Vec<Unknown>,
    is_near_switch: bool,
}

/// Nothing if there are not as many unknowns as constraints.
pub fn constrained(constants: &Constants<'_>, given: &Given, instant: &Instant) -> Option<Solved> {
    let mut problem = Problem::new(constants, given, instant);
    let n = problem.unknowns.len();
    let at = |problem: &mut Problem<'_>, values: &[Wide]| problem.accelerations(values);
    let free = at(&mut problem, &vec![Wide::ZERO; n]);
    // of the size of what they are taken from, so that no digits of them are lost
    let much = (free.linear.size + free.angular.size).max(1.0);
    let much = Wide::from(much.log2().ceil().exp2());
    let units: Vec<Motions> = (0..n)
        .map(|j| {
            let mut values = vec![Wide::ZERO; n];
            values[j] = much;
            let with = at(&mut problem, &values);
            Motions {
                linear: scaled(with.linear - free.linear, Wide::ONE / much),
                angular: scaled(with.angular - free.angular, Wide::ONE / much),
            }
        })
        .collect();
    let (mut rows, mut doubts) = (Vec::new(), Vec::new());
    let (mut right, mut errors, mut noise) = (Vec::new(), Vec::new(), Vec::new());
    let constraints = &constants.body.constraints;
    for (constraint, axis) in constraints
        .iter()
        .flat_map(|one| (0..one.count(constants.body)).map(move |axis| (one, axis)))
    {
        let slopes: Vec<(Wide, f64)> = units
            .iter()
            .map(|unit| problem.slope(constraint, axis, unit))
            .collect();
        doubts.push(slopes.iter().map(|slope| slope.1).collect::<Vec<f64>>());
        rows.push(slopes.iter().map(|slope| slope.0).collect::<Vec<Wide>>());
        let (rest, error) = problem.rest(constraint, axis, &free);
        right.push(-rest);
        errors.push(error);
        noise.push(problem.noise(constraint, axis, &free));
    }
    if rows.len() != n || n == 0 {
        return None;
    }
    let matrix = rows.clone();
    let inverse = inverted_by_pivots(rows)?;
    let norm = |matrix: &[Vec<Wide>]| {
        matrix
            .iter()
            .flatten()
            .map(|x| x.high * x.high)
            .sum::<f64>()
            .sqrt()
    };
    let condition = norm(&matrix) * norm(&inverse);
    let mut values = Vec::new();
    for row in &inverse {
        values.push(row.iter().zip(&right).map(|(x, y)| *x * *y).sum::<Wide>());
    }
    let motions = units
        .iter()
        .zip(&values)
        .fold(free, |sum, (unit, value)| Motions {
            linear: sum.linear + scaled(unit.linear, *value),
            angular: sum.angular + scaled(unit.angular, *value),
        });
    // of the terms that cancel in loads, in those that follow reactions, too
    let terms = motions.linear.size + motions.angular.size;
    for (error, doubts) in errors.iter_mut().zip(&doubts) {
        let doubted = doubts.iter().zip(&values);
        *error += doubted
            .map(|(doubt, value)| doubt * value.high.abs())
            .sum::<f64>();
        *error += 1e-28 * terms;
    }
    // from the right sides by the reactions
    let reached = |sides: &[f64]| {
        let mut parts = [0.0; 2];
        for (row, unit) in inverse.iter().zip(&units) {
            let of_value: f64 = row.iter().zip(sides).map(|(x, y)| x.high.abs() * y).sum();
            for (part, along) in parts.iter_mut().zip([unit.linear, unit.angular]) {
                *part += of_value * along.length().high;
            }
        }
        parts
    };
    let noise: Vec<f64> = noise.iter().map(|of_free| of_free + terms).collect();
    let carried = reached(&noise);
    let reactions = problem.reactions(&values);
    Some(Solved {
        motions,
        reactions,
        errors: reached(&errors),
        carried,
        condition,
        is_near_switch: problem.is_near_switch,
    })
}

fn scaled(vector: Vector, factor: Wide) -> Vector {
    vector.scaled(Number::exactly(factor))
}

impl Constraint {
    fn count(&self, body: &crate::description::body::Body) -> usize {
        match self {
            Self::Scalar(..) => 1,
            Self::Vector(..) => body.axes(),
        }
    }

    fn is_of_rates(&self) -> bool {
        match self {
            Self::Scalar(_, is_of_rates) | Self::Vector(_, is_of_rates) => *is_of_rates,
        }
    }
}

impl<'a> Problem<'a> {
    fn new(constants: &'a Constants<'a>, given: &'a Given, instant: &'a Instant) -> Self {
        let scene = Scene::at(constants, given, instant);
        let planar = constants.body.motion.is_planar();
        let mut unknowns = Vec::new();
        for (load, what) in constants
            .body
            .loads
            .iter()
            .map(|load| &load.what)
            .enumerate()
        {
            let (axes, parts, only) = match what {
                What::OpenForce(axes, parts, _) => (axes, parts, if planar { 0..2 } else { 0..3 }),
                What::OpenMoment(axes, parts) => (axes, parts, if planar { 2..3 } else { 0..3 }),
                What::OpenAlong(direction, _) => {
                    unknowns.push(Unknown {
                        load,
                        direction: scene.vector(direction),
                    });
                    continue;
                }
                _ => continue,
            };
            for axis in only.filter(|axis| parts[*axis].is_none()) {
                let unit = [0, 1, 2].map(|i| if i == axis { Number::ONE } else { Number::ZERO });
                unknowns.push(Unknown {
                    load,
                    direction: scene.written_in(*axes, Vector::new(unit)),
                });
            }
        }
        Self {
            constants,
            given,
            instant,
            unknowns,
            is_near_switch: scene.is_near_switch(),
        }
    }

    /// All loads that are known in part or not at all, world axes; zero in the place of others.
    fn reactions(&mut self, values: &[Wide]) -> Vec<Vector> {
        let scene = Scene::at(self.constants, self.given, self.instant);
        let planar = self.constants.body.motion.is_planar();
        let known = |part: &Option<Scalar>| {
            part.as_ref()
                .map_or(Number::ZERO, |part| scene.scalar(part))
        };
        let loads = self.constants.body.loads.iter();
        let mut all: Vec<Vector> = loads
            .map(|load| match &load.what {
                What::OpenForce(axes, parts, _) => {
                    scene.written_in(*axes, Vector::new([0, 1, 2].map(|i| known(&parts[i]))))
                }
                What::OpenMoment(axes, parts) if !planar => {
                    scene.written_in(*axes, Vector::new([0, 1, 2].map(|i| known(&parts[i]))))
                }
                _ => Vector::ZERO,
            })
            .collect();
        for (unknown, value) in self.unknowns.iter().zip(values) {
            all[unknown.load] = all[unknown.load] + scaled(unknown.direction, *value);
        }
        all
    }

    /// With these values of the unknowns.
    fn accelerations(&mut self, values: &[Wide]) -> Motions {
        let reactions = self.reactions(values);
        let scene =
            Scene::at(self.constants, self.given, self.instant).with_reactions(reactions.clone());
        let mut total = Wrench::ZERO;
        for (load, reaction) in self.constants.body.loads.iter().zip(&reactions) {
            let wrench = match &load.what {
                What::OpenForce(_, _, place) | What::OpenAlong(_, place) => {
                    Wrench::of_force(&scene, *reaction, place)
                }
                What::OpenMoment(..) => Wrench::couple(*reaction),
                _ => acting(&scene, load).map_or(Wrench::ZERO, |acting| acting.wrench),
            };
            total = total.and(wrench);
        }
        self.is_near_switch |= scene.is_near_switch();
        acceleration(&scene, &total)
    }

    /// The value of a constraint a step away.
    fn value(&mut self, constraint: &Constraint, axis: usize, step: &Step) -> Number {
        let instant = step.from(&self.constants.body.motion, self.instant);
        let scene = Scene::at(self.constants, self.given, &instant);
        let value = match constraint {
            Constraint::Scalar(scalar, _) => scene.scalar(scalar),
            Constraint::Vector(vector, _) => scene.vector(vector).component(axis),
        };
        self.is_near_switch |= scene.is_near_switch();
        value
    }

    /// `A D`: along an acceleration, positions and velocities change alike.
    fn slope(&mut self, constraint: &Constraint, axis: usize, along: &Motions) -> (Wide, f64) {
        let (linear, angular) = self.coordinates(along);
        let largest = linear
            .iter()
            .chain(&angular)
            .map(|x| x.high.abs())
            .fold(0.0, f64::max);
        if largest == 0.0 {
            return (Wide::ZERO, 0.0);
        }
        settled(
            1.0 / largest,
            |length| {
                let part = |vector: [Wide; 3]| vector.map(|x| x * length);
                let (linear, angular) = (part(linear), part(angular));
                let step = if constraint.is_of_rates() {
                    Step {
                        velocity: linear,
                        turning: angular,
                        ..Step::default()
                    }
                } else {
                    Step {
                        position: linear,
                        attitude: angular,
                        ..Step::default()
                    }
                };
                self.value(constraint, axis, &step)
            },
            1,
        )
    }

    /// The terms that the free accelerations are sums of, as far as a constraint sees them: `|A|` times
    /// their sizes.
    fn noise(&mut self, constraint: &Constraint, axis: usize, free: &Motions) -> f64 {
        let units = [0, 1, 2].map(|k| Vector::given([0, 1, 2].map(|i| f64::from(i == k))));
        let along = units.into_iter().flat_map(|unit| {
            let still = Motions {
                linear: Vector::ZERO,
                angular: Vector::ZERO,
            };
            let (linear, angular) = (
                Motions {
                    linear: unit,
                    ..still
                },
                Motions {
                    angular: unit,
                    ..still
                },
            );
            [(linear, free.linear.size), (angular, free.angular.size)]
        });
        along
            .map(|(unit, size)| self.slope(constraint, axis, &unit).0.high.abs() * size)
            .sum()
    }

    /// `A a + b` with this acceleration, and how far it may be off.
    fn rest(&mut self, constraint: &Constraint, axis: usize, motions: &Motions) -> (Wide, f64) {
        let order = if constraint.is_of_rates() { 1 } else { 2 };
        let length = 1.0 / self.speed(motions);
        settled(
            length,
            |length| {
                let step = self.along(motions, length);
                self.value(constraint, axis, &step)
            },
            order,
        )
    }

    fn speed(&self, motions: &Motions) -> f64 {
        let scene = Scene::at(self.constants, self.given, self.instant);
        let rates = [scene.velocity, scene.angular_velocity, scene.axis_rate];
        let rates = rates.map(|rate| rate.length().high);
        let roots = [motions.linear, motions.angular].map(|vector| vector.length().high.sqrt());
        rates.iter().chain(&roots).fold(1.0, |most, x| x.max(most))
    }

    /// Accelerations as changes of the coordinates.
    fn coordinates(&self, motions: &Motions) -> ([Wide; 3], [Wide; 3]) {
        let angular = motions.angular.value;
        let angular = if matches!(self.constants.body.motion, Motion::Planar) {
            [Wide::ZERO, Wide::ZERO, angular[0]]
        } else {
            angular
        };
        (motions.linear.value, angular)
    }

    /// So much later.
    fn along(&self, motions: &Motions, length: f64) -> Step {
        let scene = Scene::at(self.constants, self.given, self.instant);
        let (linear, angular) = self.coordinates(motions);
        let rate = match self.constants.body.motion {
            Motion::Rod(_) => scene.axis_rate.value,
            _ => scene.in_body(scene.angular_velocity).value,
        };
        let length = Wide::from(length);
        let half = length * length * 0.5;
        let moved = |first: [Wide; 3], second: [Wide; 3]| {
            [0, 1, 2].map(|i| first[i] * length + second[i] * half)
        };
        Step {
            time: length,
            position: moved(scene.velocity.value, linear),
            attitude: moved(rate, angular),
            velocity: linear.map(|x| x * length),
            turning: angular.map(|x| x * length),
        }
    }
}

/// By Gauss and Jordan, the largest pivots first; nothing of a singular matrix.
fn inverted_by_pivots(mut rows: Vec<Vec<Wide>>) -> Option<Vec<Vec<Wide>>> {
    let n = rows.len();
    for (i, row) in rows.iter_mut().enumerate() {
        row.extend((0..n).map(|j| if i == j { Wide::ONE } else { Wide::ZERO }));
    }
    for column in 0..n {
        let size = |row: &Vec<Wide>| row[column].high.abs();
        let pivot = (column..n).max_by(|a, b| size(&rows[*a]).total_cmp(&size(&rows[*b])))?;
        rows.swap(column, pivot);
        let divisor = rows[column][column];
        if divisor.high == 0.0 || !divisor.high.is_finite() {
            return None;
        }
        for entry in &mut rows[column] {
            *entry = *entry / divisor;
        }
        let line = rows[column].clone();
        for (other, row) in rows.iter_mut().enumerate() {
            let factor = row[column];
            if other != column {
                for (entry, of_line) in row.iter_mut().zip(&line) {
                    *entry = *entry - factor * *of_line;
                }
            }
        }
    }
    Some(rows.into_iter().map(|mut row| row.split_off(n)).collect())
}
