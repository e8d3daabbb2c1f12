//! The guard of divisions by values that depend on the configuration.

#![allow(
    clippy::float_cmp,
    clippy::cast_precision_loss,
    clippy::excessive_precision,
    reason = "what is exact is compared exactly, with all digits of the references"
)]
use newton_euler::body::Singular;
use newton_euler::private::reciprocal;

#[test]
fn guarded() {
    assert_eq!(reciprocal("pin.x", -0.25, 1.0), Ok(-4.0));
    // Far from rounding, however small.
    assert_eq!(
        reciprocal("pin.x", 2f64.powi(-600), 2f64.powi(-590)),
        Ok(2f64.powi(600))
    );
    let rounding = 0.1 + 0.2 - 0.3;
    for (value, scale) in [
        (0.0, 0.0),
        (0.0, 1.0),
        (rounding, 0.3),
        (-rounding, 0.3),
        (1.0, 1e16),
    ] {
        let unknown = "pin.x";
        assert_eq!(
            reciprocal(unknown, value, scale),
            Err(Singular {
                unknown,
                value,
                scale
            })
        );
    }
    let error = reciprocal("pin.x", f64::NAN, 1.0).unwrap_err();
    assert!(error.value.is_nan());
    let error: Box<dyn std::error::Error> = Box::new(error);
    assert!(
        error
            .to_string()
            .starts_with("singular configuration: the divisor of `pin.x` is NaN")
    );
}
