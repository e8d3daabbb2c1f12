//! Names in generated code beside those of the user.

use std::collections::HashSet;

use proc_macro2::{Ident, Span};

/// The field of principal axes.
pub const PRINCIPAL_AXES: &str = "principal_axes";

/// A local of generated code: it does not see, and is not seen by, the names of the user.
pub fn local(name: &str) -> Ident {
    Ident::new(name, Span::mixed_site())
}

/// The name of a local after a name of the user's: in lower case, since a pattern `J` or `Some`
/// would mean a constant, if there is one; and no keyword, which `Box` would become.
pub fn local_name(name: &str) -> String {
    let name = name.to_lowercase();
    let is_word = name.bytes().all(|byte| byte.is_ascii_lowercase());
    if !is_word || syn::parse_str::<Ident>(&name).is_ok() {
        name
    } else {
        name + "_"
    }
}

/// A name that no other local has.
pub fn unique(taken: &mut HashSet<String>, wanted: &str) -> Ident {
    let wanted = local_name(wanted);
    let (mut name, mut suffix) = (wanted.clone(), 0);
    while !taken.insert(name.clone()) {
        suffix += 1;
        name = format!("{wanted}_{suffix}");
    }
    local(&name)
}
