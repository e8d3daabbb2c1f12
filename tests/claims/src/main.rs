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
mod run;
mod samples;
mod skipped;
mod smaller;
mod structure;
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
