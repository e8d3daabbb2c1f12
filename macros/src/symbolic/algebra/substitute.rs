//! The replacement of symbols. If all of them are replaced by numbers, this is exact evaluation.

use crate::symbolic::graph::{Comparison, Graph, Id, Node};
use crate::symbolic::number::{Foreign, Function, Number};

use super::operations::{self, Algebra};

impl Graph {
    /// `roots` with symbols replaced: `replacement` gives the new expression of each symbol that
    /// changes.
    pub fn substitute(&mut self, roots: &[Id], replacement: impl Fn(Id) -> Option<Id>) -> Vec<Id> {
        self.rebuild(roots, |graph, id, image| match graph.node(id) {
            Node::Symbol(_) => replacement(id).unwrap_or(id),
            _ => graph.remake(id, image),
        })
    }

    /// `roots` rebuilt from below: `make` makes a node from the images of its operands.
    pub(in crate::symbolic) fn rebuild(
        &mut self,
        roots: &[Id],
        make: impl Fn(&mut Self, Id, &dyn Fn(Id) -> Id) -> Id,
    ) -> Vec<Id> {
        let order = self.nodes_of(roots);
        let images = self.images(&order, make);
        roots.iter().map(|root| images[root.index()]).collect()
    }

    /// The image of each node in `order`, operands first, at the place of the node.
    pub(in crate::symbolic) fn images(
        &mut self,
        order: &[Id],
        make: impl Fn(&mut Self, Id, &dyn Fn(Id) -> Id) -> Id,
    ) -> Vec<Id> {
        let size = order.last().map_or(0, |last| last.index() + 1);
        let mut images = vec![self.zero(); size];
        for id in order {
            images[id.index()] = make(self, *id, &|operand| images[operand.index()]);
        }
        images
    }

    /// The same operation on the images of the operands.
    pub(in crate::symbolic) fn remake(&mut self, id: Id, image: &dyn Fn(Id) -> Id) -> Id {
        match self.node(id) {
            Node::Symbol(_) | Node::Number(_) | Node::Truth(_) | Node::Undefined => id,
            operation => {
                let operation = operation.clone();
                operations::value(self, &operation, image)
            }
        }
    }
}

/// Expressions made of other expressions.
impl Graph {
    /// A vector with symbols replaced by values.
    pub fn replaced<const N: usize>(
        &mut self,
        components: [Id; N],
        values: &[(Id, Id)],
    ) -> [Id; N] {
        let value = |id: Id| {
            let known = values.iter().find(|(symbol, _)| *symbol == id);
            known.map(|(_, value)| *value)
        };
        let images = self.substitute(&components, value);
        core::array::from_fn(|place| images[place])
    }
}

impl Algebra for Graph {
    type Value = Id;

    fn number(&mut self, number: &Number) -> Id {
        self.number(number.clone())
    }

    fn undefined(&mut self) -> Id {
        self.undefined()
    }

    fn negate(&mut self, a: &Id) -> Id {
        self.negate(*a)
    }

    fn add(&mut self, a: &Id, b: &Id) -> Id {
        self.add(*a, *b)
    }

    fn multiply(&mut self, a: &Id, b: &Id) -> Id {
        self.multiply(*a, *b)
    }

    fn divide(&mut self, a: &Id, b: &Id) -> Id {
        self.divide(*a, *b)
    }

    fn apply(&mut self, function: Function, arguments: &[Id]) -> Id {
        self.apply(function, arguments)
    }

    fn foreign(&mut self, function: Foreign, arguments: &[Id; Foreign::ARGUMENTS]) -> Id {
        self.foreign(function, *arguments)
    }

    fn is_zero(&self, a: &Id) -> bool {
        self.is_zero(*a)
    }

    fn compare(&mut self, comparison: Comparison, a: &Id, b: &Id) -> Id {
        self.compare(comparison, *a, *b)
    }

    fn select(&mut self, condition: &Id, first: &Id, second: &Id) -> Id {
        self.select(*condition, *first, *second)
    }

    fn and(&mut self, a: &Id, b: &Id) -> Id {
        self.and(*a, *b)
    }

    fn or(&mut self, a: &Id, b: &Id) -> Id {
        self.or(*a, *b)
    }

    fn not(&mut self, a: &Id) -> Id {
        self.not(*a)
    }

    fn truth(&mut self, holds: bool) -> Id {
        self.truth(holds)
    }

    fn quantity(&mut self, a: &Id) -> Id {
        self.quantity(*a)
    }

    fn positive(&mut self, a: &Id) -> Id {
        self.positive(*a)
    }

    fn pivot(&mut self, divisor: &Id, scale: &Id) -> Id {
        self.pivot(*divisor, *scale)
    }
}
