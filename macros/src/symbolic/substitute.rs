//! The replacement of symbols: by numbers, it is exact evaluation.

use super::graph::{Graph, Id, Node};

impl Graph {
    /// `roots` with symbols replaced: `replacement` answers for those that change.
    pub fn substitute(&mut self, roots: &[Id], replacement: impl Fn(Id) -> Option<Id>) -> Vec<Id> {
        self.rebuild(roots, |graph, id, image| match graph.node(id) {
            Node::Symbol(_) => replacement(id).unwrap_or(id),
            _ => graph.remake(id, image),
        })
    }

    /// `roots` made again from below: `make` makes a node of the images of its operands.
    pub(super) fn rebuild(
        &mut self,
        roots: &[Id],
        make: impl Fn(&mut Self, Id, &dyn Fn(Id) -> Id) -> Id,
    ) -> Vec<Id> {
        let order = self.reachable(roots, |_| true);
        let mut images: Vec<Id> = Vec::new();
        images.resize(order.last().map_or(0, |last| last.index() + 1), self.zero());
        for id in order {
            images[id.index()] = make(self, id, &|operand| images[operand.index()]);
        }
        roots.iter().map(|root| images[root.index()]).collect()
    }

    /// The same operation on the images of the operands.
    pub(super) fn remake(&mut self, id: Id, image: &dyn Fn(Id) -> Id) -> Id {
        match *self.node(id) {
            Node::Symbol(_) | Node::Number(_) | Node::Truth(_) | Node::Undefined => id,
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
            Node::Pivot(a, b) => self.pivot(image(a), image(b)),
            Node::Select(condition, a, b) => self.select(image(condition), image(a), image(b)),
        }
    }
}
