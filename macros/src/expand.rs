//! The driver: one call for each phase.

use proc_macro2::TokenStream;

use crate::emit::code::Shapes;
use crate::emit::items::{Equated, Roots};
use crate::emit::{Sound, emit_body, emit_tracked};
use crate::errors::Errors;
use crate::mechanics::{
    Switch, derive_equations, derive_system, describe_equations, describe_system, with_potentials,
};
use crate::model::{Outline, System, Workspace};
use crate::outputs::{self, SystemOutputs, derive_outputs, derive_system_outputs, system_offers};
use crate::range::check_range;
use crate::syntax::File;
use crate::{lower, syntax};

/// Expands `(runtime) Name { key: value, .. }`.
pub fn expand(tokens: TokenStream) -> TokenStream {
    let mut errors = Errors::default();
    let Some(description) = syntax::parse_description(tokens, &mut errors) else {
        return errors.finish().unwrap_or_default();
    };
    let mut outline = lower::outline(&description, &outputs::offers(), &mut errors);
    let model = lower::lower_description(&description, &mut outline, &mut errors);
    // what is wrong with a sound description: rank, solvability, range
    let solved = model
        .filter(|_| errors.is_empty())
        .and_then(|(model, mut work)| {
            let model = with_potentials(model, &mut work);
            let equations = derive_equations(&model, &mut work, &mut errors)?;
            let outputs = derive_outputs(&outline, &model, &mut work, &equations, &mut errors)?;
            let mut report = describe_equations(&model, &mut work, &equations);
            outputs.describe(&outline, (&model, &work), &mut report);
            let roots = outputs.roots(&equations);
            let bodies = vec![model.substance()];
            check_range(
                (&bodies, &model.defaults),
                &mut work,
                &outline,
                &roots.finite,
                &mut errors,
            );
            let sound = Sound {
                bodies,
                equations: Equated {
                    accelerations: Shapes::of(&outline).pair_part(&equations.accelerations),
                    switches: equations.switches,
                    partial: equations.partial,
                },
                work,
                report,
                roots,
            };
            Some((sound, outputs))
        });
    match (errors.finish(), solved) {
        (None, Some((sound, outputs))) => {
            emit_body(&outline, Some(&sound), |site| outputs.emit(site))
        }
        (mistakes, _) => {
            outline.unused.clear();
            let stub = emit_body(&outline, None, |site| outputs::wanted(&outline).emit(site));
            mistakes.into_iter().chain([stub]).collect()
        }
    }
}

/// Expands `(runtime) Name { key: value, .. }` of a system.
pub fn expand_system(tokens: TokenStream) -> TokenStream {
    let mut errors = Errors::default();
    let Some(description) = syntax::parse_system(tokens, &mut errors) else {
        return errors.finish().unwrap_or_default();
    };
    let mut outline = lower::outline(&description.top, &system_offers(), &mut errors);
    lower::outline_system(&description, &mut outline);
    let system = lower::lower_system(&description, &mut outline, &mut errors);
    let solved = system
        .filter(|_| errors.is_empty())
        .and_then(|(system, work)| {
            solve_system(
                &outline,
                &system,
                description.file.as_ref(),
                work,
                &mut errors,
            )
        });
    if errors.is_empty() && solved.is_none() {
        let message = "no meaning was found for this description, and no mistake in it either";
        errors.push(outline.name.span(), message);
    }
    let tracked = description
        .file
        .as_ref()
        .and_then(|file| file.path.as_deref());
    let tracked = emit_tracked(tracked);
    match (errors.finish(), solved) {
        (None, Some((sound, outputs))) => {
            let all = emit_body(&outline, Some(&sound), |site| outputs.emit(site, true));
            tracked.into_iter().chain([all]).collect()
        }
        (mistakes, _) => {
            outline.unused.clear();
            let none = SystemOutputs::default();
            let stub = emit_body(&outline, None, |site| none.emit(site, false));
            mistakes.into_iter().chain(tracked).chain([stub]).collect()
        }
    }
}

/// What a system without mistakes has, and what it is asked for.
fn solve_system(
    outline: &Outline,
    system: &System,
    file: Option<&File>,
    mut work: Workspace,
    errors: &mut Errors,
) -> Option<(Sound, SystemOutputs)> {
    let equations = derive_system(system, &mut work);
    let outputs = derive_system_outputs(outline, system, &mut work, &equations, errors)?;
    let bodies = system.substances();
    // the state has the joints as they are written, the tree each after its carrier
    let accelerations = outline.joints.iter().filter_map(|known| {
        let mut joints = system.joints.iter();
        let place = joints.position(|joint| joint.name == known.name)?;
        Some(equations.accelerations[place].clone())
    });
    let accelerations: Vec<_> = accelerations.flatten().collect();
    let mut report = describe_system(system, &work, &equations);
    if let Some(file) = file {
        let told = &file.told;
        report.lists.push(("From the file", told.read_as.clone()));
        report.skipped.extend(told.skipped.iter().cloned());
    }
    outputs.describe(outline, &mut report);
    let finite = accelerations.iter().copied().chain(outputs.roots());
    let roots = Roots {
        finite: finite.collect(),
        switches: equations.switches.iter().flat_map(Switch::roots).collect(),
        tensor: None,
    };
    let known = (&bodies[..], &system.defaults);
    check_range(known, &mut work, outline, &roots.finite, errors);
    let sound = Sound {
        bodies,
        equations: Equated {
            accelerations,
            switches: equations.switches,
            partial: equations.partial,
        },
        work,
        report,
        roots,
    };
    Some((sound, outputs))
}
