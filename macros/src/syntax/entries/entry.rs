//! The entries of lists: declarations, definitions, loads and single words.

use proc_macro2::{Delimiter, Ident, TokenTree};

use crate::errors::{Errors, is_joint, similar};

use super::charges::parse_charges;
use super::declaration::{MOVING_BEFORE, parse_declaration};
use super::definition::{parse_constraint, parse_definition, parse_value};
use super::foreign::{parse_constant, parse_function};
use crate::families::Family;
use crate::families::LoadKind;
use crate::syntax::Declaration;
use crate::syntax::Definition;
use crate::syntax::Description;
use crate::syntax::Load;
use crate::syntax::Value;
use crate::syntax::expression::{Expression, Kind};
use crate::syntax::tokens::{after_sign, is_punct, start};
use crate::syntax::words::check_name;

/// Reads one entry of the list `key`. An entry without a name is dropped. An entry without a value
/// keeps its name, so that references to it cause no further errors.
pub fn parse_entry(into: &mut Description, key: &str, entry: &[TokenTree], errors: &mut Errors) {
    if key == "functions" {
        parse_function(into, entry, errors);
        return;
    }
    let Some((name, rest)) = parse_name(into, key, entry, errors) else {
        return;
    };
    match key {
        "constants" => into.constants.push(parse_constant(name, rest, errors)),
        "params" => {
            let param = parse_declaration(name, key, rest, errors);
            let message = "a param is constant: leave `.moving` out, or make it an input";
            check_not_moving(&param, message, errors);
            into.params.push(param);
        }
        "inputs" => {
            let input = parse_declaration(name, key, rest, errors);
            let orders = if input.moving.is_some() { 1..3 } else { 1..1 };
            let derivatives: Vec<_> = orders.map(|order| input.derivative(order)).collect();
            into.inputs.push(input);
            into.inputs.extend(derivatives);
        }
        "states" => {
            let state = parse_declaration(name, key, rest, errors);
            let message =
                "a state changes by its rate, which belongs in `rates`: leave `.moving` out";
            check_not_moving(&state, message, errors);
            into.states.push(state);
        }
        "rates" => into.rates.push(parse_definition(name, rest, errors)),
        "points" => into.points.push(parse_definition(name, rest, errors)),
        "locals" => into.locals.push(parse_definition(name, rest, errors)),
        "constraints" => into.constraints.push(parse_constraint(name, rest, errors)),
        "potentials" => {
            let Definition { name, value } = parse_definition(name, rest, errors);
            let value = value.map(|value| without_point(value, errors));
            into.potentials.push(Definition { name, value });
        }
        "outputs" => {
            if let [sign, TokenTree::Ident(switch)] = rest
                && (switch == "true" || switch == "false")
            {
                let message = format!("an output is one word: write `{name}`");
                errors.push(start(sign), message);
                return;
            }
            let is_value = |token: &&TokenTree| is_punct(token, '=') || is_punct(token, '.');
            if let Some(sign) = rest.first().filter(is_value) {
                errors.push(
                    start(sign),
                    "an output is one word of the language, such as `energy`: compute other \
                     quantities of the motion from its states",
                );
                return;
            }
            // an output that does not exist is reported later, as an unknown output
            let is_reported =
                name == "jacobian" || similar(&name.to_string(), ["reactions"]).is_some();
            if let Some(extra) = rest.first().filter(|_| !is_reported) {
                errors.push(
                    start(extra),
                    format!("an output is one word: write `{name}`"),
                );
            }
            into.outputs.push(name);
        }
        loads => {
            let value = parse_value(&name, rest, errors);
            let load = parse_load(name, value, family(loads), errors);
            into.loads.push(load);
        }
    }
}

fn check_not_moving(declaration: &Declaration, message: &str, errors: &mut Errors) {
    if let Some(word) = &declaration.moving {
        errors.push(word.span(), message);
    }
}

/// Lists whose entries may be names without a value.
const DECLARED: [&str; 4] = ["params", "inputs", "states", "outputs"];

/// The name of an entry, and the tokens after it.
pub fn parse_name<'t>(
    into: &mut Description,
    key: &str,
    entry: &'t [TokenTree],
    errors: &mut Errors,
) -> Option<(Ident, &'t [TokenTree])> {
    match entry {
        [TokenTree::Ident(word), TokenTree::Group(group), ..]
            if group.delimiter() == Delimiter::Parenthesis && !DECLARED.contains(&key) =>
        {
            errors.report(
                word.span(),
                format!("every entry has a name: write `name = {word}(..)`"),
            )
        }
        [TokenTree::Ident(word), TokenTree::Ident(name), rest @ ..]
            if matches!(word.to_string().as_str(), "let" | "const" | "static")
                || !DECLARED.contains(&key) && after_sign(rest, '=').is_some() =>
        {
            errors.push(
                word.span(),
                format!("entries are written without `{word}`: write `{name} = ..`"),
            );
            parse_name(into, key, &entry[1..], errors)
        }
        [TokenTree::Ident(word), TokenTree::Punct(sign), ..]
            if !DECLARED.contains(&key) && is_operator(sign.as_char(), &entry[1..]) =>
        {
            let doubled = if sign.as_char() == '=' { "=" } else { "" };
            let message =
                format!("every entry has a name: write `name = {word} {sign}{doubled} ..`");
            let message = message.replace(" . ..", "...");
            errors.report(word.span(), message)
        }
        [TokenTree::Ident(word), TokenTree::Ident(name), ..]
            if word == "moving" && key == "inputs" =>
        {
            errors.push(word.span(), MOVING_BEFORE);
            let derivatives = ["rate", "acceleration"].map(|order| format!("{name}_{order}"));
            into.lost.extend(derivatives);
            parse_name(into, key, &entry[1..], errors)
        }
        [
            TokenTree::Ident(first),
            TokenTree::Ident(second),
            TokenTree::Group(group),
            ..,
        ] if group.delimiter() == Delimiter::Parenthesis && !DECLARED.contains(&key) => {
            let (name, kind) = if is_joint(&first.to_string()) {
                (second, first)
            } else {
                (first, second)
            };
            into.lost.push(name.to_string());
            let message = format!("an entry is written with `=`: write `{name} = {kind}(..)`");
            errors.report(second.span(), message)
        }
        [TokenTree::Ident(name), rest @ ..] => {
            let what = if key == "outputs" {
                "the name of an output, such as `energy`"
            } else {
                "a name"
            };
            if check_name(name, what, errors).is_none() {
                let word = name.to_string();
                into.lost.push(word.trim_start_matches("r#").to_owned());
                return None;
            }
            Some((name.clone(), rest))
        }
        [TokenTree::Literal(text), ..] if key == "outputs" => {
            let name = text.to_string();
            let message = format!(
                "an output has no quotes: write `{}`",
                name.trim_matches('"')
            );
            errors.report(text.span(), message)
        }
        [first, ..] if key == "outputs" => errors.report(
            start(first),
            "expected the name of an output, such as `energy`",
        ),
        [first, ..] => errors.report(
            start(first),
            "expected a name: an entry is written `name = ..`",
        ),
        [] => None,
    }
}

/// Whether a sign behind the first word of an entry belongs to its value.
fn is_operator(sign: char, tokens: &[TokenTree]) -> bool {
    let is_arrow = matches!(tokens.get(1), Some(next) if is_punct(next, '>'));
    match sign {
        '=' => after_sign(tokens, '=').is_none() && !is_arrow,
        '-' => !is_arrow,
        _ => "+*/.<>&|!".contains(sign),
    }
}

/// The family of the loads under a key, and their kind; `None` if each entry says itself whether it
/// is a moment.
fn family(key: &str) -> (Family, Option<LoadKind>) {
    match key {
        "forces" => (Family::External, Some(LoadKind::Force)),
        "moments" => (Family::External, Some(LoadKind::Moment)),
        "joint_forces" => (Family::Joint, Some(LoadKind::Force)),
        "joint_moments" => (Family::Joint, Some(LoadKind::Moment)),
        "reactions" => (Family::Reaction, None),
        _ => (Family::Field, None),
    }
}

/// Removes the point of action, which a potential does not have.
fn without_point(value: Expression, errors: &mut Errors) -> Expression {
    match value.kind {
        Kind::Method(inner, method, _) if method == "at" => {
            errors.push(
                method.span(),
                "a potential acts at no point: its force and its moment are derived; leave \
                 `.at(..)` out",
            );
            *inner
        }
        _ => value,
    }
}

/// Splits `vector.at(point)`, `moment(vector)` and `field.on([..])` off the expression of a load.
fn parse_load(
    name: Ident,
    value: Value,
    (family, kind): (Family, Option<LoadKind>),
    errors: &mut Errors,
) -> Load {
    let mut load = Load {
        name,
        family,
        kind: kind.unwrap_or(LoadKind::Force),
        vector: None,
        point: None,
        charges: None,
    };
    let Some(mut value) = value else {
        return load;
    };
    let mut at: Option<Ident> = None;
    loop {
        match value.kind {
            Kind::Method(inner, method, arguments) if method == "at" => {
                parse_place(&mut load, at.is_some(), &method, arguments, errors);
                at = Some(method);
                value = *inner;
            }
            Kind::Method(inner, method, arguments) if method == "on" && load.charges.is_none() => {
                if load.family == Family::Field && load.kind == LoadKind::Force {
                    load.charges = Some(parse_charges(&method, arguments, errors));
                } else {
                    errors.push(
                        method.span(),
                        "charges belong in a field: write `fields: [name = \
                         world(..).on([q.at(P)])]`",
                    );
                    return load;
                }
                value = *inner;
            }
            Kind::Call(function, arguments)
                if function == "moment" && load.kind == LoadKind::Force =>
            {
                let Some(vector) = vector_of_moment(&function, arguments, kind, errors) else {
                    return load;
                };
                load.kind = LoadKind::Moment;
                value = vector;
            }
            _ => break,
        }
    }
    if let Some(at) = at {
        check_place(&mut load, &at, errors);
    }
    load.vector = Some(value);
    load
}

/// The vector of `moment(vector)`, allowed under keys that leave the kind to each load.
fn vector_of_moment(
    function: &Ident,
    mut arguments: Vec<Expression>,
    kind: Option<LoadKind>,
    errors: &mut Errors,
) -> Option<Expression> {
    let message = if kind.is_some() {
        "a force is expected here: moments belong in `moments` or `joint_moments`"
    } else if arguments.len() == 1 {
        return arguments.pop();
    } else {
        "`moment` takes one vector: write `moment(body(0, 0, 1))`"
    };
    errors.report(function.span(), message)
}

/// Reads the argument of `.at(..)`, once.
fn parse_place(
    load: &mut Load,
    is_repeated: bool,
    method: &Ident,
    mut arguments: Vec<Expression>,
    errors: &mut Errors,
) {
    let message = if is_repeated {
        "a load acts at one point: leave one `.at(..)` out"
    } else if arguments.len() == 1 {
        load.point = Some(arguments.pop());
        return;
    } else {
        load.point = Some(None);
        "`.at` takes one point: write `.at(P)`"
    };
    errors.push(method.span(), message);
}

/// Reports a point of action that has no effect.
fn check_place(load: &mut Load, at: &Ident, errors: &mut Errors) {
    if load.charges.is_some() {
        errors.push(
            at.span(),
            "a field acts where its charges are: leave this `.at(..)` out",
        );
    }
    if load.kind == LoadKind::Moment {
        errors.push(
            at.span(),
            "a moment is the same about every point: leave `.at(..)` out",
        );
        load.point = None;
    }
}
