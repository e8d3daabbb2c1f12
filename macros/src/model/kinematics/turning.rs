//! The rotation of vectors from one frame to another.

use crate::model::words::{AXES, Frame};
use crate::symbolic::{Components, Function, Graph, Id, Node};

use super::attitude::Attitude;
use super::turned_vector::Turn;
use super::workspace::Workspace;

impl Workspace {
    /// A vector `s e` in body axes, to be multiplied by a vector along a body axis; s is known
    /// early, and e is along a world axis. Only two components of a row of the rotation are needed,
    /// and the factor that they share goes with the other vector.
    pub fn row(&mut self, arm: Components, v: Components, body: Frame) -> Option<Components> {
        let Attitude::Quaternion { scalar, vector } = self.attitude(body) else {
            return None;
        };
        let (j, s) = self.only_component(v)?;
        self.only_component(arm)?;
        let is_carried = self.carrier(body) != Frame::WORLD;
        if is_carried || self.turns.is_some() || !self.graph.is_early(s) {
            return None;
        }
        let graph = &mut self.graph;
        let twice = graph.add(s, s);
        let mut row = [s; 3];
        // R_jj = 1 - 2 (q_k^2 + q_l^2), R_jk = 2 (q_j q_k - w q_l), R_jl = 2 (q_j q_l + w q_k)
        let (k, l) = ((j + 1) % 3, (j + 2) % 3);
        let squares = [k, l].map(|i| graph.square(vector[i]));
        let squares = graph.add(squares[0], squares[1]);
        let less = graph.multiply(twice, squares);
        row[j] = graph.subtract(s, less);
        let [of_k, of_l] = [k, l].map(|i| graph.multiply(vector[j], vector[i]));
        let [by_k, by_l] = [k, l].map(|i| graph.multiply(scalar, vector[i]));
        let (at_k, at_l) = (graph.subtract(of_k, by_l), graph.add(of_l, by_k));
        (row[k], row[l]) = (graph.multiply(twice, at_k), graph.multiply(twice, at_l));
        self.turned.push(Turn {
            from: Frame::WORLD,
            to: body,
            vector: v,
            turned: row,
        });
        Some(row)
    }

    /// The index and the value of the only nonzero component.
    fn only_component(&self, v: Components) -> Option<(usize, Id)> {
        let mut there = (0..3).filter(|i| !self.graph.is_zero(v[*i]));
        let axis = there.next()?;
        there.next().is_none().then_some((axis, v[axis]))
    }

    /// The components of a vector in the axes of `to`, from those in the axes of `from`.
    ///
    /// A factor that all components share is taken out: `s v` becomes `s` times the rotated `v`.
    pub fn turn(&mut self, v: Components, from: Frame, to: Frame) -> Components {
        if from == to || self.graph.is_zero_vector(&v) {
            return v;
        }
        let next = self.next_frame(from, to);
        if next != to {
            let turned = self.turn(v, from, next);
            return self.turn(turned, next, to);
        }
        // a step from the axes of a body to those of its carrier, or back
        let is_back = self.carrier(to) == from;
        let body = if is_back { to } else { from };
        if self.leads_with_minus(v) {
            let opposite = self.graph.negate_vector(v);
            let turned = self.turn(opposite, from, to);
            return self.graph.negate_vector(turned);
        }
        if let Some((factor, rest)) = self.common_factor(v, body) {
            let turned = self.turn(rest, from, to);
            return self.graph.scale_vector(factor, turned);
        }
        let is_always_so = match self.attitude(body) {
            Attitude::Axis { angle, .. } => self.graph.is_early(angle),
            _ => false,
        };
        let turns = self.turns.as_mut();
        if let Some(turns) = turns.filter(|turns| !is_always_so || turns.are_apart(body)) {
            return turns.turn(&mut self.graph, v, from, to);
        }
        let turned = match self.attitude(body) {
            Attitude::Fixed | Attitude::Line { .. } => {
                self.met_still = true;
                return v;
            }
            Attitude::Axis { angle, direction } => self.turn_by_angle(angle, direction, v, is_back),
            Attitude::Quaternion { scalar, vector } => {
                let axis = if is_back {
                    self.graph.negate_vector(vector)
                } else {
                    vector
                };
                self.turn_about(scalar, axis, v)
            }
        };
        self.turned.push(Turn {
            from: self.original(from),
            to: self.original(to),
            vector: v,
            turned,
        });
        turned
    }

    /// `d d.v + c (v - d d.v) + s d x v`; in the plane, `(c x - s y, s x + c y)`.
    fn turn_by_angle(
        &mut self,
        angle: Id,
        d: Components,
        v: Components,
        is_back: bool,
    ) -> Components {
        let along = self.graph.dot(d, v);
        let along = self.graph.scale_vector(along, d);
        let across = self.graph.subtract_vectors(v, along);
        let across = self.late_quantities(across);
        let graph = &mut self.graph;
        let cosine = graph.apply(Function::Cos, &[angle]);
        let sine = graph.apply(Function::Sin, &[angle]);
        self.labels.name(cosine, "cosine");
        self.labels.name(sine, "sine");
        let sine = if is_back { graph.negate(sine) } else { sine };
        let swept = graph.cross(d, across);
        let (kept, turned) = (
            graph.scale_vector(cosine, across),
            graph.scale_vector(sine, swept),
        );
        let turned = graph.add_vectors(kept, turned);
        graph.add_vectors(turned, along)
    }

    /// `v + w t + q x t` with `t = q x 2 v`: 15 multiplications and 15 additions, or fewer if some
    /// components are zero or known before the state is.
    fn turn_about(&mut self, w: Id, q: Components, v: Components) -> Components {
        let v = self.late_quantities(v);
        let graph = &mut self.graph;
        let doubled = graph.add_vectors(v, v);
        let doubled = graph.quantities(doubled);
        let swing = graph.cross(q, doubled);
        let swing = graph.quantities(swing);
        for (component, axis) in v.into_iter().zip(AXES) {
            // do not name a vector that has a name of its own
            if let Node::Quantity(inner) = *graph.node(component)
                && self.labels.get(inner).is_none()
            {
                self.labels.name(component, format!("turned_{axis}"));
            }
        }
        self.labels.vector("doubled", doubled);
        self.labels
            .describe("swing", "s = q x 2 v, to turn v: v + w s + q x s");
        self.labels.vector("swing", swing);
        let along = graph.scale_vector(w, swing);
        let across = graph.cross(q, swing);
        let change = graph.add_vectors(along, across);
        graph.add_vectors(v, change)
    }

    /// Makes the late components statements, because a rotation uses each of them more than once.
    fn late_quantities(&mut self, v: Components) -> Components {
        v.map(|component| {
            if self.graph.is_early(component) {
                component
            } else {
                self.graph.quantity(component)
            }
        })
    }

    /// Whether to rotate the opposite vector instead: a vector and its opposite share one rotation.
    fn leads_with_minus(&mut self, v: Components) -> bool {
        let first = v
            .into_iter()
            .find(|component| !self.graph.is_zero(*component));
        first.is_some_and(|component| self.graph.split_sign(component).0)
    }

    /// A factor that all components share, if there is one, and the components without it.
    ///
    /// Rotating `s v` as `s` times the rotated `v` costs nothing if `v` has all of its components,
    /// and saves a whole rotation if `v` itself is rotated, too.
    pub fn common_factor(&mut self, v: Components, frame: Frame) -> Option<(Id, Components)> {
        let is_turned_by_angle = matches!(self.attitude(frame), Attitude::Axis { .. });
        let in_plane = self.graph.is_zero(v[2]) && is_turned_by_angle;
        let axes = if in_plane { 2 } else { 3 };
        let parts = v.map(|component| Part::of(&mut self.graph, component));
        let parts = &parts[..axes];
        if parts.iter().any(|part| self.graph.is_early(part.late)) {
            return None;
        }
        let (first, rest) = parts.split_first()?;
        let one = self.graph.one();
        let early = if rest.iter().all(|part| part.early == first.early) {
            first.early
        } else {
            one
        };
        let has = |part: &Part, factor: Id| part.factors.contains(&factor);
        let late = first
            .factors
            .iter()
            .copied()
            .find(|factor| rest.iter().all(|part| has(part, *factor)));
        if late.is_none() && self.graph.is_one(early) {
            return None;
        }
        let mut without = v;
        for (component, part) in without.iter_mut().zip(parts) {
            *component = part.rebuilt(&mut self.graph, early, late);
        }
        let factor = self.graph.multiply(early, late.unwrap_or(one));
        Some((factor, without))
    }
}

/// The factors of a component: `+- early * late`, and those of `late`.
struct Part {
    negative: bool,
    early: Id,
    late: Id,
    factors: Vec<Id>,
}

impl Part {
    fn of(graph: &mut Graph, component: Id) -> Self {
        let (negative, magnitude) = graph.split_sign(component);
        let (early, late) = graph.split_factor(magnitude);
        let factors = match *graph.node(late) {
            Node::Multiply(a, b) => vec![a, b],
            _ => vec![late],
        };
        Self {
            negative,
            early,
            late,
            factors,
        }
    }

    /// The component divided by `early` and `late`.
    fn rebuilt(&self, graph: &mut Graph, early: Id, late: Option<Id>) -> Id {
        let mut left = self.factors.clone();
        if let Some(index) = left.iter().position(|factor| Some(*factor) == late) {
            left.remove(index);
        }
        let mut rest = if early == self.early {
            graph.one()
        } else {
            self.early
        };
        for factor in left {
            rest = graph.multiply(rest, factor);
        }
        if self.negative {
            graph.negate(rest)
        } else {
            rest
        }
    }
}
