//! Unknown components of loads, and the balances that they are solved from.

use crate::errors::Extent;
use crate::families::LoadKind;
use crate::mechanics::proofs::samples;
use crate::model::{Frame, Reaction, Workspace};
use crate::symbolic::{Components, Elimination, Equation, Id, Size};

/// An unknown component: its load, its axis in the frame of the equations, and its place.
pub struct Unknown<'m> {
    pub load: &'m Reaction,
    pub axis: usize,
    pub place: Extent,
}

/// A row of the balances that is left over.
#[derive(Clone)]
pub struct Row {
    pub name: &'static str,
    /// Of a force or of a moment, from the components of the resultants.
    pub kind: LoadKind,
    pub direction: Components,
}

impl Row {
    pub fn new(name: &'static str, kind: LoadKind, direction: Components) -> Self {
        Self {
            name,
            kind,
            direction,
        }
    }

    /// Of the components of a force and of a moment, those that it is about.
    pub fn of(&self, force: Components, moment: Components) -> Components {
        match self.kind {
            LoadKind::Force => force,
            LoadKind::Moment => moment,
        }
    }
}

/// What is done with balances in which no unknown has a part.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Unmoved {
    /// They have to hold by themselves.
    Checked,
    /// The motion is taken to meet them.
    Ignored,
}

/// What the balances say of the unknowns.
pub struct Solved<'m> {
    pub frame: Frame,
    pub unknowns: Vec<Unknown<'m>>,
    pub rows: Vec<Row>,
    pub elimination: Elimination,
    /// Whether the coefficients are known before the state is.
    pub is_constant: bool,
}

impl Solved<'_> {
    /// The balances in which no unknown has a part, and which do not hold by themselves.
    pub fn unbalanced(&self, work: &Workspace) -> impl Iterator<Item = &Row> {
        let spare = self.elimination.spare.iter();
        let unmet = spare.filter(|(_, right)| !work.graph.is_zero(*right));
        unmet.map(|(row, _)| &self.rows[*row])
    }

    pub fn is_balanced(&self, work: &Workspace) -> bool {
        self.unbalanced(work).next().is_none()
    }
}

/// The coefficients of an equation, and its right side.
pub type Sides = (Vec<Id>, Id);

pub fn equations(work: &Workspace, rows: Vec<Sides>) -> Vec<Equation> {
    let all: Vec<Id> = rows.iter().flat_map(|(row, _)| row.clone()).collect();
    let mut values = samples(work, &all).into_iter();
    let equations = rows.into_iter().map(|(coefficients, right)| Equation {
        sample: values.by_ref().take(coefficients.len()).collect(),
        sizes: vec![Size::Terms; coefficients.len()],
        active: None,
        coefficients,
        right,
    });
    equations.collect()
}
