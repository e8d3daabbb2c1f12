//! Rust's reserved words, which cannot be names.

use proc_macro2::Ident;

use crate::errors::Errors;

/// Rust's keywords of all editions, without `_`.
const KEYWORDS: [&str; 52] = [
    "abstract", "as", "async", "await", "become", "box", "break", "const", "continue", "crate",
    "do", "dyn", "else", "enum", "extern", "false", "final", "fn", "for", "gen", "if", "impl",
    "in", "let", "loop", "macro", "match", "mod", "move", "mut", "override", "priv", "pub", "ref",
    "return", "self", "Self", "static", "struct", "super", "trait", "true", "try", "type",
    "typeof", "unsafe", "unsized", "use", "virtual", "where", "while", "yield",
];

/// The error for `not`.
pub const NOT: &str = "`not` is written `!`: write `!(..)`";

/// Names with a meaning in every description.
pub const BUILT_IN: [&str; 11] = [
    "t",
    "mass",
    "G",
    "position",
    "velocity",
    "attitude",
    "angular_velocity",
    "world",
    "body",
    "PI",
    "TAU",
];

pub fn is_keyword(word: &str) -> bool {
    KEYWORDS.contains(&word)
}

/// `arm_tip` of `arm` and `tip`, at the place of the second.
pub fn joined(first: &Ident, second: &Ident) -> Ident {
    let [first, name] = [first, second].map(ToString::to_string);
    let [first, name] = [&first, &name].map(|word| word.trim_start_matches("r#"));
    Ident::new(&format!("{first}_{name}"), second.span())
}

/// Whether generated code can use `name` as it is; if not, the error is reported.
pub fn check_name(name: &Ident, what: &str, errors: &mut Errors) -> Option<()> {
    let word = name.to_string();
    let message = if let Some(plain) = word.strip_prefix("r#") {
        if is_keyword(plain) {
            return errors.keyword(name, ": choose another name");
        }
        format!("write `{plain}`, without `r#`")
    } else if word == "for" {
        "there are no loops: write each entry, and several bodies as `copies`".to_owned()
    } else if is_keyword(&word) {
        return errors.keyword(name, ": choose another name");
    } else if word == "_" {
        format!("`_` is no name: expected {what}")
    } else {
        return Some(());
    };
    errors.report(name.span(), message)
}
