//! Ambiguous names.

use std::collections::{HashMap, HashSet};

use proc_macro2::Ident;

use crate::errors::Errors;
use crate::lower::expressions::{BUILT_IN, OF_ROD, Scope, written_motion};
use crate::model::Joint;
use crate::syntax::Description;

/// Reports and returns names that are defined twice or built in. Loads have a separate namespace.
pub fn check_names(description: &Description, errors: &mut Errors) -> HashSet<String> {
    let mut repeated = HashSet::new();
    let mut seen = HashMap::new();
    let is_rod = written_motion(description).is_some_and(Joint::is_line);
    let is_built_in = |word: &str| BUILT_IN.contains(&word) || is_rod && OF_ROD.contains(&word);
    let mut check = |name: &Ident, what: &'static str, errors: &mut Errors| {
        let word = name.to_string();
        if is_built_in(&word) {
            errors.push(
                name.span(),
                format!("`{word}` is built in: choose another name for this {what}"),
            );
            repeated.insert(word);
            return;
        }
        let message = match seen.get(&word) {
            None => {
                seen.insert(word, what);
                return;
            }
            Some(first) if *first == what => format!("there is a {what} `{word}` already"),
            Some(first) => format!(
                "`{word}` is already the name of a {first}: params, inputs, states, points and \
                 locals need different names"
            ),
        };
        errors.push(name.span(), message.replace("a input", "an input"));
        repeated.insert(word);
    };
    for (name, what) in description.foreign() {
        check(name, what, errors);
    }
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
    for state in &description.states {
        check(&state.name, "state", errors);
    }
    for point in &description.points {
        check(&point.name, "point", errors);
    }
    for local in &description.locals {
        check(&local.name, "local", errors);
    }
    let named = description.loads.iter().map(|load| &load.name);
    let potentials = description.potentials.iter();
    let loads = named.chain(potentials.map(|potential| &potential.name));
    check_distinct("load", loads, errors);
    let constraints = description.constraints.iter();
    let rates = description.rates.iter().map(|rate| &rate.name);
    check_distinct("rate", rates, errors);
    check_distinct("constraint", constraints.map(|one| &one.name), errors);
    repeated
}

pub fn check_distinct<'n>(what: &str, names: impl Iterator<Item = &'n Ident>, errors: &mut Errors) {
    let mut seen = HashSet::new();
    for name in names {
        if !seen.insert(name) {
            errors.push(
                name.span(),
                format!(
                    "there is a {what} `{name}` already: {what}s are told apart by their names"
                ),
            );
        }
    }
}

/// The names that nothing refers to. An input counts together with its rates.
pub fn unused(description: &Description, scope: &Scope) -> Vec<Ident> {
    let inputs = description.inputs.iter().filter(|input| input.order == 0);
    let declared = description.params.iter().chain(inputs);
    let defined = description.points.iter().chain(&description.locals);
    let foreign = description.foreign().map(|(name, _)| name);
    foreign
        .chain(declared.map(|declaration| &declaration.name))
        .chain(defined.map(|definition| &definition.name))
        .filter(|name| !scope.is_used(name))
        .cloned()
        .collect()
}
