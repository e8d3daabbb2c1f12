//! Numbers that carry two first derivatives and the mixed second one, and Lagrange's equations with
//! these numbers.
#![allow(dead_code, reason = "each test uses its part")]

use std::ops::{Add, Mul, Neg, Sub};

/// `value + first ε + second η + mixed ε η` with ε² = η² = 0: exact derivatives, no steps.
#[derive(Clone, Copy, Debug)]
pub struct Dual {
    pub value: f64,
    pub first: f64,
    pub second: f64,
    pub mixed: f64,
}

impl From<f64> for Dual {
    fn from(value: f64) -> Self {
        Self::along(value, 0.0)
    }
}

impl Dual {
    /// A number with a first derivative.
    pub fn along(value: f64, first: f64) -> Self {
        Self {
            value,
            first,
            second: 0.0,
            mixed: 0.0,
        }
    }

    /// A function, of which `[f, f', f'']` at the value are given.
    fn map(self, [f, df, ddf]: [f64; 3]) -> Self {
        Self {
            value: f,
            first: df * self.first,
            second: df * self.second,
            mixed: df * self.mixed + ddf * self.first * self.second,
        }
    }

    pub fn sin(self) -> Self {
        let (sin, cos) = self.value.sin_cos();
        self.map([sin, cos, -sin])
    }

    pub fn cos(self) -> Self {
        let (sin, cos) = self.value.sin_cos();
        self.map([cos, -sin, -cos])
    }
}

impl Add for Dual {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        Self {
            value: self.value + other.value,
            first: self.first + other.first,
            second: self.second + other.second,
            mixed: self.mixed + other.mixed,
        }
    }
}

impl Neg for Dual {
    type Output = Self;

    fn neg(self) -> Self {
        self * -1.0
    }
}

impl Sub for Dual {
    type Output = Self;

    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Mul<f64> for Dual {
    type Output = Self;

    fn mul(self, factor: f64) -> Self {
        self * Self::from(factor)
    }
}

impl Mul for Dual {
    type Output = Self;

    fn mul(self, other: Self) -> Self {
        Self {
            value: self.value * other.value,
            first: self.first * other.value + self.value * other.first,
            second: self.second * other.value + self.value * other.second,
            mixed: self.mixed * other.value
                + self.first * other.second
                + self.second * other.first
                + self.value * other.mixed,
        }
    }
}

/// `d/dt ∂L/∂q'_i - ∂L/∂q_i` on a motion with these coordinates, rates and accelerations, where
/// `d/dt ∂L/∂q'_i` is the second derivative of L along q'_i and along (q', q'').
pub fn lagrange<const N: usize>(
    lagrangian: impl Fn(&[Dual; N], &[Dual; N]) -> Dual,
    q: [f64; N],
    dq: [f64; N],
    ddq: [f64; N],
) -> [f64; N] {
    let moving = |x: [f64; N], rate: [f64; N]| -> [Dual; N] {
        core::array::from_fn(|i| Dual {
            second: rate[i],
            ..Dual::from(x[i])
        })
    };
    core::array::from_fn(|i| {
        let [mut varied, mut varied_rate] = [moving(q, dq), moving(dq, ddq)];
        varied_rate[i].first = 1.0;
        let change = lagrangian(&varied, &varied_rate).mixed;
        varied_rate[i].first = 0.0;
        varied[i].first = 1.0;
        change - lagrangian(&varied, &varied_rate).first
    })
}
