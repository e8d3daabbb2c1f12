//! Arguments of outputs: selected joints, and points of bodies.

use proc_macro2::Ident;

use crate::errors::Errors;
use crate::families::LoadKind;
use crate::lower::expressions::Value;
use crate::model::{Checks, Dimension, Frame, Meaning};
use crate::symbolic::{Components, Stage};
use crate::syntax::Expression;

use super::joints::joint::{ReadJoint, first_name_of};
use super::outline::name_of_point;
use super::reading::names::no_joint;
use super::reading::reader::Reader;

impl Reader<'_> {
    /// The claims about a system, which may use the loads of joints.
    pub fn checks(&mut self, holding: &[Ident], errors: &mut Errors) -> Checks {
        let top = &self.system.top;
        let held = if top.checks.is_empty() {
            Vec::new()
        } else {
            self.members.are_loaded = true;
            holding.iter().map(|joint| self.carried(joint)).collect()
        };
        let checks = self.at_top(errors, |lowering| lowering.checks(top));
        Checks { held, ..checks }
    }

    /// New symbols for the force and the moment of a joint, defined as its `.force` and `.moment`.
    fn carried(&mut self, joint: &Ident) -> (Ident, [Components; 2]) {
        let is_planar = self.system.is_planar;
        let work = &mut self.work;
        let [force, moment] = [LoadKind::Force, LoadKind::Moment]
            .map(|kind| work.symbols(Stage::State, kind.axes(is_planar), |_| Meaning::Virtual));
        let vector = |dimension, part| Value::Vector(part, dimension);
        let [along, around] = [force, moment].map(|part| work.vector(Frame::WORLD, part));
        let around = if is_planar {
            Value::Scalar(moment[2], Dimension::MOMENT)
        } else {
            vector(Dimension::MOMENT, around)
        };
        let values = [
            ("force", vector(Dimension::FORCE, along)),
            ("moment", around),
        ];
        let mut joints = self.members.joints.iter_mut();
        if let Some(known) = joints.find(|known| *joint == known.name) {
            known.values.extend(values);
        }
        (joint.clone(), [force, moment])
    }

    /// Checks that the names in `reactions(..)` are joints that transmit loads, or are among
    /// `kept`.
    pub fn check_held(&self, joints: &[Option<ReadJoint>], kept: &[Ident], errors: &mut Errors) {
        let held = self.system.held.iter().flatten();
        let mut seen: Vec<&Ident> = Vec::new();
        for name in held {
            let names = || self.system.joints.iter().map(|joint| &joint.name);
            let mut read = joints.iter().flatten();
            let joint = read.find(|joint| joint.name == *name);
            let message = if seen.contains(&name) {
                format!("`{name}` is named twice")
            } else if joint.is_some_and(|joint| joint.kind.is_free()) {
                format!("nothing holds what `{name}` carries: it has no reactions")
            } else if names().any(|known| known == name)
                || kept.contains(name)
                || self.system.lost.joints
            {
                seen.push(name);
                continue;
            } else if let Some(body) = self.body_named(name) {
                let mut read = joints.iter().flatten();
                let joint = read.find(|joint| joint.carried == body);
                let such = joint.map_or(String::new(), |one| format!(", such as `{}`", one.name));
                format!("`{name}` is a body: reactions are those of joints{such}")
            } else {
                no_joint(self.system, name)
            };
            errors.push(name.span(), message);
        }
    }

    fn body_named(&self, name: &Ident) -> Option<usize> {
        let mut bodies = self.members.bodies.iter();
        bodies.position(|body| *name == body.name.as_str())
    }

    /// The points in `jacobian(..)`: for each, its body and its offset there.
    pub fn asked_points(&mut self, errors: &mut Errors) -> Option<Vec<(usize, Components)>> {
        let system = self.system;
        let (mut seen, mut found): (Vec<(Ident, &Expression)>, _) = (Vec::new(), Some(Vec::new()));
        for written in &system.points {
            let anchor = self.anchor(written, errors);
            let message = match (anchor, name_of_point(written)) {
                (Some((Some(body), offset)), Some(name))
                    if seen.iter().all(|(other, _)| *other != name) =>
                {
                    seen.push((name, written));
                    found = found.map(|mut all| {
                        all.push((body, offset));
                        all
                    });
                    continue;
                }
                (None, _) => None,
                (Some((None, _)), _) => Some("the ground does not move".to_owned()),
                (_, None) => Some("expected a point by its name, such as `arm.tip`".to_owned()),
                (_, Some(name)) if is_another(&seen, &name, written) => Some(format!(
                    "`{name}` is the field of another point already: call one of them something else"
                )),
                (_, Some(_)) => Some("this point is requested twice".to_owned()),
            };
            if let Some(message) = message {
                errors.push(written.extent, message);
            }
            found = None;
        }
        found
    }
}

/// Whether another point already has the field of this name.
fn is_another(seen: &[(Ident, &Expression)], name: &Ident, written: &Expression) -> bool {
    let mut seen = seen.iter();
    let first = seen.find(|(other, _)| other == name);
    first.is_some_and(|(_, first)| first_name_of(first) != first_name_of(written))
}
