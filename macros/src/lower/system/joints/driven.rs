//! Joints whose motion is prescribed: `.driven(speed * t)`.

use proc_macro2::Ident;

use crate::errors::Errors;
use crate::model::{Coordinate, Dimension, JointKind, Meaning, Rates, Variable};
use crate::symbolic::{Id, Node};
use crate::syntax::Expression;

use crate::lower::system::reading::reader::Reader;

/// The coordinates of a joint, with the variables of their rates and accelerations.
pub fn coordinates(kind: &JointKind) -> Vec<(&'static str, [Variable; 3], usize)> {
    let fields = kind.shape.into_iter().flat_map(|shape| shape.fields);
    let fields = fields.filter_map(|field| {
        let variables = match field.variable {
            Variable::Position => [
                Variable::Position,
                Variable::Velocity,
                Variable::LinearAcceleration,
            ],
            Variable::Angle => [
                Variable::Angle,
                Variable::AngularVelocity,
                Variable::AngularAcceleration,
            ],
            _ => return None,
        };
        Some((field, variables))
    });
    fields
        .flat_map(|(field, variables)| {
            let names = field.names.iter().enumerate();
            names.map(move |(part, name)| (*name, variables, field.first + part))
        })
        .collect()
}

/// Whether the coordinates of a joint are numbers, each with a rate.
fn has_numbers(kind: &JointKind) -> bool {
    let fields = kind.shape.into_iter().flat_map(|shape| shape.fields);
    let mut turning = fields.filter(|field| field.variable == Variable::Quaternion);
    turning.next().is_none() && !coordinates(kind).is_empty() && !kind.is_free()
}

impl Reader<'_> {
    /// `.driven(f)`, if given: the coordinates as functions of time, with their rates and
    /// accelerations; the inner `None` is none.
    #[allow(clippy::option_option, reason = "outer: reported; inner: not written")]
    pub fn driven(
        &mut self,
        kind: &JointKind,
        methods: &[(&Ident, &[Expression])],
        errors: &mut Errors,
    ) -> Option<Option<Rates>> {
        let mut written = methods.iter().filter(|(method, _)| *method == "driven");
        let Some((word, functions)) = written.next() else {
            return Some(None);
        };
        if let Some((again, _)) = written.next() {
            errors.push(again.span(), "`.driven(..)` is written twice");
            return None;
        }
        let all = coordinates(kind);
        if !has_numbers(kind) {
            let message = format!(
                "`{}` has no coordinates that are numbers: none to prescribe",
                kind.word
            );
            errors.push(word.span(), message);
            return None;
        }
        if functions.len() != all.len() {
            let names: Vec<&str> = all.iter().map(|(name, ..)| *name).collect();
            errors.push(
                word.span(),
                format!(
                    "`.driven(..)` gives the coordinates as functions of time: `{}`",
                    names.join("`, `")
                ),
            );
            return None;
        }
        let mut list = Some(Vec::new());
        for (function, (_, variables, part)) in functions.iter().zip(all) {
            let dimension = match variables[0] {
                Variable::Position => Dimension::LENGTH,
                _ => Dimension::NONE,
            };
            let motion = self.prescribed(function, dimension, errors);
            match (motion, &mut list) {
                (Some(motion), Some(list)) => {
                    let both = variables.into_iter().zip(motion);
                    list.extend(both.map(|(variable, id)| Coordinate { variable, part, id }));
                }
                _ => list = None,
            }
        }
        Some(Some(Rates(list?)))
    }

    /// A function of time, its rate and its acceleration.
    fn prescribed(
        &mut self,
        written: &Expression,
        dimension: Dimension,
        errors: &mut Errors,
    ) -> Option<[Id; 3]> {
        let value = self.at_top(errors, |lowering| {
            lowering.scalar(written, dimension, "the coordinate of a driven joint")
        })?;
        let rate = self.rate(value, written, errors)?;
        let acceleration = self.rate(rate, written, errors)?;
        Some([value, rate, acceleration])
    }

    /// The rate of a function of time, and of inputs with their rates.
    fn rate(&mut self, value: Id, written: &Expression, errors: &mut Errors) -> Option<Id> {
        let graph = &self.work.graph;
        let symbols = graph.reachable(&[value], |id| !graph.is_early(id));
        let symbols = symbols
            .into_iter()
            .filter(|id| matches!(graph.node(*id), Node::Symbol(_)) && !graph.is_early(*id));
        let symbols: Vec<Id> = symbols.collect();
        let mut terms = Vec::new();
        for symbol in symbols {
            let rate = match self.work.meaning(symbol) {
                Some(Meaning::Time) => Some(self.work.graph.one()),
                Some(Meaning::Input(input, part)) if self.derivatives[input] > 0 => {
                    self.work.symbol_of(Meaning::Input(input + 1, part))
                }
                _ => None,
            };
            let Some(rate) = rate else {
                errors.push(
                    written.extent,
                    "the motion of a driven joint needs its rate and its acceleration: write a function of `t`, or \
                     of an input with both, `crank[rad].moving`",
                );
                return None;
            };
            let slope = self.work.graph.derivative(&[value], symbol)[0];
            terms.push(self.work.graph.multiply(slope, rate));
        }
        Some(self.work.graph.sum(&terms))
    }
}
