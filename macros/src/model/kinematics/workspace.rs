//! What a description is worked out in, and the algebra of physical vectors.

use crate::model::words::{Doubtful, Labels, Meaning, Meanings};
use crate::symbolic::{Components, Graph, Id, Node, Stage};

use super::frame::{Attitude, Frame, Vector};
use super::turned_vector::{Turn, Turns};

/// What a description is worked out in: its graph, seen through the two frames of its body, and the
/// words for what is in it. Lowering begins it, mechanics goes on in it.
pub struct Workspace {
    pub graph: Graph,
    pub labels: Labels,
    pub meanings: Meanings,
    pub attitude: Attitude,
    /// Turned vectors are kept apart in here, where potentials are read.
    pub turns: Option<Turns>,
    /// All vectors that were turned otherwise: their rates are known as vectors.
    pub turned: Vec<Turn>,
    /// Of a rod, products `u x b`, and b; world axes.
    pub swept: Vec<(Components, Components)>,
    /// What was written that parameters may leave without a value.
    pub doubtful: Vec<Doubtful>,
}

impl Workspace {
    pub fn new(graph: Graph, meanings: Meanings, attitude: Attitude) -> Self {
        Self {
            graph,
            labels: Labels::default(),
            meanings,
            attitude,
            turns: None,
            turned: Vec::new(),
            swept: Vec::new(),
            doubtful: Vec::new(),
        }
    }

    /// A new symbol that stands for this, known from `stage` on.
    pub fn symbol(&mut self, stage: Stage, meaning: Meaning) -> Id {
        self.meanings.symbol(&mut self.graph, stage, meaning)
    }

    /// What a symbol stands for; none if the expression is no symbol.
    pub fn meaning(&self, id: Id) -> Option<Meaning> {
        match self.graph.node(id) {
            Node::Symbol(symbol) => Some(self.meanings.of(*symbol)),
            _ => None,
        }
    }

    /// The angle of a body that turns about an axis.
    pub fn angle(&self) -> Option<Id> {
        match self.attitude {
            Attitude::Axis { angle, .. } => Some(angle),
            _ => None,
        }
    }

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
        let turned_a = self.turned_if_needed(a, b);
        let turned_b = match self.row(a.body, b.world) {
            Some(row) => row,
            None => self.turned_if_needed(b, a),
        };
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
}
