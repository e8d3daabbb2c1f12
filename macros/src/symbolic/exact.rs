//! Numbers as they are in a description: rational ones exactly, all others to 200 bits.

use super::algebra::Algebra;
use super::function::Function;
use super::graph::Comparison;
use super::number::Number;

/// Numbers; `None` where there is no value.
pub struct Exact;

impl Algebra for Exact {
    type Value = Option<Number>;

    fn number(&mut self, number: &Number) -> Option<Number> {
        Some(number.sampled())
    }

    fn undefined(&mut self) -> Option<Number> {
        None
    }

    fn negate(&mut self, a: &Option<Number>) -> Option<Number> {
        Some(-a.clone()?)
    }

    fn add(&mut self, a: &Option<Number>, b: &Option<Number>) -> Option<Number> {
        carried(a.clone()? + b.clone()?)
    }

    fn multiply(&mut self, a: &Option<Number>, b: &Option<Number>) -> Option<Number> {
        carried(a.clone()? * b.clone()?)
    }

    fn divide(&mut self, a: &Option<Number>, b: &Option<Number>) -> Option<Number> {
        carried(a.as_ref()?.checked_div(b.as_ref()?)?)
    }

    fn apply(&mut self, function: Function, arguments: &[Option<Number>]) -> Option<Number> {
        let arguments: Option<Vec<Number>> = arguments.iter().cloned().collect();
        carried(Number::apply_sampled(function, &arguments?)?)
    }

    fn is_zero(&self, a: &Option<Number>) -> bool {
        a.as_ref().is_some_and(Number::is_zero)
    }

    fn is_not_zero(&self, a: &Option<Number>) -> bool {
        a.as_ref().is_some_and(|a| !a.is_zero())
    }

    fn compare(
        &mut self,
        comparison: Comparison,
        a: &Option<Number>,
        b: &Option<Number>,
    ) -> Option<Number> {
        let holds = comparison.holds(a.as_ref()?.cmp(b.as_ref()?));
        Some(Number::integer(i64::from(holds)))
    }

    fn select(
        &mut self,
        condition: &Option<Number>,
        first: &Option<Number>,
        second: &Option<Number>,
    ) -> Option<Number> {
        if condition.as_ref()?.is_zero() {
            second.clone()
        } else {
            first.clone()
        }
    }
}

fn carried(number: Number) -> Option<Number> {
    number.is_carried().then_some(number)
}
