//! A system: bodies, the joints between them, and what drives these.

use proc_macro2::{Delimiter, Ident, TokenStream, TokenTree};
use quote::format_ident;

use crate::errors::{Errors, hint, similar};

use super::entries::{parse_name, parse_value};
use super::expression::{Expression, Kind};
use super::head::parse_head;
use super::parse::{check_length, key_meant, key_value, parse_key, parse_keys};
use super::tokens::{Entry, is_punct, split, start, stream, without_attributes};
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
    /// For each body, the first one that is written in the same braces.
    pub firsts: Vec<usize>,
    /// The keys in the braces of bodies.
    pub keys: Vec<Ident>,
    /// Something that may have named bodies, or joints, could not be read.
    pub has_lost_bodies: bool,
    pub has_lost_joints: bool,
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
const OF_SYSTEMS: [&str; 8] = [
    "motion", "params", "inputs", "outputs", "doc", "bodies", "joints", "drives",
];
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
        firsts: Vec::new(),
        keys: Vec::new(),
        has_lost_bodies: false,
        has_lost_joints: false,
    };
    for entry in split(body, Entry::Key, errors) {
        system.parse_key(without_attributes(&entry, errors), errors);
    }
    system.is_planar = system.check_motion(errors);
    system.lose_names();
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
        } else if let Some((list, example)) = list_meant(&word) {
            let is_given = self.top.keys.iter().any(|other| {
                list_meant(&other.to_string()).is_some_and(|(other, _)| other == list)
            });
            if is_given {
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
        let message = format!("`{list}` is a list in brackets: write `{list}: [{example}]`");
        let group = match key_value(key, rest, errors) {
            [TokenTree::Group(group)] => group,
            value => {
                if let Some(first) = value.first() {
                    errors.push(start(first), message);
                }
                self.has_lost_bodies |= list == "bodies";
                self.has_lost_joints |= list == "joints";
                return;
            }
        };
        if group.delimiter() != Delimiter::Bracket {
            errors.push(group.span_open(), message);
        }
        for entry in split(group.stream(), Entry::Defined, errors) {
            let entry = without_attributes(&entry, errors);
            if list == "bodies" {
                self.parse_body(entry, errors);
                continue;
            }
            let Some((name, rest)) = parse_name(&mut self.top, list, entry, errors) else {
                self.has_lost_joints |= list == "joints";
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
            [TokenTree::Ident(name), TokenTree::Group(group)] => {
                let message =
                    format!("a body is described in braces: write `{name} {{ mass: 1[kg], .. }}`");
                errors.push(group.span_open(), message);
                (name, group)
            }
            [
                TokenTree::Ident(name),
                TokenTree::Punct(sign),
                TokenTree::Group(group),
            ] => {
                let message = format!(
                    "nothing stands between the name of a body and its braces: write `{name} {{ .. }}`"
                );
                errors.push(sign.span(), message);
                (name, group)
            }
            [TokenTree::Ident(_), TokenTree::Group(_), next, ..] => {
                let first = start(next);
                let message = match next {
                    TokenTree::Ident(name) => format!("expected a comma before `{name}`"),
                    _ => "expected a comma before this".to_owned(),
                };
                errors.push(first, message);
                self.parse_body(&entry[..2], errors);
                self.parse_body(&entry[2..], errors);
                return;
            }
            [TokenTree::Ident(name), ..] => {
                let message = format!(
                    "a body is a name and a description: write `{name} {{ mass: 1[kg], .. }}`"
                );
                errors.push(name.span(), message);
                self.has_lost_bodies = true;
                return;
            }
            [first, ..] => {
                errors.push(
                    start(first),
                    "expected the name of a body: `arm { mass: 1[kg], .. }`",
                );
                self.has_lost_bodies = true;
                return;
            }
            [] => return,
        };
        if check_name(name, "the name of a body", errors).is_none() {
            self.has_lost_bodies = true;
            return;
        }
        let mut body = Description::new(name.clone(), self.top.runtime.clone());
        let mut copies: Option<Vec<Definition>> = None;
        let mut keys = Vec::new();
        for entry in split(group.stream(), Entry::Key, errors) {
            match entry.as_slice() {
                [TokenTree::Ident(key), rest @ ..] if is_copies(&key.to_string()) => {
                    if key != "copies" {
                        errors.push(
                            key.span(),
                            format!("there is no key `{key}`; did you mean `copies`?"),
                        );
                    } else if copies.is_some() {
                        let message =
                            "`copies` is given twice: put everything into one `copies: [..]`";
                        errors.push(key.span(), message);
                        self.has_lost_bodies = true;
                    }
                    let read = read_copies(&mut body, key, rest, errors);
                    self.has_lost_bodies |= read.is_none();
                    copies
                        .get_or_insert_default()
                        .extend(read.unwrap_or_default());
                }
                [TokenTree::Ident(key), ..] if OF_SYSTEMS.contains(&key.to_string().as_str()) => {
                    let message = if key == "motion" {
                        "the joints of a system say how its bodies move: leave `motion` out"
                            .to_owned()
                    } else {
                        format!(
                            "`{key}` belongs to the system: write it outside of the braces of its bodies"
                        )
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
        self.keys.extend(body.keys.iter().cloned());
        let first = self.bodies.len();
        match copies {
            None => self.add(body, first, errors),
            Some(copies) => {
                for copy in copies {
                    self.add(copied(&body, &copy), first, errors);
                }
            }
        }
    }

    fn add(&mut self, body: Description, first: usize, errors: &mut Errors) {
        if self.bodies.iter().any(|other| other.name == body.name) {
            let message = format!("there is a body `{}` already", body.name);
            errors.push(body.name.span(), message);
            self.has_lost_bodies = true;
            return;
        }
        self.firsts.push(first);
        self.bodies.push(body);
    }

    /// What is written beside the bodies.
    fn written(&self) -> impl Iterator<Item = &Expression> {
        let loads = self.drives.iter().chain(&self.forces).chain(&self.moments);
        let definitions = self.joints.iter().chain(loads).chain(&self.top.locals);
        definitions.filter_map(|definition| definition.value.as_ref())
    }

    /// Where something that names bodies or joints could not be read, any unknown name may be one.
    fn lose_names(&mut self) {
        if !self.has_lost_bodies && !self.has_lost_joints {
            return;
        }
        let bodies = self.bodies.iter().flat_map(|body| {
            let loads = body.loads.iter().filter_map(|load| load.vector.as_ref());
            loads.chain(body.locals.iter().filter_map(|local| local.value.as_ref()))
        });
        let names = self.written().chain(bodies).flat_map(Expression::names);
        let top = &self.top;
        let declared = top.params.iter().chain(&top.inputs).map(|one| &one.name);
        let members = self.bodies.iter().map(|body| &body.name);
        let defined = top.locals.iter().chain(&self.joints).map(|one| &one.name);
        let known: Vec<&Ident> = declared.chain(members).chain(defined).collect();
        let lost: Vec<String> = names
            .filter(|name| !known.contains(name))
            .map(ToString::to_string)
            .collect();
        for body in &mut self.bodies {
            let own = body
                .points
                .iter()
                .chain(&body.locals)
                .map(|one| one.name.to_string());
            let own: Vec<String> = own.collect();
            body.lost
                .extend(lost.iter().filter(|name| !own.contains(name)).cloned());
        }
        self.top.lost.extend(lost);
    }

    /// Whether the first vector that is written has two components.
    fn looks_planar(&self) -> bool {
        let points = self.bodies.iter().flat_map(|body| &body.points);
        let points = points.filter_map(|point| point.value.as_ref());
        let mut sizes = Vec::new();
        for expression in self.written().chain(points) {
            expression.visit(|part| match &part.kind {
                Kind::Tuple(parts) => sizes.push(parts.len()),
                Kind::Call(word, parts) if word == "world" || word == "body" => {
                    sizes.push(parts.len())
                }
                _ => {}
            });
        }
        sizes.first() == Some(&2)
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
        written != "spatial" && (!hint.is_empty() || self.looks_planar())
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
) -> Option<Vec<Definition>> {
    let message = "`copies` is a list in brackets: write `copies: [x = body(1, 0, 0)]`";
    let value = key_value(key, rest, errors);
    let [TokenTree::Group(group)] = value else {
        if !value.is_empty() {
            errors.push(crate::errors::Extent::of(stream(value)), message);
        }
        return None;
    };
    if group.delimiter() != Delimiter::Bracket {
        errors.push(group.span_open(), message);
    }
    if group.stream().is_empty() {
        errors.push(
            group.span_open(),
            "this makes no body: write a copy, `copies: [x = body(1, 0, 0)]`, or leave `copies` out",
        );
        return None;
    }
    let mut copies = Vec::new();
    let mut is_sound = true;
    for entry in split(group.stream(), Entry::Defined, errors) {
        let entry = without_attributes(&entry, errors);
        if let Some((name, rest)) = parse_name(into, "points", entry, errors) {
            let is_bare = rest.first().is_none_or(|token| !is_punct(token, '='));
            let value = (!is_bare)
                .then(|| parse_value(&name, rest, errors))
                .flatten();
            copies.push(Definition { name, value });
        } else {
            is_sound = false;
        }
    }
    is_sound.then_some(copies)
}

fn is_copies(word: &str) -> bool {
    word == "copies"
        || word != "bodies" && similar(word, ["copies"]).is_some() && key_meant(word).is_none()
}

/// The list of a system that a key, perhaps misspelt, is meant to be.
fn list_meant(word: &str) -> Option<&'static (&'static str, &'static str)> {
    let exact = LISTS.iter().find(|(list, _)| *list == word);
    let of_body = key_meant(word).is_some_and(|meant| meant == word);
    let lists = LISTS.iter().map(|(list, _)| *list);
    let meant = || similar(word, lists).filter(|_| !of_body);
    exact.or_else(|| {
        let meant = meant()?;
        LISTS.iter().find(|(list, _)| *list == meant)
    })
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
