//! Free rotation in closed form, classified by the moments of inertia as far as these are known.

use crate::model::Workspace;
use crate::symbolic::{Components, Graph, Id, Number, Spectrum};

use super::solid::Solid;

/// What determines the free rotation of a body.
pub enum Free {
    /// All moments of inertia are equal.
    Steady,
    /// The moments across an axis and along it, and its unit vector in body axes.
    Symmetric([Id; 2], Components),
    /// The principal moments along the body axes, known when the body is built.
    Along([Id; 3]),
    /// Three principal moments, and the unit vectors of their axes in body axes.
    Principal([Id; 3], [Components; 3]),
    /// The entries xx, yy, zz, xy, yz, zx of a tensor that is known when the body is built; its
    /// principal axes are computed then.
    Tensor([Id; 6]),
}

impl Free {
    pub fn roots(&self) -> Vec<Id> {
        match self {
            Self::Steady | Self::Tensor(_) => Vec::new(),
            Self::Along(moments) => moments.to_vec(),
            Self::Symmetric(moments, axis) => [&moments[..], &axis[..]].concat(),
            Self::Principal(moments, axes) => [&moments[..], &axes.concat()[..]].concat(),
        }
    }
}

/// Classifies a free rotation. The principal axes of a tensor of numbers are computed here, to any
/// precision.
pub fn free(solid: &Solid, work: &mut Workspace) -> Free {
    let (graph, rows) = (&mut work.graph, &solid.rows);
    let Some(spectrum) = graph.spectrum(rows) else {
        let [xx, yy, zz] = [0, 1, 2].map(|i| rows[i][i]);
        if [rows[0][1], rows[1][2], rows[2][0]]
            .into_iter()
            .all(|entry| graph.is_zero(entry))
        {
            return Free::Along([xx, yy, zz]);
        }
        return Free::Tensor([xx, yy, zz, rows[0][1], rows[1][2], rows[2][0]]);
    };
    match spectrum {
        Spectrum::Spherical(_) => Free::Steady,
        Spectrum::Symmetric(symmetry) => {
            let axis = unit(graph, &symmetry.axis);
            let moments = [symmetry.across, symmetry.along];
            Free::Symmetric(moments.map(|moment| graph.number(moment)), axis)
        }
        Spectrum::General(principal) => Free::Principal(
            principal.moments.map(|moment| graph.number(moment)),
            principal
                .axes
                .map(|axis| axis.map(|component| graph.number(component))),
        ),
    }
}

/// The unit vector along an axis.
pub fn unit(graph: &mut Graph, axis: &[Number; 3]) -> Components {
    let axis = axis.clone().map(|component| graph.number(component));
    let (norm, one) = (graph.norm(axis), graph.one());
    let inverse = graph.divide(one, norm);
    graph.scale_vector(inverse, axis)
}
