//! `cargo run --release -p fuzz -- expander --executions 10000000 --seed 1`, and the same for
//! `runtime`.

use std::process::ExitCode;

use fuzz::run::{Plan, run, shown};

/// Most of an expansion is making and freeing tokens, here as in rustc, which has an allocator of its own.
#[global_allocator]
static ALLOCATOR: mimalloc::MiMalloc = mimalloc::MiMalloc;

/// That of the thread in which rustc expands macros \[bytes\].
const STACK: usize = 8 << 20;

fn main() -> ExitCode {
    let words: Vec<String> = std::env::args().skip(1).collect();
    let number = |name: &str, default: u64| {
        let place = words.iter().position(|word| word == name);
        let digits = place.and_then(|place| words.get(place + 1));
        digits.map_or(default, |digits| digits.parse().expect("a whole number"))
    };
    let plan = Plan {
        first: number("--first", 0),
        executions: number("--executions", 100_000),
        seed: number("--seed", 1),
        mutants: number("--mutants", 32),
        of_systems: words.iter().any(|word| word == "--systems"),
        stack: STACK,
        is_traced: words.iter().any(|word| word == "--trace"),
        is_shown: true,
    };
    match words.first().map(String::as_str) {
        Some("expander") => {
            let report = run(plan);
            println!("{report}");
            if report.failures.is_empty() {
                ExitCode::SUCCESS
            } else {
                ExitCode::FAILURE
            }
        }
        Some("runtime") => {
            let mut is_sound = true;
            for (name, count) in fuzz::runtime::run(plan.executions, plan.seed) {
                println!(
                    "{name}: {} accepted, {} refused, {} failures",
                    count.accepted,
                    count.refused,
                    count.failures.len()
                );
                for failure in count.failures.iter().take(5) {
                    is_sound = false;
                    println!("  {failure}");
                }
            }
            if is_sound {
                ExitCode::SUCCESS
            } else {
                ExitCode::FAILURE
            }
        }
        Some("show") => {
            println!("{}", shown(&plan));
            ExitCode::SUCCESS
        }
        _ => {
            eprintln!(
                "fuzz expander|runtime|show [--executions N] [--seed N] [--first N] [--mutants N] [--systems] [--trace]"
            );
            ExitCode::FAILURE
        }
    }
}
