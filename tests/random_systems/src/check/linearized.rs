//! Linearisation, against differences of the accelerations that the law holds true.

use std::ops::Range;

use fuzz::mechanics::{Column, Row};
use fuzz::model::{Group, Variable};

use super::state::{State, slope};
use super::{Checks, Failure, apart};
use crate::law::scene::still;
use crate::law::space::{cross, identity};
use crate::wide::Wide;

/// What differences leave of the digits, and of those of loops beside light bodies.
const TREES: f64 = 1e-11;
const LOOPS: f64 = 1e-7;

impl Checks<'_> {
    pub fn linearized(&mut self) {
        let Some(found) = &self.compiled.linearization else {
            return;
        };
        let groups = self.compiled.outline.tangent();
        let accelerations = self.values(&found.accelerations);
        let largest = accelerations.iter().fold(1.0, size);
        for (number, group) in groups.iter().enumerate() {
            for part in 0..group.size {
                let column = (Column::State(number), part);
                let failure = self.column(column, largest, |by| self.shifted(group, part, by));
                self.failures += &failure.unwrap_or_default();
            }
            if group.variable == Variable::Quaternion {
                self.attitude(number, group);
            }
        }
        for number in 0..self.state.inputs.len() {
            let column = (Column::Input(number), 0);
            let failure = self.column(column, largest, |by| {
                let mut inputs = self.state.inputs.clone();
                inputs[number] = inputs[number] + Wide::from(by);
                State {
                    inputs,
                    ..self.state.with(self.state.rates.clone())
                }
            });
            self.failures += &failure.unwrap_or_default();
        }
    }

    /// The freedoms of a group: its joint, and which of its own.
    fn freedoms(&self, group: &Group) -> (usize, Range<usize>) {
        let joint = self.compiled.system.written[group.joint];
        let link = self.compiled.links[joint];
        let coordinates = &self.compiled.system.joints[joint].coordinates.0;
        let is_linear = |variable| matches!(variable, Variable::Position | Variable::Velocity);
        let mut linear = coordinates.iter();
        let linear = linear
            .by_ref()
            .filter(|one| one.variable == Variable::Velocity);
        let before = if is_linear(group.variable) {
            0
        } else {
            linear.count()
        };
        let first = before + group.first;
        (link, first..first + group.size)
    }

    /// The state, moved along one component of a group.
    fn shifted(&self, group: &Group, part: usize, by: f64) -> State {
        let (link, freedoms) = self.freedoms(group);
        let freedom = freedoms.start + part;
        let is_rate = matches!(
            group.variable,
            Variable::Velocity | Variable::AngularVelocity
        );
        if is_rate {
            let mut rates = self.state.rates.clone();
            rates[link].1[freedom] = rates[link].1[freedom] + Wide::from(by);
            return self.state.with(rates);
        }
        let mut along = still(&self.drawn.links);
        along[link][freedom] = Wide::ONE;
        self.state.shifted(self.drawn, &along, by)
    }

    /// What the accelerations change by along one column.
    fn column(
        &self,
        (column, part): (Column, usize),
        largest: f64,
        at: impl Fn(f64) -> State,
    ) -> Option<Failure> {
        let compiled = self.compiled;
        let found = compiled.linearization.as_ref()?;
        let expected = slope(1.0, |by| {
            compiled.values(&found.accelerations, &at(by).given())
        });
        let mut first = 0;
        let mut entries = vec![Wide::ZERO; expected.len()];
        for (number, group) in compiled.outline.accelerations().iter().enumerate() {
            let row = Row::Acceleration(number);
            let mut blocks = found.blocks.iter();
            let block = blocks.find(|block| block.row == row && block.column == column);
            if let Some(block) = block {
                let ids = &block.entries[part * group.size..(part + 1) * group.size];
                entries[first..first + group.size].copy_from_slice(&self.values(ids));
            }
            first += group.size;
        }
        let size = expected.iter().fold(largest, size);
        let exact = if self.drawn.rings.is_empty() {
            TREES
        } else {
            LOOPS
        };
        let what = format!("linearization by {column:?}");
        apart(&what, &entries, &expected, (size, exact))
    }

    /// An attitude moves by e with `e' = dw - w x e`.
    fn attitude(&mut self, number: usize, group: &Group) {
        let Some(found) = &self.compiled.linearization else {
            return;
        };
        let (link, freedoms) = self.freedoms(group);
        let w = &self.state.rates[link].1[freedoms];
        let w = [w[0], w[1], w[2]];
        let expected = identity().map(|e| cross(e, w)).concat();
        let mut blocks = found.blocks.iter();
        let block = blocks.find(|block| block.row == Row::Attitude(number));
        let entries = block.map_or(Vec::new(), |block| self.values(&block.entries));
        self.close("linearization of an attitude", &entries, &expected, 1.0);
    }
}

fn size(most: f64, one: &Wide) -> f64 {
    most.max(one.high.abs())
}
