//! The most operations that accelerations and reactions may take.

use newton_euler::operations::Operations;

use super::described::*;

/// Without sines: mul + add + div of the acceleration, and its sines and cosines.
fn count(operations: &[Operations]) -> (u32, u32) {
    counted(operations, "acceleration")
}

pub fn counted(operations: &[Operations], function: &str) -> (u32, u32) {
    let mut rows = operations.iter();
    let row = rows.find(|row| row.function == function).unwrap();
    assert_eq!((row.sqrt, row.other), (0, 0));
    (row.mul + row.add + row.div, row.trig)
}

#[test]
fn operations_stay_few() {
    let bounds = [
        (count(DoublePendulum::OPERATIONS), (30, 4)),
        (count(CartPole::OPERATIONS), (16, 2)),
        (count(Furuta::OPERATIONS), (30, 2)),
        (count(BallDouble::OPERATIONS), (200, 0)),
        (count(Satellite::OPERATIONS), (124, 0)),
        (count(Ur5::OPERATIONS), (394, 10)),
    ];
    let found = bounds.map(|(found, _)| found);
    assert!(
        bounds
            .iter()
            .all(|(found, bound)| found.0 <= bound.0 && found.1 <= bound.1),
        "{found:?}"
    );
}

/// With the accelerations that they follow from, in world axes: in those of the links they take 30
/// operations more than the accelerations of the double pendulum, and 298 more than those of the arm.
#[test]
fn reactions_stay_few() {
    let bounds = [
        (counted(DoublePendulum::OPERATIONS, "reactions"), (72, 4)),
        (counted(Ur5::OPERATIONS, "reactions"), (885, 16)),
    ];
    for (found, bound) in bounds {
        assert!(found.0 <= bound.0 && found.1 <= bound.1, "{found:?}");
    }
}
