//! The distance of a state from its constraints, and the correction.
//!
//! The projection moves the state along `M^-1 A^T`, which is the shortest way in the metric of the
//! kinetic energy: `S l = g` with `S = A M^-1 A^T`, then `q - M^-1 A^T l`. Velocities are moved in
//! the same way.
//!
//! The same metric bounds the rounding error of a constraint, by `|A q| <= sqrt(S) |q|`. For
//! positions, the size of the state is the radius of inertia of its mass about the origin; for
//! velocities, it is the kinetic energy.

use crate::mechanics::balances::{response, turned_by, twice_kinetic};
use crate::model::{Inertia, Model, Pair, Workspace};
use crate::symbolic::{Components, Function, Graph, Id, Node};

use super::constrained::Constrained;

/// One constraint, as it is passed to the runtime.
#[derive(Clone)]
pub struct Consistency {
    pub name: String,
    /// `g`, and the size of the terms of its sum.
    pub position: Option<(Id, Id)>,
    /// A cosine that is one in the assembly that is meant, and less in others where `g` is zero.
    pub facing: Option<Id>,
    /// `h`, and the size of the terms of its sum.
    pub velocity: (Id, Id),
    /// `M^-1 A^T`, in the order of the acceleration.
    pub direction: Vec<Id>,
    /// Its row of `S`.
    pub coupling: Vec<Id>,
    /// The index of the first row of the same joint that has the same dimension.
    pub part: usize,
    /// Whether it follows from the others wherever all of them hold.
    pub follows: bool,
}

impl Consistency {
    /// All its expressions.
    pub fn roots(&self) -> Vec<Id> {
        let (value, size) = self.velocity;
        let position = self
            .position
            .into_iter()
            .flat_map(|(value, size)| [value, size]);
        let own = [value, size].into_iter().chain(position);
        own.chain(self.facing)
            .chain(self.direction.iter().copied())
            .chain(self.coupling.iter().copied())
            .collect()
    }
}

pub fn derive_consistency(
    model: &Model,
    work: &mut Workspace,
    constraints: &[Constrained],
) -> Vec<Consistency> {
    let directions: Vec<Pair> = constraints
        .iter()
        .map(|constraint| {
            let Pair { linear, angular } = response(model, work, constraint.rates.factors);
            let graph = &mut work.graph;
            Pair {
                linear: graph.results(linear),
                angular: graph.results(angular),
            }
        })
        .collect();
    let list = constraints.iter().enumerate().map(|(row, constraint)| {
        let graph = &mut work.graph;
        let angular = constraint.rates.factors.angular;
        let factors = constraint.rates.factors;
        let coupling = directions.iter().map(|by| factors.dot(graph, *by));
        let coupling = coupling.collect();
        let position = constraint.position.map(|value| {
            let size = summed_size(graph, value);
            (value, with_angles(graph, size, angular))
        });
        let size = summed_size(graph, constraint.velocity);
        let velocity = (constraint.velocity, size);
        Consistency {
            name: constraint.name.clone(),
            position,
            facing: None,
            velocity,
            direction: {
                let Pair { linear, angular } = directions[row];
                let angular = match model.state.axis {
                    // for a rod, the change of its axis takes the place of the angular change
                    Some(axis) => turned_by(work, axis, angular),
                    None => angular,
                };
                let motion = model.motion;
                [
                    &linear[motion.linear_axes()],
                    &angular[motion.angular_axes()],
                ]
                .concat()
            },
            coupling,
            part: row,
            follows: false,
        }
    });
    list.collect()
}

/// The sizes that bound the rounding errors of a constraint in a state whose zeros may come from
/// cancellation.
pub struct Reach {
    pub position: Option<Id>,
    pub velocity: Id,
}

/// The bounds of each constraint.
pub fn derive_reach(
    model: &Model,
    work: &mut Workspace,
    constraints: &[Consistency],
) -> Vec<Reach> {
    if constraints.is_empty() {
        return Vec::new();
    }
    let (spread, motion) = (spread(model, work), twice_kinetic(model, work));
    let graph = &mut work.graph;
    let list = constraints.iter().enumerate().map(|(row, constraint)| {
        let coupling = constraint.coupling[row];
        let mut reach = |size: Id, of_state: Id| reached(graph, size, coupling, of_state);
        Reach {
            position: constraint.position.map(|(_, size)| reach(size, spread)),
            velocity: reach(constraint.velocity.1, motion),
        }
    });
    list.collect()
}

/// The size that bounds the rounding error of a constraint, from the size of its terms and that of
/// the state.
pub fn reached(graph: &mut Graph, size: Id, coupling: Id, of_state: Id) -> Id {
    let square = graph.multiply(coupling, of_state);
    let across = graph.apply(Function::Sqrt, &[square]);
    graph.apply(Function::Max, &[size, across])
}

/// `m r^2 + tr J`: an attitude has the rounding error of one radian.
fn spread(model: &Model, work: &mut Workspace) -> Id {
    let graph = &mut work.graph;
    let inertia = match &model.inertia {
        Inertia::Absent => graph.zero(),
        Inertia::Scalar(moment) => *moment,
        Inertia::Spatial(rows) => graph.sum(&[rows[0][0], rows[1][1], rows[2][2]]),
    };
    let Some(mass) = model.moved_mass() else {
        return inertia;
    };
    let square = work.norm_squared(model.state.position);
    let graph = &mut work.graph;
    let moving = graph.multiply(mass, square);
    graph.add(moving, inertia)
}

/// The size of the terms of a sum; for a product, the product of those of its factors.
pub fn summed_size(graph: &mut Graph, value: Id) -> Id {
    let (mut factors, mut sums, mut rest) = (vec![value], Vec::new(), graph.one());
    while let Some(factor) = factors.pop() {
        match *graph.node(factor) {
            Node::Multiply(a, b) => factors.extend([a, b]),
            Node::Divide(a, b) => {
                factors.push(a);
                rest = graph.divide(rest, b);
            }
            Node::Negate(a) | Node::Quantity(a) | Node::Positive(a) => factors.push(a),
            Node::Add(..) | Node::Subtract(..) => sums.push(factor),
            Node::Select(condition, a, b) => {
                let [a, b] = [a, b].map(|value| summed_size(graph, value));
                let size = graph.select(condition, a, b);
                rest = graph.multiply(rest, size);
            }
            _ => rest = graph.multiply(rest, factor),
        }
    }
    if sums.is_empty() {
        return graph.largest_term(value);
    }
    let rest = graph.apply(Function::Abs, &[rest]);
    sums.into_iter().fold(rest, |size, sum| {
        let largest = graph.largest_term(sum);
        graph.multiply(size, largest)
    })
}

/// Adds the size of angles: an attitude has the rounding error of one radian.
fn with_angles(graph: &mut Graph, size: Id, angular: Components) -> Id {
    angular.into_iter().fold(size, |size, part| {
        if graph.is_zero(part) {
            return size;
        }
        let part = graph.apply(Function::Abs, &[part]);
        graph.apply(Function::Max, &[size, part])
    })
}
