//! Names: one namespace for parameters, inputs, points, locals and what is built in, and the order
//! in which definitions are to be read.

use std::collections::{HashMap, HashSet};

use proc_macro2::Ident;

use crate::syntax::Description;

use super::value::Value;

/// Names that mean something in every description.
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

/// Names that mean something under `motion: rod(..)` alone.
pub const OF_ROD: [&str; 2] = ["axis", "axis_rate"];

/// Built-in names of what changes while the body moves.
const CHANGING: [&str; 7] = [
    "t",
    "position",
    "velocity",
    "attitude",
    "angular_velocity",
    "axis",
    "axis_rate",
];

/// What the names of a description stand for.
#[derive(Clone)]
pub struct Scope {
    /// `None` is known, but was reported and has no value.
    values: HashMap<String, Option<Value>>,
    used: HashSet<String>,
    /// All names that the description defines somewhere.
    defined: HashSet<String>,
    /// Names whose definition could not be read.
    lost: HashSet<String>,
}

impl Scope {
    /// `repeated` are names that mean two things.
    pub fn new(description: &Description, repeated: HashSet<String>) -> Self {
        let declarations = description.params.iter().chain(&description.inputs);
        let definitions = description.points.iter().chain(&description.locals);
        let declared = declarations.map(|declaration| declaration.name.to_string());
        let defined = definitions.map(|definition| definition.name.to_string());
        Self {
            values: HashMap::new(),
            used: HashSet::new(),
            defined: declared.chain(defined).collect(),
            lost: description.lost.iter().cloned().chain(repeated).collect(),
        }
    }

    pub fn define(&mut self, name: &str, value: Option<Value>) {
        self.values.entry(name.to_owned()).or_insert(value);
    }

    /// Gives a name that has a value another one.
    pub fn redefine(&mut self, name: &str, value: Option<Value>) {
        self.values.insert(name.to_owned(), value);
    }

    /// `None` for a name that nobody defined.
    #[allow(clippy::option_option, reason = "outer: not defined; inner: reported")]
    pub fn look_up(&mut self, name: &str) -> Option<Option<Value>> {
        if self.lost.contains(name.strip_prefix("r#").unwrap_or(name)) {
            return Some(None);
        }
        let value = self.values.get(name)?;
        self.used.insert(name.to_owned());
        Some(*value)
    }

    /// The values of all names, to be restored.
    pub fn values(&self) -> HashMap<String, Option<Value>> {
        self.values.clone()
    }

    pub fn restore(&mut self, values: HashMap<String, Option<Value>>) {
        self.values = values;
    }

    /// Whether the description, or the language, gives this name a value that is no constant.
    pub fn is_open(&self, name: &str) -> bool {
        self.defined.contains(name) || CHANGING.contains(&name) || name == "mass"
    }

    /// Whether a name has a value, or had one that was reported.
    pub fn knows(&self, name: &str) -> bool {
        self.values.contains_key(name)
    }

    /// Whether the definition of a name could not be read.
    pub fn is_lost(&self, name: &str) -> bool {
        self.lost.contains(name)
    }

    /// The value of a name, without saying that it is used.
    pub fn peek(&self, name: &str) -> Option<Value> {
        self.values.get(name).copied().flatten()
    }

    /// Whether this is a built-in name of what changes while the body moves.
    pub fn is_changing(name: &str) -> bool {
        CHANGING.contains(&name)
    }

    /// The names that mean something.
    pub fn known(&self) -> impl Iterator<Item = &str> {
        self.values.keys().map(String::as_str).chain(BUILT_IN)
    }

    /// Whether anybody looked it up.
    pub fn has_used(&self, name: &str) -> bool {
        self.used.contains(name)
    }

    pub fn is_used(&self, name: &Ident) -> bool {
        self.used.contains(&name.to_string()) || name.to_string().starts_with('_')
    }
}
