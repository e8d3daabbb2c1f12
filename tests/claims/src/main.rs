//! Random descriptions, and all claims of the compiler about them, compared with their meaning.
//!
//! ```text
//! cargo run --release -p claims -- --descriptions 1000000 --seed 1
//! ```
//!
//! The compiler is called as a function, and its output is not compiled. Its claims (zeros,
//! symmetries, unread quantities, closed forms) and its accelerations are compared with the vector
//! law in 106 bits, at states of all scales and on both sides of every number in the description. A
//! refuted claim is shown with the smallest description that makes it.

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
    use super::description::body::{Body, Param};
    use super::description::draw::sparse_body;
    use super::description::expression::{Scalar, Unary};
    use super::description::literal::Literal;
    use super::description::written::described;
    use super::oracle::Constants;
    use super::oracle::arithmetic::Values;
    use super::oracle::differences::settled;
    use super::oracle::number::Number;
    use super::oracle::scene::Scene;
    use super::samples::Source;
    use super::trials::{Tally, refuted};
    use super::wide::Wide;
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
        let (wrong, seen) = planted(0..100, |body, compiled| {
            let turns = !layout::Layout::of(&body.motion).turning.is_empty();
            let is_claimed = &mut compiled.structure.is_torque_free;
            turns && !std::mem::replace(is_claimed, true)
        });
        assert!(wrong > 20 && seen * 10 > wrong * 6, "{seen} of {wrong}");
    }

    #[test]
    fn wrong_accelerations_under_constraints_are_refuted() {
        let (wrong, seen) = planted(0..200, |body, compiled| {
            let graph = &mut compiled.work.graph;
            let (x, one) = (compiled.equations.accelerations.linear[0], graph.one());
            compiled.equations.accelerations.linear[0] = graph.add(x, one);
            !body.constraints.is_empty()
        });
        assert!(wrong > 10 && seen * 10 > wrong * 8, "{seen} of {wrong}");
    }

    /// A pivot may vanish in some states, and not in all of them.
    #[test]
    fn pivots_that_vanish_everywhere_are_refuted() {
        let (wrong, seen) = planted(0..200, |body, compiled| {
            let graph = &mut compiled.work.graph;
            // beside which all that is divided by is rounding
            let (x, huge) = (
                compiled.equations.accelerations.linear[0],
                graph.integer(i64::MAX),
            );
            let scale = graph.multiply(huge, huge);
            let scale = graph.multiply(scale, scale);
            compiled.equations.accelerations.linear[0] = graph.pivot(x, scale);
            !body.constraints.is_empty()
        });
        assert!(wrong > 10 && seen * 10 > wrong * 6, "{seen} of {wrong}");
    }

    /// How many bodies something wrong is said of, and of how many a state refutes it.
    fn planted(
        indices: std::ops::Range<usize>,
        wrong: impl Fn(&Body, &mut Compiled) -> bool,
    ) -> (usize, usize) {
        let (mut count, mut seen) = (0, 0);
        for index in indices {
            let body = sparse_body(3, index);
            let text = described(&body, &[]);
            let Ok(mut compiled) = Compiled::new(&text) else {
                continue;
            };
            if !wrong(&body, &mut compiled) {
                continue;
            }
            let mut source = Source::new(run::random(3, index), &text);
            let mut tally = Tally::default();
            let failure = refuted(&body, &compiled, &mut source, &mut tally);
            // a claim that no state is held against is not tried
            count += usize::from(tally.states > 0);
            seen += usize::from(failure.is_some());
        }
        (count, seen)
    }

    /// Poles of `atan(1/x)`, what cancels in 106 bits or in doubles, numbers without squares, jumps
    /// within the lengths of differences, and a pivot that vanishes in some states.
    #[test]
    fn what_the_oracle_does_not_know_refutes_nothing() {
        const SEVEN: [usize; 10] = [
            4502, 17459, 18425, 19922, 25991, 26117, 28288, 31894, 32989, 34329,
        ];
        const ONE: [usize; 9] = [
            95_318, 177_541, 208_584, 209_219, 249_427, 323_434, 337_488, 486_532, 779_367,
        ];
        let numbers = SEVEN.map(|first| (7, first));
        for (seed, first) in numbers.into_iter().chain(ONE.map(|first| (1, first))) {
            assert_none(seed, first);
        }
    }

    /// Coefficients that vanish by identities that nobody knows, where other pivots do not.
    #[test]
    fn what_a_parameter_may_make_vanish_is_no_pivot() {
        for first in [337_954, 438_820, 549_587] {
            assert_none(1, first);
        }
    }

    /// That no state refutes a claim of this description, and not by leaving all states out.
    fn assert_none(seed: u64, first: usize) {
        let report = run::run(&run::Plan {
            first,
            descriptions: 1,
            seed,
            shown: 1,
        });
        assert!(
            report.failures == 0 && report.states >= 5,
            "{first}: {report}"
        );
    }

    /// A corner that is nearer than the lengths of differences is no derivative of its own.
    #[test]
    fn differences_end_before_corners() {
        // the mean of both slopes is zero, or nearly the slope
        for (slope, other) in [(1.0, -1.0), (1.0, 0.999)] {
            let value = |length: f64| {
                let along = if length > -1e-4 { slope } else { other };
                Number::exactly(Wide::from(length) * along + Wide::ONE)
            };
            let (found, error) = settled(0.3, value, 1);
            let apart = (found.high - slope).abs();
            assert!(apart <= error + 1e-12, "{found:?} to {error:e}");
        }
        // of a square at its least there is one, and it is zero
        let square = |x: f64| Number::exactly(Wide::from(x) * x + Wide::ONE);
        let (found, error) = settled(0.3, square, 1);
        assert!(
            found.high.abs() <= error && error < 1e-12,
            "{found:?}, {error:e}"
        );
    }

    #[test]
    fn a_pole_is_near_by_the_terms_that_cancel() {
        for (x, is_near) in [(0.0, true), (1e-12, true), (1e-6, false), (-3.0, false)] {
            let mut body = sparse_body(3, 0);
            body.params = vec![Param::Scalar(Literal::new(0, 0))];
            body.constraints.clear();
            body.loads.clear();
            let constants = Constants::new(&body, &[1.0 + x]);
            let given = given::Given {
                params: vec![1.0 + x],
                state: vec![1.0; layout::Layout::of(&body.motion).len()],
                ..given::Given::default()
            };
            let scene = Scene::new(&constants, &given);
            let difference = Scalar::Param(0) - Scalar::literal(1, 0);
            let divisor = Scalar::Unary(Unary::Recip, Box::new(difference));
            scene.scalar(&Scalar::Unary(Unary::Atan, Box::new(divisor)));
            assert_eq!(scene.is_near_switch(), is_near, "at {x}");
        }
    }

    /// Of exact numbers that cancel, a part in 1e-29 is rounding, and one in 1e-20 is not.
    #[test]
    fn known_numbers_cancel_to_106_bits() {
        let third = Number::ONE / Number::known(3.0.into());
        let rest = third + third + third - Number::ONE;
        assert!(rest.value.high.abs() <= structure::EXACT * rest.span());
        let rest = third - (third + Number::known(1e-20.into()));
        assert!(rest.value.high.abs() > structure::EXACT * rest.span());
        // and so it remains, whatever is added to it
        let rest = third + third + third - Number::ONE + Number::ZERO;
        assert!(rest.span() > 1e-10);
    }
}
