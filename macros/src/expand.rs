//! The driver: one call for each phase.

use proc_macro2::TokenStream;

use crate::emit::code::Shapes;
use crate::emit::items::{Equated, Roots};
use crate::emit::{Sound, emit_body, emit_tracked};
use crate::errors::Errors;
use crate::mechanics::{
    Switch, check_followers, derive_equations, derive_system, describe_equations, describe_system,
    with_potentials, with_system_potentials,
};
use crate::model::{Model, Outline, System, Workspace};
use crate::outputs::{Listed, Outputs, derive_outputs, offers, wanted};
use crate::range::check_range;
use crate::syntax::File;
use crate::{lower, syntax};

/// A body or a system without mistakes, and what it is asked for.
type Solved<S> = (Sound, Outputs<S>);

/// Expands `(runtime) Name { key: value, .. }`.
pub fn expand(tokens: TokenStream) -> TokenStream {
    let mut errors = Errors::default();
    let Some(description) = syntax::parse_description(tokens, &mut errors) else {
        return errors.finish().unwrap_or_default();
    };
    let mut outline = lower::outline(&description, &offers::<Model>(), &mut errors);
    let model = lower::lower_description(&description, &mut outline, &mut errors);
    // what is wrong with a sound description: rank, solvability, range
    let solved = model
        .filter(|_| errors.is_empty())
        .and_then(|(model, work)| solve_body(&outline, model, work, &mut errors));
    emit(outline, solved, errors)
}

/// Expands `(runtime) Name { key: value, .. }` of a system.
pub fn expand_system(tokens: TokenStream) -> TokenStream {
    let mut errors = Errors::default();
    let Some(description) = syntax::parse_system(tokens, &mut errors) else {
        return errors.finish().unwrap_or_default();
    };
    let mut outline = lower::outline(&description.top, &offers::<System>(), &mut errors);
    lower::outline_system(&description, &mut outline);
    let system = lower::lower_system(&description, &mut outline, &mut errors);
    let solved = system
        .filter(|_| errors.is_empty())
        .and_then(|(system, work)| {
            let file = description.file.as_ref();
            solve_system(&outline, system, file, work, &mut errors)
        });
    if errors.is_empty() && solved.is_none() {
        let message = "no meaning was found for this description, and no mistake in it either";
        errors.push(outline.name.span(), message);
    }
    let tracked = description.file.as_ref();
    let tracked = emit_tracked(tracked.and_then(|file| file.path.as_deref()));
    let all = emit(outline, solved, errors);
    tracked.into_iter().chain([all]).collect()
}

/// The code; of a description with mistakes, these and the same items without content.
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

/// What a body without mistakes has, and what it is asked for.
fn solve_body(
    outline: &Outline,
    model: Model,
    mut work: Workspace,
    errors: &mut Errors,
) -> Option<Solved<Model>> {
    let model = with_potentials(model, &mut work);
    let equations = derive_equations(&model, &mut work, errors)?;
    let outputs = derive_outputs(outline, &model, &mut work, &equations, errors)?;
    let mut report = describe_equations(&model, &mut work, &equations);
    outputs.describe(outline, (&model, &work), &mut report);
    let roots = Roots {
        finite: [equations.accelerations.entries(), outputs.roots()].concat(),
        switches: equations.switches.iter().flat_map(Switch::roots).collect(),
        tensor: outputs.tensor(),
    };
    let bodies = vec![model.substance()];
    let known = (&bodies[..], &model.defaults);
    check_range(known, &mut work, outline, &roots.finite, errors);
    let equations = Equated {
        accelerations: Shapes::of(outline).pair_part(&equations.accelerations),
        switches: equations.switches,
        partial: equations.partial,
    };
    let sound = Sound {
        bodies,
        work,
        equations,
        report,
        roots,
    };
    Some((sound, outputs))
}

/// What a system without mistakes has, and what it is asked for.
fn solve_system(
    outline: &Outline,
    system: System,
    file: Option<&File>,
    mut work: Workspace,
    errors: &mut Errors,
) -> Option<Solved<System>> {
    check_followers(&system, &mut work, errors)?;
    let system = &with_system_potentials(system, &mut work);
    let equations = derive_system(system, &mut work);
    equations.check(system, errors)?;
    let outputs = derive_outputs(outline, system, &mut work, &equations, errors)?;
    let mut report = describe_system(system, &work, &equations);
    if let Some(file) = file {
        let told = &file.told;
        report.lists.push(("From the file", told.read_as.clone()));
        report.skipped.extend(told.skipped.iter().cloned());
    }
    outputs.describe(outline, (system, &work), &mut report);
    // the state has the joints as they are written, the tree each after its carrier
    let written = system.written.iter();
    let accelerations = written.flat_map(|joint| equations.accelerations[*joint].clone());
    let accelerations: Vec<_> = accelerations.collect();
    let roots = Roots {
        finite: [accelerations.clone(), outputs.roots()].concat(),
        switches: equations.switches.iter().flat_map(Switch::roots).collect(),
        tensor: outputs.tensor(),
    };
    let bodies = system.substances();
    let known = (&bodies[..], &system.defaults);
    check_range(known, &mut work, outline, &roots.finite, errors);
    let equations = Equated {
        accelerations,
        switches: equations.switches,
        partial: equations.partial,
    };
    let sound = Sound {
        bodies,
        work,
        equations,
        report,
        roots,
    };
    Some((sound, outputs))
}
