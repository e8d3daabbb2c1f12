//! Rust constants and functions of the user: their names and units.

use crate::errors::every;
use crate::lower::expressions::{Lowering, Value, lower_unit};
use crate::model::{Dimension, ForeignConstant, ForeignFunction, Meaning, is_solid};
use crate::symbolic::{Foreign, Function, Number, Stage};
use crate::syntax::{self, Description, UnitExpression};

/// Functions of the language, and words that are called like functions.
const CALLED: [&str; 5] = ["table", "moment", "principal", "compose", "point"];

impl Lowering<'_> {
    pub fn foreign_definitions(&mut self, description: &Description) {
        for constant in &description.constants {
            let value = self.foreign_constant(constant);
            self.scope.define(&constant.name.to_string(), value);
        }
        for function in &description.functions {
            let value = self.foreign_function(function);
            self.scope.define(&function.name.to_string(), value);
        }
    }

    fn foreign_constant(&mut self, written: &syntax::Constant) -> Option<Value> {
        let value = written.value.clone()?;
        let (factor, dimension) = self.factor(written.unit.as_ref())?;
        let number = self.work.constants.len();
        let symbol = self
            .work
            .symbol(Stage::Parameter, Meaning::Constant(number));
        self.work.labels.name(symbol, written.name.to_string());
        self.work.constants.push(ForeignConstant {
            name: written.name.clone(),
            value,
        });
        let factor = self.work.graph.number(factor);
        let value = self.work.graph.multiply(factor, symbol);
        Some(Value::Scalar(value, dimension))
    }

    fn foreign_function(&mut self, written: &syntax::Function) -> Option<Value> {
        let (name, word) = (&written.name, written.name.to_string());
        let is_called = CALLED.contains(&word.as_str()) || is_solid(name);
        if is_called || Function::from_name(&word).is_some() {
            let message = format!("`{word}` is a function of the language: choose another name");
            return self.report(name.span(), message);
        }
        let number = self.work.functions.len();
        if number == Foreign::COUNT {
            let message = format!("more than {} functions", Foreign::COUNT);
            return self.report(name.span(), message);
        }
        let arguments = written.arguments.iter();
        let arguments = every(arguments.map(|(name, unit)| {
            let (factor, dimension) = match unit {
                Some(unit) => lower_unit(unit, self.errors)?,
                None => (Number::one(), Dimension::NONE),
            };
            Some((name.clone(), factor, dimension))
        }));
        let result = self.factor(written.unit.as_ref());
        self.work.functions.push(ForeignFunction {
            name: name.clone(),
            arguments: arguments?,
            result: result?,
            paths: written.paths.clone(),
        });
        Some(Value::Function(number))
    }

    /// The factor that converts this unit to SI units, and its dimension. Without a unit, the value
    /// is a plain number, which fits any dimension.
    fn factor(&mut self, unit: Option<&UnitExpression>) -> Option<(Number, Dimension)> {
        match unit {
            Some(unit) => lower_unit(unit, self.errors),
            None => Some((Number::one(), Dimension::ANY)),
        }
    }
}
