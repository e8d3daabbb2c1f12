//! The balances that are left over, because they do not determine accelerations.

use crate::families::LoadKind;
use crate::model::{Model, Workspace};
use crate::symbolic::Components;

use super::rows::BalanceRow;

const FORCES: [&str; 3] = [
    "the forces along x",
    "the forces along y",
    "the forces along z",
];
const MOMENTS: [&str; 3] = [
    "the moments about x",
    "the moments about y",
    "the moments about z",
];

/// The balances that are left over.
pub fn balances_left(model: &Model, work: &mut Workspace) -> Vec<BalanceRow> {
    let units = work.graph.unit_vectors();
    let row = |names: [&'static str; 3], kind: LoadKind| {
        move |axis: usize| BalanceRow::new(names[axis], kind, units[axis])
    };
    let mut rows = Vec::new();
    if !model.motion.translates() {
        let axes = model.motion.axes_of(LoadKind::Force);
        rows.extend(axes.map(row(FORCES, LoadKind::Force)));
    }
    if !model.motion.has_attitude() {
        let axes = model.motion.axes_of(LoadKind::Moment);
        rows.extend(axes.map(row(MOMENTS, LoadKind::Moment)));
    } else if let (false, Some(d)) = (model.motion.is_planar, model.hinge(&mut work.graph)) {
        let rows_across = across(work, d);
        rows.extend(rows_across.map(|(name, d)| BalanceRow::new(name, LoadKind::Moment, d)));
    }
    rows
}

/// Two directions perpendicular to an axis; if it is a coordinate axis, the other two.
pub fn across(work: &mut Workspace, d: Components) -> [(&'static str, Components); 2] {
    let graph = &mut work.graph;
    let units = graph.unit_vectors();
    if let Some(axis) = (0..3).find(|axis| graph.is_along(d, *axis)) {
        return [(axis + 1) % 3, (axis + 2) % 3].map(|axis| (MOMENTS[axis], units[axis]));
    }
    let zero_axis = (0..3).find(|axis| graph.is_zero(d[*axis]));
    let first = match zero_axis {
        Some(axis) => units[axis],
        None => graph.cross(d, units[0]),
    };
    let second = graph.cross(d, first);
    let name = "the moments across the axis";
    [(name, first), (name, second)]
}
