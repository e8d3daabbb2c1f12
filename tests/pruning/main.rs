//! Every pruning rule that concerns one body: the operations before and after, what the documentation says, and that the
//! accelerations are those of the unpruned law, at 1000 random states, to 64 units in the last place of its largest term.
//!
//! Rules that pay inside an integrator are claims of the structure of a body: `tests/structure/`.
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

/// As many operations for any number of charges, and of constant loads.
#[test]
fn numbers_of_loads() {
    let total = |operations: &[Operations]| {
        let found = operations.iter().find(|row| row.function == "acceleration");
        found.expect("every body has one").total()
    };
    assert_eq!(
        total(bodies::Charged::OPERATIONS),
        total(bodies::ChargedTwice::OPERATIONS)
    );
    assert_eq!(
        total(bodies::FourJets::OPERATIONS),
        total(bodies::OneJet::OPERATIONS)
    );
}
