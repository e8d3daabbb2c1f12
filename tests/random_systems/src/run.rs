//! Many systems, each by its number.

use std::collections::BTreeMap;
use std::fmt;

use fastrand::Rng;

use crate::check::{State, check};
use crate::compiled::Compiled;
use crate::drawn::{Drawn, Extent, drawn};

/// States of each system.
const STATES: usize = 2;

pub struct Plan {
    pub first: usize,
    pub systems: usize,
    pub seed: u64,
    /// Of each.
    pub extent: Extent,
    /// Failures that are shown.
    pub shown: usize,
}

#[derive(Default)]
pub struct Report {
    pub systems: usize,
    pub states: usize,
    pub near: usize,
    pub refused: usize,
    pub failures: usize,
    /// What joints there were.
    pub joints: BTreeMap<String, usize>,
    /// What was left out of the equations.
    pub refusals: BTreeMap<String, usize>,
    /// The largest relative errors of doubles, and beside what a rounding of the state does.
    pub worst: Vec<(f64, usize)>,
    pub conditioned: Vec<(f64, usize)>,
    /// Of the first kind of failure.
    pub kinds: BTreeMap<String, usize>,
}

pub fn run(plan: &Plan) -> Report {
    let mut report = Report::default();
    for index in plan.first..plan.first + plan.systems {
        report.one(plan, index);
    }
    report
}

/// The first failure in some states, and how it is called.
fn failure(drawn: &Drawn, compiled: &Compiled, plan: &Plan, index: usize) -> Option<String> {
    let mut rng = states(plan, index);
    (0..STATES).find_map(|_| {
        let state = State::new(drawn, &mut rng);
        check(drawn, compiled, &state, &mut rng)?.err()
    })
}

fn states(plan: &Plan, index: usize) -> Rng {
    Rng::with_seed(plan.seed ^ ((index as u64) << 20))
}

/// The words before the number of a body or joint.
fn kind(failure: &str) -> String {
    let line = failure.lines().next().unwrap_or_default();
    let words = line.split(':').next().unwrap_or_default();
    words.chars().filter(|c| !c.is_ascii_digit()).collect()
}

impl Report {
    fn one(&mut self, plan: &Plan, index: usize) {
        let drawn = drawn(plan.seed, index, plan.extent);
        self.systems += 1;
        let compiled = match Compiled::new(&drawn) {
            Ok(compiled) => compiled,
            Err(message) => {
                self.refused += 1;
                let words = message.split('"').nth(1).unwrap_or(&message);
                let words: String = words.chars().filter(|c| !c.is_ascii_digit()).collect();
                let count = self.refusals.entry(words).or_default();
                *count += 1;
                if *count == 1 && plan.shown > 0 {
                    println!("system {index} is refused: {message}\n{}\n", drawn.text);
                }
                return;
            }
        };
        for joint in &compiled.system.joints {
            let driven = if joint.is_driven() { ", driven" } else { "" };
            *self
                .joints
                .entry(format!("{}{driven}", joint.kind.word))
                .or_default() += 1;
        }
        let mut rng = states(plan, index);
        for _ in 0..STATES {
            let state = State::new(&drawn, &mut rng);
            match check(&drawn, &compiled, &state, &mut rng) {
                None => self.near += 1,
                Some(Ok(errors)) => {
                    self.states += 1;
                    keep(&mut self.worst, errors.acceleration, index);
                    keep(&mut self.conditioned, errors.conditioned, index);
                }
                Some(Err(failure)) => {
                    self.failures += 1;
                    *self.kinds.entry(kind(&failure)).or_default() += 1;
                    if self.failures <= plan.shown {
                        let (text, failure) = smaller(plan, index, failure);
                        println!("system {index}\n{text}\n{failure}");
                    }
                    return;
                }
            }
        }
    }
}

fn keep(list: &mut Vec<(f64, usize)>, error: f64, index: usize) {
    list.push((error, index));
    list.sort_by(|a, b| b.0.total_cmp(&a.0));
    list.truncate(8);
}

/// The smallest description that fails in the same way.
fn smaller(plan: &Plan, index: usize, first: String) -> (String, String) {
    let mut extent = plan.extent;
    let (mut text, mut found) = (drawn(plan.seed, index, extent).text, first);
    loop {
        let mut less: Vec<Extent> = (1..extent.bodies)
            .map(|bodies| Extent { bodies, ..extent })
            .collect();
        less.extend([
            Extent {
                without: u64::MAX,
                ..extent
            },
            Extent {
                turned: false,
                ..extent
            },
            Extent {
                driven: false,
                ..extent
            },
            Extent {
                params: false,
                ..extent
            },
            Extent {
                pins: false,
                ..extent
            },
            Extent {
                places: false,
                ..extent
            },
            Extent {
                tensors: false,
                ..extent
            },
        ]);
        less.extend((0..40).map(|load| Extent {
            without: extent.without | 1 << load,
            ..extent
        }));
        let next = less.into_iter().find_map(|less| {
            let drawn = drawn(plan.seed, index, less);
            if drawn.text.len() >= text.len() {
                return None;
            }
            let compiled = Compiled::new(&drawn).ok()?;
            let failure = failure(&drawn, &compiled, plan, index)?;
            (kind(&failure) == kind(&found)).then_some((less, drawn.text, failure))
        });
        match next {
            Some((less, smaller, failure)) => (extent, text, found) = (less, smaller, failure),
            None => return (text, found),
        }
    }
}

impl fmt::Display for Report {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(
            f,
            "{} systems, {} refused; {} states, {} without a direction; {} failures",
            self.systems, self.refused, self.states, self.near, self.failures
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
        for (what, list) in [
            ("largest relative errors of doubles", &self.worst),
            (
                "beside what a rounding of the state does",
                &self.conditioned,
            ),
        ] {
            let list = list
                .iter()
                .map(|(error, index)| format!("{error:.1e} ({index})"));
            writeln!(f, "{what}: {}", list.collect::<Vec<_>>().join(", "))?;
        }
        Ok(())
    }
}
