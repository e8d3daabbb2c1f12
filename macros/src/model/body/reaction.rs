//! A load with unknown components.

use proc_macro2::Ident;

use crate::errors::Extent;
use crate::families::LoadKind;
use crate::model::joints::Motion;
use crate::model::kinematics::{Point, Vector, Workspace};
use crate::model::words::{AXES, Frame};
use crate::symbolic::Components;

/// A load with unknown components.
#[derive(Clone)]
pub struct Reaction {
    pub name: Ident,
    pub kind: LoadKind,
    pub point: Point,
    /// The axes of its components.
    pub frame: Frame,
    /// The known components, and zeros for the others.
    pub known: Components,
    /// The unknown components: the index of each, and its place.
    pub unknown: Vec<(usize, Extent)>,
    /// The direction of `_ * direction`, which has one unknown.
    pub along: Option<Vector>,
    /// The constraint whose gradient the direction is: its support is smooth.
    pub gradient_of: Option<String>,
    /// The whole load as symbols, given from outside, in world axes.
    pub symbols: Vector,
}

impl Reaction {
    /// Whether all its components are unknown.
    pub fn is_whole(&self, motion: Motion) -> bool {
        self.unknown.len() == motion.axes_of(self.kind).len()
    }

    /// One unit of an unknown component, in these axes.
    pub fn direction(&self, work: &mut Workspace, frame: Frame, axis: usize) -> Vector {
        let unit = [0, 1, 2].map(|other| work.graph.integer(i64::from(other == axis)));
        self.along.unwrap_or_else(|| work.vector(frame, unit))
    }

    /// The name of a component: `normal` if there is only one, `pin.x` if there are several.
    pub fn component_name(&self, motion: Motion, axis: usize) -> String {
        if self.along.is_some() || motion.axes_of(self.kind).len() == 1 {
            self.name.to_string()
        } else {
            format!("{}.{}", self.name, AXES[axis])
        }
    }
}
