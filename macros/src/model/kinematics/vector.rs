//! Physical vectors, given by their parts.

use crate::model::words::Frame;
use crate::symbolic::Components;

/// A physical vector: the sum of its parts.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub struct Vector(usize);

impl Vector {
    pub const ZERO: Self = Self(0);

    pub fn is_zero(self) -> bool {
        self.0 == Self::ZERO.0
    }
}

/// A part of a vector, with components in one frame.
pub type Part = (Frame, Components);

/// The parts of all vectors except the zero vector.
#[derive(Default)]
pub struct Vectors(Vec<Vec<Part>>);

impl Vectors {
    /// The vector that is the sum of these parts, which are in different frames and nonzero.
    pub fn add(&mut self, parts: Vec<Part>) -> Vector {
        if parts.is_empty() {
            return Vector::ZERO;
        }
        self.0.push(parts);
        Vector(self.0.len())
    }

    pub fn parts(&self, vector: Vector) -> &[Part] {
        match vector.0.checked_sub(1) {
            Some(index) => &self.0[index],
            None => &[],
        }
    }
}
