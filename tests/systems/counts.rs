//! How many operations the accelerations take, at most.

use newton_euler::operations::Operations;

use super::described::*;

/// Without sines: mul + add + div of the acceleration, and its sines and cosines.
fn count(operations: &[Operations]) -> (u32, u32) {
    let row = operations
        .iter()
        .find(|row| row.function == "acceleration")
        .unwrap();
    assert_eq!((row.sqrt, row.other), (0, 0));
    (row.mul + row.add + row.div, row.trig)
}

#[test]
fn operations_stay_few() {
    let bounds = [
        (count(DoublePendulum::OPERATIONS), (32, 4)),
        (count(CartPole::OPERATIONS), (17, 2)),
        (count(Furuta::OPERATIONS), (34, 2)),
        (count(BallDouble::OPERATIONS), (224, 0)),
        (count(Satellite::OPERATIONS), (149, 0)),
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
