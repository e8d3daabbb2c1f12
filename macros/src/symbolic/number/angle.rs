//! Sines and cosines of the angles that `atan`, `asin`, `acos` and `atan2` give, and of multiples and
//! sums of them. They are algebraic: `cos(2 atan(1/2))` is 3/5.

use super::exact::{Number, Term};
use super::function::Function;

/// The largest multiple of an angle whose tangent is computed.
const LARGEST: i64 = 12;

/// `turns pi + sum of count atan(tangent)`
struct Angle {
    turns: Number,
    parts: Vec<(Number, Number)>,
}

impl Angle {
    fn of(number: &Number) -> Option<Self> {
        let Some(term) = number.term() else {
            return number.is_zero().then(|| Self::turned(Number::zero()));
        };
        match term {
            Term::Pi => Some(Self::turned(Number::one())),
            Term::Value(Function::Atan, tangent) => Some(Self {
                turns: Number::zero(),
                parts: vec![(Number::one(), tangent.clone())],
            }),
            Term::Sum(a, b) => Some(Self::of(a)?.plus(Self::of(b)?)),
            Term::Product(a, b) if a.term().is_none() => Some(Self::of(b)?.times(a)),
            Term::Product(a, b) if b.term().is_none() => Some(Self::of(a)?.times(b)),
            Term::Quotient(a, b) if b.term().is_none() => {
                Some(Self::of(a)?.times(&Number::one().checked_div(b)?))
            }
            _ => None,
        }
    }

    fn turned(turns: Number) -> Self {
        let parts = Vec::new();
        Self { turns, parts }
    }

    fn plus(mut self, other: Self) -> Self {
        self.turns = self.turns + other.turns;
        for (count, tangent) in other.parts {
            match self.parts.iter_mut().find(|(_, known)| *known == tangent) {
                Some((sum, _)) => *sum = sum.clone() + count,
                None => self.parts.push((count, tangent)),
            }
        }
        self
    }

    fn times(mut self, factor: &Number) -> Self {
        let scale = |number: &mut Number| *number = number.clone() * factor.clone();
        scale(&mut self.turns);
        self.parts.iter_mut().for_each(|(count, _)| scale(count));
        self
    }

    /// The tangent of half the angle, if it is algebraic in the tangents and finite.
    fn half_tangent(&self) -> Option<Number> {
        let eighths = (self.turns.clone() * Number::integer(2)).to_integer()?;
        let mut sum = match eighths.rem_euclid(4) {
            0 => Some(Number::zero()),
            1 => Some(Number::one()),
            2 => None,
            _ => Some(Number::integer(-1)),
        };
        for (count, tangent) in &self.parts {
            let count = count.to_integer().filter(|count| count.abs() <= LARGEST)?;
            let (tangent, count) = if count % 2 == 0 {
                (tangent.clone(), count / 2)
            } else {
                (halved(tangent)?, count)
            };
            let tangent = if count < 0 { -tangent } else { tangent };
            for _ in 0..count.abs() {
                sum = tangent_of_sum(sum, tangent.clone());
            }
        }
        sum
    }
}

/// The tangent of a half: `atan` is less than a right angle, so its cosine is positive.
fn halved(tangent: &Number) -> Option<Number> {
    let secant = Number::one() + tangent.clone() * tangent.clone();
    let secant = Number::apply(Function::Sqrt, &[secant])?;
    tangent.checked_div(&(Number::one() + secant))
}

/// The tangent of the sum of two angles by their tangents; `None` is that of a right angle.
fn tangent_of_sum(a: Option<Number>, b: Number) -> Option<Number> {
    let Some(a) = a else {
        return (-Number::one()).checked_div(&b);
    };
    let below = Number::one() - a.clone() * b.clone();
    (a + b).checked_div(&below)
}

impl Number {
    /// Its cosine and sine, if it is an angle by its tangent.
    pub(super) fn on_circle_by_tangent(&self) -> Option<[Self; 2]> {
        let tangent = Angle::of(self)
            .filter(|angle| !angle.parts.is_empty())?
            .half_tangent()?;
        let square = tangent.clone() * tangent.clone();
        let below = Self::one() + square.clone();
        let cosine = (Self::one() - square).checked_div(&below)?;
        let sine = (tangent.clone() + tangent).checked_div(&below)?;
        Some([cosine, sine])
    }
}
