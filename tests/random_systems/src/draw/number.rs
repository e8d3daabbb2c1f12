//! Numbers as they are written, and their values.

use fastrand::Rng;

use super::led::Led;
use crate::law::space::{Vec3, unit};
use crate::wide::Wide;

/// What is declared.
#[derive(Default)]
pub struct Declared {
    /// With their units.
    pub params: Vec<(String, f64)>,
    /// User-defined, with their units.
    pub states: Vec<(String, String, f64)>,
    pub inputs: Vec<(String, f64)>,
    /// How inputs are declared: of moving ones the rates are not.
    pub input_words: Vec<String>,
    /// By the inputs: the number of one that is its rate.
    pub rates: Vec<Option<usize>>,
    pub locals: Vec<String>,
    /// The rates of states that drive joints.
    pub led: Vec<Led>,
    /// Whether functions of Rust are called.
    pub calls: bool,
}

impl Declared {
    /// Of inputs, and of user-defined states.
    pub fn values(&self) -> (Vec<Wide>, Vec<Wide>) {
        let inputs = self.inputs.iter().map(|(_, value)| (*value).into());
        let states = self.states.iter().map(|(.., value)| (*value).into());
        (inputs.collect(), states.collect())
    }
}

/// Draws numbers of few binary digits, which decimals write exactly.
pub struct Numbers {
    pub rng: Rng,
    pub declared: Declared,
    /// One of so many is a parameter; 0: none.
    pub params: usize,
    /// And a local.
    pub locals: usize,
    /// Of what may change, one of so many is a state of its own; 0: none.
    pub states: usize,
}

pub type Written = (String, Wide);

/// A vector as it is written, and what it is.
pub type Written3 = (String, Vec3);

impl Numbers {
    pub fn one_of(&mut self, count: usize) -> bool {
        self.rng.usize(0..count) == 0
    }

    /// A multiple of 1/64 up to `most`, not zero.
    pub fn plain(&mut self, most: f64) -> f64 {
        #[allow(clippy::cast_possible_truncation, reason = "small")]
        let steps = (most * 64.0) as i32;
        let number = f64::from(self.rng.i32(1..=steps)) / 64.0;
        if self.rng.bool() { number } else { -number }
    }

    pub fn positive(&mut self, most: f64) -> f64 {
        self.plain(most).abs()
    }

    /// A number with its unit, or a parameter of this value.
    pub fn quantity(&mut self, value: f64, unit: &str) -> Written {
        if self.params > 0 && self.one_of(self.params) {
            return (self.param(value, unit), value.into());
        }
        let unit = if unit.is_empty() {
            String::new()
        } else {
            format!("[{unit}]")
        };
        (self.local(literal(value) + &unit), value.into())
    }

    /// The same of what may change: a quantity, or a user-defined state of this value.
    pub fn changing(&mut self, value: f64, unit: &str) -> Written {
        let written = self.quantity(value, unit);
        // what else is drawn does not depend on it
        if self.states == 0 || self.rng.clone().usize(0..self.states) > 0 {
            return written;
        }
        let (name, _) = self.state(value, unit);
        (name, value.into())
    }

    /// A user-defined state of this value, and its number.
    pub fn state(&mut self, value: f64, unit: &str) -> (String, usize) {
        let place = self.declared.states.len();
        let name = format!("s{place}");
        let state = (name.clone(), unit.to_owned(), value);
        self.declared.states.push(state);
        (name, place)
    }

    /// What is written, or the name of a local that is this.
    pub fn local(&mut self, word: String) -> String {
        if self.locals == 0 || !self.one_of(self.locals) {
            return word;
        }
        let name = format!("l{}", self.declared.locals.len());
        self.declared.locals.push(format!("{name} = {word}"));
        name
    }

    pub fn param(&mut self, value: f64, unit: &str) -> String {
        let name = format!("p{}", self.declared.params.len());
        let unit = if unit.is_empty() {
            String::new()
        } else {
            format!("[{unit}]")
        };
        self.declared.params.push((format!("{name}{unit}"), value));
        name
    }

    pub fn input(&mut self, unit: &str) -> (String, usize) {
        let place = self.declared.inputs.len();
        let name = format!("u{place}");
        self.declared.input_words.push(format!("{name}[{unit}]"));
        let value = self.plain(3.0);
        self.declared.inputs.push((name.clone(), value));
        self.declared.rates.push(None);
        (name, place)
    }

    /// An input with its rate and acceleration.
    pub fn moving(&mut self, unit: &str) -> (String, usize) {
        let place = self.declared.inputs.len();
        let name = format!("u{place}");
        self.declared
            .input_words
            .push(format!("{name}[{unit}].moving"));
        for (order, suffix) in ["", "_rate", "_acceleration"].into_iter().enumerate() {
            let value = self.plain(2.0);
            let rate = (order < 2).then_some(place + order + 1);
            self.declared.rates.push(rate);
            self.declared
                .inputs
                .push((format!("{name}{suffix}"), value));
        }
        (name, place)
    }

    /// Components, many of them zero.
    pub fn components(&mut self, most: f64, unit: &str, is_planar: bool) -> (String, Vec3) {
        let count = if is_planar { 2 } else { 3 };
        let one = self.rng.usize(0..count);
        let is_along = self.rng.bool();
        let mut value = [Wide::ZERO; 3];
        let mut words = Vec::new();
        for (axis, part) in value.iter_mut().enumerate().take(count) {
            let is_zero = if is_along {
                axis != one
            } else {
                self.one_of(5)
            };
            if is_zero {
                words.push("0".to_owned());
                continue;
            }
            let number = self.plain(most);
            let (word, number) = self.quantity(number, unit);
            words.push(word);
            *part = number;
        }
        (words.join(", "), value)
    }

    /// A direction: an axis, of whole numbers, or of a parameter.
    pub fn direction(&mut self, is_planar: bool) -> Written3 {
        let (parts, mut words) = self.whole(is_planar);
        let is_of_param = self.one_of(5) && self.params > 0;
        if is_of_param && let Some(axis) = parts.iter().position(|part| *part != 0.0) {
            words[axis] = self.param(parts[axis], "");
        }
        (words.join(", "), unit(parts.map(Wide::from)))
    }

    /// One of numbers.
    pub fn numeric(&mut self, is_planar: bool) -> Written3 {
        let (parts, words) = self.whole(is_planar);
        (words.join(", "), unit(parts.map(Wide::from)))
    }

    fn whole(&mut self, is_planar: bool) -> ([f64; 3], Vec<String>) {
        let count = if is_planar { 2 } else { 3 };
        let mut parts = [0.0_f64; 3];
        if self.rng.usize(0..5) < 3 {
            parts[self.rng.usize(0..count)] = if self.one_of(4) { -1.0 } else { 1.0 };
        } else {
            while parts.iter().all(|part| part.abs() < 0.5) {
                for part in parts.iter_mut().take(count) {
                    *part = f64::from(self.rng.i32(-3..=3));
                }
            }
        }
        let words = parts.iter().take(count).map(ToString::to_string);
        (parts, words.collect())
    }
}

/// All its digits, not only those that tell it from its neighbors.
pub fn literal(value: f64) -> String {
    let text = format!("{value:.80}");
    let text = text.trim_end_matches('0').trim_end_matches('.');
    if value < 0.0 {
        format!("({text})")
    } else {
        text.to_owned()
    }
}
