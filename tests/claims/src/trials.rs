//! Everything that is claimed about a description, tried at many states.

use crate::answer::answer;
use crate::compiled::Compiled;
use crate::description::body::{Body, Motion};
use crate::oracle::Constants;
use crate::samples::{Sample, Source};
use crate::{closed, skipped, structure};

/// Sets of parameters of a body, and states of each.
pub const SETS: usize = 3;
pub const STATES: usize = 8;
/// In fewer states, a pivot may vanish in all of them by chance.
const FEW: usize = 4;

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

/// States that were tried, and those that were left out.
#[derive(Default)]
pub struct Tally {
    pub states: usize,
    pub undecided: usize,
    /// Those in which a pivot vanishes: no acceleration is computed there.
    pub without_pivot: usize,
}

/// The first claim that a state refutes.
pub fn refuted(
    body: &Body,
    compiled: &Compiled,
    source: &mut Source,
    tally: &mut Tally,
) -> Option<Failure> {
    let mut lost = None;
    let sets = if body.params.is_empty() { 1 } else { SETS };
    for _ in 0..sets {
        let params = source.params(body);
        let constants = Constants::new(body, &params);
        if !is_possible(body, &constants) {
            continue;
        }
        let case = Case {
            body,
            compiled,
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
                tally.undecided += 1;
                continue;
            };
            tally.states += 1;
            let mut refuted = Refuted::default();
            if compiled.has_no_pivot(body, &sample.given) {
                tally.without_pivot += 1;
                lost = Some(Failure {
                    claim: "pivots: none of them is zero everywhere".to_owned(),
                    what: "in every state that was tried, one of them vanishes".to_owned(),
                    sample: sample.clone(),
                });
            } else {
                structure::accelerations(&case, &sample, &known, source, &mut refuted);
            }
            structure::zeros(&case, &known, &mut refuted);
            structure::reads(&case, &sample, &known, source, &mut refuted);
            structure::symmetries(&case, &sample, &known, source, &mut refuted);
            structure::planes(&case, &sample, &mut refuted);
            closed::flow(&case, &sample, &known, &mut refuted);
            skipped::skipped(&case, &sample, &known, source, &mut refuted);
            if let Some((claim, what)) = refuted.list.into_iter().next() {
                return Some(Failure {
                    claim,
                    what,
                    sample,
                });
            }
        }
    }
    lost.filter(|_| tally.states >= FEW && tally.without_pivot == tally.states)
}

/// Whether parameters make a body whose mass and inertia doubles can do with.
pub fn is_possible(body: &Body, constants: &Constants<'_>) -> bool {
    let mass = constants.mass.float();
    let has_mass = body.mass.is_none() || mass > 0.0 && mass.is_finite();
    let turns = body.motion.turns() && !body.motion.is_planar();
    let condition = constants.inertia.condition();
    has_mass
        && (!turns
            || matches!(body.motion, Motion::Rod(_))
            || condition.is_finite() && condition < 1e6)
}
