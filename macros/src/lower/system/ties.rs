//! Links and cables: their ends, and their properties.

use proc_macro2::Ident;

use crate::errors::{Errors, every};
use crate::model::{Dimension, Property, Tie, shown};
use crate::symbolic::{Id, Number};
use crate::syntax::{Definition, Expression, LINK, call};

use super::joints::joint::first_name_of;
use super::reading::reader::Reader;

/// A property of a link or a cable.
#[derive(Clone, Copy)]
pub struct Sort {
    /// The word for it, and what it is a property of.
    pub word: &'static str,
    pub of: &'static str,
    pub dimension: Dimension,
    pub may_vanish: bool,
}

pub const LENGTH_OF_CABLE: Sort = Sort {
    of: "cable",
    may_vanish: true,
    ..LENGTH_OF_LINK
};

pub const STIFFNESS_OF_CABLE: Sort = Sort {
    word: "stiffness",
    dimension: Dimension::STIFFNESS,
    ..LENGTH_OF_CABLE
};

impl Sort {
    fn allows(&self, number: &Number) -> bool {
        number.is_positive() || number.is_zero() && self.may_vanish
    }
}

const LENGTH_OF_LINK: Sort = Sort {
    word: "length",
    of: "link",
    dimension: Dimension::LENGTH,
    may_vanish: false,
};

impl Reader<'_> {
    /// The links, `link(P, Q, length)`, and their lengths.
    pub fn links(&mut self, errors: &mut Errors) -> Option<(Vec<Tie>, Vec<Property>)> {
        let system = self.system;
        let (mut ties, mut lengths) = (Vec::new(), Vec::new());
        for written in &system.top.constraints {
            let Some(((word, [p, q, length]), _)) = written.value.as_ref().and_then(call) else {
                continue;
            };
            if word != LINK {
                continue;
            }
            ties.push(Tie {
                name: written.name.clone(),
                bodies: [p, q].map(|end| self.body_of(end)),
            });
            lengths.push(self.property(written, length, LENGTH_OF_LINK, errors));
        }
        Some((ties, every(lengths)?))
    }

    /// The body of a point; `None` for the ground.
    fn body_of(&self, end: &Expression) -> Option<Ident> {
        let mut bodies = self.system.bodies.iter().map(|body| &body.name);
        first_name_of(end)
            .filter(|name| bodies.any(|body| body == *name))
            .cloned()
    }

    /// A property of a link or a cable. It must be valid for the defaults of parameters.
    pub fn property(
        &mut self,
        tie: &Definition,
        written: &Expression,
        sort: Sort,
        errors: &mut Errors,
    ) -> Option<Property> {
        let what = format!("the {} of a {}", sort.word, sort.of);
        let value = self.at_top(errors, |lowering| {
            lowering.property(written, sort.dimension, &what)
        })?;
        let known = self.with_defaults(value);
        if let Some(number) = known.filter(|number| !sort.allows(number)) {
            let number = shown(&number);
            let message = format!(
                "with the defaults of the parameters this is {number}: {what} cannot be that"
            );
            return errors.report(written.extent, message);
        }
        Some(Property {
            of: tie.name.clone(),
            word: sort.word,
            value,
            may_vanish: sort.may_vanish,
        })
    }

    /// The numerical value of an expression with the defaults of parameters, if it has one.
    pub fn with_defaults(&mut self, value: Id) -> Option<Number> {
        let defaults = &self.defaults;
        let graph = &mut self.work.graph;
        let known = graph.substitute(&[value], |id| defaults.get(&id).copied());
        graph.as_number(known[0]).cloned()
    }
}
