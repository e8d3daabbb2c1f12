//! Missing derivatives of the user's Rust functions.

use crate::errors::{Errors, Extent};
use crate::model::{ForeignFunction, Outline, Workspace};
use crate::symbolic::{Foreign, Id, Node};

use super::output::{Listed, Output};

/// Reports the missing derivatives that an output needs, at its request.
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

/// Reports the derivatives that the equations would need, at the functions.
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
    let mut reported = Vec::new();
    for id in work.graph.reachable(roots, |_| true) {
        let Node::Foreign(which, _) = *work.graph.node(id) else {
            continue;
        };
        let function = &work.functions[which.number()];
        if function.word(which).is_some() || reported.contains(&which.number()) {
            continue;
        }
        reported.push(which.number());
        let place = place.unwrap_or_else(|| function.name.span().into());
        errors.push(place, format!("{needs} {}", missing(function, which)));
    }
    reported.is_empty().then_some(())
}

/// The missing derivative, and the remedy.
fn missing(function: &ForeignFunction, which: Foreign) -> String {
    let name = &function.name;
    if which.orders().iter().sum::<u32>() > 1 {
        return format!(
            "`{name}` twice, and of a function of Rust the first derivatives are known alone"
        );
    }
    let paths = function.arguments.iter().zip(which.orders());
    let paths: Vec<String> = paths
        .zip(&function.derivatives)
        .map(|(((argument, ..), order), given)| match (order, given) {
            (0, None) => "_".to_owned(),
            _ => format!("{name}_by_{argument}"),
        })
        .collect();
    format!(
        "`{name}`, a function of Rust whose derivative is not given: write `.derivatives({})` behind it",
        paths.join(", ")
    )
}
