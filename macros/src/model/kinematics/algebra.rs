//! The algebra of physical vectors: each is one object, whatever axes it is written in.
//!
//! A [`Vector`] is a sum of parts, each with components in one frame. Sums stay in the axes in
//! which they were written. Parts are rotated only where components are read, or where parts in
//! different frames are multiplied. So all forces fixed in a body are added before a single
//! rotation, and the difference of two points of a body does not depend on the place of the body
//! (`docs/trust.md`, H9).

use std::collections::BTreeSet;

use crate::model::words::Frame;
use crate::symbolic::{Components, Function, Graph, Id};

use super::turned_vector::Turns;
use super::vector::{Part, Vector};
use super::workspace::Workspace;

impl Workspace {
    pub fn vector(&mut self, frame: Frame, components: Components) -> Vector {
        self.whole(vec![(frame, components)])
    }

    fn whole(&mut self, mut parts: Vec<Part>) -> Vector {
        parts.retain(|(_, part)| !self.graph.is_zero_vector(part));
        self.vectors.add(parts)
    }

    /// The nonzero parts; those in the frames of bodies come first.
    pub fn parts(&self, a: Vector) -> &[Part] {
        self.vectors.parts(a)
    }

    /// The part with components in this frame.
    pub fn part(&self, a: Vector, frame: Frame) -> Components {
        let mut parts = self.parts(a).iter();
        let part = parts.find(|(of, _)| *of == frame);
        part.map_or(self.graph.zeros(), |(_, part)| *part)
    }

    /// Whether it has no part in another frame.
    pub fn is_in(&self, a: Vector, frame: Frame) -> bool {
        self.parts(a).iter().all(|(of, _)| *of == frame)
    }

    /// The frames of the parts.
    fn frames(&self, vectors: &[Vector]) -> BTreeSet<Frame> {
        let parts = vectors.iter().flat_map(|vector| self.parts(*vector));
        parts.map(|(frame, _)| *frame).collect()
    }

    /// The components of all parts.
    pub fn entries(&self, vectors: &[Vector]) -> Vec<Id> {
        let parts = vectors.iter().flat_map(|vector| self.parts(*vector));
        parts.flat_map(|(_, part)| *part).collect()
    }

    /// The coordinates of the attitudes that rotate its parts in the world.
    pub fn turning(&self, a: Vector) -> Vec<Id> {
        let mut coordinates = Vec::new();
        for mut frame in self.frames(&[a]) {
            while frame != Frame::WORLD {
                coordinates.extend(self.attitude(frame).coordinates());
                frame = self.carrier(frame);
            }
        }
        coordinates
    }

    /// The same in world axes, if it is written in axes that never rotate.
    pub fn in_parallel_axes(&mut self, a: Vector) -> Option<Vector> {
        if !self.turning(a).is_empty() {
            return None;
        }
        let (zeros, parts) = (self.graph.zeros(), self.parts(a).to_vec());
        let sum =
            |sum: Components, (_, part): &(Frame, Components)| self.graph.add_vectors(sum, *part);
        let components = parts.iter().fold(zeros, sum);
        Some(self.vector(Frame::WORLD, components))
    }

    /// The vector with each part changed in its own axes.
    pub fn map(
        &mut self,
        a: Vector,
        mut change: impl FnMut(&mut Graph, Components) -> Components,
    ) -> Vector {
        self.combine(&[a], |graph, parts| change(graph, parts[0]))
    }

    /// Combines several vectors frame by frame.
    pub fn combine(
        &mut self,
        vectors: &[Vector],
        mut combine: impl FnMut(&mut Graph, &[Components]) -> Components,
    ) -> Vector {
        let parts = self.frames(vectors).into_iter().rev().map(|frame| {
            let parts = vectors.iter().map(|vector| self.part(*vector, frame));
            let parts: Vec<Components> = parts.collect();
            (frame, combine(&mut self.graph, &parts))
        });
        let parts = parts.collect();
        self.whole(parts)
    }

    pub fn add(&mut self, a: Vector, b: Vector) -> Vector {
        self.combine(&[a, b], |graph, parts| {
            graph.add_vectors(parts[0], parts[1])
        })
    }

    pub fn sum(&mut self, vectors: impl IntoIterator<Item = Vector>) -> Vector {
        let vectors: Vec<Vector> = vectors.into_iter().collect();
        self.combine(&vectors, |graph, parts| {
            [0, 1, 2].map(|i| graph.sum(&parts.iter().map(|part| part[i]).collect::<Vec<_>>()))
        })
    }

    pub fn negate(&mut self, a: Vector) -> Vector {
        self.map(a, Graph::negate_vector)
    }

    /// A multiple of a vector. A factor that contains its length needs it in one frame, so the
    /// multiple is taken there.
    pub fn scale(&mut self, factor: Id, a: Vector) -> Vector {
        let a = match self.gathered.get(&a) {
            Some((square, gathered)) if self.is_made_of(factor, *square) => *gathered,
            _ => a,
        };
        self.map(a, |graph, part| graph.scale_vector(factor, part))
    }

    fn is_made_of(&self, whole: Id, part: Id) -> bool {
        // operands come before what is made of them
        let inside = self.graph.reachable(&[whole], &|id| id > part);
        inside.contains(&part)
    }

    /// The components of a vector in one frame; parts in other frames are rotated.
    pub fn components(&mut self, a: Vector, frame: Frame) -> Components {
        let turned = self.turned_parts(a, frame, |from| from != frame);
        let components = self.graph.add_vectors(turned, self.part(a, frame));
        self.labels
            .vector(&format!("in_{}", frame.word()), components);
        components
    }

    /// The components in the frame of the only part. If there are several parts, the frame is a
    /// free choice: the first one, that of a body.
    fn in_one_frame(&mut self, a: Vector) -> (Frame, Components) {
        let frame = match *self.parts(a) {
            [] => Frame::WORLD,
            [(frame, _)] => frame,
            [(first, _), ..] => self.turns.as_mut().map_or(first, Turns::choose_axes),
        };
        (frame, self.components(a, frame))
    }

    /// `a x b`, frame by frame: the parts written in a frame are multiplied with each other, and
    /// with parts that are rotated into it.
    pub fn cross(&mut self, a: Vector, b: Vector) -> Vector {
        let mut whole = Vector::ZERO;
        for frame in self.frames(&[a, b]) {
            let (left, right) = (self.part(a, frame), self.part(b, frame));
            let turned_left = self.turned_for(right, a, frame);
            let turned_right = match self.row(left, self.part(b, Frame::WORLD), frame) {
                Some(row) => row,
                None => self.turned_for(left, b, frame),
            };
            let graph = &mut self.graph;
            let own = graph.cross(left, right);
            let mixed = [(left, turned_right), (turned_left, right)];
            let [first, second] = mixed.map(|(a, b)| graph.cross(a, b));
            let mixed = graph.add_vectors(first, second);
            let product = graph.add_vectors(own, mixed);
            self.note_swept(left, right, own);
            let product = self.vector(frame, product);
            whole = self.add(whole, product);
        }
        whole
    }

    /// The parts of `a` in frames nearer to the ground, rotated into this frame if `other` is
    /// nonzero.
    fn turned_for(&mut self, other: Components, a: Vector, frame: Frame) -> Components {
        let is_needed = !self.graph.is_zero_vector(&other);
        self.turned_parts(a, frame, |from| is_needed && from < frame)
    }

    /// The parts of some frames, rotated into this one.
    fn turned_parts(
        &mut self,
        a: Vector,
        to: Frame,
        is_wanted: impl Fn(Frame) -> bool,
    ) -> Components {
        let mut sum = self.graph.zeros();
        for (from, part) in self.parts(a).to_vec() {
            if is_wanted(from) {
                let turned = self.turn(part, from, to);
                sum = self.graph.add_vectors(sum, turned);
            }
        }
        sum
    }

    pub fn dot(&mut self, a: Vector, b: Vector) -> Id {
        let mut products = Vec::new();
        for frame in self.frames(&[a, b]) {
            let (left, right) = (self.part(a, frame), self.part(b, frame));
            let turned_left = self.turned_for(right, a, frame);
            let turned_right = self.turned_for(left, b, frame);
            let factors = [(left, right), (left, turned_right), (turned_left, right)];
            products.extend(factors.map(|(a, b)| self.graph.dot(a, b)));
        }
        self.graph.sum(&products)
    }

    pub fn norm_squared(&mut self, a: Vector) -> Id {
        let (frame, components) = self.in_one_frame(a);
        let square = self.graph.norm_squared(components);
        if self.turns.is_none() && self.nonzero(&self.entries(&[a])) > self.nonzero(&components) {
            let gathered = self.vector(frame, components);
            self.gathered.insert(a, (square, gathered));
        }
        square
    }

    /// The number of nonzero components.
    fn nonzero(&self, components: &[Id]) -> usize {
        let components = components.iter();
        components.filter(|id| !self.graph.is_zero(**id)).count()
    }

    pub fn norm(&mut self, a: Vector) -> Id {
        let square = self.norm_squared(a);
        let norm = self.graph.apply(Function::Sqrt, &[square]);
        self.labels.name(norm, "norm");
        norm
    }
}
