//! The results for many systems.

use std::collections::BTreeMap;
use std::fmt;

use crate::check::compiled::Compiled;
use crate::draw::Drawn;

#[derive(Default)]
pub struct Report {
    pub systems: usize,
    pub states: usize,
    pub near: usize,
    /// States in which the loops do not close.
    pub open: usize,
    pub refused: usize,
    pub failures: usize,
    /// What joints there were.
    pub joints: BTreeMap<String, usize>,
    /// What was left out of the equations.
    pub refusals: BTreeMap<String, usize>,
    /// The largest relative errors of doubles, and beside what a rounding of the state does.
    pub trees: [Vec<(f64, usize)>; 2],
    /// Of trees whose loads follow accelerations.
    pub followed: [Vec<(f64, usize)>; 2],
    pub loops: [Vec<(f64, usize)>; 2],
    /// Of the first kind of failure.
    pub kinds: BTreeMap<String, usize>,
}

pub fn keep(list: &mut Vec<(f64, usize)>, error: f64, index: usize) {
    list.push((error, index));
    list.sort_by(|a, b| b.0.total_cmp(&a.0));
    list.truncate(8);
}

impl Report {
    /// Counts what there is in a system.
    pub fn count(&mut self, compiled: &Compiled, drawn: &Drawn) {
        let system = &compiled.system;
        let mut words = Vec::new();
        for joint in &system.joints {
            let driven = if joint.is_driven() { ", driven" } else { "" };
            words.push(format!("{}{driven}", joint.kind.word));
        }
        let undetermined = if compiled.reactions.is_none() {
            ", undetermined"
        } else {
            ""
        };
        for closing in &system.closings {
            words.push(format!("{}, closes{undetermined}", closing.kind.word));
        }
        let counts = [
            (system.cables.len(), "cable"),
            (system.potentials.list.len(), "potential"),
            (drawn.declared.locals.len(), "local"),
            (drawn.text.matches("copies").count(), "copies"),
            (drawn.open.len(), "open drive"),
            (system.links.len(), "link"),
            (drawn.declared.led.len(), "driving state"),
            (drawn.text.matches("table(").count(), "table"),
            (drawn.text.matches(", cubic").count(), "cubic"),
            (usize::from(drawn.declared.calls), "function"),
            (drawn.text.matches(".armature").count(), "armature"),
            (usize::from(compiled.regressors.is_some()), "regressor"),
            (
                usize::from(compiled.linearization.is_some()),
                "linearization",
            ),
        ];
        for (count, word) in counts {
            words.extend(std::iter::repeat_n(format!("({word})"), count));
        }
        for word in words {
            *self.joints.entry(word).or_default() += 1;
        }
    }
}

impl fmt::Display for Report {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(
            f,
            "{} systems, {} refused; {} states, {} without a direction, {} that do not close; {} failures",
            self.systems, self.refused, self.states, self.near, self.open, self.failures
        )?;
        for (joint, count) in &self.joints {
            writeln!(f, "{count:>9}  {joint}")?;
        }
        for (words, count) in &self.refusals {
            writeln!(f, "{count:>9}  refused: {words}")?;
        }
        for (words, count) in &self.kinds {
            writeln!(f, "{count:>9}  FAILED: {words}")?;
        }
        let lists = [
            ("trees", &self.trees),
            ("trees with loads that follow accelerations", &self.followed),
            ("loops", &self.loops),
        ];
        for (what, [errors, conditioned]) in lists {
            let listed = |list: &[(f64, usize)]| {
                let list = list
                    .iter()
                    .map(|(error, index)| format!("{error:.1e} ({index})"));
                list.collect::<Vec<_>>().join(", ")
            };
            writeln!(
                f,
                "{what}, largest relative errors of doubles: {}",
                listed(errors)
            )?;
            writeln!(
                f,
                "  beside what a rounding of the state does: {}",
                listed(conditioned)
            )?;
        }
        Ok(())
    }
}
