//! From equations to tokens. Nothing can fail here.
//!
//! The only room that names the runtime: everything goes through the path that the wrapper of the
//! macro passes, so that a renamed dependency or a re-export works.

mod batch;
mod code;
mod columns;
mod consistency;
mod constructor;
mod docs;
mod expression;
mod flow;
mod functions;
mod implementations;
mod items;
mod lints;
mod naming;
mod paths;
mod reads;
mod scalar;
mod shapes;
mod structure;
mod taylor;
mod taylor_names;
mod text;

use proc_macro2::TokenStream;
use quote::quote;

use crate::mechanics::Equations;
use crate::model::{Model, Outline, Workspace};

use constructor::Constructor;
use functions::Functions;

/// The type of a body, its parameters and inputs, and all that it implements.
pub fn emit_body(
    outline: &Outline,
    model: &Model,
    work: &Workspace,
    equations: &Equations,
) -> TokenStream {
    let meant = (model, work);
    let fields = constructor::stored_fields(outline, meant, equations);
    let functions = Functions::write(outline, meant, equations, &fields);
    let constructor = Constructor::write(outline, meant, equations, &fields);
    let documentation = docs::Documentation::write(outline, &functions, &constructor, equations);
    let items = items::emit_items(outline, &constructor, &documentation);
    let implementations = implementations::emit_implementations(outline, &functions);
    let structure = structure::emit_structure(outline, Some(&equations.structure));
    let columns = columns::emit_columns(outline, &constructor);
    let checks = items::emit_checks(outline);
    let all =
        items::with_private_fields(outline, quote!(#items #implementations #structure #columns));
    quote!(#all #checks)
}

/// The same items for a description with mistakes, so that nothing else turns red: they compile
/// and do nothing.
pub fn emit_stub(outline: &Outline) -> TokenStream {
    let constructor = Constructor::stub();
    let items = items::emit_items(outline, &constructor, &docs::Documentation::stub(outline));
    let implementations = implementations::emit_implementations(outline, &Functions::stub(outline));
    let structure = structure::emit_structure(outline, None);
    let columns = columns::emit_columns(outline, &constructor);
    let checks = items::emit_checks(outline);
    let all =
        items::with_private_fields(outline, quote!(#items #implementations #structure #columns));
    quote!(#all #checks)
}
