//! Calls of the user's Rust functions.

use proc_macro2::Ident;

use crate::lower::expressions::lowering::Lowering;
use crate::lower::expressions::scope::Value;
use crate::symbolic::Foreign;
use crate::syntax::Expression;

impl Lowering<'_> {
    /// The value of the function with this index, converted to SI units.
    pub fn foreign(
        &mut self,
        number: usize,
        word: &Ident,
        written: &[Expression],
    ) -> Option<Value> {
        let arguments = &self.work.functions[number].arguments;
        if arguments.len() != written.len() {
            let (expected, count) = (arguments.len(), written.len());
            let names: Vec<String> = arguments
                .iter()
                .map(|(name, ..)| name.to_string())
                .collect();
            let names = names.join(", ");
            let s = if expected == 1 { "" } else { "s" };
            let message =
                format!("`{word}({names})` takes {expected} argument{s}, and this has {count}");
            self.visit(written);
            return self.report(word.span(), message);
        }
        let expected = arguments.clone();
        let mut values = [self.work.graph.zero(); Foreign::ARGUMENTS];
        let mut is_read = true;
        for (place, ((name, factor, dimension), written)) in
            expected.iter().zip(written).enumerate()
        {
            let what = format!("`{name}` of `{word}`");
            let Some(value) = self.scalar(written, *dimension, &what) else {
                is_read = false;
                continue;
            };
            let graph = &mut self.work.graph;
            let factor = graph.number(factor.clone());
            values[place] = graph.divide(value, factor);
        }
        if !is_read {
            return None;
        }
        let (factor, dimension) = self.work.functions[number].result.clone();
        let graph = &mut self.work.graph;
        let value = graph.foreign(Foreign::new(number), values);
        let factor = graph.number(factor);
        Some(Value::Scalar(graph.multiply(factor, value), dimension))
    }
}
