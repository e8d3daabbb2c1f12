//! Where functions and quotients have no value, and why.

use crate::errors::{Errors, Extent};
use crate::symbolic::{Id, Number};

use super::lower::Lowering;
use super::value::shown;
use super::{Model, Workspace};

/// Something that was written and has no value everywhere, and depends on parameters.
pub struct Doubtful {
    /// The word of a function; of a quotient, `/`.
    word: String,
    operands: Vec<Id>,
    value: Id,
    place: Extent,
}

impl Lowering<'_> {
    /// Refuses what has no value, at its word; what parameters may bring there is remembered.
    pub fn check_value(
        &mut self,
        word: &str,
        operands: &[Id],
        value: Id,
        place: Extent,
    ) -> Option<()> {
        let graph = &self.work.graph;
        if graph.is_undefined(value) {
            let numbers = operands.iter().map(|id| graph.as_number(*id).cloned());
            let why = numbers.collect::<Option<Vec<_>>>();
            let why = why.map_or_else(
                || format!("`{word}` has no value"),
                |all| why_not(word, &all),
            );
            return self.report(place, why);
        }
        if graph.is_early(value) && graph.as_number(value).is_none() {
            self.work.doubtful.push(Doubtful {
                word: word.to_owned(),
                operands: operands.to_vec(),
                value,
                place,
            });
        }
        Some(())
    }
}

/// Reports the first part of the description that has no value with the defaults of the parameters.
pub fn report_without_value(model: &Model, work: &mut Workspace, errors: &mut Errors) -> bool {
    let graph = &mut work.graph;
    for doubtful in &work.doubtful {
        let all: Vec<Id> = doubtful
            .operands
            .iter()
            .copied()
            .chain([doubtful.value])
            .collect();
        let mut values = graph.substitute(&all, |id| model.defaults.get(&id).copied());
        let has_value = values.pop().is_some_and(|value| !graph.is_undefined(value));
        let numbers = values.iter().map(|id| graph.as_number(*id).cloned());
        if has_value {
            continue;
        }
        if let Some(numbers) = numbers.collect::<Option<Vec<_>>>() {
            let why = why_not(&doubtful.word, &numbers);
            errors.push(
                doubtful.place,
                format!("with the defaults of the parameters, {why}"),
            );
            return true;
        }
    }
    false
}

fn why_not(word: &str, operands: &[Number]) -> String {
    let [x, rest @ ..] = operands else {
        return format!("`{word}` has no value");
    };
    let of = shown(x);
    match (word, rest) {
        _ if operands.iter().any(is_nearly_whole) => format!(
            "`{word}` is not known here: whether its argument is exactly {of} is not told by thousands of \
             bits; write what it is as a number"
        ),
        ("/", _) => "this is zero, and nothing can be divided by it".to_owned(),
        ("powf", [y]) if x.is_negative() && !y.is_whole() => format!(
            "`powf` of {of} has no value: negative numbers have whole powers, and this exponent is {}",
            shown(y)
        ),
        ("powf" | "powi" | "recip", _) if x.is_zero() => {
            format!("`{word}` of 0 has no value: it divides by it")
        }
        ("exp" | "sinh" | "cosh" | "tanh" | "powf" | "powi", _) => {
            format!("`{word}` of {of} has no value: it is far beyond the range of `f64`")
        }
        _ => format!("`{word}` of {of} has no value"),
    }
}

/// Whether a number cannot be told from a whole one.
fn is_nearly_whole(number: &Number) -> bool {
    [-1, 0, 1]
        .into_iter()
        .any(|whole| (number.clone() - Number::integer(whole)).is_undecided())
}
