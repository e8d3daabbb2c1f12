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

    /// A vector at half the angle, if it is algebraic in the tangents: the product of `1 + i tangent`
    /// for each `atan(tangent)`, and of `1 + i` for each eighth of a turn.
    fn half(&self) -> Option<[Number; 2]> {
        let eighths = (self.turns.clone() * Number::integer(2)).to_integer()?;
        let mut vector = [Number::one(), Number::zero()];
        for _ in 0..eighths.rem_euclid(4) {
            vector = turned(vector, &Number::one());
        }
        for (count, tangent) in &self.parts {
            let count = count.to_integer().filter(|count| count.abs() <= LARGEST)?;
            let (tangent, count) = if count % 2 == 0 {
                (tangent.clone(), count / 2)
            } else {
                (halved(tangent)?, count)
            };
            let tangent = if count < 0 { -tangent } else { tangent };
            for _ in 0..count.abs() {
                vector = turned(vector, &tangent);
            }
        }
        Some(vector)
    }
}

/// The tangent of a half: `atan` is less than a right angle, so its cosine is positive.
fn halved(tangent: &Number) -> Option<Number> {
    let secant = Number::one() + tangent.clone() * tangent.clone();
    let secant = Number::apply(Function::Sqrt, &[secant])?;
    tangent.checked_div(&(Number::one() + secant))
}

/// `(x + i y) (1 + i tangent)`
fn turned([x, y]: [Number; 2], tangent: &Number) -> [Number; 2] {
    let across = y.clone() * tangent.clone();
    let along = x.clone() * tangent.clone();
    [x - across, y + along]
}

impl Number {
    /// Its cosine and sine, if it is an angle by its tangent.
    pub(super) fn on_circle_by_tangent(&self) -> Option<[Self; 2]> {
        let angle = Angle::of(self).filter(|angle| !angle.parts.is_empty())?;
        let [x, y] = angle.half()?;
        let product = x.clone() * y.clone();
        let [x, y] = [x, y].map(|one| one.clone() * one);
        // positive: each factor of the vector has a length of one or more
        let length = x.clone() + y.clone();
        let cosine = (x - y).checked_div(&length)?;
        let sine = (product.clone() + product).checked_div(&length)?;
        Some([cosine, sine])
    }
}
