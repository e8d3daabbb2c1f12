//! How large a divisor has to be.

use crate::symbolic::graph::{Graph, Id};
use crate::symbolic::number::Function;

/// What a coefficient is compared with before it is divided by.
#[derive(Clone, Copy, Debug)]
pub enum Size {
    /// It is a sum of squares, and remains positive when others are eliminated: it is compared with
    /// its original value.
    Squares,
    /// It is a product of two vectors: it is compared with the product of their lengths.
    Product(Id),
    /// It is compared with the largest of its terms.
    Terms,
    /// The same for a mass to which loads may have added something. It is a pivot before the
    /// entries next to it.
    Masses,
    /// The same; as a pivot, it would destroy the positivity of the remaining sums of squares.
    Beside,
    /// Once all sums of squares are eliminated, it is the negative of one, and remains negative
    /// when others are eliminated: it is compared with its value at that point.
    Reduced,
}

impl Graph {
    /// The size of the largest term of a sum.
    pub fn largest_term(&mut self, sum: Id) -> Id {
        let mut largest = self.zero();
        for (_, term) in self.terms(sum) {
            let size = self.apply(Function::Abs, &[term]);
            largest = self.larger(largest, size);
        }
        largest
    }

    /// The larger of two sizes.
    pub(super) fn larger(&mut self, a: Id, b: Id) -> Id {
        if self.is_zero(a) {
            b
        } else {
            self.apply(Function::Max, &[a, b])
        }
    }
}
