//! Random bodies, compared with the vector law in extended precision.
//!
//! `build/` draws bodies and writes them for the compiler. Here, they are drawn again, for the
//! oracle, and all outputs of each are evaluated in random states. `cargo test -p random-bodies`
//! runs a few. In full:
//!
//! ```text
//! BODIES=1000 cargo run --release -p random-bodies -- 100000
//! ```
//!
//! `-- motions 1000` integrates `MOVING` other bodies from as many states each, in closed form,
//! with series and with DOP853.
//!
//! The argument is the number of states of each body, or their range, as in `50000..100000`. With
//! two arguments, a body and a state, the outputs of that body in that state are shown.

use survey::{Ask, Survey};

#[allow(dead_code, reason = "`tests/claims` draws more")]
mod description;
mod given;
mod motions;
#[allow(dead_code, reason = "`tests/claims` asks for more")]
mod oracle;
mod output;
mod states;
mod survey;
mod wide;

/// What `build/` wrote.
#[allow(
    warnings,
    clippy::all,
    clippy::pedantic,
    reason = "descriptions at random have names that nothing reads, and parentheses to spare"
)]
mod bodies {
    use newton_euler::prelude::*;

    use crate::given::{Given, motion, state};
    use crate::motions::{Ends, March};
    use crate::output::Answers;
    use newton_euler::integrate::{ClosedForm, DormandPrince, TaylorSeries, Tolerant};

    include!(concat!(env!("OUT_DIR"), "/bodies.rs"));
}

/// Runs of states before what was found is shown.
const ROUND: usize = 150;

fn main() {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let number = |text: &str| text.parse::<usize>().expect("a whole number");
    match arguments.as_slice() {
        [] => survey(0, 1000),
        [word, states @ ..] if word == "motions" => {
            let states = states.first().map_or(100, |text| number(text));
            println!("{}", moved(states));
        }
        [states] => match states.split_once("..") {
            Some((from, to)) => survey(number(from), number(to)),
            None => survey(0, number(states)),
        },
        [body, state, ..] => {
            let body = number(body);
            Survey::show(bodies::SEED, body, find(body), number(state));
        }
    }
}

/// Asks all bodies in these states, whole runs of them.
fn survey(from: usize, to: usize) {
    let runs = from / states::RUN..to.div_ceil(states::RUN);
    let mut survey = Survey::default();
    for from in runs.clone().step_by(ROUND) {
        let round = from..runs.end.min(from + ROUND);
        for (index, ask) in bodies::ALL {
            survey.ask(bodies::SEED, *index, *ask, round.clone());
        }
        let [from, to] = [runs.start, round.end].map(|run| run * states::RUN);
        println!(
            "{} bodies, states {from}..{to} of each\n\n{survey}",
            bodies::ALL.len()
        );
    }
}

/// Moves the bodies from so many states.
fn moved(states: usize) -> motions::Motions {
    let mut motions = motions::Motions::default();
    for (index, march) in bodies::MOVING {
        motions.ask(bodies::SEED, *index, *march, states);
    }
    motions
}

fn find(body: usize) -> Ask {
    let found = bodies::ALL.iter().find(|(index, _)| *index == body);
    found
        .expect("one of the bodies that were built: see FIRST and BODIES")
        .1
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Units in the last place of the largest term; what the full size finds is in `docs/trust.md`.
    const BOUND: f64 = 64.0;

    #[test]
    fn within_units_of_the_largest_term() {
        let mut survey = Survey::default();
        for (index, ask) in bodies::ALL {
            survey.ask(bodies::SEED, *index, *ask, 0..4);
        }
        println!("{survey}");
        // few states are left out, and fewer answers
        assert!(survey.near_switches < survey.evaluations / 8);
        assert!(survey.undefined < survey.evaluations / 1000);
        assert!(survey.wrong.is_empty() && survey.undecided < survey.derivatives / 10);
        for (output, record) in output::Output::ALL.iter().zip(&survey.records) {
            assert!(record.error <= BOUND, "{output}: {record:?}");
        }
    }

    /// Every method comes to the end that DOP853 comes to.
    #[test]
    fn all_methods_agree() {
        let motions = moved(6);
        println!("{motions}");
        assert!(motions.failures.is_empty() && motions.undecided < motions.count / 10);
        // series have no value where an exponential is infinite
        assert!(motions.unfinished.len() < motions.count / 10);
    }

    /// The survey finds what is wrong by more than that.
    #[test]
    fn an_answer_that_is_off_is_seen() {
        let (index, ask) = bodies::ALL[0];
        let off = |given: &given::Given, answers: &mut output::Answers| {
            ask(given, answers);
            answers.list[0].2[0] += 1e-12 * (1.0 + answers.list[0].2[0].abs());
        };
        let mut survey = Survey::default();
        survey.ask(bodies::SEED, index, off, 0..1);
        assert!(survey.records.iter().any(|record| record.error > 64.0));
    }
}
