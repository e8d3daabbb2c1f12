//! Descriptions that name files, as they stand in programs of the repository.

use std::path::{Path, PathBuf};

use proc_macro2::{Group, Literal, TokenStream, TokenTree};

pub fn repository() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}

/// The description with whole paths. Without, they begin at the package that is built.
pub fn from_root(description: TokenStream) -> TokenStream {
    let tokens = description.into_iter().map(|token| match token {
        TokenTree::Group(group) => {
            let inner = from_root(group.stream());
            TokenTree::Group(Group::new(group.delimiter(), inner))
        }
        TokenTree::Literal(literal) => TokenTree::Literal(whole_path(&literal).unwrap_or(literal)),
        other => other,
    });
    tokens.collect()
}

fn whole_path(literal: &Literal) -> Option<Literal> {
    let text = literal.to_string();
    let name = text.strip_prefix('"')?.strip_suffix('"')?;
    let path = repository().join(name);
    let is_file = path.extension().is_some() && path.is_file();
    is_file.then(|| Literal::string(&path.to_string_lossy()))
}
