//! A random system, as it is written.

use std::fmt::Write as _;

use crate::law::functions::DECLARED;

use super::{CABLES, DRIVES, Drawing, Drawn, FIELDS, FORCES, Keys, MOMENTS, POTENTIALS};

impl Drawing {
    /// The text, of bodies and joints in any order; what closes a loop follows what carries.
    pub fn finish(mut self) -> Drawn {
        let mut bodies: Vec<String> = Vec::new();
        for (number, keys) in self.bodies.iter().enumerate() {
            if self.firsts[number] == number {
                bodies.push(braces(number, keys));
            }
        }
        let joints = self.joints.iter().enumerate();
        let mut joints: Vec<String> = joints
            .map(|(number, word)| format!("j{number} = {word}"))
            .collect();
        let closing = joints.split_off(self.firsts.len());
        self.numbers.rng.shuffle(&mut bodies);
        self.numbers.rng.shuffle(&mut joints);
        for (word, ring) in closing.into_iter().zip(&self.rings) {
            let carries = format!("j{} ", ring.body);
            let after = joints.iter().position(|joint| joint.starts_with(&carries));
            let after = after.map_or(joints.len(), |place| place + 1);
            let place = self.numbers.rng.usize(after..=joints.len());
            joints.insert(place, word);
        }
        for cable in std::mem::take(&mut self.tops[CABLES]) {
            let place = self.numbers.rng.usize(0..=joints.len());
            joints.insert(place, cable);
        }
        let body = self.numbers.rng.usize(0..self.firsts.len());
        let (point, place) = self.point_of(body);
        let mut outputs = vec!["energy", "momentum", "reactions", "balance"];
        if self.rings.is_empty() {
            outputs.push("mass_matrix");
        }
        let jacobian = format!("jacobian({}.{point})", self.name(body));
        outputs.push(&jacobian);
        if self.numbers.one_of(4) && self.extent.linearized {
            outputs.push("linearization");
            if !self.numbers.declared.params.is_empty() {
                outputs.push("sensitivity");
            }
        }
        // the parameters are constant, and states may change masses
        if self.numbers.one_of(3) && self.numbers.declared.states.is_empty() {
            outputs.push("regressor");
        }
        let text = self.text(&bodies, &joints, &outputs, false);
        let opened = (!self.open.is_empty()).then(|| {
            let outputs = [&outputs[..], &["inverse"]].concat();
            self.text(&bodies, &joints, &outputs, true)
        });
        Drawn {
            text,
            opened,
            names: (0..self.firsts.len()).map(|body| self.name(body)).collect(),
            is_planar: self.is_planar,
            links: self.links,
            rings: self.rings,
            start: self.start,
            acting: self.acting,
            pulling: self.pulling,
            stored: self.stored,
            falling: self.falling,
            declared: self.numbers.declared,
            follows: self.following > 0,
            rates: self.rates.into_iter().map(|(_, rate)| rate).collect(),
            open: self.open,
            gravity: self.gravity,
            falls: self.falls,
            asked: Some((body, place)),
        }
    }

    fn text(
        &self,
        bodies: &[String],
        joints: &[String],
        outputs: &[&str],
        is_opened: bool,
    ) -> String {
        let declared = &self.numbers.declared;
        let params = declared.params.iter().map(|(word, _)| word.clone());
        let params: Vec<String> = params.collect();
        let states = declared.states.iter();
        let states: Vec<String> = states
            .map(|(name, unit, _)| format!("{name}[{unit}]"))
            .collect();
        let rates: Vec<String> = self.rates.iter().map(|(word, _)| word.clone()).collect();
        let functions = [DECLARED.to_owned()];
        let functions = &functions[..usize::from(declared.calls)];
        let mut drives = self.tops[DRIVES].clone();
        let mut inputs = declared.input_words.clone();
        if is_opened {
            // the inputs that stand for them are the last ones
            inputs.truncate(inputs.len() - self.open.len());
            for drive in drives.iter_mut().filter(|drive| drive.starts_with('o')) {
                let parts = drive.split_once(" = ").zip(drive.split_once(".on("));
                let ((name, _), (_, joint)) = parts.expect("a drive of a joint");
                *drive = format!("{name} = _.on({joint}");
            }
        }
        let mut text = "Drawn {\n".to_owned();
        if self.is_planar {
            text += "    motion: planar,\n";
        }
        for (key, list) in [
            ("params", &params[..]),
            ("functions", functions),
            ("inputs", &inputs),
            ("states", &states),
            ("rates", &rates),
            ("bodies", bodies),
            ("joints", joints),
            ("locals", &declared.locals),
            ("forces", &self.tops[FORCES]),
            ("moments", &self.tops[MOMENTS]),
            ("fields", &self.tops[FIELDS]),
            ("potentials", &self.tops[POTENTIALS]),
            ("drives", &drives),
            ("outputs", &[outputs.join(", ")]),
        ] {
            if !list.is_empty() {
                let list = list.join(",\n        ");
                let _ = write!(text, "    {key}: [\n        {list},\n    ],\n");
            }
        }
        text + "}"
    }
}

/// A body, or those that are alike, with what stands in its braces.
fn braces(number: usize, keys: &Keys) -> String {
    let points = keys.points.iter();
    let points: Vec<String> = points
        .map(|(name, _, word)| format!("{name} = ({word})"))
        .collect();
    let mut text = if keys.copies.is_empty() {
        format!("b{number} {{ ")
    } else {
        format!("g{number} {{ copies: [{}], ", keys.copies.join(", "))
    };
    let _ = write!(text, "mass: {}, inertia: {}", keys.mass, keys.inertia);
    for (key, list) in [
        ("points", &points),
        ("locals", &keys.locals),
        ("fields", &keys.fields),
        ("potentials", &keys.potentials),
        ("forces", &keys.forces),
        ("moments", &keys.moments),
    ] {
        if !list.is_empty() {
            let _ = write!(text, ", {key}: [{}]", list.join(", "));
        }
    }
    text + " }"
}
