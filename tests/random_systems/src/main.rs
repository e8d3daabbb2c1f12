//! Systems of bodies at random: what the compiler derives of them, against the law of each body in
//! 106 bits.
//!
//! ```text
//! cargo run --release -p random-systems -- --systems 20000 --seed 1
//! ```
//!
//! The compiler is called as a function, and its expressions are evaluated in 106 bits: what differs
//! from the law by more than 1e-20 is wrong, and no rounding. It is shown with the smallest
//! description that fails alike. Beside it stand the largest errors of doubles.

#[allow(dead_code, reason = "the oracle needs a part of it")]
#[path = "../../random_bodies/src/wide/mod.rs"]
mod wide;

mod check;
mod compiled;
mod drawn;
mod joints;
mod loads;
mod number;
mod oracle;
mod run;
mod space;
mod written;

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
        systems: number("--systems", 1000),
        seed: number("--seed", 1) as u64,
        extent: drawn::Extent {
            bodies: number("--bodies", 6),
            ..drawn::Extent::ALL
        },
        shown: number("--shown", 5),
    };
    if words.first().is_some_and(|word| word == "show") {
        println!("{}", drawn::drawn(plan.seed, plan.first, plan.extent).text);
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
    use super::check::{State, check};
    use super::compiled::Compiled;
    use super::drawn::{Extent, drawn};
    use super::*;

    /// An expansion without optimisation takes ten times as long.
    const SYSTEMS: usize = if cfg!(debug_assertions) { 25 } else { 300 };

    #[test]
    fn systems_move_by_the_law() {
        let report = run::run(&run::Plan {
            first: 0,
            systems: SYSTEMS,
            seed: 2,
            extent: Extent::ALL,
            shown: 3,
        });
        assert!(report.failures == 0, "{report}");
        assert!(report.states > SYSTEMS * 3 / 2, "{report}");
        assert!(report.refused * 10 <= SYSTEMS, "{report}");
        // doubles lose what the masses make them lose
        assert!(report.worst[0].0 < 1e-11, "{report}");
    }

    /// An acceleration that is off by less than doubles can tell.
    #[test]
    fn a_wrong_acceleration_is_seen() {
        let mut rng = fastrand::Rng::with_seed(5);
        let (mut wrong, mut seen) = (0, 0);
        for index in 0..12 {
            let drawn = drawn(2, index, Extent::ALL);
            let Ok(mut compiled) = Compiled::new(&drawn) else {
                continue;
            };
            let mut joints = compiled.accelerations.iter();
            let Some(joint) = joints.position(|joint| !joint.is_empty()) else {
                continue;
            };
            let graph = &mut compiled.work.graph;
            let right = compiled.accelerations[joint][0];
            let little = graph.number(fuzz::symbolic::Number::power_of_ten(-17));
            compiled.accelerations[joint][0] = graph.add(right, little);
            let state = State::new(&drawn, &mut rng);
            wrong += 1;
            seen += usize::from(
                check(&drawn, &compiled, &state, &mut rng).is_some_and(|one| one.is_err()),
            );
        }
        assert!(wrong > 8 && seen * 3 > wrong * 2, "{seen} of {wrong}");
    }
}
