//! The words that editors know are those of the compiler. `check.py`, next to this file, asks an
//! editor for them.

use std::collections::BTreeSet;
use std::fs;
use std::path::Path;

use proc_macro2::{TokenStream, TokenTree};

type Words = BTreeSet<String>;

fn tokens(path: &str) -> Vec<TokenTree> {
    let path = Path::new(env!("CARGO_MANIFEST_DIR"))
        .join("../..")
        .join(path);
    let source = fs::read_to_string(&path).expect("a readable source");
    let tokens: TokenStream = source.parse().expect("tokens of Rust");
    tokens.into_iter().collect()
}

/// All tokens, those in brackets after the bracket.
fn flat(tokens: impl IntoIterator<Item = TokenTree>) -> Vec<TokenTree> {
    let mut all = Vec::new();
    for token in tokens {
        all.push(token.clone());
        if let TokenTree::Group(group) = token {
            all.extend(flat(group.stream()));
        }
    }
    all
}

fn text(token: &TokenTree) -> Option<String> {
    let text = token.to_string();
    let inside = text.strip_prefix('"')?.strip_suffix('"')?;
    Some(inside.to_owned())
}

/// The strings of a constant; of pairs, the first.
fn constant(path: &str, name: &str) -> Words {
    let tokens = flat(tokens(path));
    let start = tokens.windows(2).position(|pair| {
        let [first, second] = [&pair[0], &pair[1]].map(ToString::to_string);
        first == "const" && second == name
    });
    let start = start.unwrap_or_else(|| panic!("{path} has no constant {name}"));
    let value = tokens[start..]
        .iter()
        .skip_while(|token| token.to_string() != "=");
    let Some(TokenTree::Group(list)) = value
        .skip(1)
        .find(|token| matches!(token, TokenTree::Group(_)))
    else {
        panic!("{name} is no list");
    };
    let entries = list.stream().into_iter().filter_map(|entry| match entry {
        TokenTree::Group(pair) => pair.stream().into_iter().next().as_ref().and_then(text),
        literal => text(&literal),
    });
    entries.collect()
}

/// What is found in three tokens in a row of the sources of a folder, not in folders of it.
fn find(folder: &str, find: impl Fn(&[TokenTree]) -> Option<String>) -> Words {
    let path = Path::new(env!("CARGO_MANIFEST_DIR"))
        .join("../..")
        .join(folder);
    let files = fs::read_dir(path).expect("a readable folder");
    let files = files.map(|file| file.expect("a readable entry").path());
    let files = files.filter(|file| file.extension().is_some_and(|end| end == "rs"));
    let files = files.map(|file| flat(tokens(file.to_str().expect("a path is text"))));
    let found = files.flat_map(|all| all.windows(3).filter_map(&find).collect::<Words>());
    found.collect()
}

/// The strings that follow these tokens.
fn behind(folder: &str, before: [&str; 2]) -> Words {
    find(folder, |three| {
        let found = [0, 1].map(|place| three[place].to_string());
        (found == before).then(|| text(&three[2])).flatten()
    })
}

/// The fields of a struct of the schema.
fn schema(file: &str, name: &str) -> Words {
    let all = flat(tokens(&format!("runtime/src/schema/{file}.rs")));
    let braces = all.windows(2).find_map(|pair| match &pair[1] {
        TokenTree::Group(group) if pair[0].to_string() == name => Some(group.stream()),
        _ => None,
    });
    let braces: Vec<TokenTree> = braces.expect("the struct is there").into_iter().collect();
    let words = braces.iter().filter_map(|token| match token {
        TokenTree::Ident(word) if word != "pub" => Some(word.to_string()),
        _ => None,
    });
    words.collect()
}

fn joined(sets: impl IntoIterator<Item = Words>) -> Words {
    sets.into_iter().flatten().collect()
}

fn one(words: &[&str]) -> Words {
    words.iter().map(ToString::to_string).collect()
}

#[test]
fn keys_are_known() {
    let keys = "macros/src/syntax/entries/keys.rs";
    let body = joined([constant(keys, "LISTS"), constant(keys, "VALUES")]);
    assert_eq!(schema("keys", "Body"), body);
    let system = "macros/src/syntax/system/mod.rs";
    let own = [constant(system, "LISTS"), constant(system, "OF_SYSTEMS")];
    let shared = &body - &constant(system, "OF_BODIES");
    // the compiler answers these itself
    let shared = &shared - &one(&["reactions", "independent"]);
    assert_eq!(
        schema("keys", "System"),
        joined(own.into_iter().chain([shared]))
    );
}

#[test]
fn motions_and_joints_are_known() {
    let motions = behind("macros/src/model/joints", ["word", ":"]);
    assert_eq!(schema("words", "Motions"), motions);
    let joints = behind("macros/src/model/system", ["word", ":"]);
    let others = one(&["translation", "planar_translation", "cable", "link"]);
    assert_eq!(schema("words", "Joints"), joined([joints, others]));
}

/// The names of the offers in a folder: `Offer::new(..)` or `word: ..`, by a string or a constant.
fn offers(folder: &str) -> Words {
    let named = find(folder, |three| {
        let name = three[2].to_string();
        let is_constant = name.chars().all(|letter| letter.is_ascii_uppercase());
        let name = is_constant.then(|| name.to_lowercase());
        let name = name.or_else(|| text(&three[2]))?;
        (three[0].to_string() == "new").then_some(name)
    });
    joined([named, behind(folder, ["word", ":"])])
}

#[test]
fn outputs_are_known() {
    let both = offers("macros/src/outputs");
    for (name, own) in [("Outputs", "body"), ("SystemOutputs", "system")] {
        let own = offers(&format!("macros/src/outputs/{own}"));
        let words = joined([both.clone(), own]);
        let missing = &words - &schema("words", name);
        assert!(
            words.len() > 8 && missing.is_empty(),
            "{missing:?} of {words:?}"
        );
    }
}

#[test]
fn units_are_known() {
    let unit = |name| constant("macros/src/units.rs", name);
    let (metric, prefixes) = (unit("METRIC"), unit("PREFIXES"));
    let prefixed = metric.iter().flat_map(|unit| {
        let prefixes = prefixes.iter();
        prefixes.map(move |prefix| format!("{prefix}{unit}"))
    });
    let prefixed = prefixed.collect();
    let all = [metric.clone(), prefixed, unit("CUSTOMARY"), unit("ANGLES")];
    let all = joined(all.into_iter().chain([one(&["rpm"])]));
    assert_eq!(schema("units", "Units"), all);
}

#[test]
fn words_of_expressions_are_known() {
    let words = constant("macros/src/syntax/words.rs", "BUILT_IN");
    let missing = &words - &schema("words", "Words");
    assert!(missing.is_empty(), "{missing:?}");
    let functions = "macros/src/lower/expressions/functions.rs";
    let members = ["VECTOR_METHODS", "SCALAR_METHODS"].map(|name| constant(functions, name));
    let of_scalars = constant("macros/src/symbolic/number/function.rs", "ALL");
    let members = joined(members.into_iter().chain([of_scalars]));
    let missing = &members - &schema("words", "Members");
    assert!(missing.is_empty(), "{missing:?}");
}
