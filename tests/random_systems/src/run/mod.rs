//! Runs many systems, each identified by its number.

mod report;
mod smaller;

use fastrand::Rng;

use crate::check::compiled::Compiled;
use crate::check::state::State;
use crate::check::{Errors, check, round_trip};
use crate::draw::{Drawn, Extent, drawn};

pub use report::Report;
use report::keep;
use smaller::smaller;

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

pub fn run(plan: &Plan) -> Report {
    let mut report = Report::default();
    for index in plan.first..plan.first + plan.systems {
        report.one(plan, index);
    }
    report
}

/// What came of one state.
enum Outcome {
    /// A load has no direction.
    Near,
    /// The loops do not close.
    Open,
    Right(Errors),
    Wrong(String),
}

fn outcome(drawn: &Drawn, [compiled, opened]: [Option<&Compiled>; 2], rng: &mut Rng) -> Outcome {
    let (Some(compiled), Some(mut state)) = (compiled, State::new(drawn, rng)) else {
        return Outcome::Open;
    };
    match check(drawn, compiled, &state, rng) {
        None => Outcome::Near,
        Some(Err(failure)) => Outcome::Wrong(failure),
        Some(Ok(errors)) => {
            let opened = opened.and_then(|opened| round_trip(drawn, compiled, opened, &mut state));
            match opened {
                Some(failure) => Outcome::Wrong(failure),
                None => Outcome::Right(errors),
            }
        }
    }
}

/// The first failure in some states, and how it is called.
fn failure(drawn: &Drawn, compiled: &Compiled, plan: &Plan, index: usize) -> Option<String> {
    let mut rng = states(plan, index);
    let opened = opened(drawn).and_then(Result::ok);
    (0..STATES).find_map(
        |_| match outcome(drawn, [Some(compiled), opened.as_ref()], &mut rng) {
            Outcome::Wrong(failure) => Some(failure),
            _ => None,
        },
    )
}

/// The system with open drives, if it has any.
fn opened(drawn: &Drawn) -> Option<Result<Compiled, String>> {
    drawn.opened.as_ref().map(|text| Compiled::new(text))
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
        let compiled = Compiled::new(&drawn.text);
        let opened = opened(&drawn).transpose();
        let (compiled, opened) = match (compiled, opened) {
            (Ok(compiled), Ok(opened)) => (compiled, opened),
            (Err(message), _) | (_, Err(message)) => {
                self.refuse(plan, index, &drawn, &message);
                return;
            }
        };
        self.count(&compiled, &drawn);
        let mut rng = states(plan, index);
        for _ in 0..STATES {
            match outcome(&drawn, [Some(&compiled), opened.as_ref()], &mut rng) {
                Outcome::Near => self.near += 1,
                Outcome::Open => self.open += 1,
                Outcome::Right(errors) => {
                    self.states += 1;
                    let lists = match (drawn.rings.is_empty(), drawn.follows) {
                        (true, false) => &mut self.trees,
                        (true, true) => &mut self.followed,
                        (false, _) => &mut self.loops,
                    };
                    keep(&mut lists[0], errors.acceleration, index);
                    keep(&mut lists[1], errors.conditioned, index);
                }
                Outcome::Wrong(failure) => {
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

    fn refuse(&mut self, plan: &Plan, index: usize, drawn: &Drawn, message: &str) {
        self.refused += 1;
        let words = message.split('"').nth(1).unwrap_or(message);
        let words: String = words.chars().filter(|c| !c.is_ascii_digit()).collect();
        let count = self.refusals.entry(words).or_default();
        *count += 1;
        if *count == 1 && plan.shown > 0 {
            println!("system {index} is refused: {message}\n{}\n", drawn.text);
        }
    }
}
