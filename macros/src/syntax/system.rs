//! A system: bodies, the joints between them, and what drives these.

use proc_macro2::{Delimiter, Ident, TokenStream, TokenTree};
use quote::format_ident;

use crate::errors::{Errors, hint};

use super::entries::{parse_name, parse_value};
use super::expression::{Expression, Kind};
use super::head::parse_head;
use super::parse::{check_length, parse_key, parse_keys};
use super::tokens::{Entry, after_sign, is_punct, split, start, without_attributes};
use super::words::check_name;
use super::{Definition, Description, Motion};

/// A whole description of a system.
pub struct System {
    /// What is said of the system: its name, params, inputs, locals, fields and outputs.
    pub top: Description,
    /// A description each, with the motion that all bodies have.
    pub bodies: Vec<Description>,
    pub joints: Vec<Definition>,
    pub drives: Vec<Definition>,
    /// Forces between points, and moments on bodies and between them.
    pub forces: Vec<Definition>,
    pub moments: Vec<Definition>,
    pub is_planar: bool,
}

/// Lists of a system that a body does not have, or has with other entries, each with one to show.
const LISTS: [(&str, &str); 5] = [
    ("bodies", "arm { mass: 1[kg], inertia: 0.1[kg * m ^ 2] }"),
    ("joints", "elbow = revolute(upper.tip, lower.hinge)"),
    ("drives", "motor = torque.on(elbow)"),
    ("forces", "spring = tension.between(upper.tip, lower.tip)"),
    ("moments", "load = moment(2[N * m]).on(upper)"),
];
/// Keys that stand in bodies alone.
const OF_BODIES: [&str; 6] = [
    "mass",
    "inertia",
    "points",
    "joint_forces",
    "joint_moments",
    "pole",
];
/// Keys that stand in the system alone.
const OF_SYSTEMS: [&str; 5] = ["motion", "params", "inputs", "outputs", "doc"];
/// Keys of the language of systems that are not there yet.
const LATER: [&str; 6] = [
    "constraints",
    "reactions",
    "independent",
    "urdf",
    "drawing",
    "potentials",
];

/// Parses `(runtime) Name { key: value, .. }` of a system.
pub fn parse_system(tokens: TokenStream, errors: &mut Errors) -> Option<System> {
    check_length(&tokens, errors)?;
    let (top, body) = parse_head(tokens, errors)?;
    let mut system = System {
        top,
        bodies: Vec::new(),
        joints: Vec::new(),
        drives: Vec::new(),
        forces: Vec::new(),
        moments: Vec::new(),
        is_planar: false,
    };
    for entry in split(body, Entry::Key, errors) {
        system.parse_key(without_attributes(&entry, errors), errors);
    }
    system.is_planar = system.check_motion(errors);
    let word = if system.is_planar {
        "planar"
    } else {
        "spatial"
    };
    for body in &mut system.bodies {
        body.motion = Some(Motion {
            word: Ident::new(word, body.name.span()),
            support: None,
        });
    }
    system.top.motion = Some(Motion {
        word: Ident::new(word, system.top.name.span()),
        support: None,
    });
    Some(system)
}

impl System {
    fn parse_key(&mut self, entry: &[TokenTree], errors: &mut Errors) {
        let [TokenTree::Ident(key), rest @ ..] = entry else {
            parse_key(&mut self.top, entry, errors);
            return;
        };
        let word = key.to_string();
        if OF_BODIES.contains(&word.as_str()) {
            errors.push(
                key.span(),
                format!("`{word}` belongs to a body: write it in the braces of one, in `bodies`"),
            );
        } else if LATER.contains(&word.as_str()) {
            errors.push(
                key.span(),
                format!("`{word}` is part of the language of systems, but this version does not have it yet"),
            );
        } else if let Some((list, example)) = LISTS.iter().find(|(list, _)| *list == word) {
            if self.top.keys.contains(key) {
                let message =
                    format!("`{word}` is given twice: put everything into one `{word}: [..]`");
                errors.push(key.span(), message);
            } else {
                self.top.keys.push(key.clone());
            }
            self.parse_list(list, example, key, rest, errors);
        } else {
            parse_key(&mut self.top, entry, errors);
        }
    }

    fn parse_list(
        &mut self,
        list: &str,
        example: &str,
        key: &Ident,
        rest: &[TokenTree],
        errors: &mut Errors,
    ) {
        let group = match after_sign(rest, ':') {
            Some((_, [TokenTree::Group(group)])) if group.delimiter() == Delimiter::Bracket => {
                group
            }
            _ => {
                let place = rest.get(1).map_or(key.span(), start);
                let message =
                    format!("`{list}` is a list in brackets: write `{list}: [{example}]`");
                errors.push(place, message);
                return;
            }
        };
        for entry in split(group.stream(), Entry::Defined, errors) {
            let entry = without_attributes(&entry, errors);
            if list == "bodies" {
                self.parse_body(entry, errors);
                continue;
            }
            let Some((name, rest)) = parse_name(&mut self.top, list, entry, errors) else {
                continue;
            };
            let value = parse_value(&name, rest, errors);
            let definition = Definition { name, value };
            match list {
                "joints" => self.joints.push(definition),
                "drives" => self.drives.push(definition),
                "forces" => self.forces.push(definition),
                _ => self.moments.push(definition),
            }
        }
    }

    /// `name { key: value, .. }`
    fn parse_body(&mut self, entry: &[TokenTree], errors: &mut Errors) {
        let (name, group) = match entry {
            [TokenTree::Ident(name), TokenTree::Group(group)]
                if group.delimiter() == Delimiter::Brace =>
            {
                (name, group)
            }
            [TokenTree::Ident(name), ..] => {
                let message = format!(
                    "a body is a name and a description: write `{name} {{ mass: 1[kg], .. }}`"
                );
                errors.push(name.span(), message);
                self.top.lost.push(name.to_string());
                return;
            }
            [first, ..] => {
                errors.push(
                    start(first),
                    "expected the name of a body: `arm { mass: 1[kg], .. }`",
                );
                return;
            }
            [] => return,
        };
        if check_name(name, "the name of a body", errors).is_none() {
            return;
        }
        let mut body = Description::new(name.clone(), self.top.runtime.clone());
        let mut copies = None;
        let mut keys = Vec::new();
        for entry in split(group.stream(), Entry::Key, errors) {
            match entry.as_slice() {
                [TokenTree::Ident(key), rest @ ..] if key == "copies" => {
                    copies = Some(read_copies(&mut body, key, rest, errors));
                }
                [TokenTree::Ident(key), ..] if OF_SYSTEMS.contains(&key.to_string().as_str()) => {
                    let message = if key == "motion" {
                        "the joints of a system say how its bodies move: leave `motion` out"
                            .to_owned()
                    } else {
                        format!("`{key}` belongs to the system: write it beside `bodies`")
                    };
                    errors.push(key.span(), message);
                }
                [TokenTree::Ident(key), ..]
                    if LATER.contains(&key.to_string().as_str()) || key == "pole" =>
                {
                    let message = format!("`{key}` is not there yet in the bodies of a system");
                    errors.push(key.span(), message);
                }
                _ => keys.extend(entry.into_iter().chain([comma()])),
            }
        }
        parse_keys(&mut body, keys.into_iter().collect(), errors);
        match copies {
            None => self.add(body, errors),
            Some(copies) => {
                for copy in copies {
                    self.add(copied(&body, &copy), errors);
                }
            }
        }
    }

    fn add(&mut self, body: Description, errors: &mut Errors) {
        if self.bodies.iter().any(|other| other.name == body.name) {
            let message = format!("there is a body `{}` already", body.name);
            errors.push(body.name.span(), message);
            return;
        }
        self.bodies.push(body);
    }

    /// Whether the system moves in the plane.
    fn check_motion(&self, errors: &mut Errors) -> bool {
        let Some(motion) = &self.top.motion else {
            return false;
        };
        if motion.word == "planar" && motion.support.is_none() {
            return true;
        }
        let written = motion.word.to_string();
        let hint = hint(&written, ["planar"]);
        errors.push(
            motion.word.span(),
            format!("a system moves in the plane, `motion: planar`, or in space: then leave `motion` out{hint}"),
        );
        written.starts_with("planar") || !hint.is_empty()
    }
}

fn comma() -> TokenTree {
    TokenTree::Punct(proc_macro2::Punct::new(',', proc_macro2::Spacing::Alone))
}

/// `copies: [x = direction, ..]`
fn read_copies(
    into: &mut Description,
    key: &Ident,
    rest: &[TokenTree],
    errors: &mut Errors,
) -> Vec<Definition> {
    let Some((_, [TokenTree::Group(group)])) = after_sign(rest, ':') else {
        let message = "`copies` is a list in brackets: write `copies: [x = body(1, 0, 0)]`";
        errors.push(key.span(), message);
        return Vec::new();
    };
    let mut copies = Vec::new();
    for entry in split(group.stream(), Entry::Defined, errors) {
        let entry = without_attributes(&entry, errors);
        if let Some((name, rest)) = parse_name(into, "points", entry, errors) {
            let is_bare = rest.first().is_none_or(|token| !is_punct(token, '='));
            let value = (!is_bare)
                .then(|| parse_value(&name, rest, errors))
                .flatten();
            copies.push(Definition { name, value });
        }
    }
    copies
}

/// `body_name`, with its inertia along the direction of the copy.
fn copied(body: &Description, copy: &Definition) -> Description {
    let mut copied = body.clone();
    copied.name = format_ident!("{}_{}", body.name, copy.name, span = copy.name.span());
    let written = copied
        .inertia
        .as_mut()
        .and_then(|inertia| inertia.value.as_mut());
    if let (Some(inertia), Some(direction)) = (written, &copy.value) {
        let along = Ident::new("along", copy.name.span());
        let solid = Box::new(inertia.clone());
        *inertia = Expression {
            extent: inertia.extent,
            kind: Kind::Method(solid, along, vec![direction.clone()]),
        };
    }
    copied
}
