//! A system: bodies, the joints between them, and their drives.

mod body;
mod definitions;
mod drawing;
mod file;
mod frames;
mod lost;
mod misplaced;
mod motion;
mod outputs;

pub use drawing::Center;

use proc_macro2::{Delimiter, Group, Ident, TokenStream, TokenTree};

use crate::errors::{Errors, foreign_list_meant, similar};

pub use file::{File, file_beside};
pub use lost::Lost;
pub use misplaced::parse_lone_body;

use super::entries::{
    bracketed_entry, check_length, holds_keys, key_meant, key_value, parse_key, report_unknown,
};
use super::expression::Expression;
use super::head::parse_head;
use super::tokens::{Entry, is_punct, split, start, without_attributes};
use super::{Definition, Description};

/// A whole description of a system.
pub struct System {
    /// The keys of the whole system: its name, params, inputs, locals, fields and outputs.
    pub top: Description,
    /// One description per body; each contains the motion, which all bodies share.
    pub bodies: Vec<Description>,
    pub joints: Vec<Definition>,
    /// Entries of `joints` that are cables and carry nothing.
    pub cables: Vec<Definition>,
    pub drives: Vec<Definition>,
    /// Forces between points, and moments on bodies and between them.
    pub forces: Vec<Definition>,
    pub moments: Vec<Definition>,
    pub is_planar: bool,
    /// The place of each body, if bodies and joints are drawn in one frame.
    pub centers: Option<Vec<Center>>,
    /// The joints in the parentheses of `reactions(..)`, if any.
    pub held: Option<Vec<Ident>>,
    /// The points in the parentheses of `jacobian(..)`.
    pub points: Vec<Expression>,
    /// For each body, the index of the first body in the same braces.
    pub firsts: Vec<usize>,
    /// The file that bodies and joints come from.
    pub file: Option<File>,
    /// Joints of the file that are locked at a value of their coordinate.
    pub locked: Vec<Definition>,
    pub lost: Lost,
    /// Whether any word means the acceleration of a body, a joint or a point.
    pub mentions_accelerations: bool,
    /// What is wrong where it stands, which is reported: keys of bodies beside these, keys of the
    /// system in them, a motion that no system has.
    misplaced: Description,
    /// The key that makes this a single body, described as a system.
    lone: Option<Ident>,
}

/// A cable is written among the joints but is not one: it only pulls.
pub const CABLE: &str = "cable";
/// A link is written among the joints but is a constraint: it keeps a distance.
pub const LINK: &str = "link";

/// Lists of a system that a body does not have, or whose entries differ from those of a body, each
/// with an example.
const LISTS: [(&str, &str); 6] = [
    ("bodies", "arm { mass: 1[kg], inertia: 0.1[kg * m ^ 2] }"),
    ("joints", "elbow = revolute(upper.tip, lower.hinge)"),
    ("locked", "finger = 0.02[m]"),
    ("drives", "motor = torque.on(elbow)"),
    ("forces", "spring = tension.between(upper.tip, lower.tip)"),
    ("moments", "load = moment(2[N * m]).on(upper)"),
];
/// Keys that only bodies have.
pub const OF_BODIES: [&str; 6] = [
    "mass",
    "inertia",
    "points",
    "joint_forces",
    "joint_moments",
    "pole",
];
/// Keys that only systems have.
const OF_SYSTEMS: [&str; 17] = [
    "motion",
    "constants",
    "functions",
    "params",
    "inputs",
    "states",
    "rates",
    "outputs",
    "doc",
    "bodies",
    "joints",
    "drives",
    "drawing",
    "urdf",
    "mjcf",
    "locked",
    "checks",
];

/// Parses `(runtime) Name { key: value, .. }` of a system.
pub fn parse_system(tokens: TokenStream, errors: &mut Errors) -> Option<System> {
    check_length(&tokens, errors)?;
    let (top, body) = parse_head(tokens, errors)?;
    let misplaced = Description::new(top.name.clone(), top.runtime.clone());
    let mut system = System {
        top,
        mentions_accelerations: mentions_accelerations(&body),
        misplaced,
        lone: None,
        bodies: Vec::new(),
        joints: Vec::new(),
        cables: Vec::new(),
        drives: Vec::new(),
        forces: Vec::new(),
        moments: Vec::new(),
        is_planar: false,
        centers: None,
        held: None,
        points: Vec::new(),
        firsts: Vec::new(),
        file: None,
        locked: Vec::new(),
        lost: Lost::default(),
    };
    for entry in split(body, Entry::Key, errors) {
        system.parse_key(without_attributes(&entry, errors), errors);
    }
    system.place_misplaced();
    system.read_file(errors);
    system.lone = system.key_of_lone_body();
    system.check_bodies(errors);
    system.is_planar = system.check_motion(errors);
    system.take_centers(errors);
    system.take_frames();
    system.lose_names();
    system.move_in(system.is_planar);
    Some(system)
}

impl System {
    fn parse_key(&mut self, entry: &[TokenTree], errors: &mut Errors) {
        let [TokenTree::Ident(key), rest @ ..] = entry else {
            parse_key(&mut self.top, entry, errors);
            return;
        };
        let word = key.to_string();
        if self.parse_outside(key, rest, errors) {
            return;
        }
        if OF_BODIES.contains(&word.as_str()) {
            self.parse_key_of_bodies(key, entry, errors);
        } else if word == "reactions" {
            let message = "the loads that joints hold are an output: write `outputs: [reactions]`, or \
                           `outputs: [reactions(elbow)]` for those of one";
            errors.push(key.span(), message);
        } else if word == "independent" {
            no_choice_of_joints(key, errors);
        } else if let Some((list, example)) = list_meant(&word).or_else(|| list_like(&word, rest)) {
            let is_given = self.top.keys.iter().any(|other| {
                list_meant(&other.to_string()).is_some_and(|(other, _)| other == list)
            });
            if word != *list {
                report_unknown(key, Some(list), errors);
            } else if is_given {
                let message =
                    format!("`{word}` is given twice: put everything into one `{word}: [..]`");
                errors.push(key.span(), message);
            }
            if !is_given {
                self.top.keys.push(key.clone());
            }
            self.parse_list(list, example, key, rest, errors);
        } else if word == "drawing" || similar(&word, ["drawing"]).is_some() {
            if word != "drawing" {
                report_unknown(key, Some("drawing"), errors);
            }
            self.parse_drawing(key, rest, errors);
        } else if file::KEYS.contains(&word.as_str()) {
            let other = self
                .top
                .keys
                .iter()
                .find(|key| file::KEYS.iter().any(|word| *key == word));
            if let Some(other) = other {
                let message = format!("`{other}` is given already: a system has one file");
                errors.push(key.span(), message);
                return;
            }
            self.top.keys.push(key.clone());
            self.parse_file(key, rest, errors);
        } else if word == "outputs" {
            let entry = self.without_joints(entry, errors);
            parse_key(&mut self.top, &entry, errors);
        } else {
            parse_key(&mut self.top, entry, errors);
        }
    }

    /// Reports and reads what stands in braces outside of the lists, if this is such a thing.
    fn parse_outside(&mut self, name: &Ident, rest: &[TokenTree], errors: &mut Errors) -> bool {
        let Some(found) = outside(name, rest) else {
            return false;
        };
        match found {
            Outside::Body(group) => {
                let message =
                    format!("a body belongs in `bodies`: write `bodies: [.., {name} {{ .. }}]`");
                errors.push(name.span(), message);
                let entry = [name.clone().into(), TokenTree::Group(group.clone())];
                self.parse_body(&entry, errors);
            }
            Outside::Keys(group) => {
                let message = format!(
                    "the keys belong in the braces of the system: leave `{name}` and these braces out"
                );
                errors.push(group.span_open(), message);
                for entry in split(group.stream(), Entry::Key, errors) {
                    self.parse_key(without_attributes(&entry, errors), errors);
                }
            }
        }
        true
    }

    /// Reports and reads a body in the list of joints, if the entry is one.
    fn parse_body_among_joints(&mut self, entry: &[TokenTree], errors: &mut Errors) -> bool {
        let [TokenTree::Ident(name), TokenTree::Group(group)] = entry else {
            return false;
        };
        if group.delimiter() != Delimiter::Brace || !holds_keys(group) {
            return false;
        }
        let message = format!("`{name}` is a body: move `{name} {{ .. }}` to `bodies`");
        errors.push(name.span(), message);
        self.parse_body(entry, errors);
        true
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
                self.lost.bodies |= list == "bodies";
                self.lost.joints |= list == "joints";
                return;
            }
        };
        if group.delimiter() != Delimiter::Bracket {
            errors.push(group.span_open(), message);
        }
        for entry in split(group.stream(), Entry::Defined, errors) {
            let entry = bracketed_entry(group, entry);
            let entry = without_attributes(&entry, errors);
            if list == "bodies" {
                self.parse_body(entry, errors);
                continue;
            }
            if list == "joints" && self.parse_body_among_joints(entry, errors) {
                continue;
            }
            self.parse_definition(list, entry, errors);
        }
    }
}

/// The list of a system for which a key of other programs, or an unknown one, is written: bodies are
/// names with braces, and `links` or `cables` may stand for joints.
fn list_like(word: &str, rest: &[TokenTree]) -> Option<&'static (&'static str, &'static str)> {
    let Some(TokenTree::Group(group)) = rest.last() else {
        return None;
    };
    let mut first = group.stream().into_iter();
    let meant = match (first.next()?, first.next()?) {
        (TokenTree::Ident(_), TokenTree::Group(body)) if body.delimiter() == Delimiter::Brace => {
            (key_meant(word) != Some(word)).then_some("bodies")?
        }
        (TokenTree::Ident(_), equals)
            if is_punct(&equals, '=') && ["links", "cables", "ropes"].contains(&word) =>
        {
            "joints"
        }
        _ => return None,
    };
    LISTS.iter().find(|(list, _)| *list == meant)
}

/// The list of a system that a key means, also if it is misspelt or has the name that other
/// programs use.
fn list_meant(word: &str) -> Option<&'static (&'static str, &'static str)> {
    let exact = LISTS.iter().find(|(list, _)| *list == word);
    let of_body = key_meant(word).is_some_and(|meant| meant == word);
    let lists = LISTS.iter().map(|(list, _)| *list);
    let meant = || foreign_list_meant(word).or_else(|| similar(word, lists).filter(|_| !of_body));
    exact.or_else(|| {
        let meant = meant()?;
        LISTS.iter().find(|(list, _)| *list == meant)
    })
}

/// What stands in braces behind a word that is no key.
enum Outside<'t> {
    Body(&'t Group),
    Keys(&'t Group),
}

/// The braces behind a word that is no key, with or without a colon, if they are those of a body or
/// of keys.
fn outside<'t>(key: &Ident, rest: &'t [TokenTree]) -> Option<Outside<'t>> {
    let (group, is_body) = match rest {
        [TokenTree::Group(group)] => (group, true),
        [colon, TokenTree::Group(group)] if is_punct(colon, ':') => (group, false),
        _ => return None,
    };
    let is_of_body = |word: &str| OF_BODIES.contains(&word);
    let is_key =
        |word: &str| is_of_body(word) || list_meant(word).is_some() || key_meant(word).is_some();
    if is_key(&key.to_string()) || group.delimiter() != Delimiter::Brace {
        return None;
    }
    let word = |token| match token {
        TokenTree::Ident(word) => word.to_string(),
        _ => String::new(),
    };
    let tokens: Vec<String> = group.stream().into_iter().map(word).collect();
    if tokens.iter().any(|word| is_of_body(word)) {
        return Some(Outside::Body(group));
    }
    match tokens.first() {
        Some(first) if is_key(first) => Some(Outside::Keys(group)),
        _ => is_body.then_some(Outside::Body(group)),
    }
}

/// The independent joints of a loop are an affair of the compiler.
fn no_choice_of_joints(key: &Ident, errors: &mut Errors) {
    let message = "the state has all joints, and the compiler chooses which of a loop are independent: leave this out";
    errors.push(key.span(), message);
}

fn mentions_accelerations(tokens: &TokenStream) -> bool {
    tokens.clone().into_iter().any(|token| match token {
        TokenTree::Group(group) => mentions_accelerations(&group.stream()),
        TokenTree::Ident(word) => word.to_string().contains("acceleration"),
        _ => false,
    })
}
