//! Physical dimensions, which decide which quantities can be added.

use core::fmt;

use crate::fraction::Fraction;
use crate::symbolic::Number;

use super::unit::Unit;

/// Base units, in the order of the exponents.
const BASE: [&str; 7] = ["kg", "m", "s", "A", "K", "mol", "cd"];

/// Products with their own names in messages and documentation.
const NAMED: [(&str, [i16; 7]); 8] = [
    ("N", [1, 1, -2, 0, 0, 0, 0]),
    ("W", [1, 2, -3, 0, 0, 0, 0]),
    ("Pa", [1, -1, -2, 0, 0, 0, 0]),
    ("V", [1, 2, -3, -1, 0, 0, 0]),
    ("T", [1, 0, -2, -1, 0, 0, 0]),
    ("N * m", [1, 2, -2, 0, 0, 0, 0]),
    ("C", [0, 0, 1, 1, 0, 0, 0]),
    ("N * m * s", [1, 2, -1, 0, 0, 0, 0]),
];
/// How many of these, from the first, are also shown divided by a base unit: `N / m`, `W / K`.
const DIVIDED: usize = 6;

/// Powers of the base units, or [`Dimension::ANY`] for a quantity written without a unit.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Dimension(Option<[Fraction; 7]>);

impl Dimension {
    /// Any dimension: no unit was written.
    pub const ANY: Self = Self(None);
    /// A pure number, or an angle.
    pub const NONE: Self = Self::base([0; 7]);
    pub const MASS: Self = Self::base([1, 0, 0, 0, 0, 0, 0]);
    pub const LENGTH: Self = Self::base([0, 1, 0, 0, 0, 0, 0]);
    pub const TIME: Self = Self::base([0, 0, 1, 0, 0, 0, 0]);
    pub const VELOCITY: Self = Self::base([0, 1, -1, 0, 0, 0, 0]);
    pub const ACCELERATION: Self = Self::base([0, 1, -2, 0, 0, 0, 0]);
    pub const ANGULAR_ACCELERATION: Self = Self::base([0, 0, -2, 0, 0, 0, 0]);
    pub const FREQUENCY: Self = Self::base([0, 0, -1, 0, 0, 0, 0]);
    pub const FORCE: Self = Self::base([1, 1, -2, 0, 0, 0, 0]);
    /// The dimension of the stiffness of a spring, N/m.
    pub const STIFFNESS: Self = Self::base([1, 0, -2, 0, 0, 0, 0]);
    pub const MOMENT: Self = Self::base([1, 2, -2, 0, 0, 0, 0]);
    pub const INERTIA: Self = Self::base([1, 2, 0, 0, 0, 0, 0]);

    /// From integer powers of kg, m, s, A, K, mol, cd.
    pub const fn base(exponents: [i16; 7]) -> Self {
        let mut fractions = [Fraction::ZERO; 7];
        let mut i = 0;
        while i < 7 {
            fractions[i] = Fraction::whole(exponents[i] as i32);
            i += 1;
        }
        Self(Some(fractions))
    }

    /// The dimension of a product. `None`, here and below, if an exponent becomes too large.
    pub fn times(self, other: Self) -> Option<Self> {
        self.combine(other, Fraction::plus)
    }

    pub fn over(self, other: Self) -> Option<Self> {
        self.combine(other, |a, b| a.plus(b.negative()))
    }

    pub fn power(self, exponent: Fraction) -> Option<Self> {
        self.combine(self, |own, _| own.times(exponent))
    }

    /// The dimension of a power. A power of a pure number is a pure number.
    pub fn power_of_number(self, exponent: &Number) -> Option<Self> {
        let Some(exponents) = self.0 else {
            return Some(Self::ANY);
        };
        if exponents == [Fraction::ZERO; 7] {
            return Some(self);
        }
        let (numerator, denominator) = exponent.to_fraction()?;
        self.power(Fraction::new(numerator, denominator)?)
    }

    /// The common dimension of both, if they are compatible.
    pub fn unify(self, other: Self) -> Option<Self> {
        match (self.0, other.0) {
            (Some(a), Some(b)) => (a == b).then_some(self),
            (Some(_), None) => Some(self),
            _ => Some(other),
        }
    }

    pub fn fits(self, other: Self) -> bool {
        self.unify(other).is_some()
    }

    /// A quantity of this dimension in words: `in N`, `a pure number`.
    pub fn described(self) -> String {
        match self.0 {
            Some(exponents) if exponents != [Fraction::ZERO; 7] => format!("in {self}"),
            Some(_) => "a pure number".to_owned(),
            None => "without a unit".to_owned(),
        }
    }

    /// The SI unit to write in brackets.
    pub fn unit(self) -> String {
        if self == Self::NONE {
            "[rad]".to_owned()
        } else {
            format!("[{self}]")
        }
    }

    pub fn is_known(self) -> bool {
        self.0.is_some()
    }

    fn name(self) -> Option<&'static str> {
        let mut named = NAMED.iter();
        let (name, _) = named.find(|(_, exponents)| Self::base(*exponents) == self)?;
        Some(name)
    }

    /// The named unit and the base unit whose quotient has this dimension.
    fn quotient(self) -> Option<(&'static str, &'static str)> {
        let mut named = NAMED[..DIVIDED].iter();
        named.find_map(|(name, exponents)| {
            let per = Self::base(*exponents).over(self)?;
            let mut units = BASE.iter().enumerate().skip(1);
            let (_, unit) = units.find(|(place, _)| {
                let mut exponents = [0; 7];
                exponents[*place] = 1;
                Self::base(exponents) == per
            })?;
            Some((*name, *unit))
        })
    }

    fn combine(
        self,
        other: Self,
        operation: impl Fn(Fraction, Fraction) -> Option<Fraction>,
    ) -> Option<Self> {
        let (Some(a), Some(b)) = (self.0, other.0) else {
            return Some(Self::ANY);
        };
        let mut combined = a;
        for (exponent, other) in combined.iter_mut().zip(b) {
            *exponent = operation(*exponent, other)?;
        }
        Some(Self(Some(combined)))
    }
}

impl fmt::Display for Dimension {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Some(exponents) = self.0 else {
            return f.write_str("no unit");
        };
        if let Some(name) = self.name() {
            return f.write_str(name);
        }
        if let Some((name, per)) = self.quotient() {
            return write!(f, "{name} / {per}");
        }
        let words = BASE.map(str::to_owned).into_iter().zip(exponents);
        Unit(words.collect()).fmt(f)
    }
}
