//! Units for display.

use core::fmt;

use crate::fraction::Fraction;

/// A product of powers of units, as words.
#[derive(Clone, Debug)]
pub struct Unit(pub Vec<(String, Fraction)>);

impl Unit {
    /// The unit of its time derivative; `None` if an exponent becomes too large.
    pub fn per_second(mut self) -> Option<Self> {
        let below = Fraction::ONE.negative();
        match self.0.iter_mut().find(|(word, _)| word == "s") {
            Some((_, exponent)) => *exponent = exponent.plus(below)?,
            None => self.0.push(("s".to_owned(), below)),
        }
        Some(self)
    }
}

impl fmt::Display for Unit {
    /// `kg * m / s ^ 2`
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let part = |positive: bool| {
            let factors = self.0.iter();
            let factors = factors
                .filter(|(_, exponent)| exponent.is_positive() == positive)
                .filter(|(_, exponent)| *exponent != Fraction::ZERO);
            let words = factors.map(|(unit, exponent)| match exponent.abs() {
                Fraction::ONE => unit.clone(),
                power => format!("{unit} ^ {power}"),
            });
            words.collect::<Vec<_>>()
        };
        let (above, below) = (part(true), part(false));
        let numerator = if above.is_empty() {
            "1".to_owned()
        } else {
            above.join(" * ")
        };
        match below.len() {
            0 if above.is_empty() => f.write_str("a pure number"),
            0 => f.write_str(&numerator),
            1 => write!(f, "{numerator} / {}", below[0]),
            _ => write!(f, "{numerator} / ({})", below.join(" * ")),
        }
    }
}
