//! Vectors in world axes that remember the sizes of their terms.

use std::ops::{Add, Mul, Neg, Sub};

use crate::wide::Wide;

use super::number::{Number, product};

/// A vector and its size, a product of the norms of its factors: a component may have canceled out of terms that large.
#[derive(Clone, Copy, Debug, Default)]
pub struct Vector {
    pub value: [Wide; 3],
    pub size: f64,
}

impl Vector {
    pub const ZERO: Self = Self {
        value: [Wide::ZERO; 3],
        size: 0.0,
    };

    pub fn new(components: [Number; 3]) -> Self {
        // of the smallest numbers there are no squares
        let sizes = components.map(Number::span);
        Self {
            value: components.map(|component| component.value),
            size: sizes.into_iter().fold(0.0, f64::hypot),
        }
    }

    pub fn given(components: [f64; 3]) -> Self {
        Self::exactly(components.map(Wide::from))
    }

    pub fn exactly(components: [Wide; 3]) -> Self {
        Self::new(components.map(Number::exactly))
    }

    /// Along the normal of the plane, or the only component of a scalar answer.
    pub fn normal(z: Number) -> Self {
        Self::new([Number::ZERO, Number::ZERO, z])
    }

    /// A scalar, in the first place.
    pub fn scalar(x: Number) -> Self {
        Self::new([x, Number::ZERO, Number::ZERO])
    }

    /// One component.
    pub fn component(self, axis: usize) -> Number {
        Number::made(self.value[axis], self.size, false)
    }

    pub fn cross(self, other: Self) -> Self {
        Self {
            value: cross(self.value, other.value),
            size: product(self.size, other.size),
        }
    }

    pub fn dot(self, other: Self) -> Number {
        let value = dot(self.value, other.value);
        Number::made(value, product(self.size, other.size), false)
    }

    pub fn norm(self) -> Number {
        Number::made(self.length(), self.size, false)
    }

    pub fn normalized(self) -> Self {
        let length = self.length();
        Self {
            value: self.value.map(|x| x / length),
            size: (self.size / length.high).max(1.0),
        }
    }

    pub fn scaled(self, factor: Number) -> Self {
        Self {
            value: self.value.map(|x| x * factor.value),
            size: product(self.size, factor.span()),
        }
    }

    pub fn over(self, divisor: Number) -> Self {
        self.scaled(Number::ONE / divisor)
    }

    pub fn length(self) -> Wide {
        dot(self.value, self.value).sqrt()
    }
}

pub fn cross([a, b, c]: [Wide; 3], [x, y, z]: [Wide; 3]) -> [Wide; 3] {
    [b * z - c * y, c * x - a * z, a * y - b * x]
}

pub fn dot([a, b, c]: [Wide; 3], [x, y, z]: [Wide; 3]) -> Wide {
    a * x + b * y + c * z
}

impl Add for Vector {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        let ([a, b, c], [x, y, z]) = (self.value, other.value);
        Self {
            value: [a + x, b + y, c + z],
            size: self.size.max(other.size),
        }
    }
}

impl Neg for Vector {
    type Output = Self;

    fn neg(self) -> Self {
        Self {
            value: self.value.map(|x| -x),
            ..self
        }
    }
}

impl Sub for Vector {
    type Output = Self;

    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Mul<Vector> for Number {
    type Output = Vector;

    fn mul(self, vector: Vector) -> Vector {
        vector.scaled(self)
    }
}
