//! User-defined states, the rates that they have, and tables.

use super::Drawing;
use super::number::{Numbers, literal};
use crate::wide::Wide;

/// What a table makes of a number.
pub type Table = Box<dyn Fn(Wide) -> Wide>;

impl Drawing {
    /// The rates may follow all that loads may follow; no further states are drawn for them.
    pub fn own_rates(&mut self) {
        self.numbers.states = 0;
        for (name, unit, _) in self.numbers.declared.states.clone() {
            let (word, rate) = self.size(&format!("{unit} / s"));
            self.rates.push((format!("{name} = {word}"), rate));
        }
    }
}

impl Numbers {
    /// What is written, or the same in a table: lines through some points, which go on beyond them.
    pub fn tabulated(&mut self, word: String, unit: &str) -> (String, Table) {
        if self.states == 0 || !self.one_of(3) {
            return (word, Box::new(|x| x));
        }
        let mut place = -self.positive(3.0);
        let points = (0..4).map(|_| {
            place += self.positive(1.5);
            [place, self.plain(2.0)]
        });
        let points: Vec<[f64; 2]> = points.collect();
        let [places, values] = [0, 1].map(|i| {
            let column = points.iter().map(|point| literal(point[i]));
            column.collect::<Vec<_>>().join(", ")
        });
        let word = format!("table({word}, [{places}][{unit}], [{values}][{unit}], extrapolated)");
        let table = move |x: Wide| {
            let inner = &points[1..points.len() - 1];
            let piece = inner
                .iter()
                .filter(|point| Wide::from(point[0]) < x)
                .count();
            let [[from, start], [to, end]] = [points[piece], points[piece + 1]];
            let slope = Wide::from(end - start) / Wide::from(to - from);
            Wide::from(start) + slope * (x - Wide::from(from))
        };
        (word, Box::new(table))
    }
}
