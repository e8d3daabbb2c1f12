//! The content of a file as a written description.

use proc_macro2::{Ident, Span, TokenStream};

use crate::errors::{Errors, Extent};
use crate::syntax::xml::names::{Names, ORIGIN};
use crate::syntax::xml::{Beside, Described};
use crate::syntax::{Composition, Definition, Description};

use super::body::Body;
use super::joint::{Joint, Motion};
use super::length::Length;
use super::place::{tuple, turned};
use crate::syntax::xml::written::{definition, filled, name, written};

/// Writes bodies and joints.
pub struct Writer<'a> {
    pub span: Span,
    pub runtime: &'a TokenStream,
    pub errors: &'a mut Errors,
    pub described: Described,
}

/// A place: a body, by its index among the described ones, or the world; the offset from its
/// origin, in its axes; and the rotation there.
struct Foot {
    body: Option<usize>,
    place: String,
    turned: String,
}

impl Writer<'_> {
    /// A body with its joints; `numbers` are the indices of the described bodies.
    pub fn body(&mut self, body: &Body, parent: Option<usize>, names: &mut Names) -> usize {
        let place = &body.place.place;
        let mut foot = Foot {
            body: parent,
            place: tuple(place),
            turned: turned(&body.place.turns),
        };
        let free = body.joints.iter().find(|joint| joint.kind == Motion::Free);
        let is_pinned = |joint: &Joint| {
            joint.place.iter().any(|part| !part.is_zero()) || joint.kind == Motion::Ball
        };
        let is_turned = !foot.turned.is_empty();
        if free.is_none() && is_turned && body.joints.first().is_some_and(is_pinned) {
            let frame = self.add(name(&format!("{}_frame", body.ident), self.span), None);
            let mount = self.fresh(names, &format!("{}_turned", body.ident));
            self.weld(&foot, frame, &mount, body.extent);
            foot = Foot::origin(frame);
        }
        let (last, before) = match body.joints.split_last() {
            Some((last, before)) => (Some(last), before),
            None => (None, &[][..]),
        };
        for joint in before {
            let after = name(&format!("{}_after_{}", body.ident, joint.ident), self.span);
            let frame = self.add(after, None);
            self.joint(foot, frame, joint);
            foot = Foot::origin(frame);
        }
        let number = self.add(body.ident.clone(), Some(body));
        match (free, last) {
            (Some(free), _) => {
                let text = format!("free({})", body.ident);
                self.define(&free.ident, &text, free.extent);
            }
            (None, Some(joint)) => self.joint(foot, number, joint),
            (None, None) => {
                let carrier = foot
                    .body
                    .map(|body| self.described.bodies[body].name.to_string());
                let carrier = carrier.unwrap_or("ground".to_owned());
                let mount = self.fresh(names, &format!("{}_to_{carrier}", body.ident));
                self.weld(&foot, number, &mount, body.extent);
            }
        }
        number
    }

    /// An unused name.
    fn fresh(&self, names: &mut Names, word: &str) -> Ident {
        names.fresh(word, "mount", self.span)
    }

    /// Adds a body, or a frame.
    fn add(&mut self, ident: Ident, of: Option<&Body>) -> usize {
        let mut body = Description::new(ident, self.runtime.clone());
        match of.filter(|of| !of.parts.is_empty()) {
            Some(of) => {
                body.composition = Some(Composition {
                    word: name("compose", self.span),
                    parts: of.parts.iter().cloned().map(Some).collect(),
                });
            }
            None => body.is_frame = true,
        }
        self.described.bodies.push(body);
        let number = self.described.bodies.len() - 1;
        let extent = of.map_or(Extent::from(self.span), |of| of.extent);
        self.point(number, ORIGIN, "(0, 0, 0)", extent);
        number
    }

    /// A point of a body.
    pub fn point(&mut self, body: usize, word: &str, text: &str, extent: Extent) {
        let point = definition(name(word, self.span), text, extent, self.errors);
        let body = &mut self.described.bodies[body];
        if !body.given.iter().any(|given| given == word) {
            body.given.push(word.to_owned());
            body.points.push(point);
        }
    }

    pub fn define(&mut self, ident: &Ident, text: &str, extent: Extent) {
        let joint = definition(ident.clone(), text, extent, self.errors);
        self.described.joints.push(joint);
    }

    /// How a joint refers to a place: as a point of a body, or as a vector of the world.
    pub fn end(&mut self, body: Option<usize>, word: &str, place: &str, extent: Extent) -> String {
        let Some(number) = body else {
            return format!("world{place}");
        };
        let word = if place == "(0, 0, 0)" { ORIGIN } else { word };
        self.point(number, word, place, extent);
        format!("{}.{word}", self.described.bodies[number].name)
    }

    fn weld(&mut self, foot: &Foot, body: usize, mount: &Ident, extent: Extent) {
        let word = self.described.bodies[body].name.to_string();
        let place = self.end(foot.body, &word, &foot.place, extent);
        let text = format!("weld({place}, {word}.{ORIGIN}){}", foot.turned);
        self.define(mount, &text, extent);
    }

    fn joint(&mut self, foot: Foot, body: usize, joint: &Joint) {
        let (extent, word) = (joint.extent, joint.ident.to_string());
        let pin = tuple(&joint.place);
        let is_pinned = joint.place.iter().any(|part| !part.is_zero());
        // without rotation, both have the same axes, so the offset of the joint can be added
        let place = match (is_pinned, foot.turned.is_empty()) {
            (true, true) => sum(&foot.place, &pin),
            _ => foot.place,
        };
        let place = self.end(foot.body, &word, &place, extent);
        let axis = format!("body{}", tuple(&joint.axis));
        let shift = joint.shift();
        let pin = match (&shift, joint.kind) {
            (Some(shift), Motion::Slide) => {
                let slid = format!("{ORIGIN} + body{pin} - ({shift}) * {axis}.normalize()");
                let slid = self.filled(&slid, joint);
                let body = &mut self.described.bodies[body];
                body.given.push(word.clone());
                body.points.push(slid);
                format!("{}.{word}", body.name)
            }
            _ => self.end(Some(body), &word, &pin, extent),
        };
        let kind = match joint.kind {
            _ if joint.is_held() => format!("weld({place}, {pin})"),
            Motion::Hinge => format!("revolute({place}, {pin}, {axis})"),
            Motion::Slide => format!("prismatic({place}, {pin}, {axis})"),
            Motion::Ball | Motion::Free => format!("spherical({place}, {pin})"),
        };
        let turn = shift.filter(|_| joint.kind == Motion::Hinge);
        let turn = turn.map_or(String::new(), |angle| format!(".turned({axis}, {angle})"));
        let armature = joint.armature.as_ref().filter(|_| !joint.is_held());
        let armature = armature.map_or(String::new(), |value| format!(".armature({value})"));
        let text = format!("{kind}{}{turn}{armature}", foot.turned);
        let written = self.filled(&text, joint);
        self.described.joints.push(written);
        self.loads(joint);
    }

    /// A definition named after a joint, with `_` replaced by the value at which the joint is
    /// locked.
    fn filled(&mut self, text: &str, joint: &Joint) -> Definition {
        let value = written(text, joint.extent, self.span, self.errors);
        let value = match &joint.locked {
            Some(locked) => value.map(|value| filled(value, locked)),
            None => value,
        };
        let name = joint.ident.clone();
        Definition { name, value }
    }

    /// The spring and the damper of a joint.
    fn loads(&mut self, joint: &Joint) {
        if joint.is_held() {
            return;
        }
        let (word, extent) = (&joint.ident, joint.extent);
        let (coordinate, rate) = match joint.kind {
            Motion::Slide => ("position", "velocity"),
            _ => ("angle", "angular_velocity"),
        };
        if let Some(stiffness) = &joint.stiffness {
            let rest = joint.rest.as_deref().unwrap_or("0");
            let text = format!("({stiffness}) / 2 * ({word}.{coordinate} - ({rest})).powi(2)");
            self.potential(&format!("{word}_spring"), &text, extent);
        }
        if let Some(damping) = &joint.damping {
            let name = name(&format!("{word}_damping"), self.span);
            let text = format!("(-({damping}) * {word}.{rate}).on({word})");
            let damper = definition(name, &text, extent, self.errors);
            self.described.drives.push(damper);
        }
    }

    pub fn potential(&mut self, word: &str, text: &str, extent: Extent) {
        let name = name(word, self.span);
        let potential = definition(name, text, extent, self.errors);
        self.described.potentials.push(potential);
    }

    pub fn constraint(&mut self, word: &Ident, text: &str, extent: Extent) {
        let constraint = definition(word.clone(), text, extent, self.errors);
        self.described.constraints.push(constraint);
    }

    /// A force along a length, as drives of the joints of that length.
    pub fn along(&mut self, word: &str, force: &str, length: &Length, extent: Extent) {
        for term in &length.0 {
            let joint = &term.joint;
            let share = match &term.factor {
                Some(factor) => format!("(({factor}) * {force})"),
                None => force.to_owned(),
            };
            let name = name(&format!("{word}_on_{joint}"), self.span);
            let drive = definition(name, &format!("{share}.on({joint})"), extent, self.errors);
            self.described.drives.push(drive);
        }
    }

    /// Gravity, unless the description has a field of this name.
    pub fn gravity(&mut self, text: &str, beside: Beside<'_>, extent: Extent) {
        if beside.fields.iter().any(|field| field.name == "gravity") {
            return;
        }
        let value = format!("mass * world{text}");
        let value = written(&value, extent, self.span, self.errors);
        self.described.fields.push(crate::syntax::Load {
            name: name("gravity", self.span),
            family: crate::families::Family::Field,
            kind: crate::families::LoadKind::Force,
            vector: value,
            point: None,
            charges: None,
        });
    }
}

impl Foot {
    fn origin(body: usize) -> Self {
        Self {
            body: Some(body),
            place: "(0, 0, 0)".to_owned(),
            turned: String::new(),
        }
    }
}

impl Joint {
    /// The offset from the drawn pose to the pose where the coordinate is zero, or has its locked
    /// value.
    fn shift(&self) -> Option<String> {
        match (&self.locked, &self.reference) {
            (Some(_), None) => Some("_".to_owned()),
            (Some(_), Some(reference)) => Some(format!("_ - ({reference})")),
            (None, Some(reference)) => Some(format!("-({reference})")),
            (None, None) => None,
        }
    }
}

/// `(a, b, c) + (d, e, f)`, part by part.
fn sum(a: &str, b: &str) -> String {
    let parts = |text: &str| -> Vec<String> {
        let inner = text.trim_start_matches('(').trim_end_matches(')');
        inner.split(", ").map(str::to_owned).collect()
    };
    let is_zero = |text: &str| text.parse().is_ok_and(|value: f64| value == 0.0);
    let pairs = parts(a).into_iter().zip(parts(b));
    let sums = pairs.map(
        |(a, b)| match (is_zero(&a), is_zero(&b), b.strip_prefix('-')) {
            (_, true, _) => a,
            (true, false, _) => b,
            (_, _, Some(b)) => format!("{a} - {b}"),
            (_, _, None) => format!("{a} + {b}"),
        },
    );
    let sums: Vec<String> = sums.collect();
    format!("({})", sums.join(", "))
}
