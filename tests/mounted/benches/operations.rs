//! The operation counts of all functions of all descriptions in tests, examples and benchmarks, one
//! per line. A change of the compiler is compared with the version before it:
//!
//! ```sh
//! cargo test -p mounted --bench operations > after.txt
//! diff before.txt after.txt
//! ```

#[path = "../../compiler/from_root.rs"]
mod from_root;

use std::fs;
use std::path::{Path, PathBuf};

use from_root::{from_root, repository};
use proc_macro2::{TokenStream, TokenTree};
use quote::quote;
use syn::visit::Visit;

/// The descriptions in a file, each with whether it is a system.
#[derive(Default)]
struct Descriptions(Vec<(bool, TokenStream)>);

impl<'a> Visit<'a> for Descriptions {
    fn visit_macro(&mut self, call: &'a syn::Macro) {
        let name = call.path.segments.last().map(|last| last.ident.to_string());
        let is_system = match name.as_deref() {
            Some("rigid_body") => false,
            Some("rigid_system") => true,
            _ => return,
        };
        self.0.push((is_system, call.tokens.clone()));
    }
}

fn expansion(is_system: bool, description: &TokenStream) -> String {
    let description = quote!((::newton_euler) #description);
    let expansion = if is_system {
        mounted::expand::expand_system(description)
    } else {
        mounted::expand::expand(description)
    };
    expansion.to_string()
}

/// The functions of an expansion, each with its counts as they are written there.
fn counts(expansion: &str) -> impl Iterator<Item = (&str, &str)> {
    expansion.split("Operations :: ").filter_map(|part| {
        let (head, rest) = part.split_once('[')?;
        let (counts, _) = rest.split_once(']')?;
        let function = head.split('"').nth(1)?;
        let is_one = head.starts_with("state") || head.starts_with("parameter");
        is_one.then_some((function, counts))
    })
}

fn sources(folder: &Path) -> Vec<PathBuf> {
    let entries = fs::read_dir(folder).expect("a readable folder");
    let mut paths: Vec<PathBuf> = entries.map(|entry| entry.unwrap().path()).collect();
    paths.sort();
    let files = paths.into_iter().flat_map(|path| {
        if path.is_dir() {
            let is_left_out = path.ends_with("compile_fail") || path.ends_with("target");
            if is_left_out {
                Vec::new()
            } else {
                sources(&path)
            }
        } else {
            vec![path]
        }
    });
    files
        .filter(|path| path.extension().is_some_and(|end| end == "rs"))
        .collect()
}

fn main() {
    std::env::set_current_dir(repository()).expect("the repository");
    for file in ["tests", "examples", "benches"]
        .map(Path::new)
        .into_iter()
        .flat_map(sources)
    {
        let source = fs::read_to_string(&file).expect("a readable source");
        let Ok(syntax) = syn::parse_file(&source) else {
            continue;
        };
        let mut descriptions = Descriptions::default();
        descriptions.visit_file(&syntax);
        for (is_system, description) in descriptions.0 {
            let Some(TokenTree::Ident(name)) = description.clone().into_iter().next() else {
                continue;
            };
            let description = from_root(description);
            for (function, counts) in counts(&expansion(is_system, &description)) {
                println!("{} {name} {function} {counts}", file.display());
            }
        }
    }
}
