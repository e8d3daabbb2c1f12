//! A few thousand executions of each kind, unoptimized as a user's compiler is, on half of its
//! stack.
#![allow(missing_docs)]

mod verdicts;

use fuzz::run::{Plan, run};

/// Half of what rustc's thread has: deep nesting is refused with room to spare.
const STACK: usize = 4 << 20;

fn plan(seed: u64, executions: u64, mutants: u64) -> Plan {
    Plan {
        first: 0,
        executions,
        seed,
        mutants,
        of_systems: false,
        stack: STACK,
        is_traced: false,
        is_shown: false,
    }
}

#[test]
fn arbitrary_streams_are_answered() {
    let report = run(plan(1, 3000, u64::MAX));
    assert!(report.failures.is_empty(), "{:?}", report.failures);
}

#[test]
fn mutated_descriptions_are_answered() {
    let report = run(plan(2, 300, 1));
    assert!(report.failures.is_empty(), "{:?}", report.failures);
    assert!(report.mutants_accepted.count() > 5 && report.mutants_rejected.count() > 100);
}

#[test]
fn mutated_systems_are_answered() {
    let report = run(Plan {
        of_systems: true,
        ..plan(3, 500, 1)
    });
    assert!(report.failures.is_empty(), "{:?}", report.failures);
    assert!(report.mutants_accepted.count() > 5 && report.mutants_rejected.count() > 100);
}

#[test]
fn the_runtime_refuses_what_cannot_be() {
    for (name, count) in fuzz::runtime::run(6000, 1) {
        assert!(count.failures.is_empty(), "{:?}", count.failures);
        // maps answer everything
        let is_map = name.contains("maps");
        assert!(
            is_map || count.accepted > 100 && count.refused > 100,
            "{name}"
        );
    }
}
