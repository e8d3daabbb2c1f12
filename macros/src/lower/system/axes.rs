//! The axes of joints, and how what they carry is turned.

use proc_macro2::Ident;

use crate::errors::Errors;
use crate::model::{Dimension, JointKind};
use crate::symbolic::{Components, Id};
use crate::syntax::Expression;

use super::reader::{Reader, still};

impl Reader<'_> {
    pub fn directions(
        &mut self,
        body: usize,
        kind: &JointKind,
        arguments: &[Expression],
        errors: &mut Errors,
    ) -> Option<Vec<Components>> {
        let written = &arguments[2..2 + kind.directions];
        let directions: Vec<Option<Components>> = written
            .iter()
            .map(|direction| self.direction(body, direction, errors))
            .collect();
        if let [Some(first), Some(second)] = *directions {
            let across = self.work.graph.cross(first, second);
            if self.work.graph.is_zero_vector(&across) {
                errors.push(
                    written[1].extent,
                    "the axes of a universal joint are not parallel: about parallel ones it turns twice alike",
                );
                return None;
            }
        }
        directions.into_iter().collect()
    }

    /// That of a screw; the inner `None` is any other joint.
    #[allow(clippy::option_option, reason = "outer: reported; inner: not a screw")]
    pub fn pitch(
        &mut self,
        kind: &JointKind,
        arguments: &[Expression],
        errors: &mut Errors,
    ) -> Option<Option<Id>> {
        if !kind.is_screw() {
            return Some(None);
        }
        let written = &arguments[3];
        self.at_top(errors, |lowering| {
            let what = "the pitch of a screw, metres per radian,";
            let pitch = lowering.scalar(written, Dimension::LENGTH, what)?;
            lowering.check_early(written, &[pitch], "a pitch is fixed")?;
            Some(Some(pitch))
        })
    }

    /// A unit vector, the same in the axes of both bodies where the coordinates are zero.
    fn direction(
        &mut self,
        body: usize,
        written: &Expression,
        errors: &mut Errors,
    ) -> Option<Components> {
        let frame = self.members.bodies[body].frame;
        let defaults = self.defaults.clone();
        let mut scope = self.scope.clone();
        let mut state = still(frame, self.time);
        let mut lowering = crate::lower::expressions::Lowering {
            work: &mut self.work,
            scope: &mut scope,
            errors,
            motion: self.motion,
            state: &mut state,
            reactions: Vec::new(),
            is_constrained: false,
            composed: None,
            has_parts: false,
            members: &self.members,
            is_whole: false,
        };
        let found = lowering.direction(written, &defaults);
        self.scope = scope;
        found
    }

    /// All of `.turned(axis, angle)`, each in the axes that the ones before have made.
    pub fn turned(
        &mut self,
        body: usize,
        methods: &[(&Ident, &[Expression])],
        errors: &mut Errors,
    ) -> Option<Vec<(Components, Id)>> {
        let mut turned = Some(Vec::new());
        let mut add = |turn: Option<(Components, Id)>| match (turn, &mut turned) {
            (Some(turn), Some(all)) => all.push(turn),
            _ => turned = None,
        };
        // the outermost method is the last one that is written
        for (method, arguments) in methods.iter().rev() {
            let later = ["driven", "at", "locked"];
            match (method.to_string().as_str(), *arguments) {
                ("turned", [axis, angle]) if !self.system.is_planar => {
                    let axis = self.direction(body, axis, errors);
                    let angle = self.fixed_angle(angle, errors);
                    add(axis.zip(angle));
                }
                ("turned", [angle]) if self.system.is_planar => {
                    let axis = self.work.graph.unit_vectors()[2];
                    let angle = self.fixed_angle(angle, errors);
                    add(angle.map(|angle| (axis, angle)));
                }
                ("turned", _) => {
                    errors.push(
                        method.span(),
                        "write `.turned(axis, angle)`, in the plane `.turned(angle)`",
                    );
                    add(None);
                }
                (word, _) if later.contains(&word) => {
                    errors.push(
                        method.span(),
                        format!("`.{word}(..)` of a joint is part of the language, but this version does not have it yet"),
                    );
                    add(None);
                }
                _ => {
                    errors.push(
                        method.span(),
                        format!(
                            "a joint has no `{method}`: what may follow is `.turned(axis, angle)`"
                        ),
                    );
                    add(None);
                }
            }
        }
        turned
    }

    fn fixed_angle(&mut self, written: &Expression, errors: &mut Errors) -> Option<Id> {
        self.at_top(errors, |lowering| {
            let angle = lowering.scalar(written, Dimension::NONE, "an angle")?;
            lowering.check_early(written, &[angle], "how a joint is turned is fixed")?;
            Some(angle)
        })
    }
}
