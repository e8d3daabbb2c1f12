//! User-defined states and their rates, tables, and Rust functions.

use super::Drawing;
use super::number::{Numbers, literal};
use super::sizes::Size;
use crate::interpolated::{Course, Real, curve, surface};
use crate::law::functions::{bump, wave};
use crate::law::scene::Scene;
use crate::wide::Wide;

/// What a table or a function makes of a number.
pub type Made = Box<dyn Fn(&Scene<'_>, Wide) -> Wide>;

impl Drawing {
    /// The rates may follow all that loads may follow; no further states are drawn for them.
    pub fn own_rates(&mut self) {
        self.numbers.states = 0;
        for (place, (name, unit, _)) in self.numbers.declared.states.clone().iter().enumerate() {
            let mut led = self.numbers.declared.led.iter();
            let (word, rate) = if let Some(led) = led.find(|led| led.state == place) {
                let rate = led.rate.clone();
                let size: Size = Box::new(move |scene| rate(&scene.instant));
                (led.word.clone(), size)
            } else {
                self.size(&format!("{unit} / s"))
            };
            self.rates.push((format!("{name} = {word}"), rate));
        }
    }
}

impl Numbers {
    /// What is written, or the same in a table or in a function, with the same unit.
    pub fn made_of(&mut self, word: String, unit: &str) -> (String, Made) {
        if self.states == 0 || !self.one_of(2) {
            return (word, Box::new(|_, x| x));
        }
        match self.rng.usize(0..6) {
            0..3 => self.tabulated(&word, unit),
            3 => self.on_a_grid(&word, unit),
            4 => {
                self.declared.calls = true;
                let word = format!("(1[{unit}] * bump({word} / 1[{unit}]))");
                (word, Box::new(|_, x| bump(0, x)))
            }
            _ => {
                self.declared.calls = true;
                let (input, place) = self.input("rad");
                let word = format!("(1[{unit}] * wave({word} / 1[{unit}], {input}))");
                let wave =
                    move |scene: &Scene<'_>, x: Wide| wave([0, 0], x, scene.instant.inputs[place]);
                (word, Box::new(wave))
            }
        }
    }

    fn tabulated(&mut self, word: &str, unit: &str) -> (String, Made) {
        let (places, values) = (self.places(4), self.values(4));
        let (words, course) = self.course();
        let [at, of] = [&places, &values].map(|list| listed(list));
        let word = format!("table({word}, {at}[{unit}], {of}[{unit}]{words})");
        let knots = places.iter().zip(&values);
        let knots = knots.map(|(place, value)| [Wide::from(*place), Wide::from(*value)]);
        let knots: Vec<[Wide; 2]> = knots.collect();
        (word, Box::new(move |_, x| curve(x, &knots, course)))
    }

    /// A table of it and of an input.
    fn on_a_grid(&mut self, word: &str, unit: &str) -> (String, Made) {
        let (along, across) = (self.places(3), self.places(3));
        let rows = [(); 3].map(|()| self.values(3));
        let (input, place) = self.input("rad");
        let (words, course) = self.course();
        let list = rows.each_ref().map(|row| listed(row)).join(", ");
        let (at, beside) = (listed(&along), listed(&across));
        let word = format!(
            "(1[{unit}] * table({word}, {input}, {at}[{unit}], {beside}[rad], [{list}]{words}))"
        );
        let wide =
            |list: &Vec<f64>| -> Vec<Wide> { list.iter().copied().map(Wide::from).collect() };
        let [along, across] = [&along, &across].map(wide);
        let rows = rows.each_ref().map(wide);
        let grid = move |scene: &Scene<'_>, x: Wide| {
            let at = [x, scene.instant.inputs[place]];
            surface(at, [&along, &across], &rows, course)
        };
        (word, Box::new(grid))
    }

    /// Places of a table, one behind the other, that no number drawn otherwise is at.
    fn places(&mut self, count: usize) -> Vec<f64> {
        let mut place = 1.0 / 128.0 - self.positive(3.0);
        let places = (0..count).map(|_| {
            place += self.positive(1.5);
            place
        });
        places.collect()
    }

    fn values(&mut self, count: usize) -> Vec<f64> {
        (0..count).map(|_| self.plain(2.0)).collect()
    }

    fn course(&mut self) -> (String, Course) {
        let course = Course {
            is_cubic: self.rng.bool(),
            is_extrapolated: self.rng.bool(),
        };
        let words = [
            (course.is_cubic, ", cubic"),
            (course.is_extrapolated, ", extrapolated"),
        ];
        let words = words.into_iter().filter(|(is_it, _)| *is_it);
        (words.map(|(_, word)| word).collect(), course)
    }
}

fn listed(numbers: &[f64]) -> String {
    let words: Vec<String> = numbers.iter().copied().map(literal).collect();
    format!("[{}]", words.join(", "))
}

impl Real for Wide {
    fn whole(n: i32) -> Self {
        f64::from(n).into()
    }

    fn float(self) -> f64 {
        self.high
    }
}
