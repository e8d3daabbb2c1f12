//! Names that mean two things.

use std::collections::{HashMap, HashSet};

use proc_macro2::Ident;

use crate::errors::Errors;
use crate::lower::expressions::{BUILT_IN, OF_ROD, written_motion};
use crate::model::Motion;
use crate::syntax::Description;

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
