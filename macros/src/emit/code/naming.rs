//! Names in generated code other than those of the user.

use std::collections::HashMap;

use proc_macro2::{Ident, Span};

/// The name of the field for principal axes.
pub const PRINCIPAL_AXES: &str = "principal_axes";

/// The name of the associated function that wraps a Rust item of the user.
pub fn given(word: &str) -> Ident {
    Ident::new(&format!("given_{word}"), Span::call_site())
}

/// A local of generated code; hygiene separates it from the names of the user.
pub fn local(name: &str) -> Ident {
    Ident::new(name, Span::mixed_site())
}

/// The name of a local variable for a user's name. It is in lower case, because a pattern `J` or
/// `Some` could match a constant, and it is no keyword, which `Box` would become.
pub fn local_name(name: &str) -> String {
    let name = name.to_lowercase();
    let is_word = name.bytes().all(|byte| byte.is_ascii_lowercase());
    if !is_word || syn::parse_str::<Ident>(&name).is_ok() {
        name
    } else {
        name + "_"
    }
}

/// The names of local variables.
#[derive(Default)]
pub struct Names {
    /// For each name that is taken, the last number that was appended to it.
    taken: HashMap<String, u32>,
}

impl Names {
    /// A name that no other local has.
    pub fn unique(&mut self, wanted: &str) -> Ident {
        let wanted = local_name(wanted);
        let Some(mut suffix) = self.taken.get(&wanted).copied() else {
            self.taken.insert(wanted.clone(), 0);
            return local(&wanted);
        };
        let name = loop {
            suffix += 1;
            let name = format!("{wanted}_{suffix}");
            if !self.taken.contains_key(&name) {
                break name;
            }
        };
        self.taken.insert(name.clone(), 0);
        self.taken.insert(wanted, suffix);
        local(&name)
    }
}

impl<S: Into<String>> Extend<S> for Names {
    fn extend<I: IntoIterator<Item = S>>(&mut self, names: I) {
        for name in names {
            self.taken.entry(name.into()).or_default();
        }
    }
}

impl<S: Into<String>> FromIterator<S> for Names {
    fn from_iter<I: IntoIterator<Item = S>>(names: I) -> Self {
        let mut all = Self::default();
        all.extend(names);
        all
    }
}
