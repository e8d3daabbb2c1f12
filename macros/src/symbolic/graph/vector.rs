//! Vectors and symmetric matrices of expressions, component by component.

use core::borrow::Borrow;

use crate::symbolic::number::Function;

use super::nodes::{Components, Graph, Id, Node};

impl Graph {
    pub fn zeros(&self) -> Components {
        [self.zero(); 3]
    }

    pub fn is_zero_vector(&self, a: &Components) -> bool {
        a.iter().all(|component| self.is_zero(*component))
    }

    /// Makes each component a statement.
    pub fn quantities(&mut self, a: Components) -> Components {
        a.map(|component| self.quantity(component))
    }

    /// Makes each component a result.
    pub fn results(&mut self, a: Components) -> Components {
        a.map(|component| self.result(component))
    }

    pub fn negate_vector(&mut self, a: Components) -> Components {
        a.map(|component| self.negate(component))
    }

    /// The unit vectors along the three axes.
    pub fn unit_vectors(&mut self) -> [Components; 3] {
        [0, 1, 2].map(|place| [0, 1, 2].map(|part| self.integer(i64::from(part == place))))
    }

    pub fn add_vectors(&mut self, a: Components, b: Components) -> Components {
        [0, 1, 2].map(|i| self.add(a[i], b[i]))
    }

    pub fn subtract_vectors(&mut self, a: Components, b: Components) -> Components {
        [0, 1, 2].map(|i| self.subtract(a[i], b[i]))
    }

    pub fn scale_vector(&mut self, factor: Id, a: Components) -> Components {
        a.map(|component| self.multiply(factor, component))
    }

    pub fn dot(&mut self, a: Components, b: Components) -> Id {
        let products = [0, 1, 2].map(|i| self.multiply(a[i], b[i]));
        self.sum(&products)
    }

    /// The sum of the products of corresponding entries.
    pub fn inner(
        &mut self,
        a: impl IntoIterator<Item: Borrow<Id>>,
        b: impl IntoIterator<Item: Borrow<Id>>,
    ) -> Id {
        let pairs = a.into_iter().zip(b);
        let products: Vec<Id> = pairs
            .map(|(a, b)| self.multiply(*a.borrow(), *b.borrow()))
            .collect();
        self.sum(&products)
    }

    pub fn cross(&mut self, a: Components, b: Components) -> Components {
        [(1, 2), (2, 0), (0, 1)].map(|(i, j)| {
            let (left, right) = (self.multiply(a[i], b[j]), self.multiply(a[j], b[i]));
            self.subtract(left, right)
        })
    }

    pub fn norm_squared(&mut self, a: Components) -> Id {
        self.dot(a, a)
    }

    pub fn norm(&mut self, a: Components) -> Id {
        let square = self.norm_squared(a);
        self.apply(Function::Sqrt, &[square])
    }

    /// The product of a matrix, given by rows, with a vector.
    pub fn transform(&mut self, matrix: &[Components; 3], a: Components) -> Components {
        matrix.map(|row| self.dot(row, a))
    }

    /// Whether all components but the one along this axis are zero.
    pub fn is_along(&self, a: Components, axis: usize) -> bool {
        (0..3).all(|other| other == axis || self.is_zero(a[other]))
    }

    /// The cofactors of a symmetric matrix; divided by its determinant, they are its inverse.
    pub fn cofactors(&mut self, m: &[Components; 3]) -> [Components; 3] {
        [
            self.cross(m[1], m[2]),
            self.cross(m[2], m[0]),
            self.cross(m[0], m[1]),
        ]
    }

    /// `factor` times a sum, distributed over the terms where that costs no operation: an early
    /// term is multiplied early, and terms with an early factor absorb `factor`, if at most one
    /// term has none.
    pub fn distribute(&mut self, factor: Id, a: Id) -> Id {
        let (early, late) = self.split_term(a);
        let early = self.multiply(factor, early);
        let terms = self.terms(late);
        let mut bare = 0;
        for (_, term) in &terms {
            let (_, magnitude) = self.split_sign(*term);
            let (own, _) = self.split_factor(magnitude);
            bare += usize::from(self.is_one(own));
        }
        let late = if bare > 1 {
            self.multiply(factor, late)
        } else {
            let mut sum = self.zero();
            for (negative, term) in terms {
                let scaled = self.multiply(factor, term);
                sum = if negative {
                    self.subtract(sum, scaled)
                } else {
                    self.add(sum, scaled)
                };
            }
            sum
        };
        self.add(late, early)
    }

    /// The terms of a sum, in order, and whether each is subtracted.
    pub fn terms(&self, a: Id) -> Vec<(bool, Id)> {
        let mut terms = Vec::new();
        let mut pending = vec![(false, a)];
        while let Some((negative, id)) = pending.pop() {
            match *self.node(id) {
                Node::Add(x, y) => pending.extend([(negative, y), (negative, x)]),
                Node::Subtract(x, y) => pending.extend([(!negative, y), (negative, x)]),
                Node::Negate(x) => pending.push((!negative, x)),
                _ => terms.push((negative, id)),
            }
        }
        terms
    }
}
