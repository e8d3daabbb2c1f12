//! The size required of a divisor.

use crate::symbolic::graph::{Graph, Id};
use crate::symbolic::number::Function;

/// The reference size of a coefficient before a division by it.
#[derive(Clone, Copy, Debug)]
pub enum Size {
    /// It is a sum of squares, and remains positive if others are eliminated: it is compared with
    /// its original value.
    Squares,
    /// It is a product of two vectors, compared with the product of their lengths.
    Product(Id),
    /// It is compared with the largest of its terms.
    Terms,
    /// The same for a mass, to which loads may have added. It is divided by before the entries
    /// next to it.
    Masses,
    /// The same; and as a pivot, it would make remaining sums of squares lose their positivity.
    Beside,
    /// Once all sums of squares are eliminated it is minus one, and remains negative if others are
    /// eliminated: it is compared with its value at that point.
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
