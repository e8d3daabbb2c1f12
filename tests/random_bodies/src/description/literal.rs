//! Numbers as they are written, and their exact values.

use crate::wide::Wide;

/// A decimal number, with a unit behind it or none.
#[derive(Clone, Debug)]
pub struct Literal {
    pub text: String,
    /// In SI units, to 106 bits.
    pub value: Wide,
}

/// What is written, and the numerator and denominator of its factor.
pub type Unit = (&'static str, f64, f64);

pub const LENGTHS: [Unit; 4] = [
    ("m", 1.0, 1.0),
    ("mm", 1.0, 1e3),
    ("inch", 254.0, 1e4),
    ("ft", 3048.0, 1e4),
];
pub const MASSES: [Unit; 3] = [("kg", 1.0, 1.0), ("g", 1.0, 1e3), ("lb", 45_359_237.0, 1e8)];

impl Literal {
    /// `digits * 10^exponent`, below 2^53 and from -22 up.
    #[allow(clippy::cast_precision_loss, reason = "digits are few")]
    pub fn new(digits: i64, exponent: i32) -> Self {
        let power = Wide::from(10.0_f64.powi(exponent.abs()));
        let digits_value = Wide::from(digits as f64);
        let value = if exponent < 0 {
            digits_value / power
        } else {
            digits_value * power
        };
        let text = match exponent {
            0 => format!("{digits}"),
            -12..0 => point(digits, exponent.unsigned_abs() as usize),
            _ => format!("{digits}e{exponent}"),
        };
        Self { text, value }
    }

    /// The same number of another unit than that of SI.
    pub fn unit(self, (word, numerator, denominator): Unit) -> Self {
        Self {
            text: format!("{}[{word}]", self.text),
            value: self.value * numerator / Wide::from(denominator),
        }
    }

    /// The nearest double, which is what a parameter is by default.
    pub fn nearest(&self) -> f64 {
        self.value.high
    }
}

/// With a decimal point so many digits from the end.
fn point(digits: i64, places: usize) -> String {
    let sign = if digits < 0 { "-" } else { "" };
    let all = format!("{:0>width$}", digits.unsigned_abs(), width = places + 1);
    let (whole, rest) = all.split_at(all.len() - places);
    format!("{sign}{whole}.{rest}")
}
