//! Names: one namespace for parameters, inputs, points, locals and what is built in, and the order
//! in which definitions are to be read.

use std::collections::{HashMap, HashSet};

use proc_macro2::Ident;

use crate::errors::{Errors, similar};
use crate::syntax::{Description, Expression, Kind};

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

/// What the names of a description stand for.
#[derive(Default)]
pub struct Scope {
    /// `None` is known, but was reported and has no value.
    values: HashMap<String, Option<Value>>,
    used: HashSet<String>,
}

impl Scope {
    pub fn define(&mut self, name: &str, value: Option<Value>) {
        self.values.entry(name.to_owned()).or_insert(value);
    }

    /// `None` for a name that nobody defined.
    pub fn look_up(&mut self, name: &str) -> Option<Option<Value>> {
        let value = self.values.get(name)?;
        self.used.insert(name.to_owned());
        Some(*value)
    }

    /// The end of a message about an unknown name.
    pub fn hint(&self, name: &str) -> String {
        let mut known: Vec<&str> = self
            .values
            .keys()
            .map(String::as_str)
            .chain(BUILT_IN)
            .collect();
        known.sort_unstable();
        similar(name, known).map_or_else(String::new, |known| format!("; did you mean `{known}`?"))
    }

    pub fn is_used(&self, name: &Ident) -> bool {
        self.used.contains(&name.to_string()) || name.to_string().starts_with('_')
    }
}

/// Reports names that are defined twice, or that are built in. Loads have a namespace of their own.
pub fn check_names(description: &Description, errors: &mut Errors) {
    let mut seen = HashMap::new();
    let mut check = |name: &Ident, what: &'static str, errors: &mut Errors| {
        let word = name.to_string();
        if BUILT_IN.contains(&word.as_str()) {
            errors.push(
                name.span(),
                format!("`{word}` is built in: choose another name for this {what}"),
            );
        } else if let Some(first) = seen.insert(word.clone(), what) {
            let other = if first == what {
                "another".to_owned()
            } else {
                format!(
                    "a {first} of the same name: params, inputs, points and locals share their names with"
                )
            };
            errors.push(
                name.span(),
                format!("`{word}` is defined twice; there is {other} {what}"),
            );
        }
    };
    for param in &description.params {
        check(&param.name, "param", errors);
    }
    for input in &description.inputs {
        check(&input.name, "input", errors);
    }
    for point in &description.points {
        check(&point.name, "point", errors);
    }
    for local in &description.locals {
        check(&local.name, "local", errors);
    }
    let mut loads = HashSet::new();
    for load in &description.loads {
        if !loads.insert(load.name.to_string()) {
            errors.push(
                load.name.span(),
                format!(
                    "there is another load called `{}`: loads are told apart by their names",
                    load.name
                ),
            );
        }
    }
}

/// A definition that may refer to others.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Definition {
    Mass,
    Point(usize),
    Local(usize),
}

/// The order in which points, locals and the mass can be read: each after those it refers to.
/// Names that refer to each other in a circle are reported and left out.
pub fn definition_order(
    description: &Description,
    errors: &mut Errors,
) -> (Vec<Definition>, Vec<Definition>) {
    let mut definitions: Vec<(String, Option<&Expression>, Definition)> = Vec::new();
    if let Some(mass) = &description.mass {
        definitions.push(("mass".to_owned(), mass.value.as_ref(), Definition::Mass));
    }
    for (index, point) in description.points.iter().enumerate() {
        definitions.push((
            point.name.to_string(),
            point.value.as_ref(),
            Definition::Point(index),
        ));
    }
    for (index, local) in description.locals.iter().enumerate() {
        definitions.push((
            local.name.to_string(),
            local.value.as_ref(),
            Definition::Local(index),
        ));
    }
    let index: HashMap<&str, usize> = definitions
        .iter()
        .enumerate()
        .rev()
        .map(|(index, (name, ..))| (name.as_str(), index))
        .collect();
    let mut waiting = vec![0_usize; definitions.len()];
    let mut dependents: Vec<Vec<usize>> = vec![Vec::new(); definitions.len()];
    for (user, (_, value, _)) in definitions.iter().enumerate() {
        for name in value.map(|value| mentioned(value)).unwrap_or_default() {
            if let Some(&used) = index.get(name.as_str()) {
                waiting[user] += 1;
                dependents[used].push(user);
            }
        }
    }
    let mut ready: std::collections::BTreeSet<usize> = (0..definitions.len())
        .filter(|index| waiting[*index] == 0)
        .collect();
    let mut order = Vec::new();
    while let Some(next) = ready.pop_first() {
        order.push(definitions[next].2);
        for &dependent in &dependents[next] {
            waiting[dependent] -= 1;
            if waiting[dependent] == 0 {
                ready.insert(dependent);
            }
        }
    }
    let circular: Vec<Definition> = (0..definitions.len())
        .filter(|index| waiting[*index] > 0)
        .map(|index| definitions[index].2)
        .collect();
    for (index, (name, value, _)) in definitions.iter().enumerate() {
        if let (true, Some(value)) = (waiting[index] > 0, value) {
            errors.push(
                value.extent,
                format!("`{name}` depends on itself: definitions cannot go in a circle"),
            );
        }
    }
    (order, circular)
}

/// All names in an expression.
fn mentioned(expression: &Expression) -> Vec<String> {
    let mut names = Vec::new();
    let mut pending = vec![expression];
    while let Some(expression) = pending.pop() {
        match &expression.kind {
            Kind::Number(_) | Kind::Placeholder => {}
            Kind::Name(name) => names.push(name.to_string()),
            Kind::Tuple(parts) | Kind::Call(_, parts) => pending.extend(parts),
            Kind::Unit(operand, _) | Kind::Prefix(_, operand) | Kind::Field(operand, _) => {
                pending.push(operand)
            }
            Kind::Chain(first, rest) => {
                pending.push(first);
                pending.extend(rest.iter().map(|(_, operand)| operand));
            }
            Kind::Method(receiver, _, arguments) => {
                pending.push(receiver);
                pending.extend(arguments);
            }
            Kind::Record(_, fields) => pending.extend(fields.iter().map(|(_, value)| value)),
            Kind::If(parts) => pending.extend(parts.iter()),
        }
    }
    names
}
