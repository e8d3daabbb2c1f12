//! Rotations of the world, and of the axes of a body, that leave an acceleration unchanged.
//!
//! A rotation by a small angle about e changes a state along
//!
//! ```text
//! the world    x' = e x x    v' = e x v    q' = (0, e) q / 2
//! the body     w' = e x w    q' = -q (0, e) / 2
//! ```
//!
//! and an acceleration is symmetric about e if it changes as the axes do in which it is written.
//! This condition is linear in e. Directions that satisfy it at some random states, and then at one
//! more random state, on every branch, satisfy it in all states. Only the result is emitted.

use std::ops::ControlFlow;

use crate::mechanics::balances::inertia_about_center;
use crate::mechanics::proofs::RandomState;
use crate::mechanics::variation::Direction;
use crate::model::{Inertia, Model, Workspace};
use crate::symbolic::{
    Algebra, Components, Function, Graph, Id, Node, Number, Residue, Residues, Spectrum, Tape,
    until_decided,
};

/// The directions about which a rotation changes nothing. A group of rotations has no other sets of
/// directions than these.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum Symmetry {
    None,
    About([f64; 3]),
    Every,
}

/// A set of directions, spanned by independent vectors.
pub struct Space<V = Number> {
    pub basis: Vec<[V; 3]>,
}

impl Space<Residue> {
    fn spanned_by(axes: &[usize]) -> Self {
        let unit =
            |axis: usize| [0, 1, 2].map(|i| [Residue::ZERO, Residue::ONE][usize::from(i == axis)]);
        Self {
            basis: axes.iter().map(|axis| unit(*axis)).collect(),
        }
    }

    /// Keeps only the directions that are perpendicular to `normal`.
    fn cut(&mut self, normal: &[Residue; 3]) {
        let dot = |vector: &[Residue; 3]| {
            vector[0] * normal[0] + vector[1] * normal[1] + vector[2] * normal[2]
        };
        let mut values: Vec<Residue> = self.basis.iter().map(dot).collect();
        let Some(pivot) = values.iter().position(|value| !value.is_zero()) else {
            return;
        };
        let (removed, divisor) = (self.basis.remove(pivot), values.remove(pivot));
        let inverse = divisor.reciprocal().unwrap_or(Residue::ZERO);
        for (vector, value) in self.basis.iter_mut().zip(&values) {
            let factor = *value * inverse;
            for (part, of_removed) in vector.iter_mut().zip(removed) {
                *part = *part + -(factor * of_removed);
            }
        }
    }

    /// The same directions in numbers, if these have few digits.
    fn numbers(&self) -> Option<Space> {
        let basis = self.basis.iter().map(|direction| {
            let lead = direction
                .iter()
                .find(|part| !part.is_zero())?
                .reciprocal()?;
            let [x, y, z] = direction.map(|part| (part * lead).to_number());
            Some([x?, y?, z?])
        });
        Some(Space {
            basis: basis.collect::<Option<_>>()?,
        })
    }

    /// The known axis, if it is the only direction.
    fn along(&self, axis: &[Number; 3]) -> Option<Space> {
        let [direction] = self.basis.as_slice() else {
            return None;
        };
        let known = axis.each_ref().map(Number::residue);
        let is_parallel = [(1, 2), (2, 0), (0, 1)]
            .into_iter()
            .all(|(i, j)| direction[i] * known[j] == direction[j] * known[i]);
        is_parallel.then(|| Space {
            basis: vec![axis.clone()],
        })
    }
}

impl Space {
    pub fn symmetry(&self) -> Symmetry {
        match self.basis.as_slice() {
            [_, _, _] => Symmetry::Every,
            _ => self.axis().map_or(Symmetry::None, |axis| {
                Symmetry::About(axis.map(|part| part.to_f64()))
            }),
        }
    }

    /// The unit vector along the only direction, with its first nonzero component positive.
    pub fn axis(&self) -> Option<[Number; 3]> {
        match self.basis.as_slice() {
            [direction] => unit(direction),
            _ => None,
        }
    }
}

fn unit(direction: &[Number; 3]) -> Option<[Number; 3]> {
    let square = direction.iter().fold(Number::zero(), |sum, part| {
        sum + part.clone() * part.clone()
    });
    let length = Number::apply(Function::Sqrt, &[square])?;
    let leads_with_minus = direction.iter().find(|part| !part.is_zero())?.is_negative();
    let length = if leads_with_minus { -length } else { length };
    let [x, y, z] = direction
        .each_ref()
        .map(|part| part.clone().checked_div(&length));
    Some([x?, y?, z?])
}

/// The directions about which the world may be rotated and those about which the axes of the body
/// may be, for the linear acceleration and for the angular one.
pub fn symmetries(
    model: &Model,
    work: &mut Workspace,
    linear: &Components,
    angular: &Components,
) -> [[Space; 2]; 2] {
    let is_rod = model.motion.is_line();
    let axes: &[usize] = if model.motion.is_hinged() {
        &[]
    } else if model.motion.is_planar {
        &[2]
    } else {
        &[0, 1, 2]
    };
    let of_body = if is_rod { &[] } else { axes };
    let about = work.graph.unit_vectors();
    let world = about.map(|e| Direction::turn_of_world(model, work, e));
    let body = about.map(|e| Direction::turn_of_axes(model, work, e));
    let known = axis_of_tensor(model, work);
    // the linear acceleration, and the acceleration of the axis of a rod, are written in world axes
    [(linear, true), (angular, is_rod)].map(|(vector, is_in_world)| {
        let roots = roots(&mut work.graph, vector);
        [(&world, is_in_world, axes), (&body, !is_in_world, of_body)].map(
            |(turns, is_turned, axes)| {
                let case = Case {
                    work,
                    roots: &roots,
                    turns,
                    is_turned,
                    axes,
                    known: &known,
                };
                case.space()
            },
        )
    })
}

/// The axis of a tensor of numbers, if two of its moments are equal.
fn axis_of_tensor(model: &Model, work: &mut Workspace) -> Option<[Number; 3]> {
    let Inertia::Spatial(rows) = inertia_about_center(model, work) else {
        return None;
    };
    match work.graph.spectrum(&rows)? {
        Spectrum::Symmetric(symmetry) => Some(symmetry.axis),
        _ => None,
    }
}

/// The conditions of branches, the arguments of piecewise functions, and divisors, including those
/// of a tangent. If these are unchanged, nothing jumps. Without them, expressions without a slope
/// would count as unchanged: `atan(tan x) - x`, `x / |x|`.
fn guards(graph: &mut Graph, roots: &[Id]) -> Vec<Id> {
    let mut guards = Vec::new();
    for id in graph.nodes_of(roots) {
        match *graph.node(id) {
            Node::Compare(_, a, b) => guards.push(graph.subtract(a, b)),
            Node::Unary(function, a) if function.is_piecewise() => guards.push(a),
            Node::Binary(function, a, b) if function.is_piecewise() => guards.extend([a, b]),
            Node::Unary(Function::Tan | Function::Ln, a) | Node::Positive(a) => guards.push(a),
            Node::Binary(Function::Atan2, a, b) => guards.extend([a, b]),
            Node::Divide(_, b) | Node::Pivot(b, _) => guards.push(b),
            Node::Foreign(_, arguments) => guards.extend(arguments),
            _ => {}
        }
    }
    guards.retain(|guard| !graph.is_early(*guard));
    guards.sort_unstable();
    guards.dedup();
    guards
}

/// The components of a vector, and the conditions of its branches.
fn roots(graph: &mut Graph, vector: &Components) -> Vec<Id> {
    let guards = guards(graph, vector);
    vector.iter().copied().chain(guards).collect()
}

/// A test of which rotations leave a vector and the conditions of its branches unchanged.
struct Case<'a> {
    work: &'a Workspace,
    /// The vector, followed by the conditions.
    roots: &'a [Id],
    turns: &'a [Direction; 3],
    /// Whether the rotations also rotate the axes in which the vector is written.
    is_turned: bool,
    /// The axes that span the possible directions.
    axes: &'a [usize],
    /// An axis that may be one of the directions.
    known: &'a Option<[Number; 3]>,
}

impl Case<'_> {
    /// The directions that satisfy the conditions at some random states, and all of them again at
    /// another one, so that they do not depend on the state. Nothing is claimed for directions
    /// whose components have many digits.
    fn space(&self) -> Space {
        let none = Space { basis: Vec::new() };
        if self.axes.is_empty() {
            return none;
        }
        let graph = &self.work.graph;
        let changes = self.turns.iter().flat_map(|turn| turn.changes.values());
        let all: Vec<Id> = self.roots.iter().chain(changes).copied().collect();
        let tape = graph.tape(&all);
        if !tape.has_small_degree() {
            return none;
        }
        let mut space = Space::spanned_by(self.axes);
        for number in 0.. {
            let before = space.basis.len();
            let state = RandomState::draw(number);
            until_decided(|residues| {
                for normal in self.changes(&tape, residues, &state) {
                    match normal {
                        [Some(x), Some(y), Some(z)] => space.cut(&[x, y, z]),
                        // an expression without a value cannot be proved symmetric
                        _ => space.basis.clear(),
                    }
                }
                if space.basis.is_empty() {
                    ControlFlow::Break(())
                } else {
                    ControlFlow::Continue(())
                }
            });
            if space.basis.is_empty() || space.basis.len() == before {
                break;
            }
        }
        space
            .numbers()
            .or_else(|| space.along(self.known.as_ref()?))
            .unwrap_or(none)
    }

    /// For each root, its changes under rotations about the three axes, minus the rotation of its
    /// own axes.
    fn changes(
        &self,
        tape: &Tape<'_>,
        residues: &mut Residues<'_>,
        state: &RandomState,
    ) -> Vec<[Option<Residue>; 3]> {
        let values = tape.values(residues, |_, id| Some(state.of(self.work, id)));
        let turned = self.turns.each_ref().map(|turn| {
            let change = |symbol: Id| Some(*tape.of(&values, *turn.changes.get(&symbol)?));
            tape.changes(residues, &values, change)
        });
        let change = |root: &Id| {
            let changes = turned.each_ref().map(|changes| tape.of(changes, *root));
            changes.map(|change| change.unwrap_or(Some(Residue::ZERO)))
        };
        let mut changes: Vec<[Option<Residue>; 3]> = self.roots.iter().map(change).collect();
        if self.is_turned {
            // minus e x a
            for (i, j, k) in [(0, 1, 2), (1, 2, 0), (2, 0, 1)] {
                let part = |i: usize| tape.of(&values, self.roots[i]);
                changes[j][i] = residues.add(&changes[j][i], part(k));
                changes[k][i] = residues.subtract(&changes[k][i], part(j));
            }
        }
        changes
    }
}
