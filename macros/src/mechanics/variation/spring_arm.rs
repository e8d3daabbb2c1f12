//! The moment `r x g` of a slope g along a rotated vector r.
//!
//! The part of g along r is dropped before the multiplication. Otherwise, its rounding errors would
//! remain, and grow with the length of r. The force of a spring to a distant hook is `s (c r + b)`,
//! so its arm is b. The force of several springs is a sum of such terms.

use std::collections::HashSet;

use crate::model::{Turn, Workspace};
use crate::symbolic::{Components, Graph, Id, Node};

/// `r x slope` as a factor and a vector, for a rotated vector r.
pub fn moment(work: &mut Workspace, turn: &Turn, slope: Components) -> (Id, Components) {
    let (mut factor, mut rest) = (work.graph.one(), slope);
    while let Some((part, others)) = work.common_factor(rest, turn.to) {
        factor = work.graph.multiply(factor, part);
        rest = others;
    }
    let (graph, r) = (&mut work.graph, turn.turned);
    let rest = across(graph, r, rest);
    (factor, graph.cross(r, rest))
}

/// A slope without multiples of r; unchanged if it has none.
fn across(graph: &mut Graph, r: Components, slope: Components) -> Components {
    let place: HashSet<Id> = r.into_iter().collect();
    let (zero, mut sum, mut is_less) = (graph.zero(), graph.zeros(), false);
    for (factor, mut vector) in by_factor(graph, r, &place, slope) {
        if let Some(factor) = factor {
            if common_rate(graph, vector, r, &place).is_some() {
                let others = graph.substitute(&vector, |id| place.contains(&id).then_some(zero));
                is_less |= others != vector;
                vector = [others[0], others[1], others[2]];
            }
            vector = graph.scale_vector(factor, vector);
        }
        sum = graph.add_vectors(sum, vector);
    }
    if is_less { sum } else { slope }
}

/// The terms that are not linear in r, followed by those that are, which are collected by their
/// factors.
fn by_factor(
    graph: &mut Graph,
    r: Components,
    place: &HashSet<Id>,
    slope: Components,
) -> Vec<(Option<Id>, Components)> {
    let mut groups = vec![(None, graph.zeros())];
    for (i, component) in slope.into_iter().enumerate() {
        for (negative, term) in graph.terms(component) {
            let (factor, part) = match linear(graph, r[i], place, term) {
                Some((factor, part)) => (Some(factor), part),
                None => (None, term),
            };
            let part = if negative { graph.negate(part) } else { part };
            let known = groups.iter().position(|(known, _)| *known == factor);
            let group = known.unwrap_or_else(|| {
                groups.push((factor, graph.zeros()));
                groups.len() - 1
            });
            let sum = &mut groups[group].1[i];
            *sum = graph.add(*sum, part);
        }
    }
    groups
}

/// A term, written as a factor times something that depends on the symbol linearly, with a rate
/// known early, or that does not depend on the place.
fn linear(graph: &mut Graph, symbol: Id, place: &HashSet<Id>, term: Id) -> Option<(Id, Id)> {
    let one = graph.one();
    let (early, late) = graph.split_factor(term);
    let mut forms = vec![(one, late)];
    if let Node::Multiply(a, b) = *graph.node(late) {
        forms.extend([(a, b), (b, a)]);
    }
    let found = forms.into_iter().find(|(_, part)| {
        let gradient = graph.gradient(&[(*part, one)], |id| place.contains(&id));
        match gradient.as_slice() {
            [] => true,
            [(along, rate)] => *along == symbol && graph.is_early(*rate),
            _ => false,
        }
    });
    let (factor, part) = found?;
    Some((factor, graph.multiply(early, part)))
}

/// The rate, known early, at which each component of a vector changes with its own symbol, if all
/// rates are equal and no component depends on other symbols in `place`.
pub fn common_rate(
    graph: &mut Graph,
    vector: Components,
    symbols: Components,
    place: &HashSet<Id>,
) -> Option<Id> {
    let (zero, one) = (graph.zero(), graph.one());
    let mut common = None;
    for (component, symbol) in vector.into_iter().zip(symbols) {
        let gradient = graph.gradient(&[(component, one)], |id| place.contains(&id));
        let rate = match gradient.as_slice() {
            [] if component == zero && symbol == zero => continue,
            [] => zero,
            [(along, rate)] if *along == symbol => *rate,
            _ => return None,
        };
        if common.is_some_and(|known| known != rate) {
            return None;
        }
        common = Some(rate);
    }
    common.filter(|rate| graph.is_early(*rate))
}
