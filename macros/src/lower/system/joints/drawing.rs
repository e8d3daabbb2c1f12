//! `drawing: zero_pose`: bodies and joints, drawn in one frame at zero coordinates.

use proc_macro2::Ident;
use quote::format_ident;

use crate::errors::Errors;
use crate::lower::expressions::Lowering;
use crate::model::{Dimension, Frame, JointKind, Origin};
use crate::symbolic::Components;
use crate::syntax::{Called, Center, Expression, Kind};

use super::joint::{End, first_name_of};
use crate::lower::system::reading::reader::Reader;

/// Writes `(x, y, z)` as a vector in the axes of the drawing, which are those of the ground and of
/// all bodies.
pub fn in_drawing(written: &Expression) -> Expression {
    let kind = match &written.kind {
        Kind::Tuple(parts) => {
            let word = format_ident!("world");
            Kind::Call(word, parts.clone())
        }
        Kind::Unit(inner, unit) => Kind::Unit(Box::new(in_drawing(inner)), unit.clone()),
        other => other.clone(),
    };
    Expression {
        extent: written.extent,
        kind,
    }
}

impl Reader<'_> {
    /// The place of G of a body that is not composed of parts.
    pub fn drawn_center(
        &mut self,
        center: &Center,
        body: &Ident,
        errors: &mut Errors,
    ) -> Option<Origin> {
        let written = match center {
            Center::At(written) => written,
            Center::Reported => return None,
            Center::Missing => {
                let form = if self.system.is_planar {
                    "(x, y)"
                } else {
                    "(x, y, z)"
                };
                errors.push(
                    body.span(),
                    format!(
                        "where is G of `{body}` in the drawing? write `.at({form}[m])` behind its inertia, or \
                         behind its mass if it has none"
                    ),
                );
                return None;
            }
        };
        let first = self.at_top(errors, |lowering| place(lowering, written))?;
        let center = self.work.graph.zeros();
        Some(Origin { first, center })
    }

    /// The ends of a joint at the place that `.at(..)` says, between bodies or a body and the
    /// ground.
    pub fn drawn_ends(
        &mut self,
        kind: &JointKind,
        (word, arguments): Called<'_>,
        methods: &mut Vec<Called<'_>>,
        errors: &mut Errors,
    ) -> Option<[Option<End>; 2]> {
        let found = methods.iter().position(|(method, _)| *method == "at");
        let written = found.map(|found| methods.remove(found));
        let bodies = [0, 1].map(|k| self.drawn_body(&arguments[k], k == 0, errors));
        let Some((method, places)) = written else {
            let form = if self.system.is_planar {
                "(x, y)"
            } else {
                "(x, y, z)"
            };
            let message = format!(
                "where is this joint in the drawing? write `{}(..).at({form}[m])`",
                kind.word
            );
            errors.push(word.span(), message);
            return None;
        };
        let [written] = places else {
            errors.push(
                method.span(),
                "`.at` takes one place: write `.at((x, y, z)[m])`",
            );
            return None;
        };
        let place = self.at_top(errors, |lowering| place(lowering, written))?;
        let ends = bodies.map(|body| {
            let body = body?;
            let Some(number) = body else {
                return Some((None, place));
            };
            let origin = self.members.bodies[number].origin?;
            Some((body, origin.offset(&mut self.work.graph, place)))
        });
        Some(ends)
    }

    /// The index of a body, given by its name, or the ground.
    #[allow(clippy::option_option, reason = "outer: reported; inner: the ground")]
    fn drawn_body(
        &self,
        written: &Expression,
        may_be_ground: bool,
        errors: &mut Errors,
    ) -> Option<Option<usize>> {
        let name = first_name_of(written)
            .map(ToString::to_string)
            .unwrap_or_default();
        if let Kind::Name(_) = written.kind {
            if name == "world" && may_be_ground {
                return Some(None);
            }
            if let Some(body) = self.members.body(&name) {
                return Some(Some(body));
            }
            if self.scope.is_lost(&name) {
                return None;
            }
        }
        let hint = match self.members.body(&name) {
            Some(_) => format!(": write `{name}`, and the point behind the joint, `.at(..)`"),
            None => self
                .members
                .hint(&name, ["world"].into_iter().filter(|_| may_be_ground)),
        };
        let ground = if may_be_ground { ", or `world`" } else { "" };
        errors.push(
            written.extent,
            format!("a joint of a drawing is between bodies by their names{ground}{hint}"),
        );
        None
    }
}

/// A fixed place in the drawing.
fn place(lowering: &mut Lowering<'_>, written: &Expression) -> Option<Components> {
    let vector = in_drawing(written);
    let found = lowering.vector(&vector, Dimension::LENGTH, "a place in the drawing")?;
    let components = lowering.work.components(found, Frame::WORLD);
    lowering.check_early(written, &components, "a drawing is fixed")?;
    Some(components)
}
