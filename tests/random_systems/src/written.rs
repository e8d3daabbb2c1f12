//! A system at random as it is written.

use std::fmt::Write as _;

use crate::drawn::{DRIVES, Drawing, Drawn, FIELDS, FORCES, MOMENTS};

impl Drawing {
    /// The text, of bodies and joints in any order.
    pub fn finish(mut self) -> Drawn {
        let mut bodies: Vec<String> = Vec::new();
        for (number, keys) in self.bodies.iter().enumerate() {
            let points = keys.points.iter();
            let points: Vec<String> = points
                .map(|(name, _, word)| format!("{name} = ({word})"))
                .collect();
            let mut text = format!(
                "b{number} {{ mass: {}, inertia: {}",
                keys.mass, keys.inertia
            );
            for (key, list) in [
                ("points", &points),
                ("forces", &keys.forces),
                ("moments", &keys.moments),
            ] {
                if !list.is_empty() {
                    let _ = write!(text, ", {key}: [{}]", list.join(", "));
                }
            }
            bodies.push(text + " }");
        }
        let joints = self.joints.iter().enumerate();
        let mut joints: Vec<String> = joints
            .map(|(number, word)| format!("j{number} = {word}"))
            .collect();
        self.numbers.rng.shuffle(&mut bodies);
        self.numbers.rng.shuffle(&mut joints);
        let body = self.numbers.rng.usize(0..self.links.len());
        let (point, place) = self.point_of(body);
        let declared = &self.numbers.declared;
        let params: Vec<String> = declared
            .params
            .iter()
            .map(|(word, _)| word.clone())
            .collect();
        let mut text = "Drawn {\n".to_owned();
        if self.is_planar {
            text += "    motion: planar,\n";
        }
        let outputs =
            format!("energy, momentum, reactions, balance, mass_matrix, jacobian(b{body}.{point})");
        for (key, list) in [
            ("params", &params),
            ("inputs", &declared.input_words),
            ("bodies", &bodies),
            ("joints", &joints),
            ("forces", &self.tops[FORCES]),
            ("moments", &self.tops[MOMENTS]),
            ("fields", &self.tops[FIELDS]),
            ("drives", &self.tops[DRIVES]),
            ("outputs", &vec![outputs]),
        ] {
            if !list.is_empty() {
                let _ = write!(
                    text,
                    "    {key}: [\n        {},\n    ],\n",
                    list.join(",\n        ")
                );
            }
        }
        text += "}";
        Drawn {
            text,
            is_planar: self.is_planar,
            links: self.links,
            acting: self.acting,
            declared: self.numbers.declared,
            gravity: self.gravity,
            asked: Some((body, place)),
        }
    }
}
