//! Numbers in a file: decimals, which keep their digits, and right angles.

use core::f64::consts::FRAC_PI_2;

use proc_macro2::{Ident, Span};

use crate::errors::Extent;
use crate::fraction::Fraction;
use crate::syntax::UnitExpression;
use crate::syntax::expression::{Expression, Kind, Prefix};

/// A number as written, with its place.
#[derive(Clone)]
pub struct Decimal {
    /// The digits of a literal, without a sign.
    digits: String,
    is_negative: bool,
    pub extent: Extent,
}

/// The largest difference between an angle and the right angle that it is read as.
const NEAR: f64 = 1e-9;
/// The correct digits after the point that make an angle a right angle: `1.5707963`.
const NAMING: i32 = 7;

impl Decimal {
    /// A text such as `-1.5e-3`; `None` if it is not a number.
    pub fn parse(text: &str, extent: Extent) -> Option<Self> {
        let digits = text.strip_prefix(['+', '-']).unwrap_or(text);
        let (mantissa, exponent) = match digits.split_once(['e', 'E']) {
            Some((mantissa, exponent)) => (mantissa, Some(exponent)),
            None => (digits, None),
        };
        let is_whole = |text: &str| text.bytes().all(|byte| byte.is_ascii_digit());
        let (whole, fraction) = mantissa.split_once('.').unwrap_or((mantissa, ""));
        let is_mantissa = is_whole(whole) && is_whole(fraction) && whole.len() + fraction.len() > 0;
        let is_exponent = exponent.is_none_or(|exponent| {
            let digits = exponent.strip_prefix(['+', '-']).unwrap_or(exponent);
            !digits.is_empty() && is_whole(digits)
        });
        (is_mantissa && is_exponent).then(|| Self {
            digits: digits.to_owned(),
            is_negative: text.starts_with('-'),
            extent,
        })
    }

    pub fn zero(extent: Extent) -> Self {
        Self {
            digits: "0".to_owned(),
            is_negative: false,
            extent,
        }
    }

    pub fn one(extent: Extent) -> Self {
        Self {
            digits: "1".to_owned(),
            ..Self::zero(extent)
        }
    }

    pub fn is_zero(&self) -> bool {
        let mantissa = self.digits.split(['e', 'E']).next().unwrap_or_default();
        mantissa.bytes().all(|byte| matches!(byte, b'0' | b'.'))
    }

    pub fn negated(&self) -> Self {
        Self {
            is_negative: !self.is_negative,
            ..self.clone()
        }
    }

    pub fn is_negative(&self) -> bool {
        self.is_negative
    }

    pub fn text(&self) -> String {
        let sign = if self.is_negative { "-" } else { "" };
        format!("{sign}{}", self.digits)
    }

    /// The number as a Rust literal, with a digit before the point.
    pub fn literal(&self) -> String {
        let sign = if self.is_negative && !self.is_zero() {
            "-"
        } else {
            ""
        };
        let zero = if self.digits.starts_with('.') {
            "0"
        } else {
            ""
        };
        let digits = self.digits.replace(".e", ".0e").replace(".E", ".0E");
        format!("{sign}{zero}{digits}")
    }

    /// Whether both are the same double; the sign of zero does not matter.
    pub fn is_same(&self, other: &Self) -> bool {
        // adding zero removes the sign of a negative zero
        (self.value() + 0.0).to_bits() == (other.value() + 0.0).to_bits()
    }

    /// The nearest double.
    pub fn value(&self) -> f64 {
        self.text().parse().unwrap_or(f64::NAN)
    }

    pub fn expression(&self) -> Expression {
        let number = Expression {
            kind: Kind::Number(self.digits.clone()),
            extent: self.extent,
        };
        if self.is_negative && !self.is_zero() {
            negative(number)
        } else {
            number
        }
    }

    /// The angle as a number of right angles, if it differs by less than `NEAR`, or by less than
    /// one in its last digit. Only this test uses a double; the written text comes from the digits.
    fn right_angles(&self) -> Option<i32> {
        let angle: f64 = self.text().parse().ok()?;
        let count = (angle / FRAC_PI_2).round();
        if count.abs() > 100.0 {
            return None;
        }
        let off = (angle - count * FRAC_PI_2).abs();
        let decimals = self.decimals().filter(|decimals| *decimals >= NAMING);
        let is_named = decimals.is_some_and(|decimals| off < 10_f64.powi(-decimals));
        #[allow(clippy::cast_possible_truncation, reason = "at most a hundred")]
        (off < NEAR || is_named).then_some(count as i32)
    }

    /// The number of digits after the point.
    fn decimals(&self) -> Option<i32> {
        let split = self.digits.split_once(['e', 'E']);
        let (mantissa, exponent) = split.unwrap_or((&self.digits, "0"));
        let fraction = mantissa.split_once('.').map_or("", |(_, digits)| digits);
        let exponent: i32 = exponent.parse().ok()?;
        i32::try_from(fraction.len()).ok()?.checked_sub(exponent)
    }

    /// The number as an angle in radians; `None` if it is zero.
    pub fn angle(&self) -> Option<Angle> {
        if self.is_zero() {
            return None;
        }
        Some(match self.right_angles() {
            Some(count) => Angle::Right(count, self.clone()),
            None => Angle::General(self.clone()),
        })
    }
}

/// An angle that is not written as zero.
#[derive(Clone)]
pub enum Angle {
    /// The number of right angles, and what was written.
    Right(i32, Decimal),
    General(Decimal),
}

impl Angle {
    pub fn expression(&self) -> Expression {
        let (count, extent) = match self {
            Self::General(decimal) => return decimal.expression(),
            Self::Right(count, decimal) => (count, decimal.extent),
        };
        let degrees = Expression {
            kind: Kind::Number((count.unsigned_abs() * 90).to_string()),
            extent,
        };
        let unit = UnitExpression {
            factors: vec![(Ident::new("deg", Span::call_site()), Fraction::ONE)],
            extent,
        };
        let angle = Expression {
            kind: Kind::Unit(Box::new(degrees), unit),
            extent,
        };
        if *count < 0 { negative(angle) } else { angle }
    }
}

/// `-value`
fn negative(value: Expression) -> Expression {
    Expression {
        extent: value.extent,
        kind: Kind::Prefix(Prefix::Minus, Box::new(value)),
    }
}
