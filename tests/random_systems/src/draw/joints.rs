//! Random joints.

use super::Drawing;
use super::number::{Written3, literal};
use crate::law::kind::{Kind, turn};
use crate::law::scene::Prescribed;
use crate::law::space::{Vec3, ZERO, apply, cross, diagonal, dot, identity, transposed, unit};
use crate::wide::Wide;

/// From a point to a point, as they are written.
pub struct Ends {
    pub from: String,
    pub to: String,
}

impl Drawing {
    /// A place on a body or the ground: G, or a point with a name.
    pub fn place(&mut self, body: Option<usize>, name: &str, is_drawn: bool) -> Written3 {
        let is_center = self.numbers.one_of(4) || !is_drawn;
        let (word, place) = self.numbers.components(0.5, "m", self.is_planar);
        let Some(body) = body else {
            if is_center {
                return (self.origin(), ZERO);
            }
            return (format!("world({word})"), place);
        };
        if is_center {
            return (format!("{}.G", self.name(body)), ZERO);
        }
        self.keys(body).points.push((name.to_owned(), place, word));
        (format!("{}.{name}", self.name(body)), place)
    }

    fn origin(&self) -> String {
        let zeros = if self.is_planar { "0, 0" } else { "0, 0, 0" };
        format!("world({zeros})")
    }

    pub fn joint(&mut self, number: usize, carrier: Option<usize>) {
        let may_be_free = carrier.is_none() && !self.is_flat;
        if may_be_free && self.numbers.rng.usize(0..10) >= 7 {
            self.ground_joint(number);
            return;
        }
        let (from, place) = self.place(carrier, &format!("c{number}"), self.extent.places);
        let (to, pin) = self.place(Some(number), &format!("q{number}"), self.extent.pins);
        let (word, kind) = self.kind(&Ends { from, to });
        let turned = self.turned();
        let driven = self.driven(kind);
        let (word, kind) = self.in_axes_of_the_carrier(carrier, word, kind, turned.as_ref());
        self.point_mass(number, kind, pin);
        let link = &mut self.links[number];
        (link.carrier, link.place, link.pin, link.kind) = (carrier, place, pin, kind);
        let mut word = word;
        if let Some((written, axis, angle)) = turned {
            word += &written;
            link.turned.push((axis, angle));
        }
        if let Some((written, functions)) = driven {
            word += &written;
            link.driven = Some(functions);
        }
        self.joints.push(word);
    }

    /// Makes some bodies on hinges off their G point masses.
    fn point_mass(&mut self, number: usize, kind: Kind, pin: Vec3) {
        let Kind::Revolute(axis) = kind else { return };
        let arm = cross(axis, pin);
        let is_off = arm.iter().any(|part| part.high.abs() > 0.05);
        // what else is drawn does not depend on it
        let is_wanted = self.numbers.rng.clone().usize(0..4) == 0;
        if !is_off || !is_wanted || self.alike_as(number).len() > 1 {
            return;
        }
        let moment = if self.is_planar {
            "0[kg * m ^ 2]"
        } else {
            "principal(0, 0, 0)[kg * m ^ 2]"
        };
        moment.clone_into(&mut self.bodies[number].inertia);
        let beside = if self.is_planar {
            Wide::ONE
        } else {
            Wide::ZERO
        };
        self.links[number].inertia = diagonal([beside, beside, Wide::ZERO]);
    }

    /// What is written with a body alone.
    fn ground_joint(&mut self, number: usize) {
        let which = self.numbers.rng.usize(0..5);
        let (word, kind) = match (which, self.is_planar) {
            (0..=2, true) => ("free", Kind::Plane),
            (3, true) => ("translation", Kind::Shift(2)),
            (_, true) => ("planar_translation", Kind::Shift(2)),
            (0..=2, false) => ("free", Kind::Free),
            (3, false) => ("rotation", Kind::Spherical),
            (_, false) => ("translation", Kind::Shift(3)),
        };
        let word = format!("{word}({})", self.name(number));
        self.links[number].kind = kind;
        self.joints.push(word);
    }

    /// Any kind that there is between bodies.
    fn kind(&mut self, ends: &Ends) -> (String, Kind) {
        let kind = match (self.is_planar || self.is_flat, self.is_open) {
            (true, _) => self.numbers.rng.usize(0..7),
            // the slides of a planar joint have no open drives here
            (false, true) => 9 - self.numbers.rng.usize(0..9),
            (false, false) => 10 - self.numbers.rng.usize(0..11),
        };
        let (direction, d) = self.numbers.direction(self.is_planar);
        let (second, e) = self.across(d);
        let (normal, n) = self.numbers.numeric(false);
        let pitch = self.numbers.plain(0.3);
        let (pitch_word, pitch) = self.numbers.quantity(pitch, "m");
        let Ends { from, to } = ends;
        let z = identity()[2];
        if self.is_planar || self.is_flat {
            return match (kind, self.is_planar) {
                (0..=3, true) => (format!("revolute({from}, {to})"), Kind::Revolute(z)),
                (0..=4, false) => (
                    format!("revolute({from}, {to}, body(0, 0, 1))"),
                    Kind::Revolute(z),
                ),
                (4..=5, true) => (
                    format!("prismatic({from}, {to}, body({direction}))"),
                    Kind::Prismatic(d),
                ),
                (5, false) => {
                    let words = format!("prismatic({from}, {to}, body(1, 2, 0))");
                    (
                        words,
                        Kind::Prismatic(unit([1.0, 2.0, 0.0].map(Wide::from))),
                    )
                }
                _ => (format!("weld({from}, {to})"), Kind::Weld),
            };
        }
        match kind {
            8..=10 => (
                format!("revolute({from}, {to}, body({direction}))"),
                Kind::Revolute(d),
            ),
            7 => (
                format!("prismatic({from}, {to}, body({direction}))"),
                Kind::Prismatic(d),
            ),
            6 => (
                format!("cylindrical({from}, {to}, body({direction}))"),
                Kind::Cylindrical(d),
            ),
            5 => (
                format!("screw({from}, {to}, body({direction}), {pitch_word})"),
                Kind::Screw(d, pitch),
            ),
            4 => (
                format!("universal({from}, {to}, body({direction}), body({second}))"),
                Kind::Universal(d, e),
            ),
            3 => (format!("weld({from}, {to})"), Kind::Weld),
            2 if !self.is_open => (
                format!("planar({from}, {to}, body({normal}))"),
                Kind::planar(n),
            ),
            _ => (format!("spherical({from}, {to})"), Kind::Spherical),
        }
    }

    /// A direction that is not parallel to this one.
    pub fn across(&mut self, d: Vec3) -> (String, Vec3) {
        let (word, direction) = self.numbers.direction(self.is_planar);
        let across = cross(d, direction);
        if dot(across, across).high > 0.05 {
            return (word, direction);
        }
        let other = if d[0].high.abs() > 0.5 {
            [0.0, 0.0, 1.0]
        } else {
            [1.0, 0.0, 0.0]
        };
        let words = other.map(|part: f64| part.to_string());
        (words.join(", "), unit(other.map(Wide::from)))
    }

    fn turned(&mut self) -> Option<(String, Vec3, Wide)> {
        let is_turned = self.numbers.one_of(3);
        let (axis_word, axis) = self.numbers.direction(false);
        let degrees = [90.0, 180.0, -90.0, 30.0, 45.0, 120.0, 0.0][self.numbers.rng.usize(0..7)];
        let radians = self.numbers.plain(2.0);
        let (word, angle) = if self.numbers.rng.bool() {
            let angle = Wide::PI * degrees / Wide::from(180.0);
            (format!("{}[deg]", literal(degrees)), angle)
        } else {
            self.numbers.quantity(radians, "rad")
        };
        if !is_turned || !self.extent.turned {
            return None;
        }
        if self.is_flat {
            return Some((
                format!(".turned(body(0, 0, 1), {word})"),
                identity()[2],
                angle,
            ));
        }
        if self.is_planar {
            return Some((format!(".turned({word})"), identity()[2], angle));
        }
        Some((format!(".turned(body({axis_word}), {word})"), axis, angle))
    }

    /// One joint in four has the same components as directions in the axes of its carrier.
    fn in_axes_of_the_carrier(
        &mut self,
        carrier: Option<usize>,
        word: String,
        kind: Kind,
        turned: Option<&(String, Vec3, Wide)>,
    ) -> (String, Kind) {
        // the normal of a planar joint consists of numbers
        let is_planar = matches!(kind, Kind::Planar(..));
        if !self.numbers.one_of(4) || is_planar {
            return (word, kind);
        }
        let axes = carrier.map_or("world".to_owned(), |body| {
            format!("{}.body", self.name(body))
        });
        let word = word.replace("body(", &format!("{axes}("));
        let back = |direction: Vec3| {
            turned.map_or(direction, |(_, axis, angle)| {
                apply(&transposed(&turn(*axis, *angle)), direction)
            })
        };
        (word, kind.with_directions(back))
    }

    fn driven(&mut self, kind: Kind) -> Option<(String, Vec<Prescribed>)> {
        let units: &[&str] = match kind {
            Kind::Revolute(_) | Kind::Screw(..) => &["rad"],
            Kind::Prismatic(_) => &["m"],
            Kind::Cylindrical(_) => &["m", "rad"],
            Kind::Universal(..) => &["rad", "rad"],
            Kind::Planar(..) => &["m", "m", "rad"],
            _ => return None,
        };
        if !self.numbers.one_of(5) || !self.extent.driven || self.is_open {
            return None;
        }
        let (mut words, mut functions) = (Vec::new(), Vec::new());
        for unit in units {
            let (word, function) = self.prescribed(unit);
            words.push(word);
            functions.push(function);
        }
        Some((format!(".driven({})", words.join(", ")), functions))
    }

    fn prescribed(&mut self, unit: &str) -> (String, Prescribed) {
        let numbers = &mut self.numbers;
        // what else is drawn does not depend on it
        if numbers.states > 0 && numbers.rng.clone().bool() {
            return numbers.led(unit);
        }
        let (size, rate) = (numbers.plain(2.0), numbers.plain(3.0));
        match numbers.rng.usize(0..4) {
            0 => {
                let (word, rate) = numbers.quantity(rate, &format!("{unit} / s"));
                let function: Prescribed = Box::new(move |at| [at.time * rate, rate, Wide::ZERO]);
                (format!("{word} * t"), function)
            }
            1 => {
                let (name, place) = numbers.moving(unit);
                let function: Prescribed =
                    Box::new(move |at| [0, 1, 2].map(|order| at.inputs[place + order]));
                (name, function)
            }
            2 => {
                let (word, value) = numbers.quantity(size, unit);
                let function: Prescribed = Box::new(move |_| [value, Wide::ZERO, Wide::ZERO]);
                (word, function)
            }
            _ => {
                let (size_word, size) = numbers.quantity(size, unit);
                let (rate_word, rate) = numbers.quantity(rate, "rad / s");
                let function: Prescribed = Box::new(move |at| {
                    let (sine, cosine) = (rate * at.time).sin_cos();
                    let swing = size * rate;
                    [size * sine, swing * cosine, -(swing * rate * sine)]
                });
                (format!("{size_word} * ({rate_word} * t).sin()"), function)
            }
        }
    }
}
