//! The bodies of a system, each in its braces.

use proc_macro2::{Delimiter, Group, Ident, Span, TokenTree};

use crate::errors::{Errors, Extent, similar};
use crate::syntax::entries::{
    holds_keys, key_meant, key_value, parse_keys, parse_name, parse_value,
};
use crate::syntax::expression::{Expression, Kind};
use crate::syntax::tokens::{Entry, comma, is_punct, split, start, stream, without_attributes};
use crate::syntax::words::{check_name, joined};
use crate::syntax::{Definition, Description};

use super::misplaced::no_pole;
use super::{OF_SYSTEMS, System, no_choice_of_joints};

/// Names that other programs and textbooks give to the ground.
const GROUNDS: [&str; 6] = ["ground", "base", "base_link", "floor", "wall", "earth"];

/// Whether a body has neither mass nor inertia.
fn has_no_substance(body: &Description) -> bool {
    let written = [&body.mass, &body.inertia];
    written.into_iter().all(Option::is_none) && body.composition.is_none()
}

impl System {
    /// `name { key: value, .. }`, or several of these if commas are missing.
    pub fn parse_body(&mut self, entry: &[TokenTree], errors: &mut Errors) {
        let mut entry = entry;
        while let [
            TokenTree::Ident(_),
            TokenTree::Group(_),
            TokenTree::Ident(next),
            ..,
        ] = entry
        {
            errors.push(next.span(), format!("expected a comma before `{next}`"));
            self.parse_one_body(&entry[..2], errors);
            entry = &entry[2..];
        }
        self.parse_one_body(entry, errors);
    }

    fn parse_one_body(&mut self, entry: &[TokenTree], errors: &mut Errors) {
        if entry.is_empty() {
            return;
        }
        if self.parse_joint_among_bodies(entry, errors) {
            return;
        }
        let named = name_inside(entry, errors)
            .or_else(|| name_and_braces(entry, errors))
            .filter(|(name, _)| check_name(name, "the name of a body", errors).is_some());
        let Some((name, group)) = named else {
            self.lost.bodies = true;
            return;
        };
        let mut body = Description::new(name.clone(), self.top.runtime.clone());
        let copies = self.parse_keys_of_body(&mut body, &group, errors);
        if GROUNDS.iter().any(|word| name == word) && has_no_substance(&body) {
            let message = format!(
                "`{name}` has no mass: if it is the ground, leave it out, and write its points as `world(..)`; a body \
                 has a mass, `mass: 1[kg]`"
            );
            errors.push(name.span(), message);
            self.lost.bodies = true;
            return;
        }
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

    /// Reads the keys, and returns the copies if there are any.
    fn parse_keys_of_body(
        &mut self,
        body: &mut Description,
        group: &Group,
        errors: &mut Errors,
    ) -> Option<Vec<Definition>> {
        let mut copies: Option<Vec<Definition>> = None;
        let mut keys = Vec::new();
        for entry in split(group.stream(), Entry::Key, errors) {
            let [TokenTree::Ident(key), rest @ ..] = entry.as_slice() else {
                keys.extend(entry.into_iter().chain([comma(Span::call_site())]));
                continue;
            };
            let word = key.to_string();
            if is_copies(&word) {
                let is_repeated = copies.is_some();
                if word != "copies" {
                    errors.push(
                        key.span(),
                        format!("unknown key `{key}`; did you mean `copies`?"),
                    );
                } else if is_repeated {
                    let message = "`copies` is given twice: put everything into one `copies: [..]`";
                    errors.push(key.span(), message);
                }
                let read = read_copies(body, key, rest, errors);
                self.lost.bodies |= read.is_none() || is_repeated;
                copies
                    .get_or_insert_default()
                    .extend(read.unwrap_or_default());
            } else if key == "motion" {
                let message = "the joints of a system say how its bodies move: leave `motion` out";
                errors.push(key.span(), message);
            } else if OF_SYSTEMS.contains(&word.as_str()) {
                self.parse_key_in_a_body(key, &entry, errors);
            } else if key_meant(&word).is_none() && similar(&word, ["joints"]).is_some() {
                let message = format!(
                    "unknown key `{key}`; joints go outside the braces of bodies, in `joints: [..]`"
                );
                errors.push(key.span(), message);
                self.lost.joints = true;
            } else if key == "pole" {
                no_pole(key, errors);
            } else if key == "reactions" {
                let message = "what joints do to a body is an output of the system: leave `reactions` out, and write \
                               `outputs: [reactions]`";
                errors.push(key.span(), message);
            } else if key == "independent" {
                no_choice_of_joints(key, errors);
            } else {
                keys.extend(entry.into_iter().chain([comma(Span::call_site())]));
            }
        }
        parse_keys(body, keys.into_iter().collect(), errors);
        copies
    }

    fn add(&mut self, body: Description, first: usize, errors: &mut Errors) {
        if self.bodies.iter().any(|other| other.name == body.name) {
            let message = format!("there is a body `{}` already", body.name);
            errors.push(body.name.span(), message);
            self.lost.bodies = true;
            return;
        }
        self.firsts.push(first);
        self.bodies.push(body);
    }
}

/// The name of a body whose braces begin with `name: arm`, which is reported, and the braces without
/// it.
fn name_inside(entry: &[TokenTree], errors: &mut Errors) -> Option<(Ident, Group)> {
    let Some(TokenTree::Group(group)) = entry.last() else {
        return None;
    };
    let tokens: Vec<TokenTree> = group.stream().into_iter().collect();
    let [
        TokenTree::Ident(key),
        colon,
        TokenTree::Ident(name),
        rest @ ..,
    ] = tokens.as_slice()
    else {
        return None;
    };
    if key != "name" || !is_punct(colon, ':') {
        return None;
    }
    let message = format!("the name of a body goes before its braces: write `{name} {{ .. }}`");
    errors.push(key.span(), message);
    let rest = match rest {
        [comma, rest @ ..] if is_punct(comma, ',') => rest,
        _ => rest,
    };
    Some((name.clone(), Group::new(Delimiter::Brace, stream(rest))))
}

/// The name of a body, and its braces.
fn name_and_braces(entry: &[TokenTree], errors: &mut Errors) -> Option<(Ident, Group)> {
    let (name, group) = match entry {
        [TokenTree::Ident(name), TokenTree::Group(group)] => {
            if group.delimiter() != Delimiter::Brace {
                let message =
                    format!("a body is described in braces: write `{name} {{ mass: 1[kg], .. }}`");
                errors.push(group.span_open(), message);
            }
            (name, group)
        }
        [
            TokenTree::Ident(name),
            TokenTree::Punct(sign),
            TokenTree::Group(group),
        ] if group.delimiter() == Delimiter::Brace => {
            let message = format!(
                "nothing stands between the name of a body and its braces: write `{name} {{ .. }}`"
            );
            errors.push(sign.span(), message);
            (name, group)
        }
        [
            TokenTree::Ident(name),
            TokenTree::Punct(sign),
            ..,
            TokenTree::Group(group),
        ] if entry.len() == 3 || holds_keys(group) => {
            let message = format!("a body is a name and braces: write `{name} {{ .. }}`");
            errors.push(sign.span(), message);
            (name, group)
        }
        [
            TokenTree::Ident(word),
            TokenTree::Ident(name),
            TokenTree::Group(group),
        ] if holds_keys(group) => {
            let message = format!("a body begins with its name: leave `{word}` out");
            errors.push(word.span(), message);
            (name, group)
        }
        [TokenTree::Ident(name), TokenTree::Group(group), extra, ..] => {
            errors.push(
                start(extra),
                format!("expected a comma behind the braces of `{name}`"),
            );
            (name, group)
        }
        [TokenTree::Ident(name), ..] => {
            let message =
                format!("a body is a name and a description: write `{name} {{ mass: 1[kg], .. }}`");
            return errors.report(name.span(), message);
        }
        _ => {
            let place = entry.first().map_or_else(Span::call_site, start);
            return errors.report(
                place,
                "expected the name of a body: `arm { mass: 1[kg], .. }`",
            );
        }
    };
    Some((name.clone(), group.clone()))
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
            errors.push(Extent::of(stream(value)), message);
        }
        return None;
    };
    if group.delimiter() != Delimiter::Bracket {
        errors.push(group.span_open(), message);
    }
    if group.stream().is_empty() {
        return errors.report(
            group.span_open(),
            "this makes no body: write a copy, `copies: [x = body(1, 0, 0)]`, or leave `copies` out",
        );
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

/// The body `body_name`, with its inertia along the direction of the copy.
fn copied(body: &Description, copy: &Definition) -> Description {
    let mut copied = body.clone();
    copied.name = joined(&body.name, &copy.name);
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
