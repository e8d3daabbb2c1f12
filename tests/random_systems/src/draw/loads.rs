//! Random loads on the bodies of a system.

use super::number::literal;
use super::sizes::Turning;
use super::{Drawing, FIELDS};
use crate::law::scene::{Acting, Scene};
use crate::law::space::{Vec3, ZERO, dot, scale};
use crate::wide::Wide;

impl Drawing {
    pub fn all_loads(&mut self) {
        self.fields();
        let bodies = self.firsts.len();
        for body in 0..bodies {
            // what is written of one is so of those that are alike
            if self.firsts[body] != body {
                continue;
            }
            if self.numbers.one_of(2) {
                self.force_on(body);
            }
            if self.numbers.one_of(3) {
                self.moment_on(body);
            }
            if self.numbers.one_of(5) {
                self.drag_on(body);
            }
            if self.numbers.one_of(8) {
                self.field_on(body);
            }
            if self.extent.following && self.numbers.one_of(2) {
                self.added_to(body);
            }
        }
        for joint in 0..bodies {
            if self.is_open {
                self.open_drives(joint);
            }
            if self.numbers.one_of(2) {
                self.drive(joint);
            }
        }
        for number in 0..self.numbers.rng.usize(0..3) {
            self.tension(number);
        }
        for number in 0..self.numbers.rng.usize(0..3) {
            self.couple(number);
        }
        self.potentials();
        self.own_rates();
        self.open_inputs();
    }

    pub fn act(&mut self, is_kept: bool, acting: Acting) {
        if is_kept {
            self.acting.push(acting);
        }
    }

    fn fields(&mut self) {
        if !self.numbers.one_of(4) {
            let (word, fall) = self.numbers.components(10.0, "m / s ^ 2", self.is_planar);
            if self.is_kept() {
                self.tops[FIELDS].push(format!("weight = mass * world({word})"));
                self.gravity = Some(fall);
                self.acting.push(Box::new(move |scene, loads| {
                    for body in 0..scene.bodies {
                        let weight = scale(fall, scene.links[body].mass);
                        loads.force(scene, body, ZERO, weight);
                    }
                }));
            }
        }
        if self.numbers.one_of(4) {
            let value = self.numbers.positive(1.0);
            let (word, c) = self.numbers.quantity(value, "N * s / m");
            if self.is_kept() {
                self.gravity = None;
                self.tops[FIELDS].push(format!("drag = -{word} * velocity"));
                self.acting.push(Box::new(move |scene, loads| {
                    for body in 0..scene.bodies {
                        let drag = scale(scene.motions[body].velocity, -c);
                        loads.force(scene, body, ZERO, drag);
                    }
                }));
            }
        }
        if self.numbers.one_of(6) {
            let value = self.numbers.positive(3.0);
            let (word, k) = self.numbers.quantity(value, "1 / s ^ 2");
            if self.is_kept() {
                self.gravity = None;
                self.tops[FIELDS].push(format!("pull = -mass * {word} * position"));
                self.acting.push(Box::new(move |scene, loads| {
                    for body in 0..scene.bodies {
                        let k = k * scene.links[body].mass;
                        let pull = scale(scene.motions[body].position, -k);
                        loads.force(scene, body, ZERO, pull);
                    }
                }));
            }
        }
    }

    /// A field of one body, of which there is an energy.
    fn field_on(&mut self, body: usize) {
        let (word, fall) = self.numbers.components(5.0, "m / s ^ 2", self.is_planar);
        if !self.is_kept() {
            return;
        }
        self.bodies[body]
            .fields
            .push(format!("own = mass * world({word})"));
        let all = self.alike_as(body);
        let bodies = all.clone();
        self.falls.extend(all.iter().map(|body| (*body, fall)));
        self.acting.push(Box::new(move |scene, loads| {
            for body in &bodies {
                let weight = scale(fall, scene.links[*body].mass);
                loads.force(scene, *body, ZERO, weight);
            }
        }));
        self.falling.push(Box::new(move |scene| {
            let energies = all
                .iter()
                .map(|body| -(dot(fall, scene.motions[*body].position) * scene.links[*body].mass));
            energies.sum()
        }));
    }

    pub fn point_of(&mut self, body: usize) -> (String, Vec3) {
        let points = &self.bodies[self.firsts[body]].points;
        let chosen = self.numbers.rng.usize(0..=points.len());
        match points.get(chosen) {
            Some((name, place, _)) => (name.clone(), *place),
            None => ("G".to_owned(), ZERO),
        }
    }

    fn force_on(&mut self, body: usize) {
        let (word, vector) = self.vector("N");
        let (point, place) = self.point_of(body);
        let is_kept = self.is_kept();
        if is_kept {
            let at = if point == "G" {
                String::new()
            } else {
                format!(".at({point})")
            };
            let forces = &mut self.bodies[body].forces;
            forces.push(format!("f{} = {word}{at}", forces.len()));
        }
        let all = self.alike_as(body);
        self.act(
            is_kept,
            Box::new(move |scene, loads| {
                for body in &all {
                    loads.force(scene, *body, place, vector(scene, *body));
                }
            }),
        );
    }

    fn drag_on(&mut self, body: usize) {
        let c = self.numbers.positive(1.0);
        let (point, place) = self.point_of(body);
        let is_named = self.numbers.one_of(3) && self.extent.locals;
        let is_kept = self.is_kept();
        if is_kept {
            let (mut velocity, at) = if point == "G" {
                ("velocity".to_owned(), String::new())
            } else {
                (format!("{point}.velocity()"), format!(".at({point})"))
            };
            if is_named {
                let local = format!("swift = {velocity}");
                self.bodies[body].locals.push(local);
                "swift".clone_into(&mut velocity);
            }
            let word = format!(
                "drag_{body} = (-{}[N * s / m] * {velocity}){at}",
                literal(c)
            );
            self.bodies[body].forces.push(word);
        }
        let all = self.alike_as(body);
        self.act(
            is_kept,
            Box::new(move |scene, loads| {
                for body in &all {
                    let drag = scale(scene.velocity(*body, place), (-c).into());
                    loads.force(scene, *body, place, drag);
                }
            }),
        );
    }

    /// A moment as it is written in the braces of a body.
    fn turning(&mut self) -> (String, Turning) {
        if self.numbers.one_of(3) {
            let c = self.numbers.positive(1.0);
            let word = format!("-{}[N * m * s] * angular_velocity", literal(c));
            let moment = move |scene: &Scene<'_>, body: usize| {
                scale(scene.motions[body].angular_velocity, (-c).into())
            };
            return (word, Box::new(moment));
        }
        if self.is_planar {
            let (word, size) = self.size("N * m");
            let moment = move |scene: &Scene<'_>, _: usize| [Wide::ZERO, Wide::ZERO, size(scene)];
            return (word, Box::new(moment));
        }
        self.vector("N * m")
    }

    fn moment_on(&mut self, body: usize) {
        let (word, moment) = self.turning();
        let is_kept = self.is_kept();
        if is_kept {
            self.bodies[body].moments.push(format!("m = {word}"));
        }
        let all = self.alike_as(body);
        self.act(
            is_kept,
            Box::new(move |scene, loads| {
                for body in &all {
                    loads.moment(*body, moment(scene, *body));
                }
            }),
        );
    }
}
