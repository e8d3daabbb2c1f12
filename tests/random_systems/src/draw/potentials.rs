//! Random energies, each with the loads that are its slopes, which are derived by hand.

use super::between::Line;
use super::sizes::Scalar;
use super::{Drawing, POTENTIALS};
use crate::law::functions::{bump, wave};
use crate::law::scene::{Loads, Scene};
use crate::law::space::{Vec3, cross, dot, scale, subtract};
use crate::wide::Wide;

/// The coordinate of a joint.
fn along(scene: &Scene<'_>, scalar: &Scalar) -> Wide {
    scene.rates[scalar.joint].0[scalar.place]
}

fn drive(loads: &mut Loads, scalar: &Scalar, load: Wide) {
    let sum = &mut loads.drives[scalar.joint][scalar.place];
    *sum = *sum + load;
}

impl Drawing {
    pub fn potentials(&mut self) {
        for number in 0..self.numbers.rng.usize(0..3) {
            self.cable(number);
        }
        for number in 0..self.numbers.rng.usize(0..4) {
            match self.numbers.rng.usize(0..6) {
                0 => self.coil(number),
                1 => self.coupled(number),
                2 => self.spring(number),
                3 => self.far(number),
                4 => self.magnet(number),
                _ => self.lifted(number),
            }
        }
        for body in 0..self.firsts.len() {
            if self.firsts[body] == body && self.numbers.one_of(8) {
                self.trap(body);
            }
        }
    }

    /// A coordinate that the state has.
    fn coordinate(&mut self, is_angle: bool) -> Option<Scalar> {
        let kind = if is_angle { 0 } else { 2 };
        let mut all = self.scalars();
        all.retain(|one| {
            let link = &self.links[one.joint];
            one.kind == kind && link.driven.is_none() && !link.kind.is_free()
        });
        let chosen = self.numbers.rng.usize(0..all.len().max(1));
        all.get(chosen).cloned()
    }

    /// Of a joint.
    fn coil(&mut self, number: usize) {
        let is_angle = !self.numbers.one_of(3);
        let (rest, k) = (self.numbers.plain(1.0), self.numbers.positive(3.0));
        let units = if is_angle {
            ["rad", "N * m"]
        } else {
            ["m", "N / m"]
        };
        let (rest_word, rest) = self.numbers.quantity(rest, units[0]);
        let (word, k) = self.numbers.changing(k, units[1]);
        let Some(q) = self.coordinate(is_angle) else {
            return;
        };
        if !self.is_kept() {
            return;
        }
        let stretch = format!("({} - {rest_word})", q.name);
        // what else is drawn does not depend on it
        let is_bump = self.numbers.states > 0 && self.numbers.rng.clone().bool();
        self.numbers.declared.calls |= is_bump;
        let text = if is_bump {
            let unit = units[0];
            format!("e{number} = {word} * 1[{unit} ^ 2] * bump({stretch} / 1[{unit}])")
        } else {
            format!("e{number} = {word} * {stretch}.powi(2)")
        };
        self.tops[POTENTIALS].push(text);
        let own = q.clone();
        self.pulling.push(Box::new(move |scene, loads| {
            let stretch = along(scene, &q) - rest;
            let slope = if is_bump {
                bump(1, stretch)
            } else {
                stretch * 2.0
            };
            drive(loads, &q, -(k * slope));
        }));
        self.stored.push(Box::new(move |scene| {
            let stretch = along(scene, &own) - rest;
            k * if is_bump {
                bump(0, stretch)
            } else {
                stretch * stretch
            }
        }));
    }

    /// Of two joints.
    fn coupled(&mut self, number: usize) {
        let k = self.numbers.plain(3.0);
        let (word, k) = self.numbers.changing(k, "N * m");
        let (Some(a), Some(b)) = (self.coordinate(true), self.coordinate(true)) else {
            return;
        };
        if !self.is_kept() {
            return;
        }
        let is_wave = self.numbers.states > 0 && self.numbers.rng.clone().bool();
        self.numbers.declared.calls |= is_wave;
        let text = if is_wave {
            format!("e{number} = {word} * wave({}, {})", a.name, b.name)
        } else {
            format!("e{number} = {word} * {}.sin() * {}", a.name, b.name)
        };
        self.tops[POTENTIALS].push(text);
        let both = [a.clone(), b.clone()];
        let of = move |orders: [u32; 2], x: Wide, y: Wide| {
            let (sine, cosine) = x.sin_cos();
            match orders {
                _ if is_wave => wave(orders, x, y),
                [1, _] => cosine * y,
                [_, 1] => sine,
                _ => sine * y,
            }
        };
        self.pulling.push(Box::new(move |scene, loads| {
            let [x, y] = [&a, &b].map(|one| along(scene, one));
            drive(loads, &a, -(k * of([1, 0], x, y)));
            drive(loads, &b, -(k * of([0, 1], x, y)));
        }));
        self.stored.push(Box::new(move |scene| {
            let [x, y] = both.each_ref().map(|one| along(scene, one));
            k * of([0, 0], x, y)
        }));
    }

    fn between(
        &mut self,
        text: String,
        line: Line,
        energy: impl Fn(Wide) -> [Wide; 2] + Copy + 'static,
    ) {
        self.tops[POTENTIALS].push(text);
        let own = line.clone();
        self.pulling.push(Box::new(move |scene, loads| {
            let length = line.length(scene);
            line.pull(scene, loads, energy(length)[1] / length);
        }));
        self.stored
            .push(Box::new(move |scene| energy(own.length(scene))[0]));
    }

    fn spring(&mut self, number: usize) {
        let k = self.numbers.plain(3.0);
        let (word, k) = self.numbers.changing(k, "N / m");
        let Some(line) = self.line() else { return };
        if self.is_kept() {
            let text = format!("e{number} = {word} * {}.norm_squared()", line.word());
            self.between(text, line, move |length| {
                [k * length * length, k * length * 2.0]
            });
        }
    }

    fn far(&mut self, number: usize) {
        let (k, c) = (self.numbers.plain(3.0), self.numbers.positive(2.0));
        let (word, k) = self.numbers.changing(k, "N * m ^ 2");
        let (core_word, c) = self.numbers.quantity(c, "m");
        let Some(line) = self.line() else { return };
        if self.is_kept() {
            let text = format!(
                "e{number} = {word} / ({core_word} + {}.norm())",
                line.word()
            );
            self.between(text, line, move |length| {
                let energy = k / (c + length);
                [energy, -(energy / (c + length))]
            });
        }
    }

    /// Directions of a body, and of the world or of another one.
    fn magnet(&mut self, number: usize) {
        let count = self.firsts.len();
        let k = self.numbers.plain(3.0);
        let (word, k) = self.numbers.changing(k, "N * m");
        let bodies = [0; 2].map(|_| self.numbers.rng.usize(0..=count));
        let [(first, u), (second, v)] =
            [0; 2].map(|_| self.numbers.components(2.0, "", self.is_planar));
        let bodies = bodies.map(|body| (body < count).then_some(body));
        if bodies[0] == bodies[1] || !self.is_kept() {
            return;
        }
        let [a, b] = [(bodies[0], first), (bodies[1], second)].map(|(body, words)| {
            body.map_or(format!("world({words})"), |body| {
                format!("{}.body({words})", self.name(body))
            })
        });
        self.tops[POTENTIALS].push(format!("e{number} = {word} * {a}.dot({b})"));
        let both = move |scene: &Scene<'_>| -> [Vec3; 2] {
            [scene.turned(bodies[0], u), scene.turned(bodies[1], v)]
        };
        let pairs = bodies;
        self.pulling.push(Box::new(move |scene, loads| {
            let [a, b] = both(scene);
            // as a turns by phi, a . b changes by phi . (a x b)
            let moment = scale(cross(a, b), -k);
            for (body, sign) in pairs.into_iter().zip([Wide::ONE, -Wide::ONE]) {
                if let Some(body) = body {
                    loads.moment(body, scale(moment, sign));
                }
            }
        }));
        self.stored.push(Box::new(move |scene| {
            let [a, b] = both(scene);
            k * dot(a, b)
        }));
    }

    /// Of a coordinate and of a place.
    fn lifted(&mut self, number: usize) {
        let k = self.numbers.plain(3.0);
        let (word, k) = self.numbers.changing(k, "N");
        let body = self.numbers.rng.usize(0..self.firsts.len());
        let (point, at) = self.point_of(body);
        let (up_word, up) = self.numbers.components(2.0, "", self.is_planar);
        let Some(q) = self.coordinate(true) else {
            return;
        };
        if !self.is_kept() {
            return;
        }
        let place = format!("{}.{point}.position()", self.name(body));
        let text = format!(
            "e{number} = {word} * {}.cos() * {place}.dot(world({up_word}))",
            q.name
        );
        self.tops[POTENTIALS].push(text);
        let own = q.clone();
        self.pulling.push(Box::new(move |scene, loads| {
            let (sine, cosine) = along(scene, &q).sin_cos();
            let height = dot(scene.point(Some(body), at), up);
            drive(loads, &q, k * sine * height);
            loads.force(scene, body, at, scale(up, -(k * cosine)));
        }));
        self.stored.push(Box::new(move |scene| {
            let cosine = along(scene, &own).sin_cos().1;
            k * cosine * dot(scene.point(Some(body), at), up)
        }));
    }

    /// In the braces of a body.
    fn trap(&mut self, body: usize) {
        let k = self.numbers.positive(3.0);
        let (word, k) = self.numbers.changing(k, "N / m");
        let (place, at) = self.numbers.components(1.0, "m", self.is_planar);
        let (point, on) = self.point_of(body);
        if !self.is_kept() {
            return;
        }
        let own = if point == "G" {
            "position".to_owned()
        } else {
            format!("{point}.position()")
        };
        let text = format!("trap = {word} * ({own} - world({place})).norm_squared()");
        self.bodies[body].potentials.push(text);
        let all = self.alike_as(body);
        let bodies = all.clone();
        self.pulling.push(Box::new(move |scene, loads| {
            for body in &bodies {
                let apart = subtract(scene.point(Some(*body), on), at);
                loads.force(scene, *body, on, scale(apart, k * -2.0));
            }
        }));
        self.stored.push(Box::new(move |scene| {
            let energies = all.iter().map(|body| {
                let apart = subtract(scene.point(Some(*body), on), at);
                k * dot(apart, apart)
            });
            energies.sum()
        }));
    }
}
