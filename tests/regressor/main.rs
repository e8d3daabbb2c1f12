//! `outputs: [regressor]`, compared with Newton's and Euler's laws by hand and with inverse
//! dynamics; and least squares on a log.
#![allow(missing_docs, reason = "tests")]
#![allow(clippy::float_cmp, reason = "what is exact is compared exactly")]

mod arms;
mod bodies;
mod both_levels;
#[path = "../coordinates/mod.rs"]
mod coordinates;
mod falls;
mod generic;
#[path = "../../examples/identification.rs"]
mod identification;
mod identified;
mod systems;

#[test]
fn mass_properties_come_back_from_a_log() {
    identification::main();
}

/// Whether two columns agree, in units of the larger one of 1 and what is expected.
fn close(found: &[f64], expected: &[f64], tolerance: f64) {
    assert_eq!(found.len(), expected.len());
    let size = expected
        .iter()
        .fold(1.0_f64, |size, one| size.max(one.abs()));
    for (found, expected) in found.iter().zip(expected) {
        let error = (found - expected).abs();
        assert!(
            error <= tolerance * size,
            "{found} is not {expected}: {error:e}"
        );
    }
}
