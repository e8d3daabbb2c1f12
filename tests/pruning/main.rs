//! Every pruning rule for a single body: the operations before and after, its line in the
//! documentation, and the agreement of the accelerations with the unpruned law, at 1000 random
//! states, to 64 units in the last place of the largest term.
//!
//! Rules that help integrators are claims about the structure of a body: see `tests/structure/`.
#![allow(missing_docs)]

mod bodies;
#[path = "../coordinates/mod.rs"]
mod coordinates;
mod inertia;
mod loads;
mod reference;
mod scope;
mod table;
mod top;

use newton_euler::operations::Operations;
use reference::Support;

/// Turning alone: the motion of G is not asked.
const AT_G: Support = Support::Point([0.0; 3]);

/// Of multiplications, additions and divisions.
fn total(operations: &[Operations], function: &str) -> u32 {
    let found = operations.iter().find(|row| row.function == function);
    found.expect("every function has a row").total()
}

/// As many operations for any number of charges, and of constant loads.
#[test]
fn numbers_of_loads() {
    let [many, two] = [
        bodies::Charged::OPERATIONS,
        bodies::ChargedTwice::OPERATIONS,
    ];
    assert_eq!(total(many, "acceleration"), total(two, "acceleration"));
    let [four, one] = [bodies::FourJets::OPERATIONS, bodies::OneJet::OPERATIONS];
    assert_eq!(total(four, "acceleration"), total(one, "acceleration"));
}

/// What locals name is the same as what is written again.
#[test]
fn differences_of_named_values() {
    assert_eq!(total(bodies::Named::OPERATIONS, "acceleration"), 0);
}

/// The reactions of a pendulum, with the acceleration that they need.
#[test]
fn reactions_of_a_pendulum() {
    let [all, alone] =
        ["reactions", "acceleration"].map(|name| total(bodies::Hanging::OPERATIONS, name));
    assert!(all <= alone + 12, "{all}, {alone}");
}
