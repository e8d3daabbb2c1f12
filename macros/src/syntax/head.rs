//! The head of a description: the runtime, the name of the body and its scalar.

use proc_macro2::{Delimiter, Ident, Span, TokenStream, TokenTree};

use crate::errors::{Errors, Extent};

use super::Description;
use super::tokens::{after_sign, is_punct, skip_attributes, start, stream};
use super::words::check_name;

/// Types, which cannot be names of parameters.
const TYPES: [&str; 19] = [
    "f16", "f32", "f64", "f128", "i8", "i16", "i32", "i64", "i128", "isize", "u8", "u16", "u32",
    "u64", "u128", "usize", "bool", "char", "str",
];

/// The path of the runtime, the name of the body, and the content of the braces.
pub fn parse_head(tokens: TokenStream, errors: &mut Errors) -> Option<(Description, TokenStream)> {
    let mut all: Vec<TokenTree> = tokens.into_iter().collect();
    // of another macro, such as `$v:vis`, which may be empty
    if let [_, TokenTree::Group(passed_on), ..] = all.as_slice()
        && passed_on.delimiter() == Delimiter::None
    {
        let inner = passed_on.stream();
        all.splice(1..2, inner);
    }
    let [TokenTree::Group(runtime), rest @ ..] = all.as_slice() else {
        return errors.report(
            Span::call_site(),
            "call this macro as `newton_euler::rigid_body!`",
        );
    };
    let rest = from_name(rest, errors)?;
    let [TokenTree::Ident(name), rest @ ..] = rest else {
        let place = rest.first().map_or_else(Span::call_site, start);
        return errors.report(place, "expected a name in front of this: `Name { .. }`");
    };
    if is_key(rest) {
        return errors.report(
            name.span(),
            "a description is a name, and its keys in braces: write `Name { .. }`",
        );
    }
    check_name(name, "a name", errors)?;
    let is_group = |token: &TokenTree| matches!(token, TokenTree::Group(_));
    let Some(position) = rest.iter().position(is_group) else {
        let place = rest.first().map_or(name.span(), start);
        return errors.report(
            place,
            format!("expected the description in braces: `{name} {{ .. }}`"),
        );
    };
    let (between, after) = (&rest[..position], &rest[position + 1..]);
    let scalar = parse_scalar(name, between, errors);
    let TokenTree::Group(body) = &rest[position] else {
        return None;
    };
    // any other bracket belongs to what stands in place of the braces, which is reported
    if body.delimiter() != Delimiter::Brace && !between.is_empty() && scalar.is_none() {
        return None;
    }
    if body.delimiter() != Delimiter::Brace {
        errors.push(
            body.span_open(),
            format!("a description belongs in braces: `{name} {{ .. }}`"),
        );
    }
    if let Some(extra) = after.first() {
        errors.push(
            start(extra),
            "one description in one call: nothing follows its braces",
        );
    }
    let mut description = Description::new(name.clone(), runtime.stream());
    description.scalar = scalar;
    Some((description, body.stream()))
}

/// Whether these tokens follow a key: a colon, and a value other than braces.
fn is_key(rest: &[TokenTree]) -> bool {
    let value = after_sign(rest, ':').map(|(_, value)| value);
    let is_brace = |token: &TokenTree| matches!(token, TokenTree::Group(group) if group.delimiter() == Delimiter::Brace);
    value.is_some_and(|value| !matches!(value, [first] if is_brace(first)))
}

/// Skips tokens that Rust would allow before a name. They are reported once.
fn from_name<'t>(tokens: &'t [TokenTree], errors: &mut Errors) -> Option<&'t [TokenTree]> {
    let mut rest = skip_attributes(tokens);
    if let [TokenTree::Ident(word), after @ ..] = rest
        && word == "pub"
    {
        rest = match after {
            [TokenTree::Group(_), after @ ..] => after,
            _ => after,
        };
    }
    if let [TokenTree::Ident(word), TokenTree::Ident(_), ..] = rest
        && (word == "struct" || word == "enum")
    {
        rest = &rest[1..];
    }
    let skipped = &tokens[..tokens.len() - rest.len()];
    match skipped {
        [] if rest.is_empty() => {
            return errors.report(
                Span::call_site(),
                "write a description: `rigid_body!(Name { motion: spatial, mass: 1[kg], .. })`",
            );
        }
        [] => {}
        [hash, TokenTree::Group(attribute), ..] if skip_attributes(skipped).is_empty() => {
            let is_doc = attribute.stream().to_string().starts_with("doc");
            errors.push(
                hash.span(),
                if is_doc {
                    "documentation of the generated type belongs inside: `doc: \"..\"`"
                } else {
                    "an attribute is not allowed here: leave it out"
                },
            );
        }
        [TokenTree::Ident(word)] if word != "pub" => {
            let message = format!("a description begins with its name: leave `{word}` out");
            errors.push(word.span(), message);
        }
        [TokenTree::Ident(word)] | [TokenTree::Ident(word), TokenTree::Group(_)] => errors.push(
            word.span(),
            "generated items are `pub`: wrap the call in a module to hide them",
        ),
        _ => errors.push(
            Extent::of(stream(skipped)),
            "a description begins with its name: leave this out",
        ),
    }
    Some(rest)
}

/// `::<T>` between the name and its brace: the scalar over which the body is generic. If it is
/// malformed, any name stands in for it.
fn parse_scalar(name: &Ident, between: &[TokenTree], errors: &mut Errors) -> Option<Ident> {
    let first = between.first()?;
    let is_path = is_punct(first, ':') && after_sign(between, ':').is_none();
    if !is_punct(first, '<') && !is_path {
        return errors.report(first.span(), format!("expected a brace: `{name} {{ .. }}`"));
    }
    let scalar = match between {
        [a, b, open, TokenTree::Ident(scalar), close]
            if is_punct(a, ':')
                && is_punct(b, ':')
                && is_punct(open, '<')
                && is_punct(close, '>') =>
        {
            check_scalar(name, scalar, errors).map(|()| scalar.clone())
        }
        _ => errors.report(
            Extent::of(stream(between)),
            format!("a body that is generic over its scalar is `{name}::<T> {{ .. }}`"),
        ),
    };
    Some(scalar.unwrap_or_else(|| Ident::new("AnyScalar", Span::call_site())))
}

fn check_scalar(name: &Ident, scalar: &Ident, errors: &mut Errors) -> Option<()> {
    check_name(scalar, "a scalar", errors)?;
    let message = if TYPES.contains(&&*scalar.to_string()) {
        format!(
            "a parameter stands here, not a type: write `{name}::<T> {{ .. }}`, and \
             `{name}::<{scalar}>` where the body is used"
        )
    } else if scalar == name {
        format!("`{name}` is the body: give its scalar another name")
    } else {
        return Some(());
    };
    errors.report(scalar.span(), message)
}
