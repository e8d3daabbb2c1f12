//! The class of a body with a constant tensor, in the words of the runtime's `Symmetry` and
//! `Extent`.

use crate::model::{Inertia, Model, Workspace, is_flat, shown};
use crate::symbolic::{Function, Number, Spectrum, Symmetry};

/// A principal moment and the unit vector of its axis.
type Moment = (Number, [Number; 3]);

/// Principal moments and axes about G, in body axes, and the class of the body. Empty unless the
/// body rotates in space and its tensor is known.
pub fn classify(model: &Model, work: &mut Workspace) -> Vec<String> {
    let Inertia::Spatial(rows) = model.inertia else {
        return Vec::new();
    };
    if model.motion.is_hinged() {
        return Vec::new();
    }
    let Some(spectrum) = work.graph.spectrum(&rows) else {
        return Vec::new();
    };
    match spectrum {
        Spectrum::Spherical(moment) => {
            vec![format!("spherical: {} kg m^2", shown(&moment))]
        }
        Spectrum::Symmetric(symmetry) => about_axis(*symmetry),
        Spectrum::General(principal) => {
            let [x, y, z] = principal.moments;
            let [along_x, along_y, along_z] = principal.axes;
            let matrix = work.graph.constant_matrix(&rows);
            let is_flat = matrix.is_some_and(|matrix| is_flat(&matrix));
            general([(x, along_x), (y, along_y), (z, along_z)], is_flat)
        }
    }
}

fn about_axis(symmetry: Symmetry) -> Vec<String> {
    let Symmetry {
        across,
        along,
        axis,
    } = symmetry;
    let form = if along > across { "oblate" } else { "prolate" };
    let mut lines = vec![format!(
        "symmetric about n = {}, {form}: {} kg m^2 about n, {} across",
        vector(&unit(&axis)),
        shown(&along),
        shown(&across)
    )];
    let twice = across.clone() + across.clone();
    if twice == along {
        lines.push(PLANAR.to_owned() + "n");
    }
    if is_thin(&along, &across) {
        lines.push(ROD_LIKE.to_owned() + "n");
    }
    lines
}

/// The description of a body with three different moments, in ascending order.
fn general(mut principal: [Moment; 3], is_flat: bool) -> Vec<String> {
    principal.sort_by(|a, b| a.0.cmp(&b.0));
    let [least, middle, largest] = principal;
    let mut lines = vec!["general: three different principal moments".to_owned()];
    for (moment, axis) in [&least, &middle, &largest] {
        lines.push(format!("{} kg m^2 about {}", shown(moment), vector(axis)));
    }
    if is_flat {
        lines.push(PLANAR.to_owned() + "the axis of the largest moment");
    }
    if is_thin(&least.0, &largest.0) {
        lines.push(ROD_LIKE.to_owned() + "the axis of the least moment");
    }
    lines
}

/// If the largest moment divided by the smallest is greater than this, the body is like a rod.
const SLENDER: i64 = 1000;

const PLANAR: &str = "planar: all mass is in the plane normal to ";
const ROD_LIKE: &str = "like a rod: less than 1/1000 of the largest moment is about ";

fn is_thin(least: &Number, largest: &Number) -> bool {
    least.clone() * Number::integer(SLENDER) < *largest
}

fn unit(axis: &[Number; 3]) -> [Number; 3] {
    let square = axis.iter().fold(Number::zero(), |sum, component| {
        sum + component.clone() * component.clone()
    });
    let norm = Number::apply(Function::Sqrt, &[square]).unwrap_or_else(Number::one);
    axis.clone()
        .map(|component| component.checked_div(&norm).unwrap_or_else(Number::zero))
}

fn vector(components: &[Number; 3]) -> String {
    format!("({})", components.each_ref().map(shown).join(", "))
}
