//! Loads of a body as functions of its own acceleration, whatever joints it moves by.

use crate::errors::{every, silently};
use crate::families::LoadKind;
use crate::lower::definitions::{definition_order, split_at_points};
use crate::model::{Felt, Load, Meaning, Member, State};
use crate::symbolic::Stage;

use super::body::Draft;
use super::reader::Reader;

impl Reader<'_> {
    /// Reads the loads that depend on accelerations once more, with symbols for the acceleration of
    /// their body.
    pub fn felt(&mut self, drafts: &mut [Draft<'_>], bodies: &mut [Member]) {
        for (number, (draft, body)) in drafts.iter_mut().zip(bodies).enumerate() {
            let follow = body.loads.iter().filter(|load| load.follows(&self.work));
            let follow: Vec<String> = follow.map(|load| load.name.to_string()).collect();
            if !follow.is_empty() {
                body.felt = self.felt_by(number, draft, body.state, &follow);
            }
        }
    }

    fn felt_by(
        &mut self,
        number: usize,
        draft: &mut Draft<'_>,
        state: State,
        follow: &[String],
    ) -> Option<Felt> {
        let kinds = [LoadKind::Moment, LoadKind::Force];
        let axes = kinds.map(|kind| kind.axes(self.system.is_planar));
        let work = &mut self.work;
        let acceleration = axes.map(|axes| work.symbols(Stage::State, axes, |_| Meaning::Virtual));
        let felt = State {
            angular_acceleration: acceleration[0],
            acceleration: work.vector(draft.frame, acceleration[1]),
            ..state
        };
        self.tell_of(number, &felt);
        draft.state = Some(felt);
        let known = draft.scope.values();
        let loads = self.loads_again(draft, follow);
        draft.scope.restore(known);
        draft.state = Some(state);
        self.tell_of(number, &state);
        Some(Felt {
            acceleration,
            loads: loads?,
        })
    }

    /// The loads with these names, and before them all definitions that may use the motion.
    fn loads_again(&mut self, draft: &mut Draft<'_>, names: &[String]) -> Option<Vec<Load>> {
        let (body, defaults) = (draft.description, self.defaults.clone());
        let fields = &self.system.top.loads;
        let (order, _) = definition_order(body);
        // all errors are already reported
        silently(|errors| {
            let (_, rest) = split_at_points(body, &order);
            self.in_body(draft, errors, |lowering, mass| {
                for definition in rest {
                    lowering.scope.forget(&definition.of(body).0);
                    lowering.definition(definition, body, &defaults, mass);
                }
                let written = fields.iter().chain(&body.loads);
                let written = written.filter(|load| names.contains(&load.name.to_string()));
                every(written.map(|load| lowering.load(load)))
            })
        })
    }
}
