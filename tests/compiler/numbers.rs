//! Exact numbers: literals, the one rounding, functions to 256 bits.

use crate::symbolic::{Function, Number};

fn parse(digits: &str) -> Number {
    Number::parse(digits).expect("a number")
}

#[test]
fn a_literal_rounds_as_rust_rounds_it() {
    for digits in [
        "0.1",
        "1.2",
        "9.80665",
        "1e-5",
        "1_000.5e3",
        "5e-324",
        "1.7976931348623157e308",
        "2.2250738585072011e-308",
        "0.30000000000000004",
    ] {
        let rust: f64 = digits.replace('_', "").parse().expect("a float");
        assert_eq!(parse(digits).to_f64().to_bits(), rust.to_bits(), "{digits}");
    }
    assert_eq!(parse("0x1F").to_integer(), Some(31));
    assert_eq!(parse("0b101").to_integer(), Some(5));
}

#[test]
fn arithmetic_is_exact() {
    assert_eq!(parse("0.1") + parse("0.2"), parse("0.3"));
    assert_eq!(parse("1e17") + parse("1") - parse("1e17"), Number::one());
    assert_eq!(Number::one() / parse("3") * parse("3"), Number::one());
}

#[test]
fn what_no_double_can_hold_is_seen() {
    assert!(!parse("1e400").fits_f64());
    assert!(!parse("1e-400").fits_f64());
    assert!(parse("1e308").fits_f64());
    assert_eq!(Number::parse("1e999999999999"), None);
}

#[test]
fn functions_round_once() {
    let x = 0.7_f64;
    let exact = parse("0.7");
    let near = |function: Function, expected: f64| {
        let value = Number::apply(function, std::slice::from_ref(&exact))
            .expect("in the domain")
            .to_f64();
        // std is right to an ulp
        assert!(
            (value - expected).abs() <= 2.0 * f64::EPSILON * expected.abs(),
            "{function:?}: {value} and {expected}"
        );
    };
    near(Function::Sin, x.sin());
    near(Function::Cos, x.cos());
    near(Function::Tan, x.tan());
    near(Function::Asin, x.asin());
    near(Function::Acos, x.acos());
    near(Function::Atan, x.atan());
    near(Function::Sinh, x.sinh());
    near(Function::Cosh, x.cosh());
    near(Function::Tanh, x.tanh());
    near(Function::Exp, x.exp());
    near(Function::Ln, x.ln());
    near(Function::Sqrt, x.sqrt());
    near(Function::Cbrt, x.cbrt());
    assert_eq!(
        Number::pi().to_f64().to_bits(),
        std::f64::consts::PI.to_bits()
    );
}

#[test]
fn roots_of_squares_are_exact() {
    assert_eq!(
        Number::apply(Function::Sqrt, &[parse("0.09")]),
        Some(parse("0.3"))
    );
    assert_eq!(
        Number::apply(Function::Cbrt, &[parse("-0.027")]),
        Some(parse("-0.3"))
    );
    assert_eq!(
        Number::apply(Function::Hypot, &[parse("0.3"), parse("0.4")]),
        Some(parse("0.5"))
    );
}

#[test]
fn a_zero_behind_a_rounding_is_zero() {
    let right_angle = Number::pi() / Number::integer(2);
    assert!(
        Number::apply(Function::Cos, std::slice::from_ref(&right_angle))
            .is_some_and(|value| value.is_zero())
    );
    assert!(Number::apply(Function::Sin, &[Number::pi()]).is_some_and(|value| value.is_zero()));
    let root = Number::apply(Function::Sqrt, &[parse("2")]).expect("a root");
    assert!((root.clone() * root - parse("2")).is_zero());
}

#[test]
fn outside_the_domain_there_is_nothing() {
    assert_eq!(Number::apply(Function::Sqrt, &[parse("-1")]), None);
    assert_eq!(Number::apply(Function::Ln, &[Number::zero()]), None);
    assert_eq!(Number::apply(Function::Asin, &[parse("1.5")]), None);
    assert_eq!(Number::apply(Function::Exp, &[parse("1e6")]), None);
    assert_eq!(
        Number::apply(Function::Powf, &[parse("-2"), parse("0.5")]),
        None
    );
    assert_eq!(Number::one().checked_div(&Number::zero()), None);
}

#[test]
fn exactness_is_given_up_where_it_grows_out_of_proportion() {
    let mut number = parse("1.0000001");
    for _ in 0..16 {
        number = number.clone() * number;
    }
    assert!(number.is_carried());
    // 1.0000001^65536, by logarithms in doubles
    let expected = (65536.0 * 1e-7_f64.ln_1p()).exp();
    assert!((number.to_f64() / expected - 1.0).abs() < 1e-14);
}
