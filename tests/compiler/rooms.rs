//! Imports between the rooms of the compiler go one way.

use std::fs;
use std::path::{Path, PathBuf};

/// What each room may import of the others.
const ROOMS: [(&str, &[&str]); 8] = [
    ("errors", &[]),
    ("syntax", &["errors"]),
    ("symbolic", &[]),
    ("model", &["errors", "syntax", "symbolic"]),
    ("mechanics", &["errors", "model", "symbolic"]),
    ("emit", &["model", "mechanics", "symbolic"]),
    (
        "outputs",
        &["errors", "syntax", "symbolic", "model", "mechanics", "emit"],
    ),
    (
        "expand",
        &["errors", "syntax", "model", "mechanics", "emit", "outputs"],
    ),
];

fn sources(room: &str) -> Vec<PathBuf> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("macros/src");
    let file = root.join(format!("{room}.rs"));
    if file.exists() {
        return vec![file];
    }
    let (mut folders, mut files) = (vec![root.join(room)], Vec::new());
    while let Some(folder) = folders.pop() {
        for entry in fs::read_dir(folder).expect("a room is a file or a folder") {
            let path = entry.expect("a readable entry").path();
            let kind = if path.is_dir() {
                &mut folders
            } else {
                &mut files
            };
            kind.push(path);
        }
    }
    files.sort();
    assert!(!files.is_empty(), "{room} is empty");
    files
}

/// The rooms that a source names behind `crate::`, in `use` trees too.
fn imported(source: &str) -> Vec<String> {
    let mut found = Vec::new();
    for (start, _) in source.match_indices("crate::") {
        if source[..start].ends_with('$') {
            continue;
        }
        let rest = &source[start + "crate::".len()..];
        let names: Vec<&str> = match rest.strip_prefix('{') {
            Some(tree) => tree
                .split('}')
                .next()
                .unwrap_or_default()
                .split(',')
                .collect(),
            None => vec![rest],
        };
        let word = |text: &str| {
            text.trim()
                .chars()
                .take_while(|c| c.is_alphanumeric() || *c == '_')
                .collect::<String>()
        };
        found.extend(names.into_iter().map(word).filter(|name| !name.is_empty()));
    }
    found
}

#[test]
fn each_room_imports_what_it_may() {
    for (room, allowed) in ROOMS {
        for file in sources(room) {
            let source = fs::read_to_string(&file).expect("a readable source");
            for name in imported(&source) {
                assert!(
                    name == room || allowed.contains(&name.as_str()),
                    "{} imports {name}",
                    file.display()
                );
            }
        }
    }
}

#[test]
fn only_the_door_names_proc_macro() {
    for (room, _) in ROOMS {
        for file in sources(room) {
            let source = fs::read_to_string(&file).expect("a readable source");
            assert!(
                !source.contains("proc_macro::"),
                "{} names proc_macro",
                file.display()
            );
        }
    }
}

#[test]
fn imports_are_found() {
    assert_eq!(
        imported("use crate::{emit, model::Model};"),
        ["emit", "model"]
    );
    assert_eq!(imported("let x: crate::symbolic::Id;"), ["symbolic"]);
}
