//! Axes: ranges with round ticks.

use std::format;
use std::string::{String, ToString as _};
use std::vec::Vec;

/// A range of numbers along a length of pixels.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Axis {
    low: f64,
    high: f64,
    /// Where the two are, in pixels.
    from: f64,
    to: f64,
}

/// The largest number that is shown: the difference of larger ones may overflow.
const LARGEST: f64 = 1e300;
/// The smallest number that is shown: smaller ones count as zero, because their fractions may
/// underflow.
const SMALLEST: f64 = 1e-290;

impl Axis {
    /// An axis for some numbers, without those that are not finite.
    pub(super) fn covering(numbers: impl Iterator<Item = f64>, [from, to]: [f64; 2]) -> Self {
        let finite = numbers.filter(|number| number.is_finite());
        let (mut low, mut high) = finite
            .map(|number| {
                let is_visible = number.abs() >= SMALLEST;
                if is_visible {
                    number.clamp(-LARGEST, LARGEST)
                } else {
                    0.0
                }
            })
            .fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), number| {
                (low.min(number), high.max(number))
            });
        if low > high {
            (low, high) = (0.0, 1.0);
        }
        // a constant has a range too
        let size = low.abs().max(high.abs());
        if high - low <= 1e-9 * size || size == 0.0 {
            let margin = if size == 0.0 { 1.0 } else { 0.05 * size };
            (low, high) = (low - margin, high + margin);
        }
        Self {
            low,
            high,
            from,
            to,
        }
    }

    /// The same with a margin of a part of its range on both sides.
    pub(super) fn widened(self, part: f64) -> Self {
        let margin = part * (self.high - self.low);
        Self {
            low: self.low - margin,
            high: self.high + margin,
            ..self
        }
    }

    /// The same range with at most this many pixels per unit, centered.
    pub(super) fn at_scale(self, scale: f64) -> Self {
        let half = 0.5 * (self.to - self.from).abs() / scale;
        let middle = 0.5 * (self.low + self.high);
        Self {
            low: middle - half,
            high: middle + half,
            ..self
        }
    }

    /// Pixels for a unit.
    pub(super) fn scale(&self) -> f64 {
        (self.to - self.from).abs() / (self.high - self.low)
    }

    /// Where a number is, in pixels.
    pub(super) fn place(&self, number: f64) -> f64 {
        self.from + (number - self.low) / (self.high - self.low) * (self.to - self.from)
    }

    /// Round numbers in the range, at most a few, with their labels in units of a power of ten.
    pub(super) fn ticks(&self, most: u32) -> Ticks {
        let rough = (self.high - self.low) / f64::from(most);
        let decade = 10_f64.powf(rough.log10().floor());
        let steps = [1.0, 2.0, 5.0, 10.0].map(|factor| factor * decade);
        let step = steps.into_iter().find(|step| *step >= rough);
        let step = step.unwrap_or(10.0 * decade);
        let size = self.low.abs().max(self.high.abs());
        let exponent = size.log10().floor();
        let exponent = if (-3.0..5.0).contains(&exponent) {
            0.0
        } else {
            exponent
        };
        let unit = 10_f64.powf(exponent);
        let decimals = decimals(step / unit);
        let first = (self.low / step).ceil();
        let numbers = (0..=2 * most).map(|k| (first + f64::from(k)) * step);
        let numbers = numbers.take_while(|number| *number <= self.high);
        Ticks {
            all: numbers
                .map(|number| {
                    let text = format!("{:.decimals$}", number / unit + 0.0);
                    let is_zero = text.bytes().all(|sign| matches!(sign, b'-' | b'0' | b'.'));
                    let text = text.trim_start_matches(if is_zero { "-" } else { "" });
                    (number, text.replace('-', "\u{2212}"))
                })
                .collect(),
            exponent,
        }
    }
}

/// The decimals that distinguish the multiples of a step, at most twelve.
fn decimals(step: f64) -> usize {
    (0..12)
        .find(|decimals| {
            let shown: f64 = format!("{step:.decimals$}").parse().unwrap_or(0.0);
            (shown - step).abs() < 1e-6 * step
        })
        .unwrap_or(12)
}

/// The ticks of an axis.
pub(super) struct Ticks {
    pub(super) all: Vec<(f64, String)>,
    /// The power of ten by which the labels are divided.
    exponent: f64,
}

impl Ticks {
    /// The label of the axis: its name, and its unit with the power of ten.
    pub(super) fn label(&self, name: &str, unit: &str) -> String {
        let power = if self.exponent == 0.0 {
            String::new()
        } else {
            let digits = self.exponent.to_string();
            let digits = digits.chars().map(|sign| match sign {
                '-' => '\u{207b}',
                '1' => '\u{b9}',
                '2' => '\u{b2}',
                '3' => '\u{b3}',
                digit => char::from_u32(0x2040 + u32::from(digit)).unwrap_or(digit),
            });
            format!("10{}", digits.collect::<String>())
        };
        let separator = if power.is_empty() || unit.is_empty() {
            ""
        } else {
            " "
        };
        let unit = format!("{power}{separator}{unit}");
        match (name, unit.as_str()) {
            (name, "") => name.to_string(),
            ("", unit) => format!("[{unit}]"),
            (name, unit) => format!("{name} [{unit}]"),
        }
    }

    /// The length of the longest text.
    pub(super) fn width(&self) -> usize {
        let lengths = self.all.iter().map(|(_, text)| text.chars().count());
        lengths.max().unwrap_or(0)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn texts(numbers: &[f64]) -> Vec<String> {
        let axis = Axis::covering(numbers.iter().copied(), [0.0, 100.0]);
        let ticks = axis.ticks(5);
        ticks.all.into_iter().map(|(_, text)| text).collect()
    }

    #[test]
    fn ticks_are_round() {
        assert_eq!(texts(&[0.0, 10.0]), ["0", "2", "4", "6", "8", "10"]);
        assert_eq!(texts(&[-0.25, 0.3]), ["\u{2212}0.2", "0.0", "0.2"]);
        assert_eq!(texts(&[2e7, 4e7]), ["2.0", "2.5", "3.0", "3.5", "4.0"]);
    }

    #[test]
    fn any_numbers_have_few_ticks() {
        let extremes = [0.0, -0.0, 5e-324, 1e-300, 1.0, 1e308, f64::MAX, f64::NAN];
        for low in extremes {
            for high in extremes {
                let numbers = [-low, high, f64::NEG_INFINITY];
                let ticks = Axis::covering(numbers.into_iter(), [0.0, 1.0]).ticks(5).all;
                assert!(ticks.len() <= 11, "{numbers:?}");
                let ascends = ticks.windows(2).all(|pair| pair[0].0 < pair[1].0);
                assert!(ascends && !ticks.is_empty(), "{numbers:?}: {ticks:?}");
            }
        }
    }

    #[test]
    fn labels_have_powers_of_ten() {
        let label = |numbers: &[f64], name, unit| {
            let axis = Axis::covering(numbers.iter().copied(), [0.0, 1.0]);
            axis.ticks(5).label(name, unit)
        };
        assert_eq!(label(&[0.0, 1.0], "height", "m"), "height [m]");
        assert_eq!(label(&[0.0, 3e-7], "", "m"), "[10\u{207b}\u{2077} m]");
        assert_eq!(label(&[0.0, 1e12], "x", ""), "x [10\u{b9}\u{b2}]");
    }
}
