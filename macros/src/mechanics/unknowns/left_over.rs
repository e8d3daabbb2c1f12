//! The balances that do not determine the accelerations.

use super::unknown::Row;
use crate::families::LoadKind;
use crate::model::{Model, Workspace};
use crate::symbolic::Components;

/// The balances that do not determine the accelerations.
pub fn balances_left(model: &Model, work: &mut Workspace) -> Vec<Row> {
    let graph = &mut work.graph;
    let (zero, one) = (graph.zero(), graph.one());
    let unit = |axis: usize| [0, 1, 2].map(|i| if i == axis { one } else { zero });
    let mut rows = Vec::new();
    if !model.motion.translates() {
        for axis in 0..model.motion.axes() {
            let name = [
                "the forces along x",
                "the forces along y",
                "the forces along z",
            ][axis];
            rows.push(Row {
                name,
                kind: LoadKind::Force,
                direction: unit(axis),
            });
        }
    }
    let moment_names = [
        "the moments about x",
        "the moments about y",
        "the moments about z",
    ];
    if !model.motion.has_attitude() {
        let axes = if model.motion.is_planar() { 2..3 } else { 0..3 };
        rows.extend(axes.map(|axis| Row {
            name: moment_names[axis],
            kind: LoadKind::Moment,
            direction: unit(axis),
        }));
    } else if let (false, Some(d)) = (model.motion.is_planar(), model.hinge(&mut work.graph)) {
        rows.extend(across(work, d).map(|(name, direction)| Row {
            name,
            kind: LoadKind::Moment,
            direction,
        }));
    }
    rows
}

/// Two directions across an axis: the other two axes, if it is one of them.
pub fn across(work: &mut Workspace, d: Components) -> [(&'static str, Components); 2] {
    let graph = &mut work.graph;
    let (zero, one) = (graph.zero(), graph.one());
    let unit = |axis: usize| [0, 1, 2].map(|i| if i == axis { one } else { zero });
    let along = (0..3).find(|axis| graph.is_along(d, *axis));
    if let Some(axis) = along {
        let name = |axis: usize| {
            [
                "the moments about x",
                "the moments about y",
                "the moments about z",
            ][axis]
        };
        let (i, j) = ((axis + 1) % 3, (axis + 2) % 3);
        return [(name(i), unit(i)), (name(j), unit(j))];
    }
    let zero_axis = (0..3).find(|axis| graph.is_zero(d[*axis]));
    let first = match zero_axis {
        Some(axis) => unit(axis),
        None => graph.cross(d, unit(0)),
    };
    let second = graph.cross(d, first);
    let name = "the moments across the axis";
    [(name, first), (name, second)]
}
