//! The replacement of symbols: by numbers, it is exact evaluation.

use super::graph::{Graph, Id, Node};

impl Graph {
    /// `roots` with symbols replaced: `replacement` answers for those that change.
    pub fn substitute(&mut self, roots: &[Id], replacement: impl Fn(Id) -> Option<Id>) -> Vec<Id> {
        let order = self.reachable(roots, |_| true);
        let mut images: Vec<Id> = Vec::new();
        images.resize(order.last().map_or(0, |last| last.index() + 1), self.zero());
        for id in order {
            let node = self.node(id).clone();
            let image = |operand: Id| images[operand.index()];
            images[id.index()] = match node {
                Node::Symbol(_) => replacement(id).unwrap_or(id),
                Node::Number(_) | Node::Truth(_) | Node::Undefined => id,
                Node::Quantity(a) => self.quantity(image(a)),
                Node::Negate(a) => self.negate(image(a)),
                Node::Add(a, b) => self.add(image(a), image(b)),
                Node::Subtract(a, b) => self.subtract(image(a), image(b)),
                Node::Multiply(a, b) => self.multiply(image(a), image(b)),
                Node::Divide(a, b) => self.divide(image(a), image(b)),
                Node::Unary(function, a) => self.apply(function, &[image(a)]),
                Node::Binary(function, a, b) => self.apply(function, &[image(a), image(b)]),
                Node::Compare(comparison, a, b) => self.compare(comparison, image(a), image(b)),
                Node::And(a, b) => self.and(image(a), image(b)),
                Node::Or(a, b) => self.or(image(a), image(b)),
                Node::Not(a) => self.not(image(a)),
                Node::Select(condition, a, b) => self.select(image(condition), image(a), image(b)),
            };
        }
        roots.iter().map(|root| images[root.index()]).collect()
    }
}
