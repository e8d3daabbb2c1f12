//! From tokens to a [`Description`]: keys, brackets and entries.

use proc_macro2::{Delimiter, Group, Ident, TokenStream, TokenTree};
use quote::ToTokens;
use syn::ext::IdentExt;
use syn::parse::{ParseStream, Parser};
use syn::{LitStr, Token};

use crate::errors::{Errors, Extent};

use super::expression::{Expression, Kind};
use super::unit::UnitExpression;
use super::{Declaration, Definition, Description, Family, Load, LoadKind, Written};

/// Keys of the language that are not there yet.
const LATER: [&str; 3] = ["potentials", "constraints", "checks"];

/// Parses `(runtime) Name { key: value, .. }`. Only without a name is there no description at all.
pub fn parse_description(tokens: TokenStream, errors: &mut Errors) -> Option<Description> {
    let (runtime, name, body) = errors.catch(header.parse2(tokens))?;
    let mut description = Description {
        name,
        runtime,
        refused: Vec::new(),
        keys: Vec::new(),
        doc: Vec::new(),
        motion: None,
        mass: None,
        inertia: None,
        params: Vec::new(),
        inputs: Vec::new(),
        points: Vec::new(),
        locals: Vec::new(),
        loads: Vec::new(),
        pole: None,
        outputs: Vec::new(),
    };
    for entry in split(body) {
        let first = entry.clone().into_iter().next();
        match (errors.catch(key.parse2(entry)), first) {
            (Some((key, value)), _) => parse_key(&mut description, key, value, errors),
            (None, Some(TokenTree::Ident(refused))) => description.refused.push(refused),
            _ => {}
        }
    }
    Some(description)
}

fn header(input: ParseStream<'_>) -> syn::Result<(TokenStream, Ident, TokenStream)> {
    let runtime = input.parse::<Group>()?.stream();
    if input.is_empty() {
        return Err(input.error(
            "write a description: `rigid_body!(Name { motion: spatial, mass: 1[kg], .. })`",
        ));
    }
    if input.peek(Token![pub]) {
        return Err(
            input.error("generated items are `pub`: wrap the call in a module to hide them")
        );
    }
    if input.peek(Token![#]) {
        return Err(input.error("documentation of the generated type stands inside: `doc: \"..\"`"));
    }
    let name = plain_name(input, "the name of a body")?;
    if input.peek(Token![::]) || input.peek(Token![<]) {
        return Err(
            input.error("bodies with a generic scalar are not there yet: all numbers are `f64`")
        );
    }
    let body: Group = input.parse().map_err(|error| {
        syn::Error::new(
            error.span(),
            "expected the description in braces: `Name { .. }`",
        )
    })?;
    if body.delimiter() != Delimiter::Brace {
        return Err(syn::Error::new(
            body.span(),
            "a description stands in braces: `Name { .. }`",
        ));
    }
    if !input.is_empty() {
        return Err(input.error("one description in one call: nothing follows the braces"));
    }
    Ok((runtime, name, body.stream()))
}

/// An identifier that generated code can use as it is.
fn plain_name(input: ParseStream<'_>, what: &str) -> syn::Result<Ident> {
    if !input.peek(syn::Ident::peek_any) {
        return Err(input.error(format!("expected {what}")));
    }
    let name = Ident::parse_any(input)?;
    let word = name.to_string();
    if word.starts_with("r#") || syn::parse2::<Ident>(name.to_token_stream()).is_err() {
        return Err(syn::Error::new(
            name.span(),
            format!("`{word}` is a keyword of Rust: choose another name"),
        ));
    }
    if word == "_" {
        return Err(syn::Error::new(
            name.span(),
            format!("`_` is no name: expected {what}"),
        ));
    }
    Ok(name)
}

fn key(input: ParseStream<'_>) -> syn::Result<(Ident, TokenStream)> {
    if input.peek(Token![..]) {
        return Err(input.error("a description is complete in itself: `..` cannot be used"));
    }
    if !input.peek(syn::Ident::peek_any) {
        return Err(input.error("expected a key, such as `mass: 1[kg]`"));
    }
    let key = Ident::parse_any(input)?;
    if input.peek(Token![=]) {
        return Err(input.error(format!("a key is followed by a colon: write `{key}: ..`")));
    }
    if input.is_empty() {
        return Err(syn::Error::new(
            key.span(),
            format!("`{key}` has no value: write `{key}: ..`"),
        ));
    }
    input.parse::<Token![:]>()?;
    let value: TokenStream = input.parse()?;
    if value.is_empty() {
        return Err(syn::Error::new(
            key.span(),
            format!("`{key}` has no value: write `{key}: ..`"),
        ));
    }
    Ok((key, value))
}

fn parse_key(into: &mut Description, key: Ident, value: TokenStream, errors: &mut Errors) {
    let word = key.to_string();
    if into.keys.contains(&key) {
        errors.push(
            key.span(),
            format!("`{word}` is given twice: put everything into one `{word}`"),
        );
        return;
    }
    into.keys.push(key.clone());
    let expression = |errors: &mut Errors| {
        Some(Written {
            value: Expression::parse(value.clone(), errors),
        })
    };
    match word.as_str() {
        "doc" => into.doc = parse_doc(value, errors),
        "motion" => into.motion = parse_motion(value, errors),
        "mass" => into.mass = expression(errors),
        "inertia" => into.inertia = expression(errors),
        "pole" => into.pole = expression(errors),
        "params" => into.params = entries(&key, value, "arm = 0.2[m]", errors, parse_declaration),
        "inputs" => into.inputs = entries(&key, value, "thrust[N]", errors, parse_declaration),
        "points" => {
            into.points = entries(&key, value, "tip = (0.1, 0, 0)", errors, parse_definition)
        }
        "locals" => {
            into.locals = entries(
                &key,
                value,
                "total = thrust_1 + thrust_2",
                errors,
                parse_definition,
            )
        }
        "outputs" => into.outputs = entries(&key, value, "energy", errors, parse_word),
        "forces" | "moments" | "joint_forces" | "joint_moments" | "reactions" | "fields" => {
            let (family, kind) = family(&word);
            let loads = entries(
                &key,
                value,
                "push = body(1, 0, 0).at(tip)",
                errors,
                |entry, errors| parse_load(entry, family, kind, errors),
            );
            into.loads.extend(loads);
        }
        later if LATER.contains(&later) => {
            errors.push(
                key.span(),
                format!(
                    "`{later}` are part of the language, but this version does not have them yet"
                ),
            );
        }
        // left to rustc, through the schema: it names the similar key
        _ => {}
    }
}

/// What a key of loads says about its entries; `None`: each entry says itself whether it is a moment.
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

/// Splits at the commas of the outermost level.
fn split(tokens: TokenStream) -> Vec<TokenStream> {
    let tokens: Vec<TokenTree> = tokens.into_iter().collect();
    let entries =
        tokens.split(|token| matches!(token, TokenTree::Punct(punct) if punct.as_char() == ','));
    entries
        .filter(|entry| !entry.is_empty())
        .map(|entry| entry.iter().cloned().collect())
        .collect()
}

/// The entries of `key: [ .. ]`, each parsed alone.
fn entries<T>(
    key: &Ident,
    value: TokenStream,
    example: &str,
    errors: &mut Errors,
    mut parse: impl FnMut(TokenStream, &mut Errors) -> Option<T>,
) -> Vec<T> {
    match syn::parse2::<Group>(value.clone()) {
        Ok(group) if group.delimiter() == Delimiter::Bracket => split(group.stream())
            .into_iter()
            .filter_map(|entry| parse(entry, errors))
            .collect(),
        _ => {
            errors.push(
                Extent::of(value),
                format!("`{key}` is a list: write `{key}: [{example}]`"),
            );
            Vec::new()
        }
    }
}

fn parse_doc(value: TokenStream, errors: &mut Errors) -> Vec<String> {
    let Ok(text) = syn::parse2::<LitStr>(value.clone()) else {
        errors.push(Extent::of(value), "expected a string: `doc: \"..\"`");
        return Vec::new();
    };
    text.value()
        .lines()
        .map(|line| line.trim().to_owned())
        .collect()
}

fn parse_motion(value: TokenStream, errors: &mut Errors) -> Option<Ident> {
    let mut tokens = value.clone().into_iter();
    match (tokens.next(), tokens.next()) {
        (Some(TokenTree::Ident(word)), None) => Some(word),
        (Some(TokenTree::Ident(word)), Some(TokenTree::Group(_)))
            if ["pivot", "fixed_point", "fixed_axis", "rod"]
                .contains(&word.to_string().as_str()) =>
        {
            errors.push(
                word.span(),
                format!(
                    "`{word}(..)` is part of the language, but this version does not have it yet"
                ),
            );
            None
        }
        _ => {
            errors.push(Extent::of(value), "expected a kind of motion: `planar`, `planar_translation`, `spatial`, `translation` or `rotation`");
            None
        }
    }
}

fn parse_word(entry: TokenStream, errors: &mut Errors) -> Option<Ident> {
    let word =
        |input: ParseStream<'_>| plain_name(input, "the name of an output, such as `energy`");
    errors.catch(word.parse2(entry))
}

/// `name = value` and what stands in front of it; without a value, an error that shows one.
fn named(entry: TokenStream, errors: &mut Errors) -> Option<(Ident, TokenStream)> {
    let parse =
        |input: ParseStream<'_>| Ok((plain_name(input, "a name")?, input.parse::<TokenStream>()?));
    errors.catch(parse.parse2(entry))
}

/// What follows the `=`; `None` if there is none.
fn after_equals(rest: &TokenStream) -> Option<TokenStream> {
    let mut tokens = rest.clone().into_iter();
    match tokens.next() {
        Some(TokenTree::Punct(punct))
            if punct.as_char() == '=' && punct.spacing() == proc_macro2::Spacing::Alone =>
        {
            Some(tokens.collect())
        }
        _ => None,
    }
}

fn parse_declaration(entry: TokenStream, errors: &mut Errors) -> Option<Declaration> {
    let (name, rest) = named(entry, errors)?;
    if let Some(value) = after_equals(&rest) {
        let value = parse_value(&name, value, errors);
        return Some(Declaration {
            name,
            unit: None,
            value: Some(value),
        });
    }
    if rest.is_empty() {
        return Some(Declaration {
            name,
            unit: None,
            value: None,
        });
    }
    match syn::parse2::<Group>(rest.clone()) {
        Ok(group) if group.delimiter() == Delimiter::Bracket => {
            match errors.catch(UnitExpression::parse(group.stream(), Extent::of(&rest))) {
                Some(unit) => Some(Declaration {
                    name,
                    unit: Some(unit),
                    value: None,
                }),
                None => Some(Declaration {
                    name,
                    unit: None,
                    value: Some(None),
                }),
            }
        }
        _ => {
            errors.push(
                Extent::of(rest),
                format!("expected `{name}`, `{name}[unit]` or `{name} = value`"),
            );
            Some(Declaration {
                name,
                unit: None,
                value: Some(None),
            })
        }
    }
}

fn parse_definition(entry: TokenStream, errors: &mut Errors) -> Option<Definition> {
    let (name, rest) = named(entry, errors)?;
    let Some(value) = after_equals(&rest) else {
        let place = if rest.is_empty() {
            name.span().into()
        } else {
            Extent::of(&rest)
        };
        errors.push(place, format!("expected a value: write `{name} = ..`"));
        return Some(Definition { name, value: None });
    };
    let value = parse_value(&name, value, errors);
    Some(Definition { name, value })
}

fn parse_value(name: &Ident, value: TokenStream, errors: &mut Errors) -> Option<Expression> {
    if value.is_empty() {
        errors.push(
            name.span(),
            format!("expected a value: write `{name} = ..`"),
        );
        return None;
    }
    Expression::parse(value, errors)
}

/// Splits `vector.at(point)` and `moment(vector)` off the expression of a load.
fn parse_load(
    entry: TokenStream,
    family: Family,
    kind: Option<LoadKind>,
    errors: &mut Errors,
) -> Option<Load> {
    let extent = Extent::of(&entry);
    let Some(first) = entry.clone().into_iter().next() else {
        return None;
    };
    let anonymous = matches!(
        (&first, entry.clone().into_iter().nth(1)),
        (TokenTree::Ident(_), Some(TokenTree::Group(_)))
    );
    if anonymous {
        errors.push(first.span(), "a load has a name: write `name = ..`");
        return None;
    }
    let Definition { name, value } = parse_definition(entry, errors)?;
    let mut load = Load {
        name,
        family,
        kind: kind.unwrap_or(LoadKind::Force),
        vector: None,
        point: None,
        extent,
    };
    let Some(mut value) = value else {
        return Some(load);
    };
    load.extent = value.extent;
    loop {
        match value.kind {
            Kind::Method(inner, method, mut arguments)
                if method == "at" && load.point.is_none() =>
            {
                if arguments.len() != 1 {
                    errors.push(method.span(), "`.at` takes one point: write `.at(P)`");
                    return Some(load);
                }
                load.point = arguments.pop();
                value = *inner;
            }
            Kind::Method(_, method, _) if method == "on" => {
                errors.push(
                    method.span(),
                    "`.on([..])` is part of the language, but this version does not have it yet",
                );
                return Some(load);
            }
            Kind::Call(function, mut arguments)
                if function == "moment" && load.kind == LoadKind::Force =>
            {
                if kind.is_some() {
                    errors.push(
                        function.span(),
                        "a force is expected here: moments stand in `moments` or `joint_moments`",
                    );
                    return Some(load);
                }
                if arguments.len() != 1 {
                    errors.push(
                        function.span(),
                        "`moment` takes one vector: write `moment(body(0, 0, 1))`",
                    );
                    return Some(load);
                }
                load.kind = LoadKind::Moment;
                value = arguments.remove(0);
            }
            _ => break,
        }
    }
    if let (LoadKind::Moment, Some(point)) = (load.kind, &load.point) {
        errors.push(
            point.extent,
            "a moment is the same about every point: leave `.at(..)` out",
        );
    }
    load.vector = Some(value);
    Some(load)
}
