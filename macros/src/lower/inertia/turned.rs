//! Inertia in rotated axes.
//!
//! A tensor is `lambda` times the unit matrix, plus a dyad along the axis of each principal moment
//! that differs from `lambda`. A rotation changes only the dyads, so equal moments stay equal and
//! quarter turns are exact.

use proc_macro2::Ident;

use crate::lower::expressions::Lowering;
use crate::model::{Dimension, Inertia};
use crate::symbolic::{Components, Function, Graph, Id};
use crate::syntax::{Description, Expression, Kind};

use super::draft::Draft;
use super::form::CONSTANT;

/// A symmetric matrix, by rows.
type Matrix = [Components; 3];

impl Lowering<'_> {
    /// `.along(direction)`: rotates the axis of symmetry from z to `direction`.
    pub fn along(
        &mut self,
        draft: Option<Draft>,
        place: &Ident,
        written: &[Expression],
    ) -> Option<Draft> {
        self.refuse_of_rod(place)?;
        let [written] = written else {
            return self.report(
                place.span(),
                "`.along` takes one direction: write `.along(body(1, 0, 0))`",
            );
        };
        let direction = self.body_direction(written);
        let (draft, direction) = (draft?, direction?);
        if let Inertia::Scalar(_) = draft.inertia {
            return self.report(
                place.span(),
                "one number has no axis: only a solid can lie along a direction",
            );
        }
        let graph = &mut self.work.graph;
        let rows = draft.inertia.rows(graph);
        let is_symmetric = |axis: &usize| {
            rows[(axis + 1) % 3][(axis + 1) % 3] == rows[(axis + 2) % 3][(axis + 2) % 3]
        };
        let axis = [2, 0, 1].into_iter().find(is_symmetric);
        let (Some(axis), true) = (axis, is_diagonal(graph, &rows)) else {
            return self.report(
                place.span(),
                "this has no axis of symmetry that could lie along a direction: write \
                 `.turned(axis, angle)`",
            );
        };
        let across = rows[(axis + 1) % 3][(axis + 1) % 3];
        let square = graph.norm_squared(direction);
        let one = graph.one();
        let scale = graph.divide(one, square);
        let dyad = outer(graph, direction).map(|row| graph.scale_vector(scale, row));
        let turned = from_dyads(graph, across, &[(rows[axis][axis], dyad)]);
        let inertia = draft.inertia.with_rows(turned);
        Some(Draft { inertia, ..draft })
    }

    /// Checks the direction of a copy, which is the last method of its inertia.
    pub fn check_direction(&mut self, copy: &Description) {
        let written = copy.inertia.as_ref();
        let written = written.and_then(|written| written.value.as_ref());
        if let Some(Kind::Method(_, _, directions)) = written.map(|written| &written.kind) {
            for direction in directions {
                self.body_direction(direction);
            }
        }
    }

    /// `.turned(axis, angle)`: rotated about `axis`, by the right-hand rule.
    pub fn turned(
        &mut self,
        draft: Option<Draft>,
        place: &Ident,
        written: &[Expression],
    ) -> Option<Draft> {
        if self.motion.is_planar {
            return self.report(
                place.span(),
                "in the plane the inertia is the same however the body is turned: leave \
                 `.turned(..)` out",
            );
        }
        self.refuse_of_rod(place)?;
        let [axis, angle] = written else {
            return self.report(
                place.span(),
                "`.turned` takes an axis and an angle: write `.turned(body(0, 0, 1), 90[deg])`",
            );
        };
        let direction = self.body_direction(axis);
        let by = self.scalar(angle, Dimension::NONE, "an angle");
        let (draft, direction, by) = (draft?, direction?, by?);
        self.check_early(angle, &[by], CONSTANT)?;
        let graph = &mut self.work.graph;
        let rotation = rotation(graph, direction, by);
        let rows = draft.inertia.rows(graph);
        let turned = rotate(graph, &rotation, &rows);
        let inertia = draft.inertia.with_rows(turned);
        Some(Draft { inertia, ..draft })
    }

    fn refuse_of_rod(&mut self, place: &Ident) -> Option<()> {
        if self.motion.is_line() {
            return self.report(
                place.span(),
                format!("a rod lies along its axis: leave `.{place}(..)` out"),
            );
        }
        Some(())
    }

    /// A constant nonzero vector in body axes.
    fn body_direction(&mut self, written: &Expression) -> Option<Components> {
        let vector = self.direction_in("body", written, Dimension::ANY)?;
        if !self.work.is_in(vector, self.state.body) {
            return self.report(
                written.extent,
                "this direction is fixed in the body: write `body(..)`",
            );
        }
        if vector.is_zero() {
            return self.report(written.extent, "the zero vector has no direction");
        }
        let direction = self.work.part(vector, self.state.body);
        self.check_early(written, &direction, CONSTANT)?;
        Some(direction)
    }
}

fn is_diagonal(graph: &Graph, rows: &Matrix) -> bool {
    [(0, 1), (1, 2), (2, 0)]
        .into_iter()
        .all(|(i, j)| graph.is_zero(rows[i][j]))
}

/// `a a`
fn outer(graph: &mut Graph, a: Components) -> Matrix {
    a.map(|component| graph.scale_vector(component, a))
}

/// `lambda 1 + sum of (J_k - lambda) n_k n_k`, for unit vectors `n_k`.
fn from_dyads(graph: &mut Graph, lambda: Id, dyads: &[(Id, Matrix)]) -> Matrix {
    [0, 1, 2].map(|i| {
        [0, 1, 2].map(|j| {
            // lambda times the unit matrix without the dyads: moments are not subtracted
            let mut rest = if i == j { graph.one() } else { graph.zero() };
            let mut sum = graph.zero();
            for (moment, dyad) in dyads {
                let share = graph.multiply(*moment, dyad[i][j]);
                sum = graph.add(sum, share);
                rest = graph.subtract(rest, dyad[i][j]);
            }
            let rest = graph.multiply(lambda, rest);
            graph.add(sum, rest)
        })
    })
}

/// The matrix of a rotation by an angle about a direction: `c 1 + s [n] + (1 - c) n n`.
pub fn rotation(graph: &mut Graph, direction: Components, angle: Id) -> Matrix {
    let (cosine, sine) = cosine_and_sine(graph, angle);
    let square = graph.norm_squared(direction);
    let norm = graph.apply(Function::Sqrt, &[square]);
    let along = graph.divide(sine, norm);
    let [x, y, z] = graph.scale_vector(along, direction);
    let minus = [x, y, z].map(|component| graph.negate(component));
    let zero = graph.zero();
    let skew = [
        [zero, minus[2], y],
        [z, zero, minus[0]],
        [minus[1], x, zero],
    ];
    let one = graph.one();
    let versine = graph.subtract(one, cosine);
    let scale = graph.divide(versine, square);
    let mut rows = outer(graph, direction).map(|row| graph.scale_vector(scale, row));
    for (i, row) in rows.iter_mut().enumerate() {
        row[i] = graph.add(row[i], cosine);
        *row = graph.add_vectors(*row, skew[i]);
    }
    rows
}

/// Cosine and sine; where one is zero, the other is exactly one or minus one.
fn cosine_and_sine(graph: &mut Graph, angle: Id) -> (Id, Id) {
    let cosine = graph.apply(Function::Cos, &[angle]);
    let sine = graph.apply(Function::Sin, &[angle]);
    if graph.is_zero(cosine) {
        (cosine, graph.apply(Function::Signum, &[sine]))
    } else if graph.is_zero(sine) {
        (graph.apply(Function::Signum, &[cosine]), sine)
    } else {
        (cosine, sine)
    }
}

/// `R J R^T`
fn rotate(graph: &mut Graph, rotation: &Matrix, rows: &Matrix) -> Matrix {
    let moments = [rows[0][0], rows[1][1], rows[2][2]];
    let is_repeated = |axis: &usize| moments[(axis + 1) % 3] == moments[(axis + 2) % 3];
    let lambda = [2, 0, 1]
        .into_iter()
        .find(is_repeated)
        .map_or(moments[2], |axis| moments[(axis + 1) % 3]);
    let mut dyads = Vec::new();
    for (k, moment) in moments.into_iter().enumerate() {
        if moment != lambda {
            let axis = rotation.map(|row| row[k]);
            dyads.push((moment, outer(graph, axis)));
        }
    }
    let mut turned = from_dyads(graph, lambda, &dyads);
    for (k, l) in [(0, 1), (1, 2), (2, 0)] {
        for (i, row) in turned.iter_mut().enumerate() {
            for (j, entry) in row.iter_mut().enumerate() {
                let (first, second) = (
                    graph.multiply(rotation[i][k], rotation[j][l]),
                    graph.multiply(rotation[i][l], rotation[j][k]),
                );
                let both = graph.add(first, second);
                let added = graph.multiply(rows[k][l], both);
                *entry = graph.add(*entry, added);
            }
        }
    }
    turned
}
