//! Solids of uniform density, and their moments of inertia.

use proc_macro2::Ident;

use crate::errors::{Extent, every};
use crate::lower::expressions::Lowering;
use crate::model::{Dimension, Inertia, Mass, SOLIDS, Solid, shown};
use crate::symbolic::{Id, Number};
use crate::syntax::Expression;

use super::draft::{Context, Draft};

impl Lowering<'_> {
    /// `cylinder(r, h)` and the others, computed exactly.
    pub fn solid(
        &mut self,
        word: &Ident,
        written: &[Expression],
        extent: Extent,
        context: Context<'_>,
    ) -> Option<Draft> {
        let solid = SOLIDS.iter().find(|solid| word == solid.word)?;
        let squares = self.squared_lengths(solid, word, written, context);
        let mass = match context.mass {
            Mass::Known(mass) => Some(mass),
            Mass::Reported => None,
            Mass::Absent => self.report(
                word.span(),
                format!("`{word}(..)` needs the mass of the body: write `mass: ..`"),
            ),
        };
        let (squares, mass) = (squares?, mass?);
        let graph = &mut self.work.graph;
        let moments = solid.moments.map(|factors| {
            let terms = factors
                .iter()
                .zip(&squares)
                .map(|((above, below), square)| {
                    let factor = graph.number(Number::ratio(*above, *below));
                    graph.multiply(factor, *square)
                });
            let terms: Vec<Id> = terms.collect();
            let per_mass = graph.sum(&terms);
            graph.multiply(mass, per_mass)
        });
        if self.motion.is_line() && word == "rod" {
            return Some(Draft {
                inertia: Inertia::Scalar(moments[0]),
                entries: Vec::new(),
                extent,
            });
        }
        let moments = if self.motion.is_planar && word == "rod" {
            // in the plane, a rod lies in that plane
            [moments[2], moments[0], moments[1]]
        } else {
            moments
        };
        let mut rows = [self.work.graph.zeros(); 3];
        for (i, moment) in moments.into_iter().enumerate() {
            rows[i][i] = moment;
        }
        Some(Draft {
            inertia: Inertia::Spatial(rows),
            entries: Vec::new(),
            extent,
        })
    }

    fn squared_lengths(
        &mut self,
        solid: &Solid,
        word: &Ident,
        written: &[Expression],
        context: Context<'_>,
    ) -> Option<Vec<Id>> {
        let (expected, found) = (solid.lengths.len(), written.len());
        if expected != found {
            self.visit(written);
            let lengths = if expected == 1 { "length" } else { "lengths" };
            let names = solid.lengths.join(", ");
            let spare = written.get(expected).map(|spare| spare.extent);
            return self.report(
                spare.unwrap_or_else(|| word.span().into()),
                format!("`{word}({names})` takes {expected} {lengths}, and this has {found}"),
            );
        }
        let lengths = written.iter().map(|length| self.length(length, context));
        let lengths = every(lengths)?;
        if let Some((small, large, reason)) = solid.smaller
            && let (Some(a), Some(b)) = (
                self.known(lengths[small], context.defaults),
                self.known(lengths[large], context.defaults),
            )
            && a >= b
        {
            let (a, b) = (shown(&a), shown(&b));
            return self.report(
                written[small].extent,
                format!(
                    "{reason}: {} = {a} and {} = {b}",
                    solid.lengths[small], solid.lengths[large]
                ),
            );
        }
        let graph = &mut self.work.graph;
        Some(
            lengths
                .into_iter()
                .map(|length| graph.square(length))
                .collect(),
        )
    }

    fn length(&mut self, written: &Expression, context: Context<'_>) -> Option<Id> {
        let length = self.scalar(written, Dimension::LENGTH, "a length")?;
        self.check_early(written, &[length], "a length of a rigid body is constant")?;
        match self.known(length, context.defaults) {
            Some(number) if !number.is_positive() => {
                let number = shown(&number);
                self.report(
                    written.extent,
                    format!("a length is positive, and this is {number}"),
                )
            }
            _ => Some(length),
        }
    }
}
