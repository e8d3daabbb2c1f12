//! The meaning of a description: names are resolved, frames and dimensions are checked, loads and
//! inertia are in the graph.
//!
//! The [`Outline`] of a body always exists; its [`Model`] exists if there were no errors.

mod body;
mod joints;
mod kinematics;
mod system;
mod words;

pub use body::{
    Along, Asked, Charges, Composed, Constraint, Declared, Defaults, Displaced, Drawn, ENTRIES,
    Form, Inertia, Jointed, Level, Load, Mass, Matrix, Origin, Outline, Potential, Potentials,
    Reaction, SOLIDS, Shared, Solid, Substance, Unweighed, UnweighedBody, Violation, displaced,
    is_flat, is_possible, is_solid, least_moment, matrix, thinnest, words,
};
pub use joints::{
    Coordinate, FIXED_POINT, Field, Group, Joint, MOTIONS, Motion, Orientation, PIVOT, PLANAR,
    PLANAR_TRANSLATION, Rates, SPATIAL, Shape, TRANSLATION,
};
pub use kinematics::{
    Attitude, Axis, Own, Pair, Point, State, Support, Turn, Turns, Vector, Workspace, state_symbols,
};
pub use system::{
    Axes, Connection, Constraints, Felt, Holds, JointKind, Member, Part, Property, System, Tie,
    TreeJoint,
};
pub use words::{
    AXES, Answers, Check, Checks, Claim, Dimension, Doubtful, ForeignConstant, ForeignFunction,
    Frame, FrameWord, Labels, Meaning, Unit, Variable, shown, why_not,
};

use crate::symbolic::{Components, Graph, Id};

/// The meaning of a description.
#[derive(Clone)]
pub struct Model {
    pub motion: Motion,
    /// The number of given derivatives of each input, which are declared after it.
    pub derivatives: Vec<usize>,
    pub state: State,
    /// User-defined states.
    pub states: Vec<Own>,
    pub mass: Option<Id>,
    pub inertia: Inertia,
    /// Whether its equations have to be differentiated.
    pub is_differentiated: bool,
    /// Whether an inertia was given for a body that does not rotate.
    pub has_idle_inertia: bool,
    pub loads: Vec<Load>,
    /// The same body with an unknown mass, if a regressor is requested.
    pub unweighed: Option<Shared>,
    /// If loads depend on accelerations: the loads as functions of the symbols of accelerations.
    pub following: Vec<Load>,
    /// Potentials and fields that become loads by differentiation.
    pub potentials: Potentials,
    /// Loads with unknown components.
    pub reactions: Vec<Reaction>,
    /// Drives with unknown components, which are zero for the accelerations.
    pub drives: Vec<Reaction>,
    /// The constraints of the motion, as scalars.
    pub constraints: Vec<Constraint>,
    pub pole: Point,
    /// The default values of parameters.
    pub defaults: Defaults,
    pub checks: Checks,
}

impl Model {
    /// A body under these loads, without anything else.
    pub fn of(
        motion: Motion,
        state: State,
        (mass, inertia): (Option<Id>, Inertia),
        loads: Vec<Load>,
        pole: Point,
    ) -> Self {
        Self {
            motion,
            derivatives: Vec::new(),
            state,
            states: Vec::new(),
            mass,
            inertia,
            is_differentiated: false,
            has_idle_inertia: false,
            loads,
            unweighed: None,
            following: Vec::new(),
            potentials: Potentials::default(),
            reactions: Vec::new(),
            drives: Vec::new(),
            constraints: Vec::new(),
            pole,
            defaults: Defaults::default(),
            checks: Checks::default(),
        }
    }

    /// The mass, if G has its own coordinates.
    pub fn moved_mass(&self) -> Option<Id> {
        self.mass.filter(|_| self.motion.translates())
    }

    /// The direction of the axis of a hinge, in body axes; in the plane, z.
    pub fn hinge(&self, graph: &mut Graph) -> Option<Components> {
        let support = self.state.support.filter(|_| self.motion.is_hinged())?;
        let z = [0, 0, 1].map(|component| graph.integer(component));
        Some(support.direction.unwrap_or(z))
    }

    /// The mass and the inertia of the body.
    pub fn substance(&self) -> Substance {
        Substance {
            name: None,
            mass: self.mass,
            inertia: self.inertia,
            swings: self.state.swings,
        }
    }

    /// The entries xx, yy, zz, xy, yz, zx of the inertia, or the single moment of a planar body.
    pub fn inertia_entries(&self) -> Vec<Id> {
        self.inertia.distinct_entries()
    }
}

/// The components of `.moving` inputs, each with its rate.
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
