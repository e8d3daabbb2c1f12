//! The balances that determine the unknowns.

use crate::families::LoadKind;
use crate::mechanics::proofs::samples;
use crate::model::{Frame, Reaction, Vector, Workspace};
use crate::symbolic::{Components, Elimination, Equation, Id, Size};

use super::unit::{Unit, assemble};

/// A remaining row of the balances.
#[derive(Clone)]
pub struct BalanceRow {
    pub name: &'static str,
    /// Whether it is a balance of forces or of moments.
    pub kind: LoadKind,
    pub direction: Components,
}

impl BalanceRow {
    pub fn new(name: &'static str, kind: LoadKind, direction: Components) -> Self {
        Self {
            name,
            kind,
            direction,
        }
    }

    /// The equation of this balance for unknown factors of loads, from the forces and moments of
    /// the loads and from `rest`, with forces and moments in these axes.
    pub fn sides(
        &self,
        work: &mut Workspace,
        loads: impl IntoIterator<Item = (Vector, Vector)>,
        rest: (Vector, Vector),
        frames: (Frame, Frame),
    ) -> Sides {
        let mut part = |(force, moment): (Vector, Vector)| {
            let components = match self.kind {
                LoadKind::Force => work.components(force, frames.0),
                LoadKind::Moment => work.components(moment, frames.1),
            };
            work.graph.dot(self.direction, components)
        };
        let coefficients = loads.into_iter().map(&mut part).collect();
        let rest = part(rest);
        (coefficients, work.graph.negate(rest))
    }
}

/// How balances that contain no unknown are treated.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Unmoved {
    /// They must hold by themselves.
    Checked,
    /// The motion is assumed to satisfy them.
    Ignored,
}

/// The balances, solved for the unknowns.
pub struct SolvedBalances<'m> {
    pub units: Vec<Unit<'m>>,
    pub rows: Vec<BalanceRow>,
    pub elimination: Elimination,
    /// Whether the coefficients are known before the state is.
    pub is_constant: bool,
}

impl SolvedBalances<'_> {
    /// A load: the sum of its known part and the part that was solved for.
    pub fn load(&self, work: &mut Workspace, load: &Reaction) -> Vector {
        let values = self.elimination.values.iter();
        let values: Vec<Id> = values.map(|value| work.graph.unnamed(*value)).collect();
        assemble(work, load, self.units.iter().zip(values))
    }

    /// The balances that contain no unknown and do not hold by themselves.
    pub fn unbalanced(&self, work: &Workspace) -> impl Iterator<Item = &BalanceRow> {
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

/// Turns coefficients and right sides into equations.
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
