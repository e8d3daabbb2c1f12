//! Scalars and vectors that change with the state.

use super::Drawing;
use crate::law::kind::Kind;
use crate::law::scene::Scene;
use crate::law::space::{Vec3, ZERO};
use crate::wide::Wide;

/// A number that changes with the state.
pub type Size = Box<dyn Fn(&Scene<'_>) -> Wide>;

/// A vector that does, in world axes; it may be in those of a body.
pub type Turning = Box<dyn Fn(&Scene<'_>, usize) -> Vec3>;

/// A coordinate of a joint, or a rate.
#[derive(Clone)]
pub struct Scalar {
    pub name: String,
    pub joint: usize,
    /// Which of the joint's.
    pub place: usize,
    /// An angle, its rate, a length, its rate.
    pub kind: usize,
}

impl Drawing {
    /// Of a unit that is a force or a moment: constant, or by the state, the time, or an input.
    pub fn size(&mut self, unit: &str) -> (String, Size) {
        let (word, size) = self.plain_size(unit);
        (self.numbers.local(word), size)
    }

    fn plain_size(&mut self, unit: &str) -> (String, Size) {
        let value = self.numbers.plain(4.0);
        let scalars = self.scalars();
        match self.numbers.rng.usize(0..6) {
            0 | 1 if !scalars.is_empty() => {
                let chosen = self.numbers.rng.usize(0..scalars.len());
                let Scalar {
                    name,
                    joint,
                    place,
                    kind,
                } = scalars[chosen].clone();
                let unit = [
                    unit.to_owned(),
                    format!("{unit} * s"),
                    format!("{unit} / m"),
                    format!("{unit} * s / m"),
                ];
                let (word, k) = self.numbers.changing(value, &unit[kind]);
                let known = move |scene: &Scene<'_>| {
                    let (q, v) = &scene.rates[joint];
                    if kind % 2 == 0 { q[place] } else { v[place] }
                };
                let (name, made) = self
                    .numbers
                    .made_of(name, ["rad", "rad / s", "m", "m / s"][kind]);
                let size: Size = Box::new(move |scene| k * made(scene, known(scene)));
                (format!("({word} * {name})"), size)
            }
            2 => {
                let (word, k) = self.numbers.changing(value, unit);
                let rate = self.numbers.plain(3.0);
                let (rate_word, rate) = self.numbers.quantity(rate, "1 / s");
                let size: Size = Box::new(move |scene| k * (rate * scene.instant.time).sin_cos().1);
                (format!("({word} * ({rate_word} * t).cos())"), size)
            }
            3 => {
                let (word, place) = self.numbers.input(unit);
                let size: Size = Box::new(move |scene| scene.instant.inputs[place]);
                (format!("({word})"), size)
            }
            _ => {
                let (word, k) = self.numbers.changing(value, unit);
                let size: Size = Box::new(move |_| k);
                (format!("({word})"), size)
            }
        }
    }

    /// Coordinates and rates of joints that have names.
    pub fn scalars(&self) -> Vec<Scalar> {
        let mut all = Vec::new();
        for (joint, link) in self.links[..self.firsts.len()].iter().enumerate() {
            let pairs: &[(&str, &str, usize)] = match link.kind {
                Kind::Revolute(_) | Kind::Screw(..) => &[("angle", "angular_velocity", 0)],
                Kind::Prismatic(_) => &[("position", "velocity", 2)],
                Kind::Cylindrical(_) => &[
                    ("position", "velocity", 2),
                    ("angle", "angular_velocity", 0),
                ],
                Kind::Universal(..) => &[
                    ("angle_1", "angular_velocity_1", 0),
                    ("angle_2", "angular_velocity_2", 0),
                ],
                // behind the two slides
                Kind::Planar(..) | Kind::Plane => {
                    &[("", "", 2), ("", "", 2), ("angle", "angular_velocity", 0)]
                }
                _ => &[],
            };
            for (place, (q, v, kind)) in pairs.iter().enumerate() {
                for (name, kind) in [(q, *kind), (v, kind + 1)] {
                    if !name.is_empty() {
                        all.push(Scalar {
                            name: format!("j{joint}.{name}"),
                            joint,
                            place,
                            kind,
                        });
                    }
                }
            }
        }
        all
    }

    /// A vector of some constant and some changing components, in the axes of a body or of the world:
    /// how it is written, and how it is in world axes.
    pub fn vector(&mut self, unit: &str) -> (String, Turning) {
        let is_of_body = self.numbers.rng.bool();
        let count = if self.is_planar { 2 } else { 3 };
        let mut words = Vec::new();
        let mut sizes: Vec<Size> = Vec::new();
        for _ in 0..count {
            if self.numbers.one_of(3) {
                words.push("0".to_owned());
                sizes.push(Box::new(|_| Wide::ZERO));
            } else {
                let (word, size) = self.size(unit);
                words.push(word);
                sizes.push(size);
            }
        }
        let frame = if is_of_body { "body" } else { "world" };
        let word = format!("{frame}({})", words.join(", "));
        let vector = move |scene: &Scene<'_>, body: usize| {
            let mut vector = ZERO;
            for (part, size) in vector.iter_mut().zip(&sizes) {
                *part = size(scene);
            }
            scene.turned(is_of_body.then_some(body), vector)
        };
        (word, Box::new(vector))
    }
}
