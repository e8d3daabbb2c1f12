//! Bodies in many states, and the largest error of each of their outputs.

use std::fmt;
use std::ops::Range;

use crate::description::body::Body;
use crate::description::draw;
use crate::given::Given;
use crate::oracle::linearized::{self, Entry};
use crate::oracle::{Constants, Expected, expected};
use crate::output::{Answers, Output};
use crate::states;

/// What is written at build time: from lists of numbers to a list of answers.
pub type Ask = fn(&Given, &mut Answers);

/// The largest error of one output.
#[derive(Clone, Debug, Default)]
pub struct Record {
    pub evaluations: u64,
    /// In units in the last place of the largest term.
    pub error: f64,
    /// The body and the number of the state.
    pub body: usize,
    pub state: usize,
    /// Which of the loads, if it is one.
    pub load: usize,
}

#[derive(Clone, Debug, Default)]
pub struct Survey {
    /// Bodies times states that were compared.
    pub evaluations: u64,
    /// States in which rounding decides a condition.
    pub near_switches: u64,
    /// Answers that are infinite or no number in both, or have terms that are.
    pub undefined: u64,
    /// Products of the norms of inertia and its inverse: the largest.
    pub condition: f64,
    /// Entries of linearizations, those that differences do not decide, and those that differ.
    pub derivatives: u64,
    pub undecided: u64,
    pub wrong: Vec<String>,
    pub records: [Record; Output::ALL.len()],
}

impl Survey {
    /// Asks a body in these runs of states.
    ///
    /// # Panics
    /// If `new` refuses the parameters, or the answers are not those that were expected.
    pub fn ask(
        &mut self,
        seed: u64,
        index: usize,
        ask: impl Fn(&Given, &mut Answers),
        runs: Range<usize>,
    ) {
        let body = draw::body(seed, index);
        let (mut given, mut answers) = (Given::default(), Answers::default());
        for run in runs {
            let mut random = states::of_run(seed, index, run);
            states::draw_params(&mut random, &body, &mut given);
            let constants = Constants::new(&body, &given.params);
            if body.motion.turns() && !body.motion.is_planar() {
                let condition = constants.inertia.condition();
                if condition.is_finite() {
                    self.condition = self.condition.max(condition);
                }
            }
            for state in 0..states::RUN {
                states::draw(&mut random, &body, &mut given);
                answers.clear();
                ask(&given, &mut answers);
                assert!(!answers.refused, "{} refuses {:?}", body.name, given.params);
                let state = run * states::RUN + state;
                if body.rates.is_empty() {
                    self.compare(&body, index, state, &answers, &constants, &given);
                    continue;
                }
                let constants = Constants::now(&body, &given);
                self.compare(&body, index, state, &answers, &constants, &given);
            }
        }
    }

    fn compare(
        &mut self,
        body: &Body,
        index: usize,
        state: usize,
        answers: &Answers,
        constants: &Constants<'_>,
        given: &Given,
    ) {
        let Some(expected) = expected(constants, given, answers) else {
            self.near_switches += 1;
            return;
        };
        self.evaluations += 1;
        // differences take hundreds of evaluations
        if state.is_multiple_of(16) {
            self.linearized(body, (index, state), answers, given);
        }
        let asked: Vec<(Output, usize)> = answers
            .list
            .iter()
            .map(|(output, load, _)| (*output, *load))
            .collect();
        let known: Vec<(Output, usize)> =
            expected.iter().map(|one| (one.output, one.load)).collect();
        assert_eq!(asked, known, "the answers of {}", body.name);
        for (expected, (.., answer)) in expected.iter().zip(&answers.list) {
            let Some(error) = error(expected, answer) else {
                self.undefined += 1;
                continue;
            };
            let record = &mut self.records[expected.output as usize];
            record.evaluations += 1;
            if error > record.error {
                record.error = error;
                (record.body, record.state, record.load) = (index, state, expected.load);
            }
        }
    }

    fn linearized(&mut self, body: &Body, place: (usize, usize), answers: &Answers, given: &Given) {
        let entries = linearized::derivatives(body, given).unwrap_or_default();
        // what cancels is left by this much of the largest
        let sizes = entries.iter().map(|entry| entry.value.high.abs());
        let largest = sizes.fold(0.0, f64::max);
        for entry in entries {
            let Entry {
                row,
                column,
                value,
                doubt,
            } = entry;
            let found = answers.derivatives[row][column];
            let (off, size) = ((value - found.into()).high.abs(), value.high.abs());
            self.derivatives += 1;
            let is_right = off <= 1e-8 * size + 1e-12 * (1.0 + largest);
            if !doubt.is_finite() || doubt > 1e-9 * size + 1e-13 * (1.0 + largest) {
                self.undecided += 1;
            } else if !is_right {
                let (index, state) = place;
                let known = value.high;
                self.wrong.push(format!(
                    "body {index}, state {state}: row {row}, column {column} is {found:e}, not {known:e} (+- {doubt:e})"
                ));
            }
        }
    }

    /// One state of a body, with all answers beside what they should be.
    pub fn show(seed: u64, index: usize, ask: Ask, wanted: usize) {
        let body = draw::body(seed, index);
        println!("{}", crate::description::written::description(&body));
        let (mut given, mut answers) = (Given::default(), Answers::default());
        let mut random = states::of_run(seed, index, wanted / states::RUN);
        states::draw_params(&mut random, &body, &mut given);
        for _ in 0..=wanted % states::RUN {
            states::draw(&mut random, &body, &mut given);
        }
        let constants = Constants::now(&body, &given);
        ask(&given, &mut answers);
        println!("{given:#?}");
        for (expected, (output, load, answer)) in expected(&constants, &given, &answers)
            .iter()
            .flatten()
            .zip(&answers.list)
        {
            let value = expected.value.value.map(|x| x.high);
            let error = error(expected, answer).unwrap_or(f64::NAN);
            println!(
                "{output:32} {load:2} {error:12.3} of {:e}\n  {answer:?}\n  {value:?}",
                expected.value.size
            );
        }
    }
}

/// In units in the last place of the largest term; nothing where there is no number on either side, or the term is infinite.
fn error(expected: &Expected, answer: &[f64; 3]) -> Option<f64> {
    let largest = expected.value.size;
    let is_known = expected.value.value.iter().all(|x| x.high.is_finite());
    let is_answered = answer.iter().all(|x| x.is_finite());
    if is_known != is_answered {
        return Some(f64::INFINITY);
    }
    if !is_known || !largest.is_finite() {
        return None;
    }
    let unit = largest.next_up() - largest;
    let differences = expected
        .value
        .value
        .iter()
        .zip(answer)
        .map(|(expected, answer)| {
            let difference = *expected - (*answer).into();
            difference.high.abs() / unit
        });
    Some(differences.fold(0.0, f64::max))
}

impl fmt::Display for Survey {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(
            f,
            "| output | evaluations | largest error (ulp of the largest term) | body, state |"
        )?;
        writeln!(f, "|---|---|---|---|")?;
        for (output, record) in Output::ALL.iter().zip(&self.records) {
            if record.evaluations > 0 {
                let Record {
                    evaluations,
                    error,
                    body,
                    state,
                    load,
                } = record;
                let of = if *load > 0 {
                    format!(", load {load}")
                } else {
                    String::new()
                };
                writeln!(
                    f,
                    "| {output} | {evaluations} | {error:.1} | {body}, {state}{of} |"
                )?;
            }
        }
        let Self {
            evaluations,
            near_switches,
            undefined,
            condition,
            derivatives,
            undecided,
            wrong,
            ..
        } = self;
        for wrong in wrong {
            writeln!(f, "{wrong}")?;
        }
        writeln!(
            f,
            "{derivatives} entries of linearizations; {undecided} undecided, {} wrong",
            wrong.len()
        )?;
        writeln!(
            f,
            "\n{evaluations} evaluations; {near_switches} states near a switch; {undefined} answers without a number; condition of inertia up to {condition:.0}"
        )
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::oracle::vector::Vector;

    #[test]
    fn a_number_on_one_side_alone_is_worse_than_any() {
        let [number, none] = [1.0, f64::NAN].map(|x| {
            let given = [x, 2.0, 0.0];
            let value = Vector {
                size: 2.0,
                ..Vector::given(given)
            };
            let (output, load) = (Output::AppliedForce, 0);
            (
                Expected {
                    output,
                    load,
                    value,
                },
                given,
            )
        });
        assert_eq!(error(&number.0, &number.1), Some(0.0));
        assert_eq!(error(&number.0, &none.1), Some(f64::INFINITY));
        assert_eq!(error(&none.0, &number.1), Some(f64::INFINITY));
        assert_eq!(error(&none.0, &none.1), None);
    }
}
