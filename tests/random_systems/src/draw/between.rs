//! Random loads between points and between bodies.

use super::number::literal;
use super::sizes::Turning;
use super::{CABLES, Drawing, FORCES, MOMENTS};
use crate::law::scene::{Loads, Scene};
use crate::law::space::{Vec3, dot, scale, subtract};
use crate::wide::Wide;

/// A point of a body or the ground: how it is written outside of braces, whose it is, where it is
/// there.
#[derive(Clone)]
pub struct Anchor {
    pub word: String,
    pub body: Option<usize>,
    pub at: Vec3,
}

/// Two of them.
#[derive(Clone)]
pub struct Line {
    pub start: Anchor,
    pub end: Anchor,
}

impl Line {
    /// From the start to the end.
    pub fn of(&self, scene: &Scene<'_>) -> Vec3 {
        let [start, end] = [&self.start, &self.end].map(|one| scene.point(one.body, one.at));
        subtract(end, start)
    }

    /// And its length; one that is too short for a direction is told.
    pub fn length(&self, scene: &Scene<'_>) -> Wide {
        let line = self.of(scene);
        let square = dot(line, line);
        if square.high < 1e-4 {
            scene.is_near.set(true);
            return Wide::ONE;
        }
        square.sqrt()
    }

    /// Pulls its ends together with its vector, so many times.
    pub fn pull(&self, scene: &Scene<'_>, loads: &mut Loads, share: Wide) {
        let pull = scale(self.of(scene), share);
        for (anchor, sign) in [(&self.start, Wide::ONE), (&self.end, -Wide::ONE)] {
            if let Some(body) = anchor.body {
                loads.force(scene, body, anchor.at, scale(pull, sign));
            }
        }
    }

    /// The vector, as it is written.
    pub fn word(&self) -> String {
        let [start, end] = [&self.start, &self.end].map(|anchor| match anchor.body {
            Some(_) => format!("{}.position()", anchor.word),
            None => anchor.word.clone(),
        });
        format!("({end} - {start})")
    }
}

impl Drawing {
    fn anchor(&mut self) -> Anchor {
        let count = self.firsts.len();
        let body = self.numbers.rng.usize(0..=count);
        if body == count {
            let (word, at) = self.numbers.components(3.0, "m", self.is_planar);
            return Anchor {
                word: format!("world({word})"),
                body: None,
                at,
            };
        }
        let (point, at) = self.point_of(body);
        Anchor {
            word: format!("{}.{point}", self.name(body)),
            body: Some(body),
            at,
        }
    }

    /// Between points that are never held in one place, of two bodies, or of a body and the ground.
    pub fn line(&mut self) -> Option<Line> {
        let (start, end) = (self.anchor(), self.anchor());
        let line = Line { start, end };
        (line.start.body != line.end.body && !self.is_held(&line)).then_some(line)
    }

    /// Points that a joint holds together have no line between them.
    fn is_held(&self, line: &Line) -> bool {
        let places = [&line.start, &line.end].map(|one| one.body.map(|body| (body, one.at)));
        self.links.iter().enumerate().any(|(number, link)| {
            let ring = self.rings.iter().find(|ring| ring.link == number);
            let body = ring.map_or(number, |ring| ring.body);
            let near = [
                Some((body, link.pin)),
                link.carrier.map(|carrier| (carrier, link.place)),
            ];
            places.iter().all(|place| near.contains(place))
                || (link.carrier.is_none() && places.contains(&near[0]))
        })
    }

    /// A constant or changing tension, or a spring.
    pub fn tension(&mut self, number: usize) {
        let line = self.line();
        let is_spring = self.numbers.one_of(2);
        let (mut word, size) = self.size("N");
        let stiffness = self.numbers.positive(3.0);
        let Some(line) = line else { return };
        if !self.is_kept() {
            return;
        }
        if is_spring {
            word = format!(
                "({}[N / m] * ({}.norm() - 0.5[m]))",
                literal(stiffness),
                line.word()
            );
        }
        let (start, end) = (&line.start.word, &line.end.word);
        self.tops[FORCES].push(format!("s{number} = {word}.between({start}, {end})"));
        self.acting.push(Box::new(move |scene, loads| {
            let length = line.length(scene);
            let pull = if is_spring {
                (length - 0.5.into()) * stiffness
            } else {
                size(scene)
            };
            line.pull(scene, loads, pull / length);
        }));
    }

    /// What pulls where it is longer than its length, which may change in time.
    pub fn cable(&mut self, number: usize) {
        let line = self.line();
        let (long, stiff) = (self.numbers.positive(1.5), self.numbers.positive(4.0));
        let (mut word, long) = self.numbers.quantity(long, "m");
        let (stiff_word, k) = self.numbers.quantity(stiff, "N / m");
        let rate = if self.numbers.one_of(3) {
            self.numbers.plain(0.25)
        } else {
            0.0
        };
        let Some(line) = line else { return };
        if !self.is_kept() {
            return;
        }
        if rate != 0.0 {
            word = format!("{word} + {}[m / s] * t", literal(rate));
        }
        let (start, end) = (&line.start.word, &line.end.word);
        self.tops[CABLES].push(format!(
            "k{number} = cable({start}, {end}, {word}, {stiff_word})"
        ));
        let other = line.clone();
        let stretch = move |line: &Line, scene: &Scene<'_>| {
            let square = line.of(scene);
            let length = dot(square, square).sqrt();
            let stretch = length - (long + scene.instant.time * rate);
            // at the edge nothing is differentiable twice
            if stretch.high.abs() < 1e-4 || length.high < 1e-4 {
                scene.is_near.set(true);
            }
            (
                length,
                if stretch > Wide::ZERO {
                    stretch
                } else {
                    Wide::ZERO
                },
            )
        };
        self.pulling.push(Box::new(move |scene, loads| {
            let (length, stretch) = stretch(&line, scene);
            if stretch > Wide::ZERO {
                line.pull(scene, loads, k * stretch / length);
            }
        }));
        self.stored.push(Box::new(move |scene| {
            let (_, stretch) = stretch(&other, scene);
            k * stretch * stretch * 0.5
        }));
    }

    pub fn couple(&mut self, number: usize) {
        let count = self.firsts.len();
        let (first, second) = (
            self.numbers.rng.usize(0..count),
            self.numbers.rng.usize(0..count),
        );
        let names = [first, second].map(|body| self.name(body));
        let (word, moment): (String, Turning) = if self.numbers.one_of(3) && first != second {
            let c = self.numbers.positive(1.0);
            let word = format!(
                "-{}[N * m * s] * ({}.angular_velocity - {}.angular_velocity)",
                literal(c),
                names[1],
                names[0]
            );
            let moment: Turning = Box::new(move |scene, _| {
                let [a, b] = [first, second].map(|body| scene.motions[body].angular_velocity);
                scale(subtract(b, a), (-c).into())
            });
            (word, moment)
        } else if self.is_planar {
            let (word, size) = self.size("N * m");
            (
                word,
                Box::new(move |scene, _| [Wide::ZERO, Wide::ZERO, size(scene)]),
            )
        } else {
            let (word, moment) = self.vector("N * m");
            let own = format!("{}.body(", names[0]);
            (word.replacen("body(", &own, 1), moment)
        };
        if !self.is_kept() {
            return;
        }
        let target = if first == second {
            format!(".on({})", names[1])
        } else {
            format!(".between({}, {})", names[0], names[1])
        };
        self.tops[MOMENTS].push(format!("c{number} = moment({word}){target}"));
        self.acting.push(Box::new(move |scene, loads| {
            let moment = moment(scene, first);
            loads.moment(second, moment);
            if first != second {
                loads.moment(first, scale(moment, -Wide::ONE));
            }
        }));
    }
}
