//! Expressions without branches: what holds of them holds of every branch.

use std::collections::HashMap;

use super::graph::{Graph, Id, Node, Stage};

impl Graph {
    /// `roots` with both sides of every condition mixed, by a factor of its own for each condition, and
    /// a symbol in the place of each function that is made of pieces: an identity that is linear in the
    /// sides is one of the mixture only if it is one of both.
    pub fn unbranched(&mut self, roots: &[Id]) -> Vec<Id> {
        let mut stand_ins: HashMap<Id, Id> = HashMap::new();
        for id in self.reachable(roots, |_| true) {
            let key = match *self.node(id) {
                Node::Select(condition, ..) => condition,
                Node::Unary(function, _) | Node::Binary(function, ..)
                    if function.is_piecewise() && self.stage(id) != Stage::Constant =>
                {
                    id
                }
                _ => continue,
            };
            stand_ins
                .entry(key)
                .or_insert_with(|| self.symbol(Stage::State));
        }
        if stand_ins.is_empty() {
            return roots.to_vec();
        }
        self.rebuild(roots, |graph, id, image| match *graph.node(id) {
            Node::Select(condition, first, second) => {
                let (first, second) = (image(first), image(second));
                let difference = graph.subtract(first, second);
                let part = graph.multiply(stand_ins[&condition], difference);
                graph.add(second, part)
            }
            Node::Unary(..) | Node::Binary(..) if stand_ins.contains_key(&id) => stand_ins[&id],
            _ => graph.remake(id, image),
        })
    }
}
