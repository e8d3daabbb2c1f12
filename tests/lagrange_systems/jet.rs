//! Numbers with three infinitesimal parts whose squares are zero: exact derivatives, one along each
//! part.

use std::ops::{Add, Mul, Neg, Sub};

/// What jets are made of.
pub trait Real:
    Copy + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self> + Neg<Output = Self> + From<f64>
{
    fn sin_cos(self) -> (Self, Self);
}

/// By the small parts that a term has, as bits.
#[derive(Clone, Copy)]
pub struct Jet<N>(pub [N; 8]);

impl<N: Real> Jet<N> {
    pub fn real(value: N) -> Self {
        let mut terms = [N::from(0.0); 8];
        terms[0] = value;
        Self(terms)
    }

    /// A value that changes by these along the small parts.
    pub fn moving(value: N, by: [N; 3]) -> Self {
        let mut jet = Self::real(value);
        (jet.0[1], jet.0[2], jet.0[4]) = (by[0], by[1], by[2]);
        jet
    }

    /// What is multiplied by the third small part.
    pub fn third(self) -> Self {
        let zero = N::from(0.0);
        let [.., a, b, c, d] = self.0;
        Self([a, b, c, d, zero, zero, zero, zero])
    }

    fn small(self) -> Self {
        let mut jet = self;
        jet.0[0] = N::from(0.0);
        jet
    }

    /// `f + f' n + f'' n^2 / 2 + f''' n^3 / 6`; there is no more.
    fn composed(self, f: [N; 4]) -> Self {
        let n = self.small();
        let square = n * n;
        let scaled = |jet: Self, by: N| Self(jet.0.map(|term| term * by));
        let sum = Self::real(f[0]) + scaled(n, f[1]) + scaled(square, f[2] * N::from(0.5));
        // n^3 = 6 a b c e1 e2 e3
        let mut cube = Self::real(N::from(0.0));
        cube.0[7] = n.0[1] * n.0[2] * n.0[4];
        sum + scaled(cube, f[3])
    }

    pub fn sin_cos(self) -> (Self, Self) {
        let (s, c) = self.0[0].sin_cos();
        (self.composed([s, c, -s, -c]), self.composed([c, -s, -c, s]))
    }
}

impl<N: Real> Add for Jet<N> {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        Self(std::array::from_fn(|k| self.0[k] + other.0[k]))
    }
}

impl<N: Real> Sub for Jet<N> {
    type Output = Self;

    fn sub(self, other: Self) -> Self {
        Self(std::array::from_fn(|k| self.0[k] - other.0[k]))
    }
}

impl<N: Real> Neg for Jet<N> {
    type Output = Self;

    fn neg(self) -> Self {
        Self(self.0.map(|term| -term))
    }
}

impl<N: Real> Mul for Jet<N> {
    type Output = Self;

    fn mul(self, other: Self) -> Self {
        let mut product = [N::from(0.0); 8];
        for a in 0..8 {
            for b in (0..8).filter(|b| a & b == 0) {
                product[a | b] = product[a | b] + self.0[a] * other.0[b];
            }
        }
        Self(product)
    }
}
