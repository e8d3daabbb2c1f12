//! What is known of a system even if it has errors.

use std::collections::HashSet;

use proc_macro2::Ident;
use quote::format_ident;

use crate::errors::similar;
use crate::model::{Holds, JointKind, Jointed, Outline};
use crate::syntax::{self, Definition, Expression, Kind, call, joined};

use super::drives::open_drive;
use super::joints::driven::coordinates;
use super::joints::joint::{first_name_of, kind_of};

/// Completes the outline. The moving joints become the fields of the state.
pub fn outline_system(system: &syntax::System, outline: &mut Outline) {
    outline.is_system = true;
    outline.held.clone_from(&system.held);
    outline.kept = loads_of_constraints(system);
    outline.is_constrained = !outline.kept.is_empty();
    let mut seen = HashSet::new();
    let bodies = system.bodies.iter().map(|body| body.name.clone());
    outline.bodies = bodies
        .filter(|name| seen.insert(format!("body {name}")))
        .collect();
    let points = system.points.iter().filter_map(name_of_point);
    let points = points.filter(|name| seen.insert(format!("point {name}")));
    outline.points = points.collect();
    let mut carried = HashSet::new();
    let joints = system.joints.iter();
    let joints = joints
        .filter(|joint| seen.insert(joint.name.to_string()))
        .filter_map(|joint| {
            let kind = likely_kind(joint, system.is_planar)?;
            if !kind.is_free() {
                outline.holding.push(joint.name.clone());
            }
            let body = name_of_carried(joint, kind);
            if body.is_some_and(|body| !carried.insert(body)) {
                outline.is_constrained = true;
                return None;
            }
            if is_driven(joint) {
                outline.driving.extend(drives_of(&joint.name, kind));
                return None;
            }
            Some(Jointed {
                name: joint.name.clone(),
                shape: kind.shape?,
                frame: None,
            })
        });
    let joints = joints.collect();
    outline.joints = joints;
    let kind = |name: &Ident| {
        let joint = system.joints.iter().find(|joint| joint.name == *name)?;
        likely_kind(joint, system.is_planar)
    };
    let open = system.drives.iter();
    let open = open.filter_map(|drive| open_drive(drive, kind));
    let open = open.filter(|(name, _)| seen.insert(format!("drive {name}")));
    outline.open = open.map(|(name, count)| (name.clone(), count)).collect();
}

/// The names that the loads of all written constraints may have, as scalars or as vectors.
fn loads_of_constraints(system: &syntax::System) -> Vec<Ident> {
    let of_bodies = system.bodies.iter().flat_map(|body| {
        let written = body.constraints.iter();
        written.map(|one| joined(&body.name, &one.name))
    });
    let written = system.top.constraints.iter().map(|one| one.name.clone());
    let names = written.chain(of_bodies).flat_map(|name| {
        let parts = ["_x", "_y", "_z"].map(|axis| format_ident!("{name}{axis}"));
        [name].into_iter().chain(parts)
    });
    let mut seen = HashSet::new();
    names.filter(|name| seen.insert(name.clone())).collect()
}

/// Whether the motion of a joint is prescribed.
fn is_driven(joint: &Definition) -> bool {
    let call = joint.value.as_ref().and_then(call);
    call.is_some_and(|(_, methods)| methods.iter().any(|(method, _)| *method == "driven"))
}

/// The body that a joint carries. If the ends of a joint to the ground are exchanged, the body that
/// was meant.
fn name_of_carried(joint: &Definition, kind: &JointKind) -> Option<String> {
    let ((_, arguments), _) = joint.value.as_ref().and_then(call)?;
    let written = arguments.get(usize::from(kind.holds == Holds::Points))?;
    let named = first_name_of(written).or_else(|| first_name_of(arguments.first()?));
    named.map(ToString::to_string)
}

/// `crank_drive`; for a joint of several coordinates, `gimbal_drive_angle_1`.
fn drives_of(joint: &Ident, kind: &JointKind) -> Vec<(Ident, Ident)> {
    let names: Vec<&str> = coordinates(kind)
        .into_iter()
        .map(|(name, ..)| name)
        .collect();
    let drives = names.iter().map(|coordinate| {
        let name = if names.len() == 1 {
            format_ident!("{joint}_drive", span = joint.span())
        } else {
            format_ident!("{joint}_drive_{coordinate}", span = joint.span())
        };
        (joint.clone(), name)
    });
    drives.collect()
}

/// The name `arm_tip` of the point `arm.tip`.
pub fn name_of_point(written: &Expression) -> Option<Ident> {
    let Kind::Field(body, point) = &written.kind else {
        return None;
    };
    let Kind::Name(body) = &body.kind else {
        return None;
    };
    Some(joined(body, point))
}

/// The kind of a joint; if it is unreadable, a likely kind.
fn likely_kind(joint: &Definition, is_planar: bool) -> Option<&'static JointKind> {
    let kinds = JointKind::all(is_planar);
    let Some(value) = &joint.value else {
        return kinds.first();
    };
    kind_of(value, is_planar)
        .or_else(|| kind_of(value, false))
        .or_else(|| {
            let word = call(value).map(|((word, _), _)| word.to_string());
            let meant = similar(
                &word.unwrap_or_default(),
                kinds.iter().map(|kind| kind.word),
            );
            let similar = kinds.iter().find(|kind| meant == Some(kind.word));
            similar.or_else(|| kinds.first())
        })
}
