//! Many descriptions, each by its number.

use std::collections::BTreeMap;
use std::fmt;
use std::time::{Duration, Instant};

use fastrand::Rng;

use crate::answer::{answer, is_determined};
use crate::compiled::Compiled;
use crate::description::body::{Body, Key};
use crate::description::draw;
use crate::description::written::described;
use crate::oracle::Constants;
use crate::samples::{Sample, Source};
use crate::smaller::smaller;
use crate::{closed, skipped, structure};

/// Sets of parameters of a body, and states of each.
const SETS: usize = 3;
const STATES: usize = 8;

/// So many of the slowest expansions are named.
const SLOWEST: usize = 5;

pub struct Plan {
    pub first: usize,
    pub descriptions: usize,
    pub seed: u64,
    /// Failures that are shown.
    pub shown: usize,
}

/// A description with a set of parameters.
pub struct Case<'a> {
    pub body: &'a Body,
    pub compiled: &'a Compiled,
    pub constants: &'a Constants<'a>,
}

/// Claims that a state refutes.
#[derive(Default)]
pub struct Refuted {
    pub list: Vec<(String, String)>,
}

impl Refuted {
    pub fn tell(&mut self, claim: &str, what: String) {
        self.list.push((claim.to_owned(), what));
    }
}

/// The first claim of a description that fails, with the state.
pub struct Failure {
    pub claim: String,
    pub what: String,
    pub sample: Sample,
}

#[derive(Default)]
pub struct Report {
    pub descriptions: usize,
    pub refused: usize,
    /// How often each claim was made.
    pub claims: BTreeMap<String, usize>,
    pub states: usize,
    pub undecided: usize,
    pub failures: usize,
    /// The expansions that took longest, by their number.
    pub slowest: Vec<(Duration, usize)>,
    pub kinds: BTreeMap<String, usize>,
    /// Refusals by their words.
    pub refusals: BTreeMap<String, usize>,
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

/// The claim without numbers.
fn kind(claim: &str) -> String {
    claim
        .chars()
        .filter(|c| !c.is_ascii_digit() && *c != '.' && *c != '-')
        .collect()
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
    let sets = if body.params.is_empty() { 1 } else { SETS };
    for _ in 0..sets {
        let params = source.params(body);
        let constants = Constants::new(body, params.clone());
        if !is_possible(body, &constants) {
            continue;
        }
        let case = Case {
            body,
            compiled: &compiled,
            constants: &constants,
        };
        // differences take their time
        let states = if body.constraints.is_empty() {
            STATES * SETS
        } else {
            STATES
        };
        for _ in 0..states.div_ceil(sets) {
            let sample = source.sample(body, &params);
            let Some(known) = answer(&constants, &sample.given, &sample.instant) else {
                if let Some(report) = &mut report {
                    report.undecided += 1;
                }
                continue;
            };
            if let Some(report) = &mut report {
                report.states += 1;
            }
            let mut refuted = Refuted::default();
            structure::accelerations(&case, &sample, &known, &mut source, &mut refuted);
            structure::zeros(&case, &known, &mut refuted);
            structure::reads(&case, &sample, &known, &mut source, &mut refuted);
            structure::symmetries(&case, &sample, &known, &mut source, &mut refuted);
            structure::planes(&case, &sample, &mut refuted);
            closed::flow(&case, &sample, &known, &mut refuted);
            skipped::skipped(&case, &sample, &known, &mut source, &mut refuted);
            if let Some((claim, what)) = refuted.list.into_iter().next() {
                return Some(Failure {
                    claim,
                    what,
                    sample,
                });
            }
        }
    }
    None
}

/// What is said of constraints that determine their reactions at a state.
const UNDETERMINED: [&str; 4] = [
    "no acceleration changes",
    "is kept already by",
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
        let constants = Constants::new(body, params.clone());
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

fn random(seed: u64, index: usize) -> Rng {
    Rng::with_seed((seed << 40 ^ index as u64).wrapping_mul(0x9E37_79B9_7F4A_7C15))
}

/// Whether parameters make a body whose mass and inertia doubles can do with.
fn is_possible(body: &Body, constants: &Constants<'_>) -> bool {
    let mass = constants.mass.float();
    let has_mass = body.mass.is_none() || mass > 0.0 && mass.is_finite();
    let turns = body.motion.turns() && !body.motion.is_planar();
    let condition = constants.inertia.condition();
    has_mass
        && (!turns
            || matches!(body.motion, crate::description::body::Motion::Rod(_))
            || condition.is_finite() && condition < 1e6)
}

impl Report {
    fn keep_slow(&mut self, time: Duration, index: usize) {
        self.slowest.push((time, index));
        self.slowest.sort_by_key(|slow| core::cmp::Reverse(slow.0));
        self.slowest.truncate(SLOWEST);
    }

    fn count(&mut self, compiled: &Compiled, body: &Body) {
        let structure = &compiled.equations.structure;
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
        if let Some(flow) = &compiled.equations.flow {
            claims.extend(
                flow.describe(compiled.model.motion)
                    .into_iter()
                    .map(|line| format!("flow: {line}")),
            );
        }
        for line in &compiled.equations.skipped {
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
            "{} descriptions, {} refused; {} states, {} left out\n",
            self.descriptions, self.refused, self.states, self.undecided
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
