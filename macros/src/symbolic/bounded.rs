//! Doubles with a bound of what rounding has made of them: whether a value is certainly not zero.

use super::algebra::Algebra;
use super::evaluate::{binary, unary};
use super::function::Function;
use super::number::Number;

/// Doubles that are known to be near to what they stand for.
pub struct Doubles;

/// A double, and how far it may be from what it stands for; not a number where nothing is known.
#[derive(Clone, Copy)]
pub struct Bounded {
    value: f64,
    error: f64,
}

/// A value is certainly not zero beyond so many times its bound: functions add to it by more than an ulp.
const MARGIN: f64 = 1024.0;

impl Bounded {
    /// Rounded once more, or lost below the least of doubles.
    fn new(value: f64, error: f64) -> Self {
        let error = error + value.abs() * f64::EPSILON + f64::MIN_POSITIVE;
        Self { value, error }
    }
}

impl Algebra for Doubles {
    type Value = Bounded;

    fn number(&mut self, number: &Number) -> Bounded {
        Bounded::new(number.to_f64(), 0.0)
    }

    fn undefined(&mut self) -> Bounded {
        Bounded::new(f64::NAN, f64::NAN)
    }

    fn negate(&mut self, a: &Bounded) -> Bounded {
        Bounded {
            value: -a.value,
            ..*a
        }
    }

    fn add(&mut self, a: &Bounded, b: &Bounded) -> Bounded {
        Bounded::new(a.value + b.value, a.error + b.error)
    }

    fn multiply(&mut self, a: &Bounded, b: &Bounded) -> Bounded {
        let error = a.error * (b.value.abs() + b.error) + a.value.abs() * b.error;
        Bounded::new(a.value * b.value, error)
    }

    fn divide(&mut self, a: &Bounded, b: &Bounded) -> Bounded {
        let quotient = a.value / b.value;
        let least = b.value.abs() - b.error;
        if least > 0.0 {
            Bounded::new(quotient, (a.error + quotient.abs() * b.error) / least)
        } else {
            self.undefined()
        }
    }

    fn apply(&mut self, function: Function, arguments: &[Bounded]) -> Bounded {
        let at = |moved: usize, by: f64| {
            let shift = |index: usize| if index == moved { by } else { 0.0 };
            let argument = |index: usize| arguments[index].value + shift(index);
            match arguments.len() {
                1 => unary(function, argument(0)),
                _ => binary(function, argument(0), argument(1)),
            }
        };
        let value = at(0, 0.0);
        // as much as it changes up to the ends of each argument
        let error = arguments.iter().enumerate().map(|(index, argument)| {
            let ends = [-argument.error, argument.error].map(|by| at(index, by));
            ends.map(|end| (end - value).abs()).iter().sum::<f64>()
        });
        Bounded::new(value, error.sum())
    }

    fn is_zero(&self, _: &Bounded) -> bool {
        false
    }

    fn is_not_zero(&self, a: &Bounded) -> bool {
        a.value.is_finite() && a.value.abs() > MARGIN * a.error
    }
}
