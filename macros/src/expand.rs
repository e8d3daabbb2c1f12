//! The driver: one call for each phase.

use proc_macro2::TokenStream;

use crate::emit::{Sound, emit_body};
use crate::errors::Errors;
use crate::mechanics::{derive_equations, describe_equations, with_potentials};
use crate::outputs::{self, derive_outputs};
use crate::range::check_range;
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
            check_range(&model, &mut work, &outline, &roots.finite, &mut errors);
            let sound = Sound {
                model,
                work,
                equations,
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
