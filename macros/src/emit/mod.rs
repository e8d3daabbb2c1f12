//! From equations to tokens. Nothing can fail here.
//!
//! Besides the outputs and the words for editors, this is the only room that names the runtime.
//! Everything goes through the path that the wrapper macro passes, so a renamed dependency or a
//! re-export works.

pub mod code;
pub mod items;
mod page;
pub mod series;

use proc_macro2::TokenStream;
use quote::quote;

use crate::mechanics::Report;
use crate::model::{Outline, Substance, Workspace};
use code::{Site, Writer};
use items::{Addition, Constructor, Documentation, Equated, Roots};

/// What a correct description has beyond its outline.
pub struct Sound {
    /// The bodies whose mass and inertia the constructor checks.
    pub bodies: Vec<Substance>,
    pub work: Workspace,
    pub equations: Equated,
    pub report: Report,
    pub roots: Roots,
}

/// Makes a build depend on a file that the description reads.
pub fn emit_tracked(path: Option<&str>) -> Option<TokenStream> {
    path.map(|path| {
        quote!(
            const _: &[u8] = ::core::include_bytes!(#path);
        )
    })
}

/// The type of a body, its parameters and inputs, and all its implementations; `add` writes the
/// requested outputs. An invalid description gets the same items without content, so that nothing
/// else reports an error.
pub fn emit_body(
    outline: &Outline,
    sound: Option<&Sound>,
    add: impl FnOnce(&Site<'_>) -> Addition,
) -> TokenStream {
    let fields = sound.map(|sound| items::stored_fields(outline, &sound.work, &sound.roots));
    let fields = fields.unwrap_or_default();
    let writer = sound.map(|sound| Writer::new(outline, &sound.work, &fields));
    let site = Site::new(outline, writer);
    let equations = sound.map(|sound| &sound.equations);
    let acceleration = items::write_acceleration(&site, equations);
    let addition = add(&site);
    let (constructor, documentation) = match sound {
        None => (Constructor::stub(outline), Documentation::stub(outline)),
        Some(sound) => {
            let built =
                Constructor::write(outline, (&sound.bodies, &sound.work), &sound.roots, &fields);
            let report = &sound.report;
            let said = Documentation::write(outline, &acceleration, &built, report, &addition);
            (built, said)
        }
    };
    let items = items::emit_items(outline, &constructor, &documentation);
    let bodies = sound.map_or(&[][..], |sound| &sound.bodies);
    let rigid_body = items::emit_rigid_body(&site, &acceleration, equations, bodies);
    let integrate = items::emit_integrate(&site, addition.best);
    let added = &addition.implementations;
    let columns = items::emit_columns(outline, &constructor);
    let unused = items::emit_unused(outline);
    let all = quote!(#items #rigid_body #integrate #added #columns);
    let all = items::with_private_fields(outline, all, &addition.structs);
    let foreign = sound.map(|sound| items::emit_foreign(outline, &sound.work));
    let files = sound.iter().flat_map(|sound| &sound.work.files);
    let files = files.map(|path| emit_tracked(Some(path)));
    quote!(#all #foreign #unused #(#files)*)
}
