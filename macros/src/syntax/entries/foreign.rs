//! Rust items of the user: `constants: [area = crate::AREA[m ^ 2]]`, and
//! `functions: [lift(alpha) = curves::lift[N].derivatives(curves::lift_by_alpha)]`.

use proc_macro2::{Delimiter, Group, Ident, TokenStream, TokenTree};

use crate::errors::{Errors, Extent, every};

use crate::syntax::Description;
use crate::syntax::tokens::{Entry, after_sign, is_punct, split, start, stream};
use crate::syntax::unit::UnitExpression;
use crate::syntax::words::check_name;

/// The most arguments of a function.
const ARGUMENTS: usize = 3;
/// The highest order of derivatives of a function.
const MOST: usize = 4;
const FORM: &str = "`lift(alpha) = crate::lift[N]`, its unit in brackets, or with derivatives \
                    `lift(alpha) = crate::lift[N].derivatives(crate::lift_by_alpha)`";

/// `name = value[unit]`
#[derive(Clone)]
pub struct Constant {
    pub name: Ident,
    /// A Rust expression; `None` if it could not be read, which is reported.
    pub value: Option<TokenStream>,
    pub unit: Option<UnitExpression>,
}

/// `name(argument[unit], ..) = path[unit].derivatives(path.derivatives(path, _), _)`
#[derive(Clone)]
pub struct Function {
    pub name: Ident,
    pub arguments: Vec<(Ident, Option<UnitExpression>)>,
    pub unit: Option<UnitExpression>,
    /// The paths of the function and of its derivatives. Each comes with the arguments that it is
    /// differentiated with respect to, in order.
    pub paths: Vec<(Vec<usize>, TokenStream)>,
}

/// The value after the name of a constant.
pub fn parse_constant(name: Ident, rest: &[TokenTree], errors: &mut Errors) -> Constant {
    let read = value_of_constant(&name, rest, errors);
    let (value, unit) = read.map_or((None, None), |(value, unit)| (Some(value), unit));
    Constant { name, value, unit }
}

fn value_of_constant(
    name: &Ident,
    rest: &[TokenTree],
    errors: &mut Errors,
) -> Option<(TokenStream, Option<UnitExpression>)> {
    if let [TokenTree::Group(unit), sign, ..] = rest
        && unit.delimiter() == Delimiter::Bracket
        && is_punct(sign, '=')
    {
        let unit_text = unit.stream();
        let message = format!("a unit follows its value: write `{name} = ..[{unit_text}]`");
        return errors.report(unit.span(), message);
    }
    let example = format!(
        "write `{name} = crate::{}`",
        name.to_string().to_uppercase()
    );
    let value = after_sign(rest, '=').map_or(&[][..], |(_, value)| value);
    let (value, unit) = with_unit(value, errors)?;
    if let [TokenTree::Literal(number)] = value {
        let message = format!(
            "`{number}` is no constant of Rust: write the number where it is used, or as a param or a local"
        );
        return errors.report(number.span(), message);
    }
    if value.is_empty() {
        return errors.report(name.span(), format!("`{name}` has no value: {example}"));
    }
    let value = stream(value);
    if syn::parse2::<syn::Expr>(value.clone()).is_err() {
        let message = format!("expected an expression of Rust that is an `f64`: {example}");
        return errors.report(Extent::of(value), message);
    }
    Some((value, unit))
}

/// Reads an entry of `functions`. A malformed entry is dropped, and its name counts as lost.
pub fn parse_function(into: &mut Description, entry: &[TokenTree], errors: &mut Errors) {
    let [TokenTree::Ident(name), rest @ ..] = entry else {
        if let Some(first) = entry.first() {
            errors.push(start(first), format!("expected a function: write {FORM}"));
        }
        return;
    };
    let is_name = check_name(name, "the name of a function", errors).is_some();
    match is_name.then(|| function(name, rest, errors)).flatten() {
        Some(function) => into.functions.push(function),
        None => into
            .lost
            .push(name.to_string().trim_start_matches("r#").to_owned()),
    }
}

fn function(name: &Ident, rest: &[TokenTree], errors: &mut Errors) -> Option<Function> {
    let [TokenTree::Group(list), rest @ ..] = rest else {
        let place = rest.first().map_or(name.span(), start);
        let message = format!("a function has its arguments in parentheses: write {FORM}");
        return errors.report(place, message);
    };
    if list.delimiter() != Delimiter::Parenthesis {
        let message = format!("a function has its arguments in parentheses: write {FORM}");
        return errors.report(list.span_open(), message);
    }
    let arguments = arguments(name, list, errors);
    let Some((_, value)) = after_sign(rest, '=') else {
        let place = rest.first().map_or(name.span(), start);
        return errors.report(
            place,
            format!("expected the path of a function: write {FORM}"),
        );
    };
    let (value, derivatives) = with_derivatives(value, errors)?;
    let value = with_unit(value, errors);
    let arguments = arguments?;
    let mut paths = Vec::new();
    let derivatives = derivatives.map_or(Some(()), |list| {
        slopes(&list, (arguments.len(), &[]), &mut paths, errors)
    });
    let (path, unit) = value?;
    if path.is_empty() {
        let message = format!("`{name}` has no value: write {FORM}");
        return errors.report(name.span(), message);
    }
    paths.insert(0, (Vec::new(), path_of(path, errors)?));
    derivatives?;
    Some(Function {
        name: name.clone(),
        arguments,
        unit,
        paths,
    })
}

/// `(speed[m / s], throttle)`
fn arguments(
    name: &Ident,
    list: &Group,
    errors: &mut Errors,
) -> Option<Vec<(Ident, Option<UnitExpression>)>> {
    let entries = split(list.stream(), Entry::Defined, errors);
    if entries.is_empty() {
        let message = "a function needs an argument: declare a value without one in `constants`";
        return errors.report(list.span_open(), message);
    }
    if let Some(first) = entries.get(ARGUMENTS).and_then(|entry| entry.first()) {
        let message = format!("`{name}` has more than {ARGUMENTS} arguments");
        return errors.report(start(first), message);
    }
    let mut seen: Vec<Ident> = Vec::new();
    every(entries.iter().map(|entry| {
        let (argument, unit) = match &entry[..] {
            [TokenTree::Ident(argument)] => (argument, None),
            [TokenTree::Ident(argument), TokenTree::Group(unit)]
                if unit.delimiter() == Delimiter::Bracket =>
            {
                (argument, Some(UnitExpression::parse(unit, errors)?))
            }
            other => {
                let message = "an argument is a name, or a name with a unit: write `speed[m / s]`";
                return errors.report(Extent::of(stream(other)), message);
            }
        };
        check_name(argument, "the name of an argument", errors)?;
        if seen.contains(argument) {
            let message = format!("there is an argument `{argument}` already");
            return errors.report(argument.span(), message);
        }
        seen.push(argument.clone());
        Some((argument.clone(), unit))
    }))
}

/// What follows a path: the word `derivatives`, and the list after it.
type Behind<'t> = (&'t Ident, &'t Group);

/// Takes `.derivatives(..)` off the end.
fn with_derivatives<'t>(
    value: &'t [TokenTree],
    errors: &mut Errors,
) -> Option<(&'t [TokenTree], Option<Behind<'t>>)> {
    match value {
        [
            value @ ..,
            dot,
            TokenTree::Ident(word),
            TokenTree::Group(list),
        ] if is_punct(dot, '.') && list.delimiter() == Delimiter::Parenthesis => {
            if word != "derivatives" {
                let message = "only `.derivatives(..)` may follow the path of a function, with a path for each argument";
                return errors.report(word.span(), message);
            }
            Some((value, Some((word, list))))
        }
        _ => Some((value, None)),
    }
}

/// `.derivatives(path, _)` of a function with `count` arguments that has been differentiated with
/// respect to the arguments `by`. A path may have derivatives of its own.
fn slopes(
    (word, list): &Behind<'_>,
    (count, by): (usize, &[usize]),
    paths: &mut Vec<(Vec<usize>, TokenStream)>,
    errors: &mut Errors,
) -> Option<()> {
    let entries = split(list.stream(), Entry::Defined, errors);
    if entries.len() != count {
        let message = format!(
            "a derivative for each argument, `_` where none is given: there are {count}, and these are {}",
            entries.len()
        );
        return errors.report(word.span(), message);
    }
    if by.len() == MOST {
        let message = format!("derivatives are given up to the order {MOST}");
        return errors.report(word.span(), message);
    }
    let each = entries.iter().enumerate().map(|(argument, entry)| {
        let by = [by, &[argument]].concat();
        let (path, behind) = match &entry[..] {
            [TokenTree::Ident(open)] if open == "_" => return Some(()),
            path => with_derivatives(path, errors)?,
        };
        paths.push((by.clone(), path_of(path, errors)?));
        match behind {
            Some(list) => slopes(&list, (count, &by), paths, errors),
            None => Some(()),
        }
    });
    every(each).map(|_: Vec<()>| ())
}

fn path_of(tokens: &[TokenTree], errors: &mut Errors) -> Option<TokenStream> {
    let path = stream(tokens);
    if syn::parse2::<syn::ExprPath>(path.clone()).is_ok() {
        return Some(path);
    }
    let message = "expected the path of a function, such as `crate::lift`";
    errors.report(Extent::of(path), message)
}

/// The unit in brackets at the end.
fn with_unit<'t>(
    value: &'t [TokenTree],
    errors: &mut Errors,
) -> Option<(&'t [TokenTree], Option<UnitExpression>)> {
    match value {
        [value @ .., TokenTree::Group(unit)]
            if unit.delimiter() == Delimiter::Bracket && !value.is_empty() =>
        {
            Some((value, Some(UnitExpression::parse(unit, errors)?)))
        }
        _ => Some((value, None)),
    }
}
