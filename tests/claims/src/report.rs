//! The results for many descriptions.

use std::collections::BTreeMap;
use std::fmt;
use std::time::Duration;

use crate::compiled::Compiled;
use crate::description::body::Body;
use crate::skipped;

/// So many of the slowest expansions are named.
const SLOWEST: usize = 5;

#[derive(Default)]
pub struct Report {
    pub descriptions: usize,
    pub refused: usize,
    /// How often each claim was made.
    pub claims: BTreeMap<String, usize>,
    pub states: usize,
    pub undecided: usize,
    pub without_pivot: usize,
    pub failures: usize,
    /// The expansions that took longest, by their number.
    pub slowest: Vec<(Duration, usize)>,
    pub kinds: BTreeMap<String, usize>,
    /// Refusals by their words.
    pub refusals: BTreeMap<String, usize>,
}

/// The claim without numbers.
pub fn kind(claim: &str) -> String {
    claim
        .chars()
        .filter(|c| !c.is_ascii_digit() && *c != '.' && *c != '-')
        .collect()
}

impl Report {
    pub fn keep_slow(&mut self, time: Duration, index: usize) {
        self.slowest.push((time, index));
        self.slowest.sort_by_key(|slow| core::cmp::Reverse(slow.0));
        self.slowest.truncate(SLOWEST);
    }

    pub fn count(&mut self, compiled: &Compiled, body: &Body) {
        let structure = &compiled.structure;
        let mut claims = Vec::new();
        if structure.is_force_free && crate::layout::translates(body) {
            claims.push("is_force_free".to_owned());
        }
        if structure.is_torque_free {
            claims.push("is_torque_free".to_owned());
        }
        if structure.keeps_spin {
            claims.push("keeps_spin".to_owned());
        }
        if structure.planes.contains(&true) {
            claims.push("planes".to_owned());
        }
        for (part, dependence) in [
            ("linear", &structure.linear),
            ("angular", &structure.angular),
        ] {
            for (whose, symmetry) in [("world", dependence.world), ("body", dependence.body)] {
                let word = format!("{symmetry:?}");
                if word != "None" {
                    claims.push(format!("{part}, turns of the {whose}: {}", &word[..5]));
                }
            }
        }
        if let Some(flow) = &compiled.flow {
            claims.extend(
                flow.describe(compiled.model.motion)
                    .into_iter()
                    .map(|line| format!("flow: {line}")),
            );
        }
        for line in &compiled.skipped {
            if skipped::is_tried(line, body) {
                let line = kind(line);
                claims.push(format!("skipped: {line}"));
            } else if !skipped::is_manner(line) {
                claims.push(format!("NOT TRIED: {line}"));
            }
        }
        for claim in claims {
            *self.claims.entry(claim).or_default() += 1;
        }
    }
}

impl fmt::Display for Report {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(
            f,
            "{} descriptions, {} refused; {} states, in {} of them a pivot vanishes; {} left out\n",
            self.descriptions, self.refused, self.states, self.without_pivot, self.undecided
        )?;
        for (claim, count) in &self.claims {
            writeln!(f, "{count:>9}  {claim}")?;
        }
        for (words, count) in &self.refusals {
            writeln!(f, "{count:>9}  refused: {words}")?;
        }
        for (time, index) in &self.slowest {
            writeln!(f, "{time:>9.1?}  to expand description {index}")?;
        }
        writeln!(
            f,
            "\n{} descriptions with a claim that a state refutes",
            self.failures
        )?;
        for (kind, count) in &self.kinds {
            writeln!(f, "{count:>9}  {kind}")?;
        }
        Ok(())
    }
}
