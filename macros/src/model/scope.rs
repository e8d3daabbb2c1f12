//! Names: one namespace for parameters, inputs, points, locals and what is built in, and the order
//! in which definitions are to be read.

use std::collections::{HashMap, HashSet};

use proc_macro2::Ident;

use crate::errors::{Errors, hint};
use crate::syntax::Description;

use super::motion::Motion;
use super::outline::written_motion;
use super::value::Value;

/// Names that mean something in every description.
const BUILT_IN: [&str; 11] = [
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
const OF_ROD: [&str; 2] = ["axis", "axis_rate"];

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

    /// The value of a name, without saying that it is used.
    pub fn peek(&self, name: &str) -> Option<Value> {
        self.values.get(name).copied().flatten()
    }

    /// Whether this is a built-in name of what changes while the body moves.
    pub fn is_changing(name: &str) -> bool {
        CHANGING.contains(&name)
    }

    /// The end of a message about an unknown name.
    pub fn hint(&self, name: &str) -> String {
        let defined = self.values.keys().map(String::as_str);
        let mut known: Vec<&str> = defined.chain(BUILT_IN).collect();
        known.sort_unstable();
        hint(name, known)
    }

    pub fn is_used(&self, name: &Ident) -> bool {
        self.used.contains(&name.to_string()) || name.to_string().starts_with('_')
    }
}

/// Reports names that are defined twice, or that are built in. Loads have a namespace of their own.
/// Returns the names that mean two things.
pub fn check_names(description: &Description, errors: &mut Errors) -> HashSet<String> {
    let mut repeated = HashSet::new();
    let mut seen = HashMap::new();
    let is_rod = written_motion(description) == Some(Motion::Rod);
    let is_built_in = |word: &str| BUILT_IN.contains(&word) || is_rod && OF_ROD.contains(&word);
    let mut check = |name: &Ident, what: &'static str, errors: &mut Errors| {
        let word = name.to_string();
        if is_built_in(&word) {
            errors.push(
                name.span(),
                format!("`{word}` is built in: choose another name for this {what}"),
            );
            return;
        }
        let message = match seen.get(&word) {
            None => {
                seen.insert(word, what);
                return;
            }
            Some(first) if *first == what => format!("there is a {what} `{word}` already"),
            Some(first) => format!(
                "`{word}` is the name of a {first} already: params, inputs, points and locals \
                 need different names"
            ),
        };
        errors.push(name.span(), message.replace("a input", "an input"));
        repeated.insert(word);
    };
    for param in &description.params {
        check(&param.name, "param", errors);
    }
    for input in &description.inputs {
        check(
            &input.name,
            ["input", "rate", "acceleration"][input.order.min(2)],
            errors,
        );
    }
    for point in &description.points {
        check(&point.name, "point", errors);
    }
    for local in &description.locals {
        check(&local.name, "local", errors);
    }
    let mut loads = HashSet::new();
    let named = description.loads.iter().map(|load| &load.name);
    let potentials = description.potentials.iter();
    for name in named.chain(potentials.map(|potential| &potential.name)) {
        if !loads.insert(name.to_string()) {
            errors.push(
                name.span(),
                format!("there is a load `{name}` already: loads are told apart by their names"),
            );
        }
    }
    let mut constraints = HashSet::new();
    for constraint in &description.constraints {
        if !constraints.insert(constraint.name.to_string()) {
            errors.push(
                constraint.name.span(),
                format!(
                    "there is a constraint `{}` already: constraints are told apart by their names",
                    constraint.name
                ),
            );
        }
    }
    repeated
}
