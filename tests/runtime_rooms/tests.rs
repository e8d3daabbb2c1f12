//! Imports between the rooms of the runtime go one way, and no two of its files import each other.
//!
//! A room is a folder of `runtime/src`, or a file.

mod modules;

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

use modules::{Modules, Needs};

/// What each room may import of the others: only what stands above it here.
const ROOMS: [(&str, &str); 18] = [
    ("numbers", ""),
    ("mechanics", "numbers"),
    ("state", "numbers mechanics"),
    ("bodies", "numbers mechanics state"),
    ("tops", "numbers mechanics state"),
    ("exact", "numbers mechanics state bodies"),
    ("taylor", "numbers state bodies"),
    ("integrate/steps", "numbers state bodies taylor"),
    (
        "integrate/methods",
        "numbers state bodies taylor integrate/steps",
    ),
    ("integrate/course", "numbers state bodies integrate/steps"),
    ("integrate", ""),
    (
        "ensemble",
        "numbers state bodies integrate/steps integrate/methods integrate/course",
    ),
    ("pictures", "numbers state bodies integrate/course"),
    ("private", "numbers mechanics state bodies exact"),
    ("prelude", ""),
    ("guide", ""),
    ("reference", ""),
    ("schema", ""),
];

fn files(folder: &Path) -> Vec<PathBuf> {
    let entries = fs::read_dir(folder).expect("a readable folder");
    let paths = entries.map(|entry| entry.expect("a readable entry").path());
    let files = paths.flat_map(|path| {
        if path.is_dir() {
            files(&path)
        } else {
            vec![path]
        }
    });
    files
        .filter(|file| file.extension().is_some_and(|end| end == "rs"))
        .collect()
}

/// What the files of the runtime need of each other.
fn runtime() -> Needs {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../runtime/src");
    let mut modules = Modules::default();
    for file in files(&root) {
        let source = fs::read_to_string(&file).expect("a readable source");
        let inside = file
            .strip_prefix(&root)
            .expect("it is inside")
            .with_extension("");
        let names = inside
            .iter()
            .map(|name| name.to_str().expect("a name is text"));
        modules.read_file(&names.collect::<Vec<_>>().join("/"), &source);
    }
    modules.needs()
}

/// The files that a file needs, those that these need, and so on.
fn reached(needs: &Needs, file: &str) -> BTreeSet<String> {
    let (mut reached, mut left) = (BTreeSet::new(), vec![file.to_string()]);
    while let Some(file) = left.pop() {
        for other in needs.get(&file).into_iter().flatten() {
            if reached.insert(other.clone()) {
                left.push(other.clone());
            }
        }
    }
    reached
}

/// The files that need themselves, by way of others.
fn in_circles(needs: &Needs) -> Vec<&String> {
    let files = needs.keys();
    files
        .filter(|file| reached(needs, file).contains(*file))
        .collect()
}

/// The room that a file is in, the narrowest; the door is in none.
fn room(file: &str) -> Option<&'static str> {
    let is_in = |room: &&str| {
        let rest = file.strip_prefix(*room);
        rest.is_some_and(|rest| rest.is_empty() || rest.starts_with('/'))
    };
    let rooms = ROOMS.iter().map(|(room, _)| *room).filter(is_in);
    let found = rooms.max_by_key(|room| room.len());
    assert!(found.is_some() || file == "lib", "`{file}` is in no room");
    found
}

/// The imports that the table does not allow.
fn refused(needs: &Needs) -> Vec<String> {
    let mut refused = Vec::new();
    for (file, others) in needs {
        let own = room(file);
        for other in others {
            let allowed = ROOMS.iter().find(|(room, _)| Some(*room) == own);
            let is_allowed = |of: &str| {
                allowed.is_some_and(|(_, rooms)| rooms.split(' ').any(|room| room == of))
            };
            if room(other) != own && !room(other).is_some_and(is_allowed) {
                refused.push(format!("{file} imports {other}"));
            }
        }
    }
    refused
}

#[test]
fn each_room_imports_what_it_may() {
    assert_eq!(refused(&runtime()), [""; 0]);
}

#[test]
fn no_two_files_need_each_other() {
    assert_eq!(in_circles(&runtime()), [""; 0]);
}

#[test]
fn rooms_import_what_stands_above_them() {
    for (place, (room, allowed)) in ROOMS.iter().enumerate() {
        let above = |other: &str| ROOMS[..place].iter().any(|(room, _)| *room == other);
        assert!(allowed.split_whitespace().all(above), "{room}");
    }
}

/// A crate of two rooms: what else is written in the lower one may be wrong.
fn planted(lower: &str) -> Needs {
    let mut modules = Modules::default();
    let sources = [
        ("lib", "mod numbers; mod state; pub use state::Turn;"),
        (
            "numbers/mod",
            "mod scale; pub use scale::{self as sizes, Scale};",
        ),
        ("numbers/scale", lower),
        (
            "state/mod",
            "mod turn; pub mod all { pub use super::turn::*; } pub use all::Turn;",
        ),
        (
            "state/turn",
            "use crate::numbers::sizes; pub struct Turn(sizes::Scale);",
        ),
    ];
    for (name, source) in sources {
        modules.read_file(name, source);
    }
    modules.needs()
}

#[test]
fn imports_are_found() {
    let clean = planted("/// Of a [`crate::Turn`]. \n pub struct Scale(f64);");
    assert_eq!(refused(&clean), [""; 0]);
    assert_eq!(in_circles(&clean), [""; 0]);
    assert!(clean["state/turn"].contains("numbers/scale"));
    assert!(clean["numbers/mod"].is_empty() && clean["state/mod"].is_empty());
    for wrong in [
        "use crate::Turn; pub struct Scale;",
        "use crate::state::all::{Turn as Other}; pub struct Scale;",
        "pub struct Scale; fn turn() { (|| crate::state::Turn)(); }",
        "pub struct Scale; mod inside { use super::super::super::state; fn turn(_: state::Turn) {} }",
        "pub struct Scale; pub use crate::Turn; fn turn(_: Turn) {}",
    ] {
        let needs = planted(wrong);
        assert_eq!(
            refused(&needs),
            ["numbers/scale imports state/turn"],
            "{wrong}"
        );
        assert_eq!(
            in_circles(&needs),
            ["numbers/scale", "state/turn"],
            "{wrong}"
        );
    }
}
