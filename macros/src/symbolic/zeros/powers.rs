//! Functions that turn sums into products: `e^(a + b) = e^a e^b`, and so with the points of the unit
//! circle.

use std::cell::RefCell;
use std::collections::HashMap;

use crate::symbolic::algebra::Multiples;
use crate::symbolic::number::{Function, Number, Residue};

/// The largest sum of exponents. The degree of a function of a sum is no larger than twice this.
pub(super) const MOST: f64 = 32.0;

/// The largest constant of a sum: e to its power has few digits.
const LARGEST: f64 = 64.0;

/// A sum as a constant, and as bases with exponents: a function of the sum is its value at the constant,
/// times the powers of its values at the bases.
#[derive(Clone)]
pub(super) struct Powers {
    constant: Number,
    powers: Vec<(Residue, i32)>,
}

impl Powers {
    /// An argument that is no sum: it is twice its half, so that functions of both are known together.
    pub fn single(argument: Residue) -> Self {
        Self {
            constant: Number::zero(),
            powers: vec![(argument * Number::ratio(1, 2).residue(), 2)],
        }
    }

    /// A sum of multiples; `None` if one of them has no value, or exponents or the constant are large.
    pub fn of(sum: Multiples<Option<Residue>>) -> Option<Self> {
        let Multiples { constant, terms } = sum;
        let powers = terms.into_iter();
        let powers = powers.map(|(value, factor)| power(value?, &factor));
        let powers: Vec<(Residue, i32)> = powers.collect::<Option<_>>()?;
        let exponents = powers.iter();
        let exponents = exponents.map(|(_, exponent)| f64::from(exponent.unsigned_abs()));
        let is_small = exponents.sum::<f64>() <= MOST && constant.to_f64().abs() <= LARGEST;
        is_small.then_some(Self { constant, powers })
    }

    pub fn negated(&self) -> Self {
        let powers = self.powers.iter();
        Self {
            constant: -self.constant.clone(),
            powers: powers.map(|(base, exponent)| (*base, -exponent)).collect(),
        }
    }

    /// The point of the unit circle at this angle: cosine and sine.
    pub fn on_circle(&self, half_tangent: impl Fn(Residue) -> Residue) -> Option<[Residue; 2]> {
        let mut point = [
            at(Function::Cos, &self.constant)?,
            at(Function::Sin, &self.constant)?,
        ];
        for (base, exponent) in &self.powers {
            let tangent = half_tangent(*base);
            let square = tangent * tangent;
            let below = (Residue::ONE + square).reciprocal()?;
            let cosine = (Residue::ONE + -square) * below;
            let sine = (tangent + tangent) * below;
            let sine = if *exponent < 0 { -sine } else { sine };
            for _ in 0..exponent.unsigned_abs() {
                let [x, y] = point;
                point = [x * cosine + -(y * sine), x * sine + y * cosine];
            }
        }
        Some(point)
    }

    /// e to this power.
    pub fn exponential(&self, at_base: impl Fn(Residue) -> Option<Residue>) -> Option<Residue> {
        let mut product = at(Function::Exp, &self.constant)?;
        for (base, exponent) in &self.powers {
            let value = at_base(*base)?;
            let factor = if *exponent < 0 {
                value.reciprocal()?
            } else {
                value
            };
            for _ in 0..exponent.unsigned_abs() {
                product = product * factor;
            }
        }
        Some(product)
    }
}

thread_local! {
    /// What functions are at constants: it takes long to find their digits.
    static KNOWN: RefCell<HashMap<(Function, Residue), Option<Residue>>> = RefCell::default();
}

/// What a function is at a constant.
fn at(function: Function, constant: &Number) -> Option<Residue> {
    KNOWN.with_borrow_mut(|known| {
        let value = || Some(Number::apply(function, std::slice::from_ref(constant))?.residue());
        let place = known.entry((function, constant.residue()));
        *place.or_insert_with(value)
    })
}

/// A multiple of a value as a base and its exponent, which is even for a multiple without a divisor.
fn power(value: Residue, factor: &Number) -> Option<(Residue, i32)> {
    let Some((above, below)) = factor.to_fraction() else {
        let whole = value * factor.residue();
        return Some((whole * Number::ratio(1, 2).residue(), 2));
    };
    let (exponent, parts) = if below % 2 == 0 {
        (above, below)
    } else {
        (above.checked_mul(2)?, below.checked_mul(2)?)
    };
    let part = Number::ratio(1, u64::try_from(parts).ok()?);
    Some((value * part.residue(), i32::try_from(exponent).ok()?))
}
