//! Whether constant symmetric matrices have no negative eigenvalue: proofs, and conditions on
//! parameters.

use crate::model::Defaults;
use crate::symbolic::{Graph, Id, Number};

/// The entries that must be nonnegative for a constant matrix to be positive semidefinite: those whose
/// sign is unknown. Entries on the diagonal with nothing beside them are such entries; the
/// others must be numbers times a single one. `None` if the matrix is not symmetric or not of this
/// form, or has a negative eigenvalue.
pub fn unknown_signs(graph: &mut Graph, columns: &[Vec<Id>], masses: &[Id]) -> Option<Vec<Id>> {
    let count = columns.len();
    let is_symmetric = (0..count).all(|i| (0..i).all(|j| columns[i][j] == columns[j][i]));
    let is_coupled = |own: usize| (0..count).any(|j| j != own && !graph.is_zero(columns[j][own]));
    let (coupled, apart): (Vec<usize>, Vec<usize>) = (0..count).partition(|own| is_coupled(*own));
    let mut diagonal = coupled.iter().map(|own| columns[*own][*own]);
    let factor = diagonal.find(|entry| !graph.is_zero(*entry));
    let signs = apart.iter().map(|own| columns[*own][*own]).chain(factor);
    let signs: Vec<Id> = signs
        .filter(|entry| !is_known_sign(graph, *entry, masses))
        .collect();
    let is_negative = |entry: &Id| graph.as_number(*entry).is_some();
    let has_factor = factor.is_some() || coupled.is_empty();
    if !is_symmetric || !has_factor || signs.iter().any(is_negative) {
        return None;
    }
    let mut rows = Vec::new();
    for row in &coupled {
        let ratios = coupled.iter().map(|column| {
            let ratio = graph.divide(columns[*column][*row], factor?);
            graph.as_number(ratio).cloned()
        });
        rows.push(ratios.collect::<Option<Vec<Number>>>()?);
    }
    is_semidefinite_in_numbers(rows).then_some(signs)
}

pub fn is_known_sign(graph: &Graph, entry: Id, masses: &[Id]) -> bool {
    graph.is_early(entry) && graph.is_never_negative(entry, masses)
}

/// The same for a symmetric matrix of numbers, by elimination of its last row.
fn is_semidefinite_in_numbers(mut rows: Vec<Vec<Number>>) -> bool {
    while let Some(own) = rows.pop() {
        let Some((pivot, beside)) = own.split_last() else {
            return true;
        };
        let is_alone = beside.iter().all(Number::is_zero);
        if pivot.is_negative() || pivot.is_undecided() || pivot.is_zero() && !is_alone {
            return false;
        }
        for (row, factor) in rows.iter_mut().zip(beside) {
            row.pop();
            for (entry, other) in row.iter_mut().zip(beside) {
                if let Some(share) = (factor.clone() * other.clone()).checked_div(pivot) {
                    *entry = entry.clone() - share;
                }
            }
        }
    }
    true
}

/// The pivots of the sum of two matrices, which are positive if it is positive definite. Rows of zeros
/// in both are left out. `None` if the sum is not symmetric.
pub fn pivots_of_sum(graph: &mut Graph, own: &[Vec<Id>], added: &[Vec<Id>]) -> Option<Vec<Id>> {
    let all: Vec<usize> = (0..own.len()).collect();
    let mut rows: Vec<Vec<Id>> = own
        .iter()
        .zip(added)
        .map(|(own, added)| {
            let pairs = own.iter().zip(added);
            pairs.map(|(a, b)| graph.add(*a, *b)).collect()
        })
        .collect();
    if !all
        .iter()
        .all(|i| all[..*i].iter().all(|j| rows[*i][*j] == rows[*j][*i]))
    {
        return None;
    }
    // where a load cancels the inertia, there is a pivot, which is zero
    let is_nothing = |row: &Vec<Id>| row.iter().all(|entry| graph.is_zero(*entry));
    let left = all.into_iter();
    let left: Vec<usize> = left
        .filter(|row| !is_nothing(&own[*row]) || !is_nothing(&added[*row]))
        .collect();
    let mut pivots = Vec::new();
    for (number, own) in left.iter().enumerate() {
        let pivot = graph.quantity(rows[*own][*own]);
        pivots.push(pivot);
        for other in &left[number + 1..] {
            if graph.is_zero(rows[*other][*own]) {
                continue;
            }
            let factor = graph.divide(rows[*other][*own], pivot);
            for column in &left[number + 1..] {
                let part = graph.multiply(factor, rows[*own][*column]);
                rows[*other][*column] = graph.subtract(rows[*other][*column], part);
            }
        }
    }
    Some(pivots)
}

/// Whether a number is proved nonnegative.
pub fn is_not_negative(number: &Number) -> bool {
    !number.is_negative() && !number.is_undecided()
}

/// Whether values have a property with the defaults of parameters, if these have defaults.
pub fn is_by_default(
    graph: &mut Graph,
    values: &[Id],
    defaults: &Defaults,
    is: impl Fn(&Number) -> bool,
) -> bool {
    let values = graph.substitute(values, |id| defaults.get(&id).copied());
    let mut values = values.into_iter();
    values.all(|value| !graph.is_undefined(value) && graph.as_number(value).is_none_or(&is))
}
