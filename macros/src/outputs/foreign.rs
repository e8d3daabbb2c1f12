//! Missing derivatives of the user's Rust functions.

use crate::errors::{Errors, Extent};
use crate::model::{ForeignFunction, Outline, Workspace};
use crate::symbolic::{Foreign, Id, Node};

use super::output::{Listed, Output};

/// Reports derivatives that an output needs and that are not given, at the word that requests it.
pub fn check_output<S: Listed>(
    output: &dyn Output<S>,
    outline: &Outline,
    work: &Workspace,
    errors: &mut Errors,
) -> Option<()> {
    let Some(word) = output.offer().map(|offer| offer.word) else {
        return Some(());
    };
    let needs = format!("`{word}` differentiates");
    check_slopes(work, &output.roots(), (&needs, outline.place(word)), errors)
}

/// Reports derivatives that the equations need and that are not given, at the functions.
pub fn check_equations(work: &Workspace, roots: &[Id], errors: &mut Errors) -> Option<()> {
    let needs = "potentials, constraints and what moves joints are differentiated, here";
    check_slopes(work, roots, (needs, None), errors)
}

fn check_slopes(
    work: &Workspace,
    roots: &[Id],
    (needs, place): (&str, Option<Extent>),
    errors: &mut Errors,
) -> Option<()> {
    let mut missing: Vec<Foreign> = Vec::new();
    for id in work.graph.nodes_of(roots) {
        if let Node::Foreign(which, _) = *work.graph.node(id)
            && work.functions[which.number()].word(which).is_none()
            && !missing.contains(&which)
        {
            missing.push(which);
        }
    }
    for (number, function) in work.functions.iter().enumerate() {
        let of_it = missing.iter().filter(|which| which.number() == number);
        let of_it: Vec<Foreign> = of_it.copied().collect();
        if !of_it.is_empty() {
            let place = place.unwrap_or_else(|| function.name.span().into());
            let message = advice(function, Foreign::new(number), &of_it);
            errors.push(place, format!("{needs} {message}"));
        }
    }
    missing.is_empty().then_some(())
}

/// Which derivatives are missing, and what to write.
fn advice(function: &ForeignFunction, itself: Foreign, missing: &[Foreign]) -> String {
    let name = &function.name;
    let order = |which: &Foreign| which.orders().iter().sum::<u32>();
    let which = match missing.iter().map(order).max() {
        Some(0 | 1) | None => "",
        Some(2) => "second ",
        Some(3) => "third ",
        Some(_) => "higher ",
    };
    let derivatives = written(function, (itself, &[]), missing);
    format!(
        "`{name}`, a function of Rust whose {which}derivative is not given: write `{derivatives}` behind it"
    )
}

/// The missing derivatives together with the given ones: `.derivatives(lift_by_alpha, _)`. Since
/// the order of differentiations does not matter, each is written once, with its arguments in
/// order.
fn written(
    function: &ForeignFunction,
    (which, by): (Foreign, &[usize]),
    missing: &[Foreign],
) -> String {
    let is_within = |one: &Foreign, other: &Foreign| {
        let (one, other) = (one.orders(), other.orders());
        one.iter().zip(other).all(|(one, other)| *one <= other)
    };
    let first = by.last().copied().unwrap_or(0);
    let mut is_empty = true;
    let entries = (0..function.arguments.len()).map(|argument| {
        let next = which.by(argument);
        let is_needed = missing.iter().any(|other| is_within(&next, other));
        if argument < first || !(is_needed || function.word(next).is_some()) {
            return "_".to_owned();
        }
        is_empty = false;
        let by = [by, &[argument]].concat();
        let behind = written(function, (next, &by), missing);
        format!("{}{behind}", function.named(&by))
    });
    let entries: Vec<String> = entries.collect();
    if is_empty {
        return String::new();
    }
    format!(".derivatives({})", entries.join(", "))
}
