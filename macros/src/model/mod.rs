//! What was meant: names resolved, frames and dimensions checked, loads and inertia in the graph.
//!
//! The [`Outline`] of a body always exists; its [`Model`] exists if nothing was wrong.

mod body;
mod joints;
mod kinematics;
mod system;
mod words;

pub use body::{
    Along, Asked, Charges, Composed, Constraint, Declared, Defaults, Displaced, Drawn, ENTRIES,
    Form, Inertia, Jointed, Level, Load, Mass, Matrix, Origin, Outline, Potential, Potentials,
    Reaction, SOLIDS, Solid, Substance, Violation, displaced, is_flat, is_possible, is_solid,
    least_moment, matrix, thinnest, words,
};
pub use joints::{
    Coordinate, Field, Group, Joint, MOTIONS, Motion, Orientation, PLANAR, Rates, SPATIAL, Shape,
};
pub use kinematics::{
    Attitude, Axis, Own, Pair, Point, State, Support, Turn, Turns, Vector, Workspace, state_symbols,
};
pub use system::{
    Axes, Closing, Holds, JointKind, Kept, Member, Part, Property, System, Tie, TreeJoint,
};
pub use words::{
    AXES, Answers, Check, Checks, Claim, Dimension, Doubtful, ForeignConstant, ForeignFunction,
    Frame, FrameWord, Labels, Meaning, Unit, Variable, shown, why_not,
};

use crate::symbolic::{Components, Graph, Id};

/// A description, understood.
#[derive(Clone)]
pub struct Model {
    pub motion: Motion,
    /// How many derivatives of each input are given: the inputs behind it.
    pub derivatives: Vec<usize>,
    pub state: State,
    /// States of its own.
    pub states: Vec<Own>,
    pub mass: Option<Id>,
    pub inertia: Inertia,
    /// Its equations are differentiated.
    pub is_differentiated: bool,
    /// An inertia was written for a body that does not turn.
    pub has_idle_inertia: bool,
    pub loads: Vec<Load>,
    /// The same by the symbols of accelerations, where any of them follow these.
    pub following: Vec<Load>,
    /// What becomes a load by differentiation.
    pub potentials: Potentials,
    /// Loads with unknown components.
    pub reactions: Vec<Reaction>,
    /// Drives with unknown components, at rest in the accelerations.
    pub drives: Vec<Reaction>,
    /// What the motion keeps at zero, by scalars.
    pub constraints: Vec<Constraint>,
    pub pole: Point,
    /// The values of the parameters that have a default.
    pub defaults: Defaults,
    pub checks: Checks,
}

impl Model {
    /// The mass, if G has coordinates of its own.
    pub fn moved_mass(&self) -> Option<Id> {
        self.mass.filter(|_| self.motion.translates())
    }

    /// The direction of the axis of a hinge, body axes; in the plane, z.
    pub fn hinge(&self, graph: &mut Graph) -> Option<Components> {
        let support = self.state.support.filter(|_| self.motion.is_hinged())?;
        let z = [0, 0, 1].map(|component| graph.integer(component));
        Some(support.direction.unwrap_or(z))
    }

    /// What the body of this name is made of.
    pub fn substance(&self) -> Substance {
        Substance {
            name: None,
            mass: self.mass,
            inertia: self.inertia,
        }
    }

    /// The entries xx, yy, zz, xy, yz, zx of the inertia, or the one of a planar body.
    pub fn inertia_entries(&self) -> Vec<Id> {
        self.inertia.distinct_entries()
    }
}

/// What inputs change by that move: each part with its rate.
pub fn input_rates(work: &Workspace, derivatives: &[usize]) -> Vec<(Id, Id)> {
    let moving = derivatives.iter().enumerate();
    let moving = moving.filter(|(_, given)| **given > 0);
    let parts = moving.flat_map(|(input, _)| {
        [None, Some(0), Some(1), Some(2)].map(|part| {
            let symbol = work.symbol_of(Meaning::Input(input, part))?;
            Some((symbol, work.symbol_of(Meaning::Input(input + 1, part))?))
        })
    });
    parts.flatten().collect()
}
