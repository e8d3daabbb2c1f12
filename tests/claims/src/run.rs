//! Runs many descriptions, each identified by its number.

use std::time::Instant;

use fastrand::Rng;

use crate::answer::is_determined;
use crate::compiled::Compiled;
use crate::description::body::{Body, Key};
use crate::description::draw;
use crate::description::written::described;
use crate::oracle::Constants;
use crate::report::{Report, kind};
use crate::samples::Source;
use crate::smaller::smaller;
use crate::trials::{Failure, SETS, STATES, Tally, is_possible, refuted};

pub struct Plan {
    pub first: usize,
    pub descriptions: usize,
    pub seed: u64,
    /// Failures that are shown.
    pub shown: usize,
}

pub fn run(plan: &Plan) -> Report {
    let mut report = Report::default();
    for index in plan.first..plan.first + plan.descriptions {
        let body = draw::sparse_body(plan.seed, index);
        report.descriptions += 1;
        let has_flow = index % 3 == 0;
        if let Some(failure) = tried(&body, plan.seed, index, has_flow, Some(&mut report)) {
            report.failures += 1;
            let count = report.kinds.entry(kind(&failure.claim)).or_default();
            *count += 1;
            if *count <= plan.shown {
                show(&body, plan.seed, index, has_flow, &failure);
            }
        }
    }
    report
}

/// The first description of a plan.
pub fn shown(plan: &Plan) -> String {
    described(&draw::sparse_body(plan.seed, plan.first), &[])
}

fn show(body: &Body, seed: u64, index: usize, has_flow: bool, failure: &Failure) {
    let (mut least, mut failure_of_least) = (body.clone(), None);
    while let Some((less, failure)) = smaller(&least).into_iter().find_map(|less| {
        let found = tried(&less, seed, index, has_flow, None)?;
        (kind(&found.claim) == kind(&failure.claim)).then_some((less, found))
    }) {
        (least, failure_of_least) = (less, Some(failure));
    }
    let failure = failure_of_least.as_ref().unwrap_or(failure);
    let given = &failure.sample.given;
    println!(
        "description {index} of seed {seed}: \"{}\"\n{}",
        failure.claim,
        described(&least, &[])
    );
    println!("  {}", failure.what);
    println!(
        "  at time {:e}, state {:?}, params {:?}, inputs {:?}\n",
        given.time, given.state, given.params, given.inputs
    );
}

/// Expands a description and tries what is claimed of it.
fn tried(
    body: &Body,
    seed: u64,
    index: usize,
    has_flow: bool,
    mut report: Option<&mut Report>,
) -> Option<Failure> {
    let mut outputs = Vec::new();
    if has_flow {
        outputs.push("flow");
    }
    if body
        .loads
        .iter()
        .any(|load| load.is_open() && load.key != Key::Reactions)
    {
        outputs.push("inverse");
    }
    let text = described(body, &outputs);
    let start = Instant::now();
    let compiled = Compiled::new(&text);
    if let Some(report) = &mut report {
        report.keep_slow(start.elapsed(), index);
    }
    let compiled = match compiled {
        Ok(compiled) => compiled,
        Err(_) if has_flow => return tried(body, seed, index, false, report),
        Err(mistakes) => {
            if let Some(report) = report {
                report.refused += 1;
                *report.refusals.entry(kind(&mistakes)).or_default() += 1;
            }
            return refusal(body, seed, index, &text, &mistakes);
        }
    };
    if let Some(failure) = order(body, &outputs, seed, index) {
        return Some(failure);
    }
    if let Some(report) = &mut report {
        report.count(&compiled, body);
    }
    let mut source = Source::new(random(seed, index), &text);
    let mut tally = Tally::default();
    let failure = refuted(body, &compiled, &mut source, &mut tally);
    if let Some(report) = report {
        report.states += tally.states;
        report.undecided += tally.undecided;
        report.without_pivot += tally.without_pivot;
    }
    failure
}

/// What is said of constraints that determine their reactions at a state.
const UNDETERMINED: [&str; 4] = [
    "no acceleration changes",
    "restrains the same motion as",
    "nothing determines",
    "no unknown reaction keeps",
];

/// A refusal that a state refutes.
fn refusal(body: &Body, seed: u64, index: usize, text: &str, mistakes: &str) -> Option<Failure> {
    let claim = UNDETERMINED
        .iter()
        .find(|words| mistakes.contains(**words))?;
    let mut source = Source::new(random(seed, index), text);
    for _ in 0..STATES * SETS {
        let params = source.params(body);
        let constants = Constants::new(body, &params);
        if !is_possible(body, &constants) {
            continue;
        }
        let sample = source.sample(body, &params);
        if is_determined(&constants, &sample.given, &sample.instant) {
            let claim = format!("refused: {claim}");
            return Some(Failure {
                claim,
                what: mistakes.to_owned(),
                sample,
            });
        }
    }
    None
}

/// Whether the constraints in another order are refused.
fn order(body: &Body, outputs: &[&str], seed: u64, index: usize) -> Option<Failure> {
    if body.constraints.len() < 2 {
        return None;
    }
    let mut other = body.clone();
    other.constraints.rotate_left(1);
    let text = described(&other, outputs);
    let mistakes = Compiled::new(&text).err()?;
    let mut source = Source::new(random(seed, index), &text);
    let params = body.defaults();
    let sample = source.sample(body, &params);
    Some(Failure {
        claim: "refused in another order".to_owned(),
        what: mistakes,
        sample,
    })
}

pub fn random(seed: u64, index: usize) -> Rng {
    Rng::with_seed((seed << 40 ^ index as u64).wrapping_mul(0x9E37_79B9_7F4A_7C15))
}
