//! Checks: claims of a description about the motion, decided with exact numbers at expansion.

use std::collections::{BTreeMap, BTreeSet};

use crate::model::{Check, Checks, Claim, Defaults, Meaning, Outline, Workspace, shown};
use crate::symbolic::{Comparison, Exact, Id, Number};

use super::errors::Errors;

/// Values of symbols.
type Known = BTreeMap<Id, Number>;

/// What claims are decided from.
pub struct Evidence<'a> {
    pub outline: &'a Outline,
    pub work: &'a Workspace,
    pub defaults: &'a Defaults,
    /// The symbols that follow from the motion, each with the expression that replaces it.
    pub answers: &'a [(Id, Id)],
    /// The constraints, which a given state has to satisfy.
    pub constraints: &'a [Required],
}

/// A constraint: its value and its rate, each with the size of its terms.
pub struct Required {
    pub name: String,
    pub position: Option<(Id, Id)>,
    /// A cosine that is one, unless the assembly is another one.
    pub facing: Option<Id>,
    pub velocity: (Id, Id),
}

/// The permitted violation of a constraint by a given state, as a fraction of its terms: states may
/// be given with a few digits.
const OPEN: f64 = 1e-3;

impl Evidence<'_> {
    /// Reports all claims that are false or cannot be decided.
    pub fn check(&self, checks: &Checks, errors: &mut Errors) {
        for check in &checks.list {
            if let Some(known) = self.given(check, errors)
                && self.check_closed(check, &known, errors).is_some()
            {
                self.decide(check, &known, errors);
            }
        }
    }

    /// The given values, and the defaults of all other params.
    fn given(&self, check: &Check, errors: &mut Errors) -> Option<Known> {
        let graph = &self.work.graph;
        let is_given = |symbol: &Id| check.given.iter().any(|(other, ..)| other == symbol);
        let mut known: Known = self
            .defaults
            .iter()
            .filter(|(symbol, _)| !is_given(symbol))
            .filter_map(|(symbol, value)| Some((*symbol, graph.as_number(*value)?.clone())))
            .collect();
        // a given value may depend on others
        let mut left: Vec<_> = check.given.iter().collect();
        loop {
            let count = left.len();
            let mut open = None;
            left.retain(|(symbol, value, place)| {
                match self.evaluate(*value, &known) {
                    Exact::Number(number) => {
                        known.insert(*symbol, number);
                        return false;
                    }
                    other => open = open.take().or(Some((*place, other))),
                }
                true
            });
            let Some((place, found)) = open else {
                return Some(known);
            };
            if left.len() == count {
                let message = match found {
                    Exact::Open(symbols) if symbols.iter().all(is_given) => {
                        "these given values depend on each other: give one of them a number"
                            .to_owned()
                    }
                    Exact::Open(symbols) => format!("this {}", self.lacking(&symbols)),
                    Exact::Undecided => UNDECIDED.to_owned(),
                    _ => "this has no value in this state".to_owned(),
                };
                return errors.report(place, message);
            }
        }
    }

    /// Reports a given state that violates a constraint.
    fn check_closed(&self, check: &Check, known: &Known, errors: &mut Errors) -> Option<()> {
        let mut violations = self.constraints.iter();
        let Some(violation) = violations.find_map(|one| self.violation(one, known)) else {
            return Some(());
        };
        let name = &check.name;
        errors.report(
            check.claims.first()?.place,
            format!(
                "`{name}` has a state that {violation}: give one that satisfies all constraints"
            ),
        )
    }

    /// How a state violates a constraint, if that is known: by more than the rounding of a few digits.
    fn violation(&self, constraint: &Required, known: &Known) -> Option<String> {
        let value = |id: Id| match self.evaluate(id, known) {
            Exact::Number(number) => Some(number.to_f64()),
            _ => None,
        };
        let name = &constraint.name;
        let cosine = constraint.facing.and_then(value);
        if cosine.is_some_and(|cosine| cosine < 0.5) {
            return Some(format!("reverses `{name}`"));
        }
        let position = constraint.position.map(|sized| (sized, "position"));
        let levels = position
            .into_iter()
            .chain([(constraint.velocity, "velocity")]);
        levels.into_iter().find_map(|((gap, size), level)| {
            let (gap, size) = (value(gap)?.abs(), value(size)?);
            (gap > OPEN * size).then(|| format!("violates `{name}` by {gap:.1e} in {level}"))
        })
    }

    /// Decides all claims of one check.
    fn decide(&self, check: &Check, known: &Known, errors: &mut Errors) {
        let graph = &self.work.graph;
        let sides: Vec<Id> = check.claims.iter().flat_map(|claim| claim.sides).collect();
        let needed = graph.nodes_of(&sides);
        let answers = self
            .answers
            .iter()
            .filter(|(symbol, _)| needed.contains(symbol));
        let (symbols, roots): (Vec<Id>, Vec<Id>) = answers.copied().unzip();
        let found = graph.exact(&roots, |id| known.get(&id).cloned());
        let mut values = known.clone();
        let mut without = BTreeMap::new();
        for (symbol, value) in symbols.into_iter().zip(found) {
            match value {
                Exact::Number(number) => {
                    values.insert(symbol, number);
                }
                other => {
                    without.insert(symbol, other);
                }
            }
        }
        for claim in &check.claims {
            let found = graph.exact(&claim.sides, |id| values.get(&id).cloned());
            let found = found.into_iter().map(|value| followed(value, &without));
            let found: Vec<Exact> = found.collect();
            if let Some(why) = self.refuted(claim, &found) {
                errors.push(claim.place, format!("`{}` {why}", check.name));
            }
        }
    }

    fn evaluate(&self, id: Id, known: &Known) -> Exact {
        let mut values = self.work.graph.exact(&[id], |id| known.get(&id).cloned());
        values.pop().unwrap_or(Exact::Absent)
    }

    /// Why a claim is false or undecided; `None` if it is true.
    fn refuted(&self, claim: &Claim, found: &[Exact]) -> Option<String> {
        let (a, b) = match found {
            [Exact::Number(a), Exact::Number(b)] => (a, b),
            [Exact::Open(symbols), other] | [other, Exact::Open(symbols)] => {
                let mut all = symbols.clone();
                if let Exact::Open(more) = other {
                    all.extend(more);
                }
                return Some(self.lacking(&all));
            }
            _ if found.iter().any(|one| matches!(one, Exact::Absent)) => {
                let message = "has no value in this state: something is divided by zero, outside of the domain of its function, too large for a number, or \
                 a load that the balances do not determine";
                return Some(message.to_owned());
            }
            _ => return Some(format!("is not decided: {UNDECIDED}")),
        };
        let [left, right] = if claim.is_turned { [b, a] } else { [a, b] };
        match Exact::compare(claim.comparison, a, b) {
            Exact::Number(holds) if holds.is_one() => None,
            Exact::Number(_) => {
                let (first, second) = told_apart(left, right);
                Some(match claim.comparison {
                    Comparison::NotEqual => format!("does not hold: both sides are {first}"),
                    _ => {
                        format!(
                            "does not hold: the left side is {first}, and the right side {second}"
                        )
                    }
                })
            }
            _ => Some(format!(
                "is undecided: the left side is {}, the right side agrees with it to thousands of bits, and nothing \
             proves them equal",
                shown(left)
            )),
        }
    }

    /// The names of the symbols whose values are missing.
    fn lacking(&self, symbols: &BTreeSet<Id>) -> String {
        let names = symbols.iter().map(|symbol| self.name(*symbol));
        let names: BTreeSet<String> = names.collect();
        let given: Vec<String> = names.iter().map(|name| format!("{name} = ..")).collect();
        let list: Vec<String> = names.iter().map(|name| format!("`{name}`")).collect();
        let is = if list.len() == 1 { "is" } else { "are" };
        format!(
            "depends on {}, which {is} not given: write `.given({})` behind the condition",
            list.join(", "),
            given.join(", ")
        )
    }

    fn name(&self, symbol: Id) -> String {
        let (outline, work) = (self.outline, self.work);
        let declared = |list: &[crate::model::Declared], number: usize| {
            let found = list.get(number);
            found.map_or_else(String::new, |one| one.name.to_string())
        };
        match work.meaning(symbol) {
            Some(Meaning::Time) => "t".to_owned(),
            Some(Meaning::Param(number, _)) => declared(&outline.params, number),
            Some(Meaning::Input(number, _)) => declared(&outline.inputs, number),
            Some(Meaning::Own(number)) => declared(&outline.states, number),
            Some(meaning @ Meaning::Of(frame, ..)) => {
                let joint = outline
                    .joints
                    .iter()
                    .find(|joint| joint.frame == Some(frame));
                let shape = joint.map_or(outline.motion.shape, |joint| joint.shape);
                let mut fields = shape.fields.iter();
                let field = fields.find(|field| field.component(meaning).is_some());
                let path = field.map_or("acceleration", |field| field.path);
                // users give the components of a quaternion as `attitude`
                let path = path.split('.').next().unwrap_or(path);
                joint.map_or(path.to_owned(), |joint| format!("{}.{path}", joint.name))
            }
            _ => "what follows from the motion".to_owned(),
        }
    }
}

const UNDECIDED: &str = "a subexpression is zero to thousands of bits, but not proved to be zero";

/// The symbols that a value lacks. A symbol that follows from the motion is replaced by the symbols
/// that it lacks itself.
fn followed(value: Exact, without: &BTreeMap<Id, Exact>) -> Exact {
    let Exact::Open(symbols) = value else {
        return value;
    };
    let mut open = BTreeSet::new();
    for symbol in symbols {
        match without.get(&symbol) {
            None => {
                open.insert(symbol);
            }
            Some(Exact::Open(others)) => open.extend(others),
            Some(other) => return other.clone(),
        }
    }
    Exact::Open(open)
}

/// Two numbers in words. If their doubles are equal, the second is described by the difference.
fn told_apart(left: &Number, right: &Number) -> (String, String) {
    let (first, second) = (shown(left), shown(right));
    let difference = right.clone() - left.clone();
    if first != second || difference.is_zero() {
        return (first, second);
    }
    let sign = if difference.is_negative() {
        "less"
    } else {
        "more"
    };
    let beyond = format!("{} {sign}", shown(&difference.abs()));
    (first, beyond)
}
