//! Where functions and quotients have no value, and why.

use crate::errors::Extent;
use crate::model::{Doubtful, why_not};
use crate::symbolic::Id;

use super::lowering::Lowering;

impl Lowering<'_> {
    /// Refuses what has no value, at its word; what parameters may bring there is remembered.
    pub fn check_value(
        &mut self,
        word: &str,
        operands: &[Id],
        value: Id,
        place: Extent,
    ) -> Option<()> {
        let graph = &self.work.graph;
        if graph.is_undefined(value) {
            let numbers = operands.iter().map(|id| graph.as_number(*id).cloned());
            let why = numbers.collect::<Option<Vec<_>>>();
            let why = why.map_or_else(
                || format!("`{word}` has no value"),
                |all| why_not(word, &all),
            );
            return self.report(place, why);
        }
        if graph.is_early(value) && graph.as_number(value).is_none() {
            self.work.doubtful.push(Doubtful {
                word: word.to_owned(),
                operands: operands.to_vec(),
                value,
                place,
            });
        }
        Some(())
    }
}
