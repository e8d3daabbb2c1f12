//! Inertia: from the written form to the tensor about G, checked.

use proc_macro2::Ident;

use crate::errors::{similar, solid_meant};
use crate::lower::expressions::{Lowering, base, is_of_solid, lower_unit, written_motion};
use crate::model::{Defaults, Dimension, Inertia, Mass, is_solid, words};
use crate::symbolic::{Id, Number};
use crate::syntax::{Description, Expression, Kind, UnitExpression};

use super::across_axis::FORMS_OF_ROD;
use super::draft::{Context, Draft, Entry};

impl Lowering<'_> {
    /// Reads the value of `inertia:`, and checks it as far as it is known; `defaults` are the
    /// default values of parameters.
    pub fn inertia(
        &mut self,
        description: &Description,
        mass: Mass,
        defaults: &Defaults,
    ) -> Option<Inertia> {
        let name = &description.name;
        if let Some(parts) = &description.composition {
            let composed = self.composed?;
            if !self.motion.has_attitude() {
                return Some(Inertia::Absent);
            }
            self.check_composed(composed, &parts.word, defaults)?;
            return Some(composed.inertia);
        }
        let Some(written) = &description.inertia else {
            if !self.motion.has_attitude() {
                return Some(Inertia::Absent);
            }
            written_motion(description).filter(|_| !description.is_system())?;
            let form = if self.motion.has_one_moment() {
                "0.1[kg * m ^ 2]"
            } else {
                "principal(1, 2, 3)[kg * m ^ 2]"
            };
            let of_a_point = match (self.state.swings, self.motion.has_one_moment()) {
                (false, _) => "",
                (true, true) => ", for a point mass `inertia: 0[kg * m ^ 2]`",
                (true, false) => ", for a point mass `inertia: principal(0, 0, 0)[kg * m ^ 2]`",
            };
            return self.report(
                name.span(),
                format!("`{name}` turns and has no inertia: write `inertia: {form}`{of_a_point}"),
            );
        };
        let value = written.value.as_ref()?;
        // an inertia that is not needed is read too, so that its errors are found
        let draft = self.form(value, Context { mass, defaults })?;
        let turns = self.motion.has_attitude();
        match &base(value).kind {
            Kind::Call(word, _) if word == "rod" && !self.motion.has_one_moment() => {
                let beside = |mass| self.turns_beside(draft.inertia, mass, defaults);
                let is_held = mass.known().is_some_and(beside);
                if turns && !self.state.swings && !is_held {
                    let under = self.under();
                    return self.report(
                        word.span(),
                        format!(
                            "a rod has no moment of inertia about its own axis, and {under} \
                             it could turn about it: give it a radius, \
                             `cylinder(r, l)`"
                        ),
                    );
                }
            }
            _ => {
                self.check_not_a_rod(draft.inertia, draft.extent)?;
                self.check_inertia(&draft, defaults)?;
            }
        }
        Some(if turns {
            draft.inertia.positive(&mut self.work.graph)
        } else {
            Inertia::Absent
        })
    }

    /// A constant inertia, in the form that the kind of motion needs.
    pub fn form(&mut self, written: &Expression, context: Context<'_>) -> Option<Draft> {
        let mut draft = self.draft(written, context)?;
        if let (true, Inertia::Spatial(rows)) = (self.motion.is_planar, draft.inertia) {
            draft.inertia = Inertia::Scalar(rows[2][2]);
        }
        let entries = draft.inertia.entries();
        self.check_course(written, &entries, CONSTANT)?;
        if self.motion.is_line() {
            return self.across_axis(draft);
        }
        Some(draft)
    }

    fn draft(&mut self, written: &Expression, context: Context<'_>) -> Option<Draft> {
        match &written.kind {
            Kind::Unit(inner, unit) if !is_scalar(inner) => self.in_unit(inner, unit, context),
            Kind::Method(inner, method, _) if is_repeated(inner, method) => self.report(
                method.span(),
                format!("`.{method}(..)` is written twice: leave one of them out"),
            ),
            Kind::Method(inner, method, _) if method == "about" && is_of_solid(inner) => self
                .report(
                    method.span(),
                    "a solid is about its own center of mass, which is G: leave out `.about(..)`; a solid whose center \
                     is elsewhere is a part of `compose([..])`",
                ),
            Kind::Method(inner, method, arguments) if method == "about" => {
                let draft = self.draft(inner, context);
                let [point] = arguments.as_slice() else {
                    return self
                        .report(method.span(), "`.about` takes one point: write `.about(P)`");
                };
                let point = self.point(point)?;
                self.moved_to_center(draft?, point, context.mass, method)
            }
            Kind::Method(inner, method, arguments) if method == "along" => {
                let draft = self.draft(inner, context);
                self.along(draft, method, arguments)
            }
            Kind::Method(inner, method, arguments) if method == "turned" => {
                let draft = self.draft(inner, context);
                self.turned(draft, method, arguments)
            }
            Kind::Method(_, method, _) if method == "mass" => self.report(
                method.span(),
                "`.mass(..)` follows a part of `compose([..])`: that of a whole body is \
                 the key `mass`",
            ),
            Kind::Method(_, method, _) if method == "at" => self.report(
                method.span(),
                "`.at(..)` follows a part of `compose([..])`: a whole inertia is about G, \
                 or about another point P as `.about(P)`",
            ),
            Kind::Call(word, parts) if word == "principal" => {
                self.principal(word, parts, written.extent)
            }
            Kind::Record(word, fields) => self.record(word, fields, written.extent),
            Kind::Call(word, lengths) if is_solid(word) => {
                self.solid(word, lengths, written.extent, context)
            }
            Kind::Call(word, _) if word == "point" => self.report(
                word.span(),
                "a point has no inertia about itself: points are parts of `compose([..])`",
            ),
            Kind::Poisoned => None,
            Kind::Call(word, parts) if self.motion.is_line() || self.means_solid(word) => {
                self.no_form(word, parts)
            }
            _ if self.motion.has_one_moment() => {
                let moment = self.scalar(written, Dimension::INERTIA, "the inertia about G")?;
                Some(Draft {
                    inertia: Inertia::Scalar(moment),
                    entries: Vec::new(),
                    extent: written.extent,
                })
            }
            _ => self.not_in_space(written),
        }
    }

    /// An inertia in one of its forms, followed by a unit.
    fn in_unit(
        &mut self,
        inner: &Expression,
        unit: &UnitExpression,
        context: Context<'_>,
    ) -> Option<Draft> {
        let draft = self.draft(inner, context);
        if is_of_solid(inner) {
            return self.report(
                unit.extent,
                "units belong to the lengths of a solid: write `sphere(0.1[m])`",
            );
        }
        let (factor, dimension) = lower_unit(unit, self.errors)?;
        let draft = draft?;
        if !dimension.fits(Dimension::INERTIA) {
            let (expected, found) = (Dimension::INERTIA, dimension.described());
            return self.report(
                unit.extent,
                format!("an inertia is in {expected}, and this is {found}"),
            );
        }
        let factor = self.work.graph.number(factor);
        Some(self.scale_draft(factor, draft))
    }

    /// Reports an expression that is not the inertia of a body in space.
    fn not_in_space(&mut self, written: &Expression) -> Option<Draft> {
        match &written.kind {
            // the mistake is where the name is defined
            Kind::Name(name) if matches!(self.scope.look_up(&name.to_string()), Some(None)) => None,
            Kind::Call(word, _) if word == "tensor" || word == "products" => self.report(
                word.span(),
                format!("entries have names: write `{word} {{ xx: .., yy: .., zz: .. }}`"),
            ),
            Kind::Call(word, parts) => self.no_form(word, parts),
            Kind::Chain(..) | Kind::Prefix(..) | Kind::Method(..) | Kind::Unit(..)
                if has_form(written) =>
            {
                self.report(
                    written.extent,
                    "an inertia stands alone, with one unit or `.about(P)` behind it: put \
                     factors into its numbers",
                )
            }
            _ if is_zero(written) => self.report_zero(written.extent),
            _ => self.report(
                written.extent,
                format!("an inertia in space has more than one number: {FORMS}"),
            ),
        }
    }

    /// Whether an unknown word is probably meant as a solid.
    fn means_solid(&self, word: &Ident) -> bool {
        let word = word.to_string();
        let is_meant = solid_meant(&word).is_some() || similar(&word, words()).is_some();
        is_meant && !self.scope.knows(&word)
    }

    fn no_form(&mut self, word: &Ident, parts: &[Expression]) -> Option<Draft> {
        self.visit(parts);
        let forms = if self.motion.is_line() {
            FORMS_OF_ROD
        } else if self.motion.has_one_moment() {
            FORMS_IN_PLANE
        } else {
            FORMS
        };
        let written = word.to_string();
        self.report(
            word.span(),
            match solid_meant(&written).or_else(|| similar(&written, words())) {
                Some(meant) => format!("`{word}` is no form of inertia; did you mean `{meant}`?"),
                None => format!("`{word}` is no form of inertia: {forms}"),
            },
        )
    }

    fn scale_draft(&mut self, factor: Id, draft: Draft) -> Draft {
        let graph = &mut self.work.graph;
        let inertia = match draft.inertia {
            Inertia::Absent => Inertia::Absent,
            Inertia::Scalar(moment) => Inertia::Scalar(graph.multiply(factor, moment)),
            Inertia::Spatial(rows) => {
                Inertia::Spatial(rows.map(|row| graph.scale_vector(factor, row)))
            }
        };
        let entries = draft.entries.into_iter().map(|entry| Entry {
            value: graph.multiply(factor, entry.value),
            ..entry
        });
        Draft {
            inertia,
            entries: entries.collect(),
            extent: draft.extent,
        }
    }
}

/// Why an inertia must be known early.
pub const CONSTANT: &str = "the inertia is constant in body axes";

pub const FORMS: &str = "write `principal(a, b, c)`, `tensor { xx, yy, zz, xy, yz, zx }`, \
                         `products { .. }` or a solid such as `cylinder(r, h)`; `tensor` and \
                         `products` differ in the sign of the off-diagonals";

const FORMS_IN_PLANE: &str =
    "write one number such as `0.1[kg * m ^ 2]`, or a solid such as `disc(r)`";

/// Whether `expression` contains one of the forms of inertia.
fn has_form(expression: &Expression) -> bool {
    let mut found = false;
    expression.visit(|part| {
        found |= match &part.kind {
            Kind::Call(word, _) => word == "principal" || is_solid(word),
            Kind::Record(..) => true,
            _ => false,
        };
    });
    found
}

fn is_scalar(expression: &Expression) -> bool {
    match &expression.kind {
        Kind::Call(..) | Kind::Record(..) => false,
        Kind::Method(inner, method, _) => {
            !MOVES.contains(&&*method.to_string()) || is_scalar(inner)
        }
        _ => true,
    }
}

/// The methods that an inertia has.
const MOVES: [&str; 5] = ["about", "along", "turned", "mass", "at"];

/// Whether a number is zero as written, with or without a unit.
fn is_zero(written: &Expression) -> bool {
    match &written.kind {
        Kind::Number(digits) => Number::parse(digits).is_some_and(|number| number.is_zero()),
        Kind::Unit(inner, _) => is_zero(inner),
        _ => false,
    }
}

/// Whether an inertia has one of these methods already: it is about one point, and along one direction.
fn is_repeated(inner: &Expression, method: &Ident) -> bool {
    if method != "about" && method != "along" {
        return false;
    }
    match &inner.kind {
        Kind::Method(further, earlier, _) => earlier == method || is_repeated(further, method),
        Kind::Unit(further, _) => is_repeated(further, method),
        _ => false,
    }
}
