//! Random bodies.

use super::{Drawing, Keys, Masses};
use crate::law::kind::Kind;
use crate::law::scene::Link;
use crate::law::space::{Mat3, ZERO, diagonal};
use crate::wide::Wide;

impl Drawing {
    /// Which bodies are alike.
    pub fn alike(&mut self, count: usize) {
        for number in 0..count {
            let is_alike = number > 0 && self.numbers.one_of(6) && self.extent.copies;
            let first = if is_alike {
                self.firsts[number - 1]
            } else {
                number
            };
            self.firsts.push(first);
        }
    }

    pub fn body(&mut self, masses: Masses, number: usize) {
        self.bodies.push(Keys::default());
        let first = self.firsts[number];
        if first == number {
            self.first(masses, number);
        } else {
            let link = &self.links[first];
            let (mass, inertia) = (link.mass, link.inertia);
            self.link(mass, inertia);
        }
        if self.alike_as(number).len() == 1 {
            return;
        }
        let mut word = format!("c{number}");
        if self.bodies[first].inertia.starts_with("disc") {
            // turned so that its axis goes this way
            let axis = self.numbers.rng.usize(0..3);
            let mut parts = ["0"; 3];
            parts[axis] = "1";
            word = format!("{word} = body({})", parts.join(", "));
            let mut moments = [[0, 1, 2].map(|i| self.links[first].inertia[i][i])].concat();
            moments.sort_by(|a, b| a.high.total_cmp(&b.high));
            let mut tensor = diagonal([moments[0]; 3]);
            tensor[axis][axis] = moments[2];
            self.links[number].inertia = tensor;
        }
        self.bodies[first].copies.push(word);
    }

    /// One that is not like one before it.
    fn first(&mut self, masses: Masses, number: usize) {
        let steps = i32::try_from(number).unwrap_or(0);
        let power = match masses {
            Masses::Alike => 0,
            Masses::Lighter => -5 * steps,
            Masses::Heavier => steps,
            Masses::Any => self.numbers.rng.i32(-4..=4),
        };
        let has_copies = self.alike_as(number).len() > 1;
        let numbers = &mut self.numbers;
        let mass = (0.5 + numbers.positive(2.0)) * 2.0_f64.powi(power);
        let mut keys = Keys::default();
        let (word, mass_value) = numbers.changing(mass, "kg");
        keys.mass = word;
        // moments of the distribution along each axis, so that the inertia is possible
        let [a, b, c] = [0; 3].map(|_| mass * numbers.positive(0.25));
        let (is_disc, radius) = (numbers.one_of(3), 0.125 + numbers.positive(0.5));
        let tensor = if self.is_planar {
            let (word, moment) = numbers.changing(a, "kg * m ^ 2");
            keys.inertia = word;
            diagonal([Wide::ONE, Wide::ONE, moment])
        } else if is_disc && has_copies {
            let (word, radius) = numbers.quantity(radius, "m");
            keys.inertia = format!("disc({word})");
            let across = mass_value * radius * radius * 0.25;
            diagonal([across, across, across * 2.0])
        } else {
            let axes = match numbers.rng.usize(0..6) {
                0 => [a, a, a],
                1 => [a, b, b],
                2 => [b, a, b],
                3 => [b, b, a],
                _ => [a, b, c],
            };
            self.tensor(axes, &mut keys)
        };
        for point in ["r", "s"] {
            let (word, place) = self.numbers.components(0.5, "m", self.is_planar);
            keys.points.push((point.to_owned(), place, word));
        }
        self.bodies[number] = keys;
        self.link(mass_value, tensor);
    }

    fn link(&mut self, mass: Wide, inertia: Mat3) {
        self.links.push(Link {
            mass,
            inertia,
            carrier: None,
            place: ZERO,
            pin: ZERO,
            kind: Kind::Weld,
            turned: Vec::new(),
            driven: None,
            armature: Wide::ZERO,
        });
    }

    /// Of second moments along the axes.
    fn tensor(&mut self, [a, b, c]: [f64; 3], keys: &mut Keys) -> Mat3 {
        let numbers = &mut self.numbers;
        let moments = [b + c, c + a, a + b];
        let unit = "kg * m ^ 2";
        if !self.extent.tensors || !numbers.one_of(3) {
            let mut words = Vec::new();
            let mut seen: Vec<(f64, String)> = Vec::new();
            for moment in moments {
                // what is equal is so by name, too
                let known = seen
                    .iter()
                    .find(|(value, _)| value.total_cmp(&moment).is_eq());
                let word = match known {
                    Some((_, word)) => word.clone(),
                    None => numbers.changing(moment, unit).0,
                };
                seen.push((moment, word.clone()));
                words.push(word);
            }
            keys.inertia = format!("principal({})", words.join(", "));
            return diagonal(moments.map(Wide::from));
        }
        // products, small enough for any moments
        let least = a.min(b).min(c);
        let names = [("xy", 0, 1), ("zx", 0, 2), ("yz", 1, 2)];
        let mut matrix = diagonal(moments.map(Wide::from));
        let mut words: Vec<String> = ["xx", "yy", "zz"]
            .iter()
            .zip(moments)
            .map(|(name, moment)| format!("{name}: {}", numbers.changing(moment, unit).0))
            .collect();
        for (name, i, j) in names {
            if numbers.one_of(3) {
                continue;
            }
            let entry = least * numbers.plain(0.4);
            words.push(format!("{name}: {}", numbers.quantity(entry, unit).0));
            matrix[i][j] = entry.into();
            matrix[j][i] = entry.into();
        }
        keys.inertia = format!("tensor {{ {} }}", words.join(", "));
        matrix
    }
}
