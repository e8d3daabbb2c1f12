//! Exact numbers: literals, the single rounding, functions to 256 bits.

use mounted::symbolic::{Function, Number};

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

fn apply(function: Function, arguments: &[&Number]) -> Number {
    let arguments: Vec<Number> = arguments.iter().copied().cloned().collect();
    Number::apply(function, &arguments).expect("a value")
}

/// However small a number is, it is zero only if an identity says so.
#[test]
fn small_is_not_zero() {
    let one = Number::one();
    for exponent in [20, 70, 100, 300] {
        let (tiny, huge) = (
            Number::power_of_ten(-exponent),
            Number::power_of_ten(exponent),
        );
        let angle = tiny.clone() * Number::pi();
        let near = |number: Number, expected: f64| {
            let value = (number.clone() * huge.clone()).to_f64();
            assert!(
                !number.is_zero() && (value / expected - 1.0).abs() < 1e-15,
                "{exponent}: {value} and {expected}"
            );
        };
        let beside_one = one.clone() + tiny.clone();
        near(apply(Function::Sin, &[&angle]), std::f64::consts::PI);
        near(apply(Function::Tan, &[&angle]), std::f64::consts::PI);
        near(apply(Function::Sinh, &[&tiny]), 1.0);
        near(apply(Function::Tanh, &[&tiny]), 1.0);
        near(apply(Function::Asin, &[&tiny]), 1.0);
        near(apply(Function::Ln, &[&beside_one]), 1.0);
        near(apply(Function::Exp, &[&tiny]) - one.clone(), 1.0);
        near(apply(Function::Sqrt, &[&beside_one]) - one.clone(), 0.5);
        near(
            apply(Function::Cbrt, &[&beside_one]) - one.clone(),
            1.0 / 3.0,
        );
        let two = parse("2");
        let root = apply(Function::Sqrt, &[&two]);
        let beside = apply(Function::Sqrt, &[&(two.clone() + tiny.clone())]);
        near(beside.clone() - root.clone(), 0.5 / 2.0_f64.sqrt());
        assert!(root < beside && root != beside && one < beside_one);
        // a whole turn more, and a little
        let turned = apply(
            Function::Sin,
            &[&(angle.clone() + Number::pi() * two.clone())],
        );
        near(turned, std::f64::consts::PI);
        let cosine = apply(Function::Cos, &[&(angle + Number::pi() / two)]);
        near(cosine, -std::f64::consts::PI);
        let floor = apply(Function::Floor, &[&(-(root * tiny))]);
        assert_eq!(floor.to_integer(), Some(-1));
    }
}

/// Identities in which a number is exactly another one.
#[test]
fn identities_are_seen() {
    let ratio = |numerator, denominator| Number::ratio(numerator, denominator);
    let of_pi = |numerator, denominator| Number::pi() * ratio(numerator, denominator);
    for (numerator, denominator) in [(0, 1), (1, 2), (1, 1), (3, 2), (-7, 1), (1_000, 1), (41, 2)] {
        let angle = of_pi(numerator, denominator);
        let sine = apply(Function::Sin, &[&angle]).to_integer();
        let cosine = apply(Function::Cos, &[&angle]).to_integer();
        let quarters = numerator * 2 / i64::try_from(denominator).expect("small");
        let expected = [(0, 1), (1, 0), (0, -1), (-1, 0)]
            [usize::try_from(quarters.rem_euclid(4)).expect("below 4")];
        assert_eq!(
            (sine, cosine),
            (Some(expected.0), Some(expected.1)),
            "{numerator}"
        );
    }
    let third = of_pi(1, 3);
    assert_eq!(apply(Function::Cos, &[&third]), ratio(1, 2));
    assert_eq!(
        apply(Function::Tan, &[&third]),
        apply(Function::Sqrt, &[&parse("3")])
    );
    assert_eq!(Number::apply(Function::Tan, &[of_pi(-3, 2)]), None);
    assert_eq!(apply(Function::Tan, &[&of_pi(1, 4)]), Number::one());
    assert_eq!(apply(Function::Acos, &[&-ratio(1, 2)]), of_pi(2, 3));
    assert_eq!(
        apply(
            Function::Atan2,
            &[&Number::integer(-1), &Number::integer(-1)]
        ),
        of_pi(-3, 4)
    );
    for digits in ["0.3", "17", "1e-30", "12345.6789"] {
        for angle in [parse(digits), of_pi(1, 180) * parse(digits)] {
            let (sine, cosine) = (
                apply(Function::Sin, &[&angle]),
                apply(Function::Cos, &[&angle]),
            );
            let square = sine.clone() * sine.clone() + cosine.clone() * cosine.clone();
            assert_eq!(square, Number::one(), "{digits}");
            assert_eq!(sine.clone() / cosine, apply(Function::Tan, &[&angle]));
            assert_eq!(
                apply(Function::Sin, &[&(Number::pi() - angle)])
                    .to_f64()
                    .to_bits(),
                sine.to_f64().to_bits()
            );
        }
        let x = parse(digits);
        if x < Number::integer(100) {
            let (sinh, cosh) = (apply(Function::Sinh, &[&x]), apply(Function::Cosh, &[&x]));
            assert_eq!(cosh.clone() * cosh - sinh.clone() * sinh, Number::one());
            let back = apply(Function::Ln, &[&apply(Function::Exp, &[&x])]);
            assert_eq!(back, x);
        }
        let root = apply(Function::Sqrt, &[&(x.clone() * parse("2"))]);
        assert_eq!(root.clone() * root, x.clone() * parse("2"));
    }
    let root = |of: &str| apply(Function::Sqrt, &[&parse(of)]);
    assert_eq!(root("2") * root("3"), root("6"));
    assert_eq!(root("0.5") + root("0.5"), root("2"));
    let nested = apply(Function::Sqrt, &[&(root("2") + Number::one())]);
    assert_eq!(nested.clone() * nested, root("2") + Number::one());
    // a residue with the sign of another root would prove expressions zero that are not
    let nested = apply(Function::Sqrt, &[&(parse("6") - parse("2") * root("5"))]);
    assert_ne!(nested.residue(), (Number::one() - root("5")).residue());
    let product = apply(Function::Sqrt, &[&parse("4298113591")]);
    assert_ne!(
        product.residue(),
        (-(root("65557") * root("65563"))).residue()
    );
    // equal, and nobody knows: kept, as near to zero as it is, on no side of it
    let unknown = apply(Function::Sqrt, &[&(parse("3") + parse("2") * root("2"))])
        - (Number::one() + root("2"));
    assert!(unknown.is_undecided() && !unknown.is_zero() && unknown.to_f64().abs() < 1e-60);
    assert_eq!(Number::one().checked_div(&unknown), None);
    // the residue of the prime itself is zero, and the number is not
    let prime = parse("2305843009213693951") * root("2");
    assert!(!prime.is_zero() && prime.is_positive());
    assert!(!(prime * Number::power_of_ten(-90) + root("3")).is_zero());
}

/// As `f64` has it, whatever the arguments.
#[test]
fn functions_at_the_ends_of_their_domains() {
    let two = |function, x: &str, y: &str| {
        let of = |digits: &str| match digits.strip_prefix('-') {
            Some(digits) => -parse(digits),
            None => parse(digits),
        };
        Number::apply(function, &[of(x), of(y)]).map(|number| number.to_f64())
    };
    for (x, y) in [
        ("-2", "3"),
        ("-2", "-3"),
        ("-2", "2"),
        ("-0.5", "1001"),
        ("-2.5", "0"),
        ("0", "0"),
        ("0", "2.5"),
        ("-1", "1e17"),
        ("-1", "3e5"),
        ("1", "1e300"),
        ("4", "0.5"),
        ("2", "-1.5"),
        ("-1.0009765625", "12345"),
    ] {
        let expected = x
            .parse::<f64>()
            .expect("a double")
            .powf(y.parse().expect("a double"));
        let value = two(Function::Powf, x, y).unwrap_or_else(|| panic!("{x}^{y}"));
        assert!(
            (value - expected).abs() <= 2.0 * f64::EPSILON * expected.abs(),
            "{x}^{y}: {value} and {expected}"
        );
    }
    for (x, y) in [
        ("-2", "0.5"),
        ("-8", "0.3333333333333333"),
        ("0", "-1"),
        ("0", "-0.5"),
    ] {
        assert_eq!(two(Function::Powf, x, y), None, "{x}^{y}");
    }
    for x in ["-3", "-0", "0", "2"] {
        for y in ["-3", "0", "5"] {
            let expected = x.replace("-0", "0").parse::<f64>().expect("a double");
            let expected = expected.atan2(y.parse().expect("a double"));
            assert_eq!(two(Function::Atan2, x, y), Some(expected), "{x} {y}");
        }
    }
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

/// What took more operations than are done again is as near as it is: functions of it have values.
#[test]
fn functions_of_long_terms_have_values() {
    let sum = |n: u64| {
        (1..n).fold(Number::zero(), |sum, k| {
            let root = Number::apply(Function::Sqrt, &[parse("0.37") + Number::ratio(1, k)]);
            sum + root.expect("a root") / Number::integer(3)
        })
    };
    for n in [3, 30, 100] {
        let long = sum(n);
        for function in [
            Function::Sqrt,
            Function::Cbrt,
            Function::Ln,
            Function::Sin,
            Function::Cos,
            Function::Atan,
            Function::Abs,
        ] {
            let value = Number::apply(function, std::slice::from_ref(&long));
            let value = value.unwrap_or_else(|| panic!("{function:?} of {n}"));
            let near = Number::apply(function, &[Number::from_f64(long.to_f64())]);
            let (value, near) = (value.to_f64(), near.expect("a value").to_f64());
            assert!(
                (value - near).abs() <= 1e-12 * near.abs().max(1.0),
                "{function:?} of {n}: {value}, {near}"
            );
        }
    }
}

/// What nobody can tell from zero is computed with thousands of bits once, not in each number that is
/// made of it.
#[test]
fn undecided_numbers_are_cheap() {
    let start = std::time::Instant::now();
    let apply = |function: Function, x: Number| Number::apply(function, &[x]).expect("a value");
    let x = parse("0.61728");
    let unknown = apply(Function::Asin, apply(Function::Sin, x.clone())) - x;
    for k in 1..200 {
        let part = unknown.clone() * Number::ratio(k, 7) + unknown.clone() / Number::pi();
        assert!(part.is_undecided() && !part.is_zero());
        let sum = part + Number::one();
        assert!(!sum.is_undecided() && sum.to_f64().to_bits() == 1_f64.to_bits());
    }
    // the first takes some milliseconds; all the others took as long
    assert!(start.elapsed().as_secs() < 5, "{:?}", start.elapsed());
}

fn of(function: Function, arguments: &[Number]) -> Number {
    Number::apply(function, arguments).expect("in the domain")
}

/// The value of a function of one argument.
fn at(function: Function, argument: &Number) -> Number {
    of(function, std::slice::from_ref(argument))
}

/// Sines and cosines of multiples and sums of angles by their tangents, sines or cosines are exact.
#[test]
fn angles_by_their_tangents_have_algebraic_sines() {
    let integer = Number::integer;
    for [w, v] in [
        ["0.8", "0.6"],
        ["0.6", "0.8"],
        ["0.7", "0.1"],
        ["-0.8", "0.6"],
        ["1", "-3"],
    ] {
        let [w, v] = [w, v].map(parse);
        let size = w.clone() * w.clone() + v.clone() * v.clone();
        let half = of(Function::Atan2, &[v.clone(), w.clone()]);
        for turn in [
            integer(2) * half.clone(),
            integer(2) * half.clone() + integer(2) * Number::pi(),
            half.clone() + half.clone(),
            (half.clone() * integer(6)) / integer(3),
        ] {
            let cosine = (w.clone() * w.clone() - v.clone() * v.clone()) / size.clone();
            let sine = integer(2) * w.clone() * v.clone() / size.clone();
            assert_eq!(at(Function::Cos, &turn), cosine);
            assert_eq!(of(Function::Sin, &[turn]), sine);
        }
        // of the angle itself: with a root
        let root = of(Function::Sqrt, &[size]);
        let (cosine, sine) = (at(Function::Cos, &half), at(Function::Sin, &half));
        assert_eq!(cosine * root.clone(), w);
        assert_eq!(sine * root, v);
        // with a quarter of a turn
        let on = half.clone() + Number::pi() / integer(2);
        assert_eq!(of(Function::Sin, &[on]), of(Function::Cos, &[half]));
    }
    for c in ["0.8", "-0.3", "0.123", "0.96"] {
        let c = parse(c);
        let turn = at(Function::Acos, &c);
        assert_eq!(at(Function::Cos, &turn), c);
        let twice = of(Function::Cos, &[integer(2) * turn.clone()]);
        assert_eq!(twice, integer(2) * c.clone() * c.clone() - integer(1));
        let third = of(Function::Cos, &[integer(3) * turn.clone()]);
        assert_eq!(
            third,
            integer(4) * c.clone() * c.clone() * c.clone() - integer(3) * c.clone()
        );
        let turn = at(Function::Asin, &c);
        assert_eq!(at(Function::Sin, &turn), c);
        assert_eq!(of(Function::Sin, &[-turn]), -c);
    }
    // sums of different angles
    let [a, b] = ["0.5", "0.25"].map(|tangent| of(Function::Atan, &[parse(tangent)]));
    let sum = of(Function::Tan, &[integer(2) * (a.clone() + b.clone())]);
    let tangent = parse("0.75") / parse("0.875");
    let expected = integer(2) * tangent.clone() / (integer(1) - tangent.clone() * tangent);
    assert_eq!(sum, expected);
    // angles whose halves are right angles: 2 atan(3/4) + 2 atan(4/3) is half a turn
    let tangents = [integer(3) / integer(4), integer(4) / integer(3)];
    let [a, b] = tangents.map(|tangent| at(Function::Atan, &tangent));
    let half_turn = integer(2) * (a + b);
    assert_eq!(at(Function::Cos, &half_turn), integer(-1));
    assert_eq!(at(Function::Sin, &half_turn), Number::zero());
    let half = of(Function::Atan, &[integer(1)]);
    assert_eq!(of(Function::Cos, &[integer(4) * half]), integer(-1));
    let three_quarters = of(Function::Atan2, &[integer(4), integer(3)]) * integer(2) + Number::pi();
    assert_eq!(of(Function::Cos, &[three_quarters]), parse("0.28"));
}

#[test]
fn a_root_of_a_rational_number_that_is_made_of_roots_is_the_root_of_that_number() {
    let root = |of: &str| at(Function::Sqrt, &parse(of));
    // 0.2154^2 1.059624 + 0.0426^2 = 0.3^2 0.555524 1.019624
    let second = parse("0.2154") * root("1.059624");
    let squares = second.clone() * second + parse("0.0426") * parse("0.0426");
    let product = parse("0.3") * root("0.555524") * root("1.019624");
    assert_eq!(of(Function::Sqrt, std::slice::from_ref(&squares)), product);
    // prime factors of more than 16 bits, several or equal ones
    for (of, roots) in [
        ("130840949609", ["77201", "1694809", "1"]),
        ("4295229473066606101", ["65537", "65539", "1000000007"]),
        ("12000000097000000133", ["3000000019", "4000000007", "1"]),
    ] {
        let [a, b, c] = roots.map(root);
        assert_eq!(root(of), a * b * c);
    }
    let twice = parse("65537") * root("1000000007");
    assert_eq!(root("4295098399065688583"), twice);
    // what is only near it has another root
    let near = squares + parse("1e-60") * root("2");
    let difference = of(Function::Sqrt, &[near]) - product;
    assert!(difference.is_positive() && !difference.is_undecided());
}
