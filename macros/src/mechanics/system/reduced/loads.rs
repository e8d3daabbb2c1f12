//! The loads of constraints once the motion is known. They follow from the remainder of the
//! balances: `A^T l = M x - f`.

use crate::symbolic::{Graph, Id};

use super::balances::at;
use super::block::Block;
use super::motion::Reduced;

/// The load of each row, from the remainder of the balances of the original coordinates. Blocks are
/// taken in reverse order, because the balances of a block contain the loads of later ones.
pub fn loads(graph: &mut Graph, reduced: &Reduced, lacking: &[Id], rows: usize) -> Vec<Id> {
    let zero = graph.zero();
    let mut lacking = lacking.to_vec();
    lacking.resize(reduced.values.len(), zero);
    for block in &reduced.blocks {
        if let Some(way) = &block.way {
            let sum = graph.inner(at(&lacking, &block.coordinates), &way.along);
            lacking[way.coordinate] = graph.quantity(sum);
        }
    }
    let mut loads = vec![zero; rows];
    for (row, load) in &reduced.eliminated {
        loads[*row] = *load;
    }
    for block in reduced.blocks.iter().rev() {
        let mut left: Vec<Id> = at(&lacking, &block.coordinates).collect();
        for (row, slopes) in &block.later {
            for (left, slope) in left.iter_mut().zip(slopes) {
                let part = graph.multiply(*slope, loads[*row]);
                *left = graph.subtract(*left, part);
            }
        }
        let left: Vec<Id> = left.into_iter().map(|one| graph.quantity(one)).collect();
        let found = of_block(graph, block, &left);
        for (row, load) in block.rows.iter().zip(found) {
            let load = graph.multiply(block.inverse, load);
            loads[*row] = graph.quantity(load);
        }
    }
    loads
}

/// The loads of a block, before they are multiplied by its reciprocal. They solve `A^T l = w`; or,
/// if a way remains, `A^T l + s M n = w`, since nothing is lacking along the way.
fn of_block(graph: &mut Graph, block: &Block, lacking: &[Id]) -> Vec<Id> {
    let momentum = block.way.as_ref().map(|way| way.momentum.as_slice());
    match (block.slopes.as_slice(), lacking, momentum) {
        ([_], [a, b], Some([c, d])) => vec![less(graph, (*b, *c), (*a, *d))],
        ([first, second], [a, b, c], Some([d, e, f])) => {
            let across = graph.cross([*d, *e, *f], [*a, *b, *c]);
            let across = graph.quantities(across);
            let [first, second] = [first, second].map(|row| [row[0], row[1], row[2]]);
            let (load, other) = (graph.dot(second, across), graph.dot(first, across));
            vec![load, graph.negate(other)]
        }
        ([first, second], [a, b], None) => vec![
            less(graph, (*a, second[1]), (*b, second[0])),
            less(graph, (*b, first[0]), (*a, first[1])),
        ],
        _ => lacking.to_vec(),
    }
}

/// `a b - c d`
fn less(graph: &mut Graph, (a, b): (Id, Id), (c, d): (Id, Id)) -> Id {
    let (more, less) = (graph.multiply(a, b), graph.multiply(c, d));
    graph.subtract(more, less)
}
