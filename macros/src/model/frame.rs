//! Frames: a vector is a physical object, whatever axes its components were written in.
//!
//! A [`Vector`] is the sum of a part with components in body axes and a part with components in
//! world axes. Sums stay in the axes they were written in; only where components are read, or
//! where vectors of both kinds are multiplied, one of them is turned. So all body-fixed forces are
//! added before the one rotation, and the difference of two points of the body knows nothing of
//! where the body is (EQUATIONS.md, H9).

use crate::symbolic::{Components, Function, Graph, Id, Node};

use super::names::{AXES, Labels};
use super::turned_vector::{Turn, Turns};

/// Axes in which components are written.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Frame {
    Body,
    World,
}

impl Frame {
    pub fn other(self) -> Self {
        match self {
            Self::Body => Self::World,
            Self::World => Self::Body,
        }
    }
}

/// The rotation from body axes to world axes.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Attitude {
    /// The axes stay parallel.
    Fixed,
    /// A rotation by an angle about a unit vector, which is the same in both axes.
    Axis { angle: Id, direction: Components },
    /// A unit quaternion.
    Quaternion { scalar: Id, vector: Components },
    /// That of a rod: one direction of the body, a unit vector in body axes, is along `axis`, in
    /// world axes. No other axes turn with it: all components are written in those of the world.
    Line {
        direction: Components,
        axis: Components,
    },
}

/// A physical vector: the sum of its two parts.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Vector {
    pub body: Components,
    pub world: Components,
}

/// The graph of a description, seen through the two frames of its body.
pub struct Frames {
    pub graph: Graph,
    pub labels: Labels,
    pub attitude: Attitude,
    /// Turned vectors are kept apart in here, where potentials are read.
    pub turns: Option<Turns>,
    /// All vectors that were turned otherwise: their rates are known as vectors.
    pub turned: Vec<Turn>,
    /// Of a rod, products `u x b`, and b; world axes.
    pub swept: Vec<(Components, Components)>,
}

impl Frames {
    pub fn vector(&mut self, frame: Frame, components: Components) -> Vector {
        let zeros = self.graph.zeros();
        // no axes turn with a rod
        let turns = !matches!(self.attitude, Attitude::Line { .. });
        let (body, world) = if frame == Frame::Body && turns {
            (components, zeros)
        } else {
            (zeros, components)
        };
        Vector { body, world }
    }

    pub fn zero_vector(&mut self) -> Vector {
        let zeros = self.graph.zeros();
        Vector {
            body: zeros,
            world: zeros,
        }
    }

    pub fn is_zero_vector(&self, a: Vector) -> bool {
        self.graph.is_zero_vector(&a.body) && self.graph.is_zero_vector(&a.world)
    }

    pub fn add(&mut self, a: Vector, b: Vector) -> Vector {
        Vector {
            body: self.graph.add_vectors(a.body, b.body),
            world: self.graph.add_vectors(a.world, b.world),
        }
    }

    pub fn sum(&mut self, vectors: impl IntoIterator<Item = Vector>) -> Vector {
        let vectors: Vec<Vector> = vectors.into_iter().collect();
        let graph = &mut self.graph;
        let mut gather = |part: fn(&Vector) -> &Components| {
            [0, 1, 2].map(|i| {
                graph.sum(
                    &vectors
                        .iter()
                        .map(|vector| part(vector)[i])
                        .collect::<Vec<_>>(),
                )
            })
        };
        Vector {
            body: gather(|vector| &vector.body),
            world: gather(|vector| &vector.world),
        }
    }

    pub fn negate(&mut self, a: Vector) -> Vector {
        Vector {
            body: self.graph.negate_vector(a.body),
            world: self.graph.negate_vector(a.world),
        }
    }

    pub fn scale(&mut self, factor: Id, a: Vector) -> Vector {
        Vector {
            body: self.graph.scale_vector(factor, a.body),
            world: self.graph.scale_vector(factor, a.world),
        }
    }

    /// Components in one frame; the part written in the other is turned.
    pub fn components(&mut self, a: Vector, frame: Frame) -> Components {
        let (own, other) = match frame {
            Frame::Body => (a.body, a.world),
            Frame::World => (a.world, a.body),
        };
        let turned = self.turn(other, frame);
        let components = self.graph.add_vectors(turned, own);
        self.labels.vector(
            if frame == Frame::Body {
                "in_body"
            } else {
                "in_world"
            },
            components,
        );
        components
    }

    /// Both parts with components in one frame: that of the part there is; if both are, body axes,
    /// where nobody chose others.
    fn in_one_frame(&mut self, a: Vector) -> Components {
        let frame = if self.graph.is_zero_vector(&a.body) {
            Frame::World
        } else if self.graph.is_zero_vector(&a.world) {
            Frame::Body
        } else {
            self.turns.as_mut().map_or(Frame::Body, Turns::choose_axes)
        };
        self.components(a, frame)
    }

    /// `a x b`; what is not written in the same axes is multiplied in body axes.
    pub fn cross(&mut self, a: Vector, b: Vector) -> Vector {
        let world = self.graph.cross(a.world, b.world);
        self.note_swept(a, b, world);
        let (turned_a, turned_b) = (self.turned_if_needed(a, b), self.turned_if_needed(b, a));
        let products = [
            self.graph.cross(a.body, b.body),
            self.graph.cross(a.body, turned_b),
            self.graph.cross(turned_a, b.body),
        ];
        let mixed = self.graph.add_vectors(products[1], products[2]);
        Vector {
            body: self.graph.add_vectors(products[0], mixed),
            world,
        }
    }

    /// The world part of `a` in body axes, where the body part of `b` calls for it.
    fn turned_if_needed(&mut self, a: Vector, b: Vector) -> Components {
        if self.graph.is_zero_vector(&b.body) {
            self.graph.zeros()
        } else {
            self.turn(a.world, Frame::Body)
        }
    }

    pub fn dot(&mut self, a: Vector, b: Vector) -> Id {
        let world = self.graph.dot(a.world, b.world);
        let (turned_a, turned_b) = (self.turned_if_needed(a, b), self.turned_if_needed(b, a));
        let products = [
            self.graph.dot(a.body, b.body),
            self.graph.dot(a.body, turned_b),
            self.graph.dot(turned_a, b.body),
            world,
        ];
        self.graph.sum(&products)
    }

    pub fn norm_squared(&mut self, a: Vector) -> Id {
        let components = self.in_one_frame(a);
        self.graph.norm_squared(components)
    }

    pub fn norm(&mut self, a: Vector) -> Id {
        let components = self.in_one_frame(a);
        let norm = self.graph.norm(components);
        self.labels.name(norm, "norm");
        norm
    }

    /// The components of one vector in the axes of `to`, from its components in the other axes.
    ///
    /// A factor that all components share is turned around: `s v` is `s` times the turned `v`.
    pub fn turn(&mut self, v: Components, to: Frame) -> Components {
        if self.graph.is_zero_vector(&v) {
            return v;
        }
        if self.leads_with_minus(v) {
            let opposite = self.graph.negate_vector(v);
            let turned = self.turn(opposite, to);
            return self.graph.negate_vector(turned);
        }
        if let Some((factor, rest)) = self.common_factor(v) {
            let turned = self.turn(rest, to);
            return self.graph.scale_vector(factor, turned);
        }
        if let Some(turns) = &mut self.turns {
            return turns.turn(&mut self.graph, v, to);
        }
        let turned = match self.attitude {
            Attitude::Fixed | Attitude::Line { .. } => return v,
            Attitude::Axis { angle, direction } => self.turn_by_angle(angle, direction, v, to),
            Attitude::Quaternion { scalar, vector } => {
                let axis = match to {
                    Frame::World => vector,
                    Frame::Body => self.graph.negate_vector(vector),
                };
                self.turn_about(scalar, axis, v)
            }
        };
        self.turned.push(Turn {
            to,
            vector: v,
            turned,
        });
        turned
    }

    /// `d d.v + c (v - d d.v) + s d x v`: in the plane, `(c x - s y, s x + c y)`.
    fn turn_by_angle(&mut self, angle: Id, d: Components, v: Components, to: Frame) -> Components {
        let along = self.graph.dot(d, v);
        let along = self.graph.scale_vector(along, d);
        let across = self.graph.subtract_vectors(v, along);
        let across = self.late_quantities(across);
        let graph = &mut self.graph;
        let cosine = graph.apply(Function::Cos, &[angle]);
        let sine = graph.apply(Function::Sin, &[angle]);
        self.labels.name(cosine, "cosine");
        self.labels.name(sine, "sine");
        let sine = match to {
            Frame::World => sine,
            Frame::Body => graph.negate(sine),
        };
        let swept = graph.cross(d, across);
        let (kept, turned) = (
            graph.scale_vector(cosine, across),
            graph.scale_vector(sine, swept),
        );
        let turned = graph.add_vectors(kept, turned);
        graph.add_vectors(turned, along)
    }

    /// `v + w t + q x t` with `t = q x 2 v`: 15 multiplications, 15 additions; less where
    /// components are zero or known before the state is.
    fn turn_about(&mut self, w: Id, q: Components, v: Components) -> Components {
        let v = self.late_quantities(v);
        let graph = &mut self.graph;
        let doubled = graph.add_vectors(v, v);
        let doubled = graph.quantities(doubled);
        let swing = graph.cross(q, doubled);
        let swing = graph.quantities(swing);
        for (component, axis) in v.into_iter().zip(AXES) {
            // what is turned has a name of its own, or none
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

    /// Statements of the late components: what a turned vector is made of is used more than once.
    fn late_quantities(&mut self, v: Components) -> Components {
        v.map(|component| {
            if self.graph.is_early(component) {
                component
            } else {
                self.graph.quantity(component)
            }
        })
    }

    /// A vector and its opposite are turned together.
    fn leads_with_minus(&mut self, v: Components) -> bool {
        let first = v
            .into_iter()
            .find(|component| !self.graph.is_zero(*component));
        first.is_some_and(|component| self.graph.split_sign(component).0)
    }

    /// A factor that every component has, if there is one, and the components without it.
    ///
    /// To turn `s v` as `s` times the turned `v` costs nothing where `v` has all its components,
    /// and one whole rotation less where `v` itself is turned too.
    pub fn common_factor(&mut self, v: Components) -> Option<(Id, Components)> {
        let in_plane = self.graph.is_zero(v[2]) && matches!(self.attitude, Attitude::Axis { .. });
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

/// A component, taken apart: `+- early * late`, and the factors of `late`.
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

    /// The component over `early` and `late`.
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
