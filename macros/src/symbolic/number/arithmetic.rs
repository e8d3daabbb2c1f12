//! Sums, products, quotients and powers of numbers, and their order.

use core::cmp::Ordering;
use core::hash::{Hash, Hasher};
use core::ops::{Add, Div, Mul, Neg, Sub};

use dashu_ratio::RBig;

use super::exact::{Kind, Number};

impl Number {
    pub fn abs(&self) -> Self {
        if self.is_negative() {
            -self.clone()
        } else {
            self.clone()
        }
    }

    /// `None` if the divisor is zero, or cannot be distinguished from zero.
    pub fn checked_div(&self, divisor: &Self) -> Option<Self> {
        (!divisor.is_zero() && !divisor.is_undecided()).then(|| self.clone() / divisor.clone())
    }

    /// An integer power.
    pub(in crate::symbolic) fn power(&self, exponent: i64) -> Option<Self> {
        let (mut power, mut square) = (Self::one(), self.clone());
        for bit in 0..i64::BITS - exponent.unsigned_abs().leading_zeros() {
            if exponent.unsigned_abs() >> bit & 1 == 1 {
                power = power * square.clone();
            }
            square = square.clone() * square;
            if !power.is_carried() || !square.is_carried() {
                return None;
            }
        }
        if exponent < 0 {
            Self::one().checked_div(&power)
        } else {
            Some(power)
        }
    }
}

impl Add for Number {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        match (&self.kind, &other.kind) {
            (Kind::Rational, Kind::Rational) => Self::from(self.value + other.value).condensed(),
            _ => Self::sum(self, other),
        }
    }
}

impl Sub for Number {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Mul for Number {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        match (&self.kind, &other.kind) {
            (Kind::Rational, Kind::Rational) => Self::from(self.value * other.value).condensed(),
            _ => Self::product(self, other),
        }
    }
}

impl Div for Number {
    type Output = Self;
    fn div(self, other: Self) -> Self {
        match (&self.kind, &other.kind) {
            (Kind::Rational, Kind::Rational) => Self::from(self.value / other.value).condensed(),
            _ => Self::quotient(self, other),
        }
    }
}

impl Neg for Number {
    type Output = Self;
    fn neg(self) -> Self {
        match self.kind {
            Kind::Irrational(_) => Self::product(Self::integer(-1), self),
            Kind::Rational => Self::from(-self.value),
        }
    }
}

impl PartialEq for Number {
    fn eq(&self, other: &Self) -> bool {
        match (&self.kind, &other.kind) {
            (Kind::Irrational(_), Kind::Irrational(_)) => self.is_same(other),
            (Kind::Irrational(_), _) | (_, Kind::Irrational(_)) => false,
            _ => self.value == other.value,
        }
    }
}

impl Eq for Number {}

impl Hash for Number {
    fn hash<H: Hasher>(&self, state: &mut H) {
        match &self.kind {
            Kind::Irrational(known) => known.residue.hash(state),
            Kind::Rational => self.value.hash(state),
        }
    }
}

impl PartialOrd for Number {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl Ord for Number {
    /// Irrational numbers are compared by the sign of their difference.
    fn cmp(&self, other: &Self) -> Ordering {
        match (&self.kind, &other.kind) {
            (Kind::Rational, Kind::Rational) => self.value.cmp(&other.value),
            _ if self == other => Ordering::Equal,
            _ => order_of_irrationals(self, other),
        }
    }
}

/// The order of two different numbers; arbitrary if the sign of their difference is unknown.
fn order_of_irrationals(a: &Number, b: &Number) -> Ordering {
    let difference = a.clone() - b.clone();
    if difference.is_undecided() {
        let residues = || a.residue().cmp(&b.residue());
        return a.value.cmp(&b.value).then_with(residues);
    }
    difference.value.cmp(&RBig::ZERO)
}
