//! The driver: one call for each phase.

use proc_macro2::TokenStream;

use crate::checks::{Evidence, Required};
use crate::emit::items::Roots;
use crate::emit::{Sound, emit_body, emit_tracked};
use crate::errors::Errors;
use crate::mechanics::Switch;
use crate::model::{Model, Outline, System, Workspace};
use crate::outputs::{Listed, Outputs, check_equations, derive_outputs, offers, wanted};
use crate::range::Constants;
use crate::syntax::File;
use crate::{lower, syntax};

/// A correct body or system, and its requested outputs.
type Solved<S> = (Sound, Outputs<S>);

/// Expands `(runtime) Name { key: value, .. }`.
pub fn expand(tokens: TokenStream) -> TokenStream {
    let mut errors = Errors::default();
    let Some(description) = syntax::parse_description(tokens, &mut errors) else {
        return errors.finish().unwrap_or_default();
    };
    expand_body(&description, errors)
}

fn expand_body(description: &syntax::Description, mut errors: Errors) -> TokenStream {
    let (outline, model) = lower::read_body(description, &offers::<Model>(), &mut errors);
    // errors that only a well-formed description can have: ranks, solvability, ranges
    let solved = model
        .filter(|(model, _)| errors.count() == model.checks.mistakes)
        .and_then(|(model, work)| solve(&outline, model, None, work, &mut errors));
    emit(outline, solved, errors)
}

/// Expands `(runtime) Name { key: value, .. }` of a system.
pub fn expand_system(tokens: TokenStream) -> TokenStream {
    let mut errors = Errors::default();
    let Some(mut description) = syntax::parse_system(tokens.clone(), &mut errors) else {
        return errors.finish().unwrap_or_default();
    };
    if let Some(body) = syntax::parse_lone_body(&description, tokens, &mut errors) {
        return expand_body(&body, errors);
    }
    let offers = offers::<System>();
    let (outline, system) = lower::read_system(&mut description, &offers, &mut errors);
    let solved = system
        .filter(|(system, _)| errors.count() == system.checks.mistakes)
        .and_then(|(system, work)| {
            let file = description.file.as_ref();
            solve(&outline, system, file, work, &mut errors)
        });
    if errors.is_empty() && solved.is_none() {
        let message =
            "internal error: this description was rejected without an error; please report it";
        errors.push(outline.name.span(), message);
    }
    let tracked = description.file.as_ref();
    let tracked = emit_tracked(tracked.and_then(|file| file.path.as_deref()));
    let all = emit(outline, solved, errors);
    tracked.into_iter().chain([all]).collect()
}

/// The code. For an invalid description, its errors, and the same items without content.
fn emit<S: Listed>(mut outline: Outline, solved: Option<Solved<S>>, errors: Errors) -> TokenStream {
    match (errors.finish(), solved) {
        (None, Some((sound, outputs))) => {
            emit_body(&outline, Some(&sound), |site| outputs.emit(site))
        }
        (mistakes, _) => {
            outline.unused.clear();
            let stub = emit_body(&outline, None, |site| wanted::<S>(&outline).emit(site));
            mistakes.into_iter().chain([stub]).collect()
        }
    }
}

/// The content of a correct body or system, and its requested outputs; `file` is the path of the
/// file that it comes from, if any.
fn solve<S: Listed>(
    outline: &Outline,
    model: S,
    file: Option<&File>,
    mut work: Workspace,
    errors: &mut Errors,
) -> Option<Solved<S>> {
    let (model, equations) = model.derive(&mut work, errors)?;
    let equated = model.equated(outline, &equations);
    check_equations(&work, &equated.accelerations, errors)?;
    let outputs = derive_outputs(outline, &model, &mut work, &equations, errors)?;
    let mut report = model.describe(&mut work, &equations);
    if let Some(file) = file {
        let told = &file.told;
        report.lists.push(("From the file", told.read_as.clone()));
        report.skipped.extend(told.skipped.iter().cloned());
    }
    outputs.describe(outline, (&model, &work), &mut report);
    let answers = model.answers(&mut work, &equations);
    let is_checked = outline.is_constrained && !model.checks().list.is_empty();
    let constraints = is_checked.then(|| model.constraints(&mut work, &equations));
    let constraints = constraints.into_iter().flatten();
    let constraints = constraints.map(|(constraint, _)| Required {
        name: constraint.name,
        position: constraint.position,
        facing: constraint.facing,
        velocity: constraint.velocity,
    });
    let constraints: Vec<Required> = constraints.collect();
    let evidence = Evidence {
        outline,
        work: &work,
        defaults: model.defaults(),
        answers: &answers,
        constraints: &constraints,
    };
    evidence.check(model.checks(), errors);
    let roots = Roots {
        finite: [equated.accelerations.clone(), outputs.roots()].concat(),
        switches: equated.switches.iter().flat_map(Switch::roots).collect(),
        tensor: outputs.tensor(),
        properties: model.properties().to_vec(),
    };
    let bodies = model.substances(&mut work);
    let constants = Constants {
        outline,
        bodies: &bodies,
        defaults: model.defaults(),
    };
    constants.check(&mut work, &roots.finite, errors);
    let sound = Sound {
        bodies,
        work,
        equations: equated,
        report,
        roots,
    };
    Some((sound, outputs))
}
