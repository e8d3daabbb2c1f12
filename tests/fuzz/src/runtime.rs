//! The runtime with arbitrary numbers and texts: impossible values are rejected, and accepted
//! values are read back bit for bit.

mod bodies;
mod exact;
mod inertia;
mod numbers;
mod states;
mod written;

use std::cell::Cell;
use std::panic::{AssertUnwindSafe, catch_unwind};

use fastrand::Rng;

/// How many values were accepted and refused.
#[derive(Default)]
pub struct Count {
    pub accepted: u64,
    pub refused: u64,
    pub failures: Vec<String>,
}

thread_local! {
    static ACCEPTED: Cell<u64> = const { Cell::new(0) };
    static REFUSED: Cell<u64> = const { Cell::new(0) };
}

/// What is known of a value by exact arithmetic.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
enum Verdict {
    Possible,
    Impossible,
    /// Within the tolerance of the check, or where results leave the range of doubles.
    Marginal,
}

/// Compares what the runtime did with what it should have done.
fn compare<T: core::fmt::Debug, E: core::fmt::Display>(
    what: &dyn core::fmt::Debug,
    verdict: Verdict,
    result: &Result<T, E>,
) {
    match result {
        Ok(value) => {
            ACCEPTED.set(ACCEPTED.get() + 1);
            assert!(
                verdict != Verdict::Impossible,
                "accepted {value:?} from {what:?}"
            );
        }
        Err(error) => {
            REFUSED.set(REFUSED.get() + 1);
            assert!(verdict != Verdict::Possible, "refused, {error}: {what:?}");
            assert!(
                !error.to_string().is_empty(),
                "an error without words: {what:?}"
            );
        }
    }
}

/// One execution.
type Execute = fn(&mut Rng);

/// Runs so many executions, each of one kind.
#[must_use]
pub fn run(executions: u64, seed: u64) -> [(&'static str, Count); 4] {
    let kinds: [(&str, Execute); 4] = [
        ("tensors", inertia::tensors),
        ("attitudes and maps", states::maps),
        ("states, read", states::read),
        ("bodies", bodies::build),
    ];
    kinds.map(|(name, execute)| {
        let mut count = Count::default();
        ACCEPTED.set(0);
        REFUSED.set(0);
        for number in 0..executions / 4 {
            let mut rng = Rng::with_seed(seed.rotate_left(32) ^ number);
            let outcome = catch_unwind(AssertUnwindSafe(|| execute(&mut rng)));
            if let Err(panic) = outcome {
                let text = panic.downcast_ref::<String>().cloned().unwrap_or_default();
                count
                    .failures
                    .push(format!("{name}, execution {number}: {text}"));
            }
        }
        (count.accepted, count.refused) = (ACCEPTED.get(), REFUSED.get());
        (name, count)
    })
}
