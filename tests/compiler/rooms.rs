//! The structure of the compiler: which room may import which, and that no files in a room form a
//! cycle.

use crate::from_root::repository;
use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};
use std::sync::LazyLock;

use syn::punctuated::Punctuated;
use syn::visit::Visit;

/// What each room may import of the others.
const ROOMS: [(&str, &[&str]); 16] = [
    ("errors", &[]),
    ("families", &[]),
    ("fraction", &[]),
    ("units", &[]),
    ("text", &[]),
    ("symbolic", &[]),
    (
        "syntax",
        &["errors", "families", "fraction", "units", "text"],
    ),
    ("model", &["errors", "families", "fraction", "symbolic"]),
    (
        "lower",
        &[
            "errors", "families", "fraction", "units", "symbolic", "syntax", "model",
        ],
    ),
    ("mechanics", &["errors", "families", "symbolic", "model"]),
    ("range", &["errors", "symbolic", "model"]),
    ("checks", &["errors", "symbolic", "model"]),
    ("editor", &["errors", "syntax", "model", "lower"]),
    (
        "emit",
        &["families", "symbolic", "model", "mechanics", "text"],
    ),
    (
        "outputs",
        &[
            "errors",
            "families",
            "symbolic",
            "model",
            "lower",
            "mechanics",
            "emit",
        ],
    ),
    (
        "expand",
        &[
            "errors",
            "syntax",
            "model",
            "lower",
            "mechanics",
            "range",
            "checks",
            "emit",
            "outputs",
        ],
    ),
];
/// Files of a folder, its face not counted.
const FILES: usize = 13;
const LINES: usize = 400;
/// Methods of the compiler that the standard library has, too.
const OF_STD: [&str; 21] = [
    "all", "as_ref", "atan", "chain", "choice", "cmp", "cos", "entry", "error", "exp", "extend",
    "find", "finish", "floor", "insert", "ln", "map", "peek", "powi", "sin", "sqrt",
];

/// A module of the compiler, by its path below the crate.
type Module = Vec<String>;

/// A name that a module takes from elsewhere, by its path, and whether it hands it on.
struct Import {
    path: Vec<String>,
    is_handed_on: bool,
}

struct File {
    path: PathBuf,
    source: String,
    imports: Vec<Import>,
    methods: Methods,
}

/// The methods that a source defines, and those that it calls, by name.
#[derive(Default)]
struct Methods {
    defined: BTreeSet<String>,
    called: BTreeSet<String>,
}

impl<'ast> Visit<'ast> for Methods {
    fn visit_signature(&mut self, signature: &'ast syn::Signature) {
        if signature.receiver().is_some() {
            self.defined.insert(signature.ident.to_string());
        }
    }

    fn visit_expr_method_call(&mut self, call: &'ast syn::ExprMethodCall) {
        self.called.insert(call.method.to_string());
        syn::visit::visit_expr_method_call(self, call);
    }

    // arguments of macros that are expressions
    fn visit_macro(&mut self, call: &'ast syn::Macro) {
        let parser = Punctuated::<syn::Expr, syn::Token![,]>::parse_terminated;
        for argument in call.parse_body_with(parser).into_iter().flatten() {
            self.visit_expr(&argument);
        }
    }
}

/// All of the compiler, read once.
static HOUSE: LazyLock<House> = LazyLock::new(House::read);

struct House(BTreeMap<Module, File>);

impl House {
    fn read() -> Self {
        let root = repository().join("macros/src");
        let mut files = BTreeMap::new();
        let mut folders = vec![root.clone()];
        while let Some(folder) = folders.pop() {
            for entry in fs::read_dir(&folder).expect("a readable folder") {
                let path = entry.expect("a readable entry").path();
                if path.is_dir() {
                    folders.push(path);
                    continue;
                }
                let below = path.strip_prefix(&root).expect("a path below the root");
                let mut module: Module = below
                    .with_extension("")
                    .iter()
                    .map(|part| part.to_string_lossy().into_owned())
                    .collect();
                if module.last().is_some_and(|last| last == "mod") {
                    module.pop();
                }
                let source = fs::read_to_string(&path).expect("a readable source");
                let parsed = syn::parse_file(&source).expect("a source in Rust");
                let imports = imports(&source, &parsed);
                let mut methods = Methods::default();
                methods.visit_file(&parsed);
                let file = File {
                    path,
                    source,
                    imports,
                    methods,
                };
                files.insert(module, file);
            }
        }
        Self(files)
    }

    /// The module in which a path, as it is written in another, ends, through faces that hand names on.
    fn target(&self, from: &[String], path: &[String]) -> Option<Module> {
        let (mut module, mut rest): (Module, _) = match path.first()?.as_str() {
            "crate" => (Vec::new(), &path[1..]),
            "super" | "self" => (from.to_vec(), path),
            first => {
                let child = [from, &[first.to_owned()]].concat();
                if !self.0.contains_key(&child) {
                    return None;
                }
                (from.to_vec(), path)
            }
        };
        while let [first, others @ ..] = rest {
            let child = [&module[..], std::slice::from_ref(first)].concat();
            match first.as_str() {
                "super" => drop(module.pop()),
                "self" => {}
                _ if self.0.contains_key(&child) => module = child,
                name => {
                    let file = self.0.get(&module)?;
                    let handed_on = file.imports.iter().find(|import| {
                        import.is_handed_on && import.path.last().is_some_and(|last| last == name)
                    });
                    return match handed_on {
                        Some(import) => self.target(&module, &import.path),
                        None => Some(module),
                    };
                }
            }
            rest = others;
        }
        Some(module)
    }

    /// The modules whose methods each module calls: methods that one module alone defines, by names that
    /// the standard library does not have.
    fn calls(&self) -> BTreeMap<&Module, BTreeSet<Module>> {
        let mut homes: BTreeMap<String, BTreeSet<&Module>> = BTreeMap::new();
        for (module, file) in &self.0 {
            for method in &file.methods.defined {
                homes.entry(method.clone()).or_default().insert(module);
            }
        }
        let arrows = self.0.iter().map(|(module, file)| {
            let called = file.methods.called.iter();
            let foreign = called.filter(|name| !OF_STD.contains(&name.as_str()));
            let homes = foreign.filter_map(|name| homes.get(name));
            let homes = homes.filter(|homes| homes.len() == 1).flatten();
            let others = homes.filter(|home| **home != module);
            (module, others.map(|home| (*home).clone()).collect())
        });
        arrows.collect()
    }

    /// The modules that each module imports; a face only hands on.
    fn arrows(&self) -> BTreeMap<&Module, BTreeSet<Module>> {
        let arrows = self.0.iter().map(|(module, file)| {
            let taken = file.imports.iter().filter(|import| !import.is_handed_on);
            let targets = taken.filter_map(|import| self.target(module, &import.path));
            let others = targets.filter(|target| target != module && self.0.contains_key(target));
            (module, others.collect())
        });
        arrows.collect()
    }
}

/// The paths that a source imports, in `use` trees and behind `crate::` or `super::` elsewhere.
fn imports(source: &str, file: &syn::File) -> Vec<Import> {
    let mut found = Vec::new();
    for item in &file.items {
        if let syn::Item::Use(item) = item {
            let is_handed_on = matches!(item.vis, syn::Visibility::Public(_));
            let mut paths = Vec::new();
            leaves(&item.tree, &mut Vec::new(), &mut paths);
            let import = |path| Import { path, is_handed_on };
            found.extend(paths.into_iter().map(import));
        }
    }
    let is_code = |line: &&str| {
        let line = line.trim_start();
        !line.starts_with("//") && !line.starts_with("use ") && !line.starts_with("pub use ")
    };
    for line in source.lines().filter(is_code) {
        for start in ["crate::", "super::"] {
            for (place, _) in line.match_indices(start) {
                let before = line[..place].chars().next_back();
                if before.is_some_and(|c| c.is_alphanumeric() || "_:$".contains(c)) {
                    continue;
                }
                let is_path = |c: char| c.is_alphanumeric() || c == '_' || c == ':';
                let end = line[place..].find(|c| !is_path(c));
                let path = &line[place..end.map_or(line.len(), |end| place + end)];
                let parts = path.split("::").filter(|part| !part.is_empty());
                found.push(Import {
                    path: parts.map(str::to_owned).collect(),
                    is_handed_on: false,
                });
            }
        }
    }
    found
}

fn leaves(tree: &syn::UseTree, path: &mut Vec<String>, found: &mut Vec<Vec<String>>) {
    let with = |path: &[String], name: &syn::Ident| [path, &[name.to_string()]].concat();
    match tree {
        syn::UseTree::Path(next) => {
            path.push(next.ident.to_string());
            leaves(&next.tree, path, found);
            path.pop();
        }
        syn::UseTree::Name(name) if name.ident == "self" => found.push(path.clone()),
        syn::UseTree::Name(name) => found.push(with(path, &name.ident)),
        syn::UseTree::Rename(name) => found.push(with(path, &name.ident)),
        syn::UseTree::Glob(_) => found.push(path.clone()),
        syn::UseTree::Group(group) => {
            for tree in &group.items {
                leaves(tree, path, found);
            }
        }
    }
}

/// A circle of arrows, if there is one.
fn circle<T: Ord + Clone>(arrows: &BTreeMap<T, BTreeSet<T>>) -> Option<Vec<T>> {
    let mut left = arrows.clone();
    loop {
        let names: BTreeSet<T> = left.keys().cloned().collect();
        let before = left.len();
        left.retain(|_, targets| targets.iter().any(|target| names.contains(target)));
        if left.is_empty() {
            return None;
        }
        if left.len() == before {
            break;
        }
    }
    // every one that is left has an arrow to one that is left
    let mut way: Vec<T> = Vec::new();
    let mut next = left.keys().next()?.clone();
    while !way.contains(&next) {
        way.push(next.clone());
        next = left[&next]
            .iter()
            .find(|target| left.contains_key(target))?
            .clone();
    }
    let start = way.iter().position(|one| *one == next)?;
    Some(way.split_off(start))
}

#[test]
fn each_room_imports_what_it_may() {
    let house = &HOUSE;
    let allowed: BTreeMap<&str, &[&str]> = ROOMS.into_iter().collect();
    for (module, targets) in house.arrows() {
        let Some(room) = module.first().filter(|room| *room != "lib") else {
            continue;
        };
        let allowed = allowed[room.as_str()];
        for target in targets {
            assert!(
                target[0] == *room || allowed.contains(&target[0].as_str()),
                "{} imports {}",
                module.join("::"),
                target.join("::")
            );
        }
    }
}

/// Arrows between modules, by their paths as text.
fn by_path(arrows: BTreeMap<&Module, BTreeSet<Module>>) -> BTreeMap<String, BTreeSet<String>> {
    let arrows = arrows.into_iter().map(|(module, targets)| {
        let targets = targets.iter().map(|target| target.join("::"));
        (module.join("::"), targets.collect())
    });
    arrows.collect()
}

#[test]
fn no_file_imports_itself_by_way_of_others() {
    assert_eq!(circle(&by_path(HOUSE.arrows())), None);
}

#[test]
fn no_file_calls_methods_of_itself_by_way_of_others() {
    assert_eq!(circle(&by_path(HOUSE.calls())), None);
}

/// A folder is a wing of its room: all of its files together.
#[test]
fn no_wing_imports_itself_by_way_of_others() {
    let house = &HOUSE;
    let wing = |module: &Module| {
        let is_face = house.0[module].path.ends_with("mod.rs");
        let depth = if is_face || module.len() == 1 {
            module.len()
        } else {
            module.len() - 1
        };
        module[..depth].join("::")
    };
    let mut arrows: BTreeMap<String, BTreeSet<String>> = BTreeMap::new();
    for (module, targets) in house.arrows() {
        let from = wing(module);
        // a room is not a wing: its face, and what lies in it beside its wings
        let others = targets.iter().map(wing).filter(|to| *to != from);
        arrows.entry(from.clone()).or_default().extend(others);
    }
    assert_eq!(circle(&arrows), None);
}

#[test]
fn wings_and_files_are_small() {
    let house = &HOUSE;
    let mut sizes: BTreeMap<&Path, usize> = BTreeMap::new();
    for file in house.0.values() {
        let lines = file.source.lines().count();
        assert!(lines <= LINES, "{}: {lines} lines", file.path.display());
        if !file.path.ends_with("mod.rs") {
            *sizes
                .entry(file.path.parent().expect("a folder"))
                .or_default() += 1;
        }
    }
    for (folder, files) in sizes {
        assert!(files <= FILES, "{}: {files} files", folder.display());
    }
}

#[test]
fn only_the_door_names_proc_macro() {
    for (module, file) in &HOUSE.0 {
        let is_door = module[..] == ["lib"];
        assert_eq!(
            file.source.contains("proc_macro::"),
            is_door,
            "{}",
            file.path.display()
        );
    }
}

#[test]
fn imports_are_found() {
    let source =
        "use crate::{emit, model::Model};\npub use graph::Id;\nfn f() -> crate::symbolic::Id {}";
    let found: Vec<(String, bool)> = imports(source, &syn::parse_file(source).unwrap())
        .into_iter()
        .map(|import| (import.path.join("::"), import.is_handed_on))
        .collect();
    let expected = [
        ("crate::emit", false),
        ("crate::model::Model", false),
        ("graph::Id", true),
        ("crate::symbolic::Id", false),
    ];
    assert_eq!(found, expected.map(|(path, on)| (path.to_owned(), on)));
    let arrows = |list: &[(u8, &[u8])]| -> BTreeMap<u8, BTreeSet<u8>> {
        let each = list.iter();
        each.map(|(from, to)| (*from, to.iter().copied().collect()))
            .collect()
    };
    assert_eq!(circle(&arrows(&[(1, &[2]), (2, &[3]), (3, &[])])), None);
    let found = circle(&arrows(&[(1, &[2]), (2, &[3, 4]), (3, &[2]), (4, &[])]));
    assert_eq!(found, Some(vec![2, 3]));
}
