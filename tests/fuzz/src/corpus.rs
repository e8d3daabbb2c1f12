//! Every description in the sources of the repository: those of tests, examples and benchmarks, and
//! the invalid ones.

use std::fs;
use std::path::{Path, PathBuf};

use proc_macro2::{Delimiter, Ident, TokenStream, TokenTree};

use crate::flat::{Token, flatten};

/// Descriptions of up to so many tokens; longer ones stand for a size, and take their time.
const TOKENS: usize = 600;

/// The descriptions, each once, in the order of their files.
#[must_use]
pub fn descriptions() -> Vec<Vec<Token>> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let mut found = Vec::new();
    let mut seen = std::collections::HashSet::new();
    for folder in ["examples", "tests", "benches"] {
        for file in sources(&root.join(folder)) {
            let text = fs::read_to_string(&file).expect("a readable source");
            let parsed = syn::parse_file(&text);
            let parsed = parsed.unwrap_or_else(|error| panic!("{}: {error}", file.display()));
            collect(quote::quote!(#parsed), &mut |description| {
                let flat = flatten(description.clone());
                if flat.len() <= TOKENS && seen.insert(description.to_string()) {
                    found.push(flat);
                }
            });
        }
    }
    assert!(found.len() > 400, "only {} descriptions", found.len());
    found
}

/// Whether this is the description of a system, or was one: it lists bodies or joints.
#[must_use]
pub fn is_system(tokens: &[Token]) -> bool {
    let is_list = |word: &Ident| word == "bodies" || word == "joints";
    tokens
        .iter()
        .any(|token| matches!(token, Token::Leaf(TokenTree::Ident(word)) if is_list(word)))
}

/// The sources in a folder and below, in order.
fn sources(folder: &Path) -> Vec<PathBuf> {
    let entries = fs::read_dir(folder).expect("a readable folder");
    let mut paths: Vec<PathBuf> = entries
        .map(|entry| entry.expect("an entry").path())
        .collect();
    paths.sort();
    let mut files = Vec::new();
    for path in paths {
        let is_built = path.ends_with("target") || path.ends_with("peers");
        if path.is_dir() && !is_built {
            files.extend(sources(&path));
        } else if path.extension().is_some_and(|end| end == "rs") {
            files.push(path);
        }
    }
    files
}

/// Shows what follows `rigid_body!` and `rigid_system!`, and each `Name { .. }` that a `quote!` holds alone.
fn collect(stream: TokenStream, show: &mut impl FnMut(&TokenStream)) {
    let tokens: Vec<TokenTree> = stream.into_iter().collect();
    for (index, token) in tokens.iter().enumerate() {
        let TokenTree::Group(group) = token else {
            continue;
        };
        let is_call = |name: &str| match &tokens[..index] {
            [.., TokenTree::Ident(word), TokenTree::Punct(bang)] => {
                word == name && bang.as_char() == '!'
            }
            _ => false,
        };
        let is_described = is_call("rigid_body") || is_call("rigid_system");
        if is_described || is_call("quote") && is_description(&group.stream()) {
            show(&group.stream());
        }
        collect(group.stream(), show);
    }
}

/// `Name { key: .. }`
fn is_description(stream: &TokenStream) -> bool {
    let tokens: Vec<TokenTree> = stream.clone().into_iter().collect();
    let [TokenTree::Ident(name), .., TokenTree::Group(body)] = tokens.as_slice() else {
        return false;
    };
    body.delimiter() == Delimiter::Brace && starts_with_key(&body.stream()) && is_type(name)
}

fn starts_with_key(stream: &TokenStream) -> bool {
    let mut tokens = stream.clone().into_iter();
    let key = tokens.next();
    let colon = tokens.next();
    matches!((key, colon), (Some(TokenTree::Ident(_)), Some(TokenTree::Punct(sign))) if sign.as_char() == ':')
}

fn is_type(name: &Ident) -> bool {
    name.to_string().starts_with(char::is_uppercase)
}
