//! What an expression depends on, and the name in it that an error should underline.

use std::collections::HashSet;

use crate::errors::Extent;
use crate::lower::expressions::{Lowering, Value};
use crate::symbolic::{Id, Node};
use crate::syntax::{Expression, Kind};

/// Words for the accelerations of bodies, points and joints.
const ACCELERATIONS: [&str; 4] = [
    "acceleration",
    "angular_acceleration",
    "angular_acceleration_1",
    "angular_acceleration_2",
];

impl Lowering<'_> {
    /// The symbols in `roots` that are not known early.
    pub fn late_symbols(&self, roots: &[Id]) -> Vec<Id> {
        let graph = &self.work.graph;
        let symbols = graph.nodes_of(roots).into_iter();
        symbols
            .filter(|id| matches!(graph.node(*id), Node::Symbol(_)) && !graph.is_early(*id))
            .collect()
    }

    /// Whether any of `roots` depends on one of the symbols, directly or through rotated vectors.
    pub fn depends(&self, roots: &[Id], symbols: &[Id]) -> bool {
        let mut followed = HashSet::new();
        let mut pending = roots.to_vec();
        while !pending.is_empty() {
            let found = self.late_symbols(&pending);
            if found.iter().any(|symbol| symbols.contains(symbol)) {
                return true;
            }
            let turns = self.work.turns.iter();
            let through = turns.flat_map(|turns| found.iter().filter_map(|id| turns.of(*id)));
            let new: Vec<Id> = through
                .filter(|turn| followed.insert(turn.turned))
                .flat_map(|turn| turn.vector)
                .collect();
            pending = new;
        }
        false
    }

    /// The first name or method in `expression` that is one of `words`, or whose value depends on
    /// one of the symbols.
    pub fn dependent_name(
        &self,
        expression: &Expression,
        symbols: &[Id],
        words: &[&str],
    ) -> Extent {
        let mut found = None;
        expression.visit(|part| {
            let name = match &part.kind {
                Kind::Name(name) => name,
                Kind::Method(_, method, _) | Kind::Field(_, method)
                    if words.iter().any(|word| method == word) =>
                {
                    method
                }
                _ => return,
            };
            let word = name.to_string();
            let depends = words.contains(&word.as_str())
                || self.scope.peek(&word).is_some_and(|value| {
                    let components = match value {
                        Value::Scalar(id, _) | Value::Condition(id) => vec![id],
                        Value::Components(_, components, _) => components.to_vec(),
                        Value::Vector(vector, _) => self.work.entries(&[vector]),
                        Value::Point(_)
                        | Value::Carried(..)
                        | Value::Attitude
                        | Value::Function(_) => Vec::new(),
                    };
                    self.depends(&components, symbols)
                });
            if depends && found.is_none() {
                found = Some(name.span().into());
            }
        });
        found.unwrap_or(expression.extent)
    }

    /// Reports an acceleration: only given loads may depend on one.
    pub fn check_no_acceleration(
        &mut self,
        written: &Expression,
        roots: &[Id],
        what: &str,
    ) -> Option<()> {
        let Some(place) = self.mentioned_acceleration(written, roots) else {
            return Some(());
        };
        self.report(
            place,
            format!("{what} cannot depend on an acceleration: forces, moments and drives can"),
        )
    }

    /// Where an expression with these values mentions an acceleration.
    pub fn mentioned_acceleration(&self, written: &Expression, roots: &[Id]) -> Option<Extent> {
        let all = self.work.meanings.accelerations();
        let all: Vec<Id> = all
            .map(|symbol| self.work.graph.symbol_id(symbol))
            .collect();
        let depends = self.depends(roots, &all);
        depends.then(|| self.dependent_name(written, &all, &ACCELERATIONS))
    }

    /// Where an expression mentions an unknown reaction.
    pub fn mentioned_reaction(&self, value: &Expression) -> Option<Extent> {
        let names = value.names();
        let found = names
            .iter()
            .find(|name| self.reactions.contains(&name.to_string()));
        found.map(|name| name.span().into())
    }
}
