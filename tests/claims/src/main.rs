//! Descriptions at random, and all that the compiler claims of them against what they mean.
//!
//! ```text
//! cargo run --release -p claims -- --descriptions 1000000 --seed 1
//! ```
//!
//! The compiler is called as a function: nothing of what it emits is compiled. What it claims, of zeros, of symmetries, of what is not read, of
//! closed forms, and its accelerations themselves, is held against the vector law in 106 bits, at states of all scales and at both
//! sides of every number in the description. A claim that a state refutes is shown with the smallest description that has it.

#[allow(dead_code, reason = "the claims need a part of it")]
#[path = "../../random_bodies/src/description/mod.rs"]
mod description;
#[allow(dead_code, reason = "the claims need a part of it")]
#[path = "../../random_bodies/src/given.rs"]
mod given;
#[allow(dead_code, unused_imports, reason = "the claims need a part of it")]
#[path = "../../random_bodies/src/oracle/mod.rs"]
mod oracle;
#[allow(dead_code, reason = "the oracle names it")]
#[path = "../../random_bodies/src/output.rs"]
mod output;
#[allow(dead_code, reason = "the claims need a part of it")]
#[path = "../../random_bodies/src/wide/mod.rs"]
mod wide;

mod answer;
mod closed;
mod compiled;
mod layout;
mod report;
mod run;
mod samples;
mod skipped;
mod smaller;
mod structure;
mod trials;
mod turns;

use std::process::ExitCode;

/// Most of an expansion is making and freeing nodes.
#[global_allocator]
static ALLOCATOR: mimalloc::MiMalloc = mimalloc::MiMalloc;

fn main() -> ExitCode {
    let words: Vec<String> = std::env::args().skip(1).collect();
    let number = |name: &str, default: usize| {
        let place = words.iter().position(|word| word == name);
        let digits = place.and_then(|place| words.get(place + 1));
        digits.map_or(default, |digits| digits.parse().expect("a whole number"))
    };
    let plan = run::Plan {
        first: number("--first", 0),
        descriptions: number("--descriptions", 10_000),
        seed: number("--seed", 1) as u64,
        shown: number("--shown", 20),
    };
    if words.first().is_some_and(|word| word == "show") {
        println!("{}", run::shown(&plan));
        return ExitCode::SUCCESS;
    }
    let report = run::run(&plan);
    println!("{report}");
    if report.failures == 0 {
        ExitCode::SUCCESS
    } else {
        ExitCode::FAILURE
    }
}

#[cfg(test)]
mod tests {
    use super::compiled::Compiled;
    use super::description::draw::sparse_body;
    use super::description::written::described;
    use super::samples::Source;
    use super::trials::{Tally, refuted};
    use super::*;

    #[test]
    fn no_claim_is_refuted() {
        let report = run::run(&run::Plan {
            first: 0,
            descriptions: 100,
            seed: 2,
            shown: 5,
        });
        assert!(report.failures == 0, "{report}");
        assert!(report.states > 1000 && report.refused < 10, "{report}");
    }

    /// Claims that are made of every body are refuted, by most.
    #[test]
    fn wrong_claims_are_refuted() {
        let (mut wrong, mut seen) = (0, 0);
        for index in 0..100 {
            let body = sparse_body(3, index);
            let text = described(&body, &[]);
            let Ok(mut compiled) = Compiled::new(&text) else {
                continue;
            };
            let structure = &mut compiled.equations.structure;
            let turns = !layout::Layout::of(&body.motion).turning.is_empty();
            if !turns || structure.is_torque_free {
                continue;
            }
            structure.is_torque_free = true;
            wrong += 1;
            let mut source = Source::new(run::random(3, index), &text);
            let failure = refuted(&body, &compiled, &mut source, &mut Tally::default());
            seen += usize::from(failure.is_some());
        }
        assert!(wrong > 20 && seen * 10 > wrong * 6, "{seen} of {wrong}");
    }
}
