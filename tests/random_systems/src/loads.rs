//! What acts on a system at random.

use crate::drawn::{DRIVES, Drawing, FIELDS, FORCES, MOMENTS};
use crate::number::literal;
use crate::oracle::{Acting, Kind, Scene};
use crate::space::{Vec3, ZERO, apply, dot, scale, subtract, transposed};
use crate::wide::Wide;

/// A number that changes with the state.
pub type Size = Box<dyn Fn(&Scene<'_>) -> Wide>;

/// A vector that does, in world axes.
pub type Turning = Box<dyn Fn(&Scene<'_>) -> Vec3>;

/// A point of a body: how it is written outside of its braces, whose it is, where it is there.
type Anchor = (String, Option<usize>, Vec3);

impl Drawing {
    pub fn all_loads(&mut self) {
        self.fields();
        for body in 0..self.bodies.len() {
            if self.numbers.one_of(2) {
                self.force_on(body);
            }
            if self.numbers.one_of(3) {
                self.moment_on(body);
            }
            if self.numbers.one_of(5) {
                self.drag_on(body);
            }
        }
        for joint in 0..self.links.len() {
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
    }

    fn act(&mut self, is_kept: bool, acting: Acting) {
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
                    for body in 0..scene.links.len() {
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
                    for body in 0..scene.links.len() {
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
                    for body in 0..scene.links.len() {
                        let k = k * scene.links[body].mass;
                        let pull = scale(scene.motions[body].position, -k);
                        loads.force(scene, body, ZERO, pull);
                    }
                }));
            }
        }
    }

    /// Of a unit that is a force or a moment: constant, or by the state, the time, or an input.
    fn size(&mut self, unit: &str) -> (String, Size) {
        let value = self.numbers.plain(4.0);
        let scalars = self.scalars();
        match self.numbers.rng.usize(0..6) {
            0 | 1 if !scalars.is_empty() => {
                let chosen = self.numbers.rng.usize(0..scalars.len());
                let (name, joint, place, kind) = scalars[chosen].clone();
                let unit = [
                    unit.to_owned(),
                    format!("{unit} * s"),
                    format!("{unit} / m"),
                    format!("{unit} * s / m"),
                ];
                let (word, k) = self.numbers.quantity(value, &unit[kind]);
                let size: Size = Box::new(move |scene| {
                    let (q, v) = &scene.rates[joint];
                    k * if kind % 2 == 0 { q[place] } else { v[place] }
                });
                (format!("({word} * {name})"), size)
            }
            2 => {
                let (word, k) = self.numbers.quantity(value, unit);
                let rate = self.numbers.plain(3.0);
                let (rate_word, rate) = self.numbers.quantity(rate, "1 / s");
                let size: Size = Box::new(move |scene| k * (rate * scene.time).sin_cos().1);
                (format!("({word} * ({rate_word} * t).cos())"), size)
            }
            3 => {
                let (word, place) = self.numbers.input(unit);
                let size: Size = Box::new(move |scene| scene.inputs[place]);
                (format!("({word})"), size)
            }
            _ => {
                let (word, k) = self.numbers.quantity(value, unit);
                let size: Size = Box::new(move |_| k);
                (format!("({word})"), size)
            }
        }
    }

    /// Coordinates and rates of joints: the name, the joint, which of them, and whether it is an
    /// angle, its rate, a length, or its rate.
    fn scalars(&self) -> Vec<(String, usize, usize, usize)> {
        let mut all = Vec::new();
        for (joint, link) in self.links.iter().enumerate() {
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
                _ => &[],
            };
            for (place, (q, v, kind)) in pairs.iter().enumerate() {
                all.push((format!("j{joint}.{q}"), joint, place, *kind));
                all.push((format!("j{joint}.{v}"), joint, place, kind + 1));
            }
        }
        all
    }

    /// A vector of some constant and some changing components, in body or world axes: how it is
    /// written, and how it is in world axes.
    fn vector(&mut self, body: usize, unit: &str) -> (String, Turning) {
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
        let vector = move |scene: &Scene<'_>| {
            let mut vector = ZERO;
            for (part, size) in vector.iter_mut().zip(&sizes) {
                *part = size(scene);
            }
            scene.turned(is_of_body.then_some(body), vector)
        };
        (word, Box::new(vector))
    }

    pub fn point_of(&mut self, body: usize) -> (String, Vec3) {
        let points = &self.bodies[body].points;
        let chosen = self.numbers.rng.usize(0..=points.len());
        match points.get(chosen) {
            Some((name, place, _)) => (name.clone(), *place),
            None => ("G".to_owned(), ZERO),
        }
    }

    fn force_on(&mut self, body: usize) {
        let (word, vector) = self.vector(body, "N");
        let (point, place) = self.point_of(body);
        let is_kept = self.is_kept();
        if is_kept {
            let at = if point == "G" {
                String::new()
            } else {
                format!(".at({point})")
            };
            let number = self.bodies[body].forces.len();
            self.bodies[body]
                .forces
                .push(format!("f{number} = {word}{at}"));
        }
        self.act(
            is_kept,
            Box::new(move |scene, loads| loads.force(scene, body, place, vector(scene))),
        );
    }

    fn drag_on(&mut self, body: usize) {
        let c = self.numbers.positive(1.0);
        let (point, place) = self.point_of(body);
        let is_kept = self.is_kept();
        if is_kept {
            let (velocity, at) = if point == "G" {
                ("velocity".to_owned(), String::new())
            } else {
                (format!("{point}.velocity()"), format!(".at({point})"))
            };
            let word = format!(
                "drag_{body} = (-{}[N * s / m] * {velocity}){at}",
                literal(c)
            );
            self.bodies[body].forces.push(word);
        }
        self.act(
            is_kept,
            Box::new(move |scene, loads| {
                let drag = scale(scene.velocity(body, place), (-c).into());
                loads.force(scene, body, place, drag);
            }),
        );
    }

    /// A moment as it is written in the braces of a body, or behind it.
    fn turning(&mut self, body: usize) -> (String, Turning) {
        if self.numbers.one_of(3) {
            let c = self.numbers.positive(1.0);
            let word = format!("-{}[N * m * s] * angular_velocity", literal(c));
            let moment =
                move |scene: &Scene<'_>| scale(scene.motions[body].angular_velocity, (-c).into());
            return (word, Box::new(moment));
        }
        if self.is_planar {
            let (word, size) = self.size("N * m");
            let moment = move |scene: &Scene<'_>| [Wide::ZERO, Wide::ZERO, size(scene)];
            return (word, Box::new(moment));
        }
        self.vector(body, "N * m")
    }

    fn moment_on(&mut self, body: usize) {
        let (word, moment) = self.turning(body);
        let is_kept = self.is_kept();
        if is_kept {
            self.bodies[body].moments.push(format!("m = {word}"));
        }
        self.act(
            is_kept,
            Box::new(move |scene, loads| loads.moment(body, moment(scene))),
        );
    }

    fn drive(&mut self, joint: usize) {
        let coordinates: &[(&str, &str)] = match self.links[joint].kind {
            _ if self.links[joint].driven.is_some() => return,
            Kind::Revolute(_) | Kind::Screw(..) => &[("", "N * m")],
            Kind::Prismatic(_) => &[("", "N")],
            Kind::Cylindrical(_) => &[(".position", "N"), (".angle", "N * m")],
            Kind::Universal(..) => &[(".angle_1", "N * m"), (".angle_2", "N * m")],
            Kind::Spherical => {
                let (word, moment) = self.vector(joint, "N * m");
                // the body is not meant by itself outside of its braces
                let word = word.replacen("body(", &format!("b{joint}.body("), 1);
                let is_kept = self.is_kept();
                if is_kept {
                    self.tops[DRIVES].push(format!("d{joint} = {word}.on(j{joint})"));
                }
                self.act(
                    is_kept,
                    Box::new(move |scene, loads| {
                        let back = transposed(&scene.motions[joint].attitude);
                        let along = apply(&back, moment(scene));
                        for (drive, part) in loads.drives[joint].iter_mut().zip(along) {
                            *drive = *drive + part;
                        }
                    }),
                );
                return;
            }
            _ => return,
        };
        for (freedom, (word, unit)) in coordinates.iter().enumerate() {
            if coordinates.len() > 1 && self.numbers.one_of(3) {
                continue;
            }
            let (written, size) = self.size(unit);
            let is_kept = self.is_kept();
            if is_kept {
                self.tops[DRIVES]
                    .push(format!("d{joint}_{freedom} = {written}.on(j{joint}{word})"));
            }
            self.act(
                is_kept,
                Box::new(move |scene, loads| {
                    let drive = &mut loads.drives[joint][freedom];
                    *drive = *drive + size(scene);
                }),
            );
        }
    }

    fn anchor(&mut self) -> Anchor {
        let body = self.numbers.rng.usize(0..=self.links.len());
        if body == self.links.len() {
            let (word, place) = self.numbers.components(3.0, "m", self.is_planar);
            return (format!("world({word})"), None, place);
        }
        let (point, place) = self.point_of(body);
        (format!("b{body}.{point}"), Some(body), place)
    }

    /// A constant, changing tension, or a spring, between points that are never at one place.
    fn tension(&mut self, number: usize) {
        let (start, end) = (self.anchor(), self.anchor());
        if start.1 == end.1 {
            return;
        }
        let is_spring = self.numbers.one_of(2) && start.1.is_some() && end.1.is_some();
        let (mut word, size_of) = self.size("N");
        let stiffness = is_spring.then(|| self.numbers.positive(3.0));
        if let Some(k) = stiffness {
            let line = format!("({}.position() - {}.position()).norm()", end.0, start.0);
            word = format!("({}[N / m] * ({line} - 0.5[m]))", literal(k));
        }
        // points that a joint holds together have no line between them
        let places = [&start, &end].map(|(_, body, place)| body.map(|body| (body, *place)));
        let is_held = self.links.iter().enumerate().any(|(body, link)| {
            let near = [
                Some((body, link.pin)),
                link.carrier.map(|carrier| (carrier, link.place)),
            ];
            places.iter().all(|place| near.contains(place))
                || (link.carrier.is_none() && places.contains(&near[0]))
        });
        if is_held || !self.is_kept() {
            return;
        }
        self.tops[FORCES].push(format!(
            "s{number} = {word}.between({}, {})",
            start.0, end.0
        ));
        self.acting.push(Box::new(move |scene, loads| {
            let line = subtract(scene.point(end.1, end.2), scene.point(start.1, start.2));
            let length = dot(line, line).sqrt();
            let pull = match stiffness {
                Some(k) => (length - 0.5.into()) * k,
                None => size_of(scene),
            };
            // too near for a direction
            if length.high < 1e-2 {
                scene.is_near.set(true);
                return;
            }
            let pull = scale(line, pull / length);
            for ((_, body, place), sign) in [(&start, 1.0), (&end, -1.0)] {
                if let Some(body) = body {
                    loads.force(scene, *body, *place, scale(pull, sign.into()));
                }
            }
        }));
    }

    fn couple(&mut self, number: usize) {
        let count = self.links.len();
        let (first, second) = (
            self.numbers.rng.usize(0..count),
            self.numbers.rng.usize(0..count),
        );
        let (word, moment) = if self.numbers.one_of(3) && first != second {
            let c = self.numbers.positive(1.0);
            let word = format!(
                "-{}[N * m * s] * (b{second}.angular_velocity - b{first}.angular_velocity)",
                literal(c)
            );
            let moment: Turning = Box::new(move |scene| {
                let [a, b] = [first, second].map(|body| scene.motions[body].angular_velocity);
                scale(subtract(b, a), (-c).into())
            });
            (word, moment)
        } else if self.is_planar {
            let (word, size) = self.size("N * m");
            let moment: Turning = Box::new(move |scene| [Wide::ZERO, Wide::ZERO, size(scene)]);
            (word, moment)
        } else {
            let (word, moment) = self.vector(first, "N * m");
            (
                word.replacen("body(", &format!("b{first}.body("), 1),
                moment,
            )
        };
        if !self.is_kept() {
            return;
        }
        let target = if first == second {
            format!(".on(b{second})")
        } else {
            format!(".between(b{first}, b{second})")
        };
        self.tops[MOMENTS].push(format!("c{number} = moment({word}){target}"));
        self.acting.push(Box::new(move |scene, loads| {
            let moment = moment(scene);
            loads.moment(second, moment);
            if first != second {
                loads.moment(first, scale(moment, -Wide::ONE));
            }
        }));
    }
}
