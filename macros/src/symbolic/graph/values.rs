//! Nodes that have the same value, though rules see different expressions: a quantity and its
//! content, and what is built from either.

use crate::symbolic::number::Function;

use super::hash::ShortMap;
use super::nodes::{Graph, Id, Node};

/// Which nodes of a program have the value of an earlier one.
pub struct Values {
    firsts: ShortMap<Id, Id>,
    copies: ShortMap<Id, Vec<Id>>,
}

impl Values {
    /// The first node that has the value of `id`.
    pub fn first(&self, id: Id) -> Id {
        self.firsts.get(&id).copied().unwrap_or(id)
    }

    /// The other nodes that have the value of `id`, if it is the first, in order.
    pub fn copies_of(&self, id: Id) -> &[Id] {
        self.copies.get(&id).map_or(&[], Vec::as_slice)
    }
}

impl Graph {
    /// The values of `nodes`, which are in order.
    pub(super) fn values(&self, nodes: &[Id]) -> Values {
        let mut values = Values {
            firsts: ShortMap::default(),
            copies: ShortMap::default(),
        };
        let mut known = ShortMap::default();
        for &id in nodes {
            let first = |id: Id| values.first(id);
            let found = match *self.node(id) {
                Node::Quantity(content) if nodes.binary_search(&content).is_ok() => first(content),
                // a sine belongs to the cosine of the same node, a pivot to its unknown
                Node::Unary(Function::Sin | Function::Cos, _) | Node::Pivot(..) => id,
                ref node => *known.entry(node.words_of(first)).or_insert(id),
            };
            if found != id {
                values.firsts.insert(id, found);
                values.copies.entry(found).or_default().push(id);
            }
        }
        values
    }
}
