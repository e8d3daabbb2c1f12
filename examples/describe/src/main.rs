//! Prints the description equivalent to a robot file, for copying and editing:
//!
//! ```sh
//! cargo run -p describe -- robot.urdf
//! cargo run -p describe -- robot.urdf 'locked: [finger = 20[mm]], joints: [root = free(base)]'
//! ```
//!
//! Arguments after the file are additional keys. All numbers are in SI units and
//! keep their decimals; rustfmt formats the text.

mod text;

use std::path::Path;
use std::process::ExitCode;

use mounted::errors::Errors;
use proc_macro2::{TokenStream, TokenTree};
use quote::{format_ident, quote};

/// The description equivalent to a file with additional keys, or the errors in them.
fn described(path: &Path, beside: &str) -> Result<TokenStream, Vec<String>> {
    let full = path.canonicalize();
    let full = full.map_err(|error| vec![format!("{}: {error}", path.display())])?;
    let beside: TokenStream = beside
        .parse()
        .map_err(|error| vec![format!("{beside}: {error}")])?;
    let file = full.to_string_lossy();
    let kind = path.extension().map(|kind| kind.to_string_lossy());
    let key = format_ident!(
        "{}",
        if kind.is_some_and(|kind| kind == "xml") {
            "mjcf"
        } else {
            "urdf"
        }
    );
    let name = name(path);
    let mut errors = Errors::default();
    let system = mounted::syntax::parse_system(
        quote!((::newton_euler) #name { #key: #file, #beside }),
        &mut errors,
    );
    match (errors.finish(), system) {
        (None, Some(system)) => Ok(text::system(&system)),
        (mistakes, _) => Err(strings(mistakes.unwrap_or_default())),
    }
}

/// `left-arm.urdf` is a `LeftArm`.
fn name(path: &Path) -> proc_macro2::Ident {
    let stem = path.file_stem().unwrap_or_default().to_string_lossy();
    let words = stem.split(|letter: char| !letter.is_ascii_alphanumeric());
    let words = words.filter_map(|word| {
        let (first, rest) = word.split_at_checked(1)?;
        Some(first.to_ascii_uppercase() + rest)
    });
    let name: String = words.collect();
    let is_name = name.starts_with(|first: char| first.is_ascii_alphabetic());
    format_ident!("{}", if is_name { &name } else { "Robot" })
}

/// The texts of `compile_error!` calls.
fn strings(tokens: TokenStream) -> Vec<String> {
    let mut found = Vec::new();
    for token in tokens {
        match token {
            TokenTree::Group(group) => found.extend(strings(group.stream())),
            TokenTree::Literal(literal) => {
                if let syn::Lit::Str(text) = syn::Lit::new(literal) {
                    found.push(text.value());
                }
            }
            _ => {}
        }
    }
    found
}

fn main() -> ExitCode {
    let mut arguments = std::env::args().skip(1);
    let path = arguments
        .next()
        .unwrap_or_else(|| concat!(env!("CARGO_MANIFEST_DIR"), "/../urdf_arm.urdf").to_owned());
    let beside: Vec<String> = arguments.collect();
    match described(Path::new(&path), &beside.join(", ")) {
        Ok(description) => {
            print!(
                "{}",
                text::laid_out(&format!("rigid_system!({description});"))
            );
            ExitCode::SUCCESS
        }
        Err(mistakes) => {
            for mistake in mistakes {
                eprintln!("error: {mistake}");
            }
            ExitCode::FAILURE
        }
    }
}
