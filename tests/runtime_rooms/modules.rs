//! The modules of a crate, and what their files need from each other.
//!
//! What counts is where an item is defined. A name that a module re-exports is looked up there, so
//! a file that only re-exports depends on no others. What is reached only through methods is not
//! seen.

use std::collections::{BTreeMap, BTreeSet};

use proc_macro2::{Group, TokenStream, TokenTree};

/// Names from the root of the crate on.
type Names = Vec<String>;

/// The files that each file needs.
pub type Needs = BTreeMap<String, BTreeSet<String>>;

/// What a module defines, hands on and names.
#[derive(Default)]
struct Module {
    file: String,
    defined: BTreeSet<String>,
    /// By the name here.
    imported: BTreeMap<String, Import>,
    /// Modules of which all names are imported.
    globs: Vec<Names>,
    /// Paths in its code, and single names.
    paths: Vec<Names>,
    words: BTreeSet<String>,
}

struct Import {
    path: Names,
    is_handed_on: bool,
}

/// The modules of a crate.
#[derive(Default)]
pub struct Modules(BTreeMap<Names, Module>);

fn word(token: Option<&TokenTree>) -> Option<String> {
    match token {
        Some(TokenTree::Ident(name)) => Some(name.to_string()),
        _ => None,
    }
}

fn is_sign(token: Option<&TokenTree>, sign: char) -> bool {
    matches!(token, Some(TokenTree::Punct(punct)) if punct.as_char() == sign)
}

fn are_colons(tokens: &[TokenTree]) -> bool {
    tokens.len() == 2 && tokens.iter().all(|token| is_sign(Some(token), ':'))
}

fn listed(group: &Group) -> Vec<TokenTree> {
    group.stream().into_iter().collect()
}

fn joined(before: &[String], after: &[String]) -> Names {
    before.iter().chain(after).cloned().collect()
}

/// The paths of a tree of imports, each with the name that it has here.
fn leaves(tokens: &[TokenTree], before: &[String]) -> Vec<(Names, String)> {
    let branches = tokens.split(|token| is_sign(Some(token), ','));
    branches
        .flat_map(|branch| branch_leaves(branch, before))
        .collect()
}

fn branch_leaves(branch: &[TokenTree], before: &[String]) -> Vec<(Names, String)> {
    let mut path = before.to_vec();
    for (place, token) in branch.iter().enumerate() {
        match token {
            TokenTree::Group(group) => return leaves(&listed(group), &path),
            TokenTree::Ident(name) if *name == "as" => {
                let renamed = word(branch.get(place + 1));
                return vec![(path, renamed.expect("a name after `as`"))];
            }
            // of a list, the module itself
            TokenTree::Ident(name) if *name == "self" && !path.is_empty() => {}
            TokenTree::Ident(name) => path.push(name.to_string()),
            TokenTree::Punct(sign) if sign.as_char() == '*' => {
                return vec![(path, "*".to_string())];
            }
            _ => {}
        }
    }
    let name = path.last().cloned();
    name.map(|name| (path, name)).into_iter().collect()
}

impl Modules {
    /// Reads a file, by its path in the crate without the ending.
    pub fn read_file(&mut self, name: &str, source: &str) {
        let mut path: Names = name.split('/').map(String::from).collect();
        if name == "lib" || path.last().is_some_and(|last| last == "mod") {
            path.pop();
        }
        let tokens = source.parse().expect("a source is made of tokens");
        self.read(&path, name, tokens);
    }

    /// Reads a module, and those that are written inside of it.
    fn read(&mut self, path: &[String], file: &str, stream: TokenStream) {
        let tokens: Vec<TokenTree> = stream.into_iter().collect();
        let mut module = Module {
            file: file.to_string(),
            ..Module::default()
        };
        let (mut place, mut is_public) = (0, false);
        while let Some(token) = tokens.get(place) {
            let next = tokens.get(place + 1);
            match word(Some(token)).as_deref() {
                Some("pub") => is_public = true,
                Some("use") => {
                    let rest = &tokens[place + 1..];
                    let end = rest.iter().position(|token| is_sign(Some(token), ';'));
                    let end = end.expect("an import ends");
                    module.import(&rest[..end], is_public);
                    place += end;
                    is_public = false;
                }
                Some("mod") => {
                    let name = word(next).expect("a module has a name");
                    if let Some(TokenTree::Group(inside)) = tokens.get(place + 2) {
                        self.read(&joined(path, &[name]), file, inside.stream());
                    }
                    place += 2;
                    is_public = false;
                }
                Some("fn" | "struct" | "enum" | "trait" | "type" | "const" | "static") => {
                    module.defined.extend(word(next));
                    is_public = false;
                }
                Some("macro_rules") => module.defined.extend(word(tokens.get(place + 2))),
                _ => module.mention(&tokens, place),
            }
            place += 1;
        }
        self.0.insert(path.to_vec(), module);
    }

    /// The file in which a thing is defined that a module names; none of what is another crate's,
    /// and of a module.
    fn file(&self, from: &[String], path: &[String]) -> Option<&str> {
        let (first, rest) = path.split_first()?;
        match first.as_str() {
            "crate" => self.file_inside(&[], rest),
            "self" => self.file_inside(from, rest),
            "super" => {
                let (_, above) = from.split_last()?;
                match rest.first().map(String::as_str) {
                    Some("super") => self.file(above, rest),
                    _ => self.file_inside(above, rest),
                }
            }
            _ => self.file_inside(from, path),
        }
    }

    fn file_inside(&self, module: &[String], path: &[String]) -> Option<&str> {
        let (name, rest) = path.split_first()?;
        let here = self.0.get(module)?;
        let child = joined(module, std::slice::from_ref(name));
        if !rest.is_empty() && self.0.contains_key(&child) {
            return self.file_inside(&child, rest);
        }
        if here.defined.contains(name) {
            return Some(&here.file);
        }
        if let Some(import) = here.imported.get(name) {
            return self.file(module, &joined(&import.path, rest));
        }
        let mut globs = here.globs.iter();
        globs.find_map(|glob| self.file(module, &joined(glob, path)))
    }

    /// What each file needs of the others.
    pub fn needs(&self) -> Needs {
        let mut needs = Needs::new();
        for (path, module) in &self.0 {
            let is_used = |(name, import): &(&String, &Import)| {
                !import.is_handed_on || module.words.contains(*name)
            };
            let imports = module.imported.iter().filter(is_used);
            let named = imports.map(|(_, import)| &import.path).chain(&module.paths);
            let files = named.filter_map(|named| self.file(path, named));
            let others = files.filter(|file| **file != module.file).map(String::from);
            needs.entry(module.file.clone()).or_default().extend(others);
        }
        needs
    }
}

impl Module {
    fn import(&mut self, tree: &[TokenTree], is_handed_on: bool) {
        for (path, name) in leaves(tree, &[]) {
            if name == "*" {
                self.globs.push(path);
            } else if path != [name.as_str()] {
                self.imported.insert(name, Import { path, is_handed_on });
            }
        }
    }

    /// Notes the path that begins at a place of the code, and those inside of a group.
    fn mention(&mut self, tokens: &[TokenTree], place: usize) {
        let before = &tokens[..place];
        match &tokens[place] {
            TokenTree::Group(group) if !is_documentation(before, group) => {
                let inside = listed(group);
                (0..inside.len()).for_each(|place| self.mention(&inside, place));
            }
            TokenTree::Ident(name) if is_beginning(before) => {
                let mut path = vec![name.to_string()];
                let mut rest = &tokens[place + 1..];
                while are_colons(&rest[..rest.len().min(2)]) {
                    let Some(next) = word(rest.get(2)) else { break };
                    path.push(next);
                    rest = &rest[3..];
                }
                self.words.insert(path[0].clone());
                self.paths.push(path);
            }
            // attributes name functions in quotes
            TokenTree::Literal(text) => {
                let text = text.to_string();
                let path = text.trim_matches('"').parse::<TokenStream>();
                let path: Vec<TokenTree> = path.into_iter().flatten().collect();
                if text.contains("::") && !path.is_empty() {
                    self.mention(&path, 0);
                }
            }
            _ => {}
        }
    }
}

/// Links in documentation are no imports.
fn is_documentation(before: &[TokenTree], group: &Group) -> bool {
    let is_marked = is_sign(before.last(), '#') || is_sign(before.last(), '!');
    is_marked && word(listed(group).first()).is_some_and(|name| name == "doc")
}

/// Whether a name goes on from nothing: from no path, no value and no `$`.
fn is_beginning(before: &[TokenTree]) -> bool {
    let goes_on = before.len() >= 2 && are_colons(&before[before.len() - 2..]);
    !(goes_on || is_sign(before.last(), '.') || is_sign(before.last(), '$'))
}
