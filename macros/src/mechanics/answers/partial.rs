//! Loads that may have no value: those that read values given at each evaluation, those that divide
//! by quantities of the motion, and those with a function that is undefined for some numbers or
//! whose value quickly leaves the range of doubles.

use crate::model::{Load, Meaning, Model, Own, Workspace};
use crate::symbolic::{Function, Graph, Id, Node};

/// A load, and all of its nonzero components.
#[derive(Clone)]
pub struct Partial {
    pub name: String,
    pub parts: Vec<Id>,
}

/// The name of a load and all of its components.
pub fn parts(load: &Load, work: &Workspace) -> (String, Vec<Id>) {
    let mut parts = work.entries(&[load.force, load.moment]);
    parts.extend(load.pull.into_iter().flatten());
    (load.name.to_string(), parts)
}

/// All loads of a body and the rates of its user-defined states, by name, with their components.
pub fn loads(model: &Model, work: &Workspace) -> Vec<(String, Vec<Id>)> {
    let loads = model.loads.iter().map(|load| parts(load, work));
    let rates = model.states.iter().map(Own::named_rate);
    loads.chain(rates).collect()
}

pub fn list_partial(
    loads: impl IntoIterator<Item = (String, Vec<Id>)>,
    work: &Workspace,
) -> Vec<Partial> {
    let graph = &work.graph;
    let loads = loads.into_iter().map(|(name, mut parts)| {
        parts.retain(|part| !graph.is_early(*part));
        parts.sort_unstable();
        parts.dedup();
        Partial { name, parts }
    });
    loads.filter(|load| is_partial(work, &load.parts)).collect()
}

/// Whether expressions may have no value and depend on nothing that is solved for.
fn is_partial(work: &Workspace, parts: &[Id]) -> bool {
    let graph = &work.graph;
    let (mut may_fail, mut is_given) = (false, true);
    for id in graph.reachable(parts, &|id| !graph.is_early(id)) {
        match graph.node(id) {
            Node::Symbol(symbol) => match work.meanings.of(*symbol) {
                Meaning::Input(..) => may_fail = true,
                // unknowns that are solved for
                Meaning::Reaction(..) | Meaning::Virtual => is_given = false,
                _ => {}
            },
            node => may_fail |= has_no_value_somewhere(graph, node),
        }
    }
    may_fail && is_given
}

/// Whether an expression is a sum of squares, as under the root of a length.
fn is_sum_of_squares(graph: &Graph, sum: Id) -> bool {
    let mut pending = vec![sum];
    while let Some(id) = pending.pop() {
        match *graph.node(id) {
            Node::Add(a, b) => pending.extend([a, b]),
            Node::Quantity(a) => pending.push(a),
            Node::Multiply(a, b) if a == b => {}
            _ => return false,
        }
    }
    true
}

fn has_no_value_somewhere(graph: &Graph, node: &Node) -> bool {
    match *node {
        Node::Divide(_, divisor) => !graph.is_early(divisor),
        Node::Pivot(..) | Node::Foreign(..) => true,
        Node::Unary(Function::Sqrt, operand) if is_sum_of_squares(graph, operand) => false,
        Node::Unary(function, operand) => {
            let is_partial = matches!(
                function,
                Function::Sqrt
                    | Function::Exp
                    | Function::Ln
                    | Function::Tan
                    | Function::Asin
                    | Function::Acos
                    | Function::Sinh
                    | Function::Cosh
            );
            is_partial && !graph.is_early(operand)
        }
        Node::Binary(function, ..) => function == Function::Powf,
        _ => false,
    }
}
