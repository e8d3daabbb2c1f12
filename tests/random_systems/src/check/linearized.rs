//! Linearization, compared with finite differences of the accelerations that satisfy the law.

use std::ops::Range;

use mounted::mechanics::{Column, Linearization, Row};
use mounted::model::{Group, Variable};

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
        let params = self.drawn.declared.params.len();
        let accelerations = self.values(&found.accelerations);
        let largest = accelerations.iter().fold(1.0, size);
        for (number, group) in groups.iter().enumerate() {
            for part in 0..group.size {
                let column = (Column::State(number), part);
                let failure = if group.variable == Variable::Own {
                    self.by_value(found, column, largest, params + group.first)
                } else {
                    self.column(found, column, largest, |by| self.shifted(group, part, by))
                };
                self.failures += &failure.unwrap_or_default();
            }
            if group.variable == Variable::Quaternion {
                self.attitude(number, group);
            }
        }
        for number in 0..self.state.inputs.len() {
            let column = (Column::Input(number), 0);
            let failure = self.column(found, column, largest, |by| {
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

    /// By parameters, each of them.
    pub fn sensitive(&mut self) {
        let Some(found) = &self.compiled.sensitivity else {
            return;
        };
        let accelerations = self.values(&found.accelerations);
        let largest = accelerations.iter().fold(1.0, size);
        for number in 0..self.drawn.declared.params.len() {
            let column = (Column::Param(number), 0);
            let failure = self.by_value(found, column, largest, number);
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

    /// The same by a parameter, or a state behind them, in steps of its own size.
    fn by_value(
        &self,
        found: &Linearization,
        column: (Column, usize),
        largest: f64,
        number: usize,
    ) -> Option<Failure> {
        // a power of two, of which multiples are exact
        let unit = self.state.params[number].high.abs().log2().floor().exp2();
        let at = |by: f64| self.state.valued(number, by * unit);
        self.column_in((found, unit), column, largest, at)
    }

    fn column(
        &self,
        found: &Linearization,
        column: (Column, usize),
        largest: f64,
        at: impl Fn(f64) -> State,
    ) -> Option<Failure> {
        self.column_in((found, 1.0), column, largest, at)
    }

    /// What the accelerations change by along one column, in steps of a unit.
    fn column_in(
        &self,
        (found, unit): (&Linearization, f64),
        (column, part): (Column, usize),
        largest: f64,
        at: impl Fn(f64) -> State,
    ) -> Option<Failure> {
        let compiled = self.compiled;
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
                let values = self.values(ids).into_iter().map(|value| value * unit);
                entries.splice(first..first + group.size, values);
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
