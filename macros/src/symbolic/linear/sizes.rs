//! How large what is divided by has to be.

use crate::symbolic::graph::{Graph, Id};
use crate::symbolic::number::Function;

/// What a coefficient is compared with before it is divided by.
#[derive(Clone, Copy, Debug)]
pub enum Size {
    /// It is a sum of squares, and remains positive if others are eliminated: it is compared with
    /// itself as it was.
    Squares,
    /// It is a product of two vectors, with the product of their lengths.
    Product(Id),
    /// It is compared with the largest of its terms.
    Terms,
    /// The same; and if it were a pivot, sums of squares that are left would remain positive no longer.
    Beside,
    /// Once all sums of squares are eliminated it is minus one, and remains negative if others are
    /// eliminated: it is compared with itself as it was then.
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

    /// Of two sizes.
    pub(super) fn larger(&mut self, a: Id, b: Id) -> Id {
        if self.is_zero(a) {
            b
        } else {
            self.apply(Function::Max, &[a, b])
        }
    }
}
