//! Joints at random.

use crate::drawn::Drawing;
use crate::number::literal;
use crate::oracle::{Kind, Prescribed};
use crate::space::{Vec3, ZERO, cross, dot, identity, unit};
use crate::wide::Wide;

impl Drawing {
    /// A place on a body or the ground: G, or a point with a name.
    fn place(&mut self, body: Option<usize>, name: &str, is_drawn: bool) -> (String, Vec3) {
        let is_center = self.numbers.one_of(4) || !is_drawn;
        let (word, place) = self.numbers.components(0.5, "m", self.is_planar);
        let Some(body) = body else {
            if is_center {
                return (self.origin(), ZERO);
            }
            return (format!("world({word})"), place);
        };
        if is_center {
            return (format!("b{body}.G"), ZERO);
        }
        self.bodies[body]
            .points
            .push((name.to_owned(), place, word));
        (format!("b{body}.{name}"), place)
    }

    fn origin(&self) -> String {
        if self.is_planar {
            "world(0, 0)"
        } else {
            "world(0, 0, 0)"
        }
        .to_owned()
    }

    pub fn joint(&mut self, number: usize, carrier: Option<usize>) {
        let is_planar = self.is_planar;
        let kind = match (carrier, is_planar) {
            (None, _) => self.numbers.rng.usize(0..10),
            (_, true) => self.numbers.rng.usize(0..7),
            (_, false) => self.numbers.rng.usize(0..9),
        };
        let is_free = carrier.is_none() && kind >= 7;
        if is_free {
            self.links[number].kind = if is_planar { Kind::Plane } else { Kind::Free };
            self.joints.push(format!("free(b{number})"));
            return;
        }
        let (from, place) = self.place(carrier, &format!("c{number}"), self.extent.places);
        let (to, pin) = self.place(Some(number), "p", self.extent.pins);
        let (direction, d) = self.numbers.direction(is_planar);
        let (second, e) = self.across(d);
        let pitch = self.numbers.plain(0.3);
        let (pitch_word, pitch) = self.numbers.quantity(pitch, "m");
        let z = identity()[2];
        let (word, kind) = match (kind, is_planar) {
            (0..=3, true) => (format!("revolute({from}, {to})"), Kind::Revolute(z)),
            (4..=5, true) | (3, false) => (
                format!("prismatic({from}, {to}, body({direction}))"),
                Kind::Prismatic(d),
            ),
            (0..=2, false) => (
                format!("revolute({from}, {to}, body({direction}))"),
                Kind::Revolute(d),
            ),
            (4, false) => (
                format!("cylindrical({from}, {to}, body({direction}))"),
                Kind::Cylindrical(d),
            ),
            (5, false) => (
                format!("screw({from}, {to}, body({direction}), {pitch_word})"),
                Kind::Screw(d, pitch),
            ),
            (6, false) => (
                format!("universal({from}, {to}, body({direction}), body({second}))"),
                Kind::Universal(d, e),
            ),
            (7, false) => (format!("spherical({from}, {to})"), Kind::Spherical),
            _ => (format!("weld({from}, {to})"), Kind::Weld),
        };
        let turned = self.turned();
        let driven = self.driven(kind);
        let link = &mut self.links[number];
        (link.carrier, link.place, link.pin, link.kind) = (carrier, place, pin, kind);
        let mut word = word;
        if let Some((written, axis, angle)) = turned {
            word += &written;
            link.turned = Some((axis, angle));
        }
        if let Some((written, functions)) = driven {
            word += &written;
            link.driven = Some(functions);
        }
        self.joints.push(word);
    }

    /// A direction that is not parallel to this one.
    fn across(&mut self, d: Vec3) -> (String, Vec3) {
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
        if self.is_planar {
            return Some((format!(".turned({word})"), identity()[2], angle));
        }
        Some((format!(".turned(body({axis_word}), {word})"), axis, angle))
    }

    fn driven(&mut self, kind: Kind) -> Option<(String, Vec<Prescribed>)> {
        let units: &[&str] = match kind {
            Kind::Revolute(_) | Kind::Screw(..) => &["rad"],
            Kind::Prismatic(_) => &["m"],
            Kind::Cylindrical(_) => &["m", "rad"],
            Kind::Universal(..) => &["rad", "rad"],
            _ => return None,
        };
        if !self.numbers.one_of(5) || !self.extent.driven {
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
        let (size, rate) = (numbers.plain(2.0), numbers.plain(3.0));
        match numbers.rng.usize(0..4) {
            0 => {
                let (word, rate) = numbers.quantity(rate, &format!("{unit} / s"));
                let function: Prescribed = Box::new(move |t, _| [t * rate, rate, Wide::ZERO]);
                (format!("{word} * t"), function)
            }
            1 => {
                let (name, place) = numbers.moving(unit);
                let function: Prescribed =
                    Box::new(move |_, inputs| [0, 1, 2].map(|order| inputs[place + order]));
                (name, function)
            }
            2 => {
                let (word, value) = numbers.quantity(size, unit);
                let function: Prescribed = Box::new(move |_, _| [value, Wide::ZERO, Wide::ZERO]);
                (word, function)
            }
            _ => {
                let (size_word, size) = numbers.quantity(size, unit);
                let (rate_word, rate) = numbers.quantity(rate, "rad / s");
                let function: Prescribed = Box::new(move |t, _| {
                    let (sine, cosine) = (rate * t).sin_cos();
                    let swing = size * rate;
                    [size * sine, swing * cosine, -(swing * rate * sine)]
                });
                (format!("{size_word} * ({rate_word} * t).sin()"), function)
            }
        }
    }
}
