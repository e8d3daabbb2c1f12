//! The driver: one call for each phase.

use proc_macro2::TokenStream;

use crate::errors::Errors;
use crate::mechanics::{derive_equations, with_potentials};
use crate::range::check_range;
use crate::{emit, lower, syntax};

/// Expands `(runtime) Name { key: value, .. }`.
pub fn expand(tokens: TokenStream) -> TokenStream {
    let mut errors = Errors::default();
    let Some(description) = syntax::parse_description(tokens, &mut errors) else {
        return errors.finish().unwrap_or_default();
    };
    let mut outline = lower::outline(&description, &mut errors);
    let model = lower::lower_description(&description, &mut outline, &mut errors);
    // what is wrong with a sound description: rank, solvability, range
    let solved = model
        .filter(|_| errors.is_empty())
        .and_then(|(model, mut work)| {
            let model = with_potentials(model, &mut work);
            let equations = derive_equations(&model, &mut work, &mut errors)?;
            let roots = equations.finite_roots();
            check_range(&model, &mut work, &outline, &roots, &mut errors);
            Some((model, work, equations))
        });
    match (errors.finish(), solved) {
        (None, Some((model, work, equations))) => {
            emit::emit_body(&outline, &model, &work, &equations)
        }
        (mistakes, _) => {
            outline.unused.clear();
            let stub = emit::emit_stub(&outline);
            mistakes.into_iter().chain([stub]).collect()
        }
    }
}
