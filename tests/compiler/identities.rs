//! What the test for zeros knows of functions: identities for all arguments, and no others.

use crate::zeros::is_proved;
use mounted::symbolic::{Function, Graph, Id, Number};

#[test]
fn functions_are_what_they_are_of_equal_arguments() {
    let squares = |functions: [Function; 2], sign: i64| {
        move |g: &mut Graph, a: Id, b: Id| {
            let angle = g.multiply(a, b);
            let [x, y] = functions.map(|function| {
                let part = g.apply(function, &[angle]);
                g.square(part)
            });
            let sign = g.integer(sign);
            let signed = g.multiply(sign, y);
            let (sum, one) = (g.add(x, signed), g.one());
            g.subtract(sum, one)
        }
    };
    assert!(is_proved(squares([Function::Sin, Function::Cos], 1)));
    assert!(is_proved(squares([Function::Cosh, Function::Sinh], -1)));
    assert!(!is_proved(squares([Function::Sin, Function::Sinh], 1)));
    // what they do not know, and do not claim
    assert!(!is_proved(|g, a, _| {
        let logarithm = g.apply(Function::Ln, &[a]);
        let power = g.apply(Function::Exp, &[logarithm]);
        g.subtract(power, a)
    }));
}

/// `c a + d b + e`
fn combined(g: &mut Graph, [a, b]: [Id; 2], [c, d]: [&str; 2], e: &Number) -> Id {
    let terms = [(a, c), (b, d)].map(|(symbol, factor)| {
        let factor = g.number(Number::parse(factor).expect("a number"));
        g.multiply(factor, symbol)
    });
    let constant = g.number(e.clone());
    let sum = g.sum(&terms);
    g.add(sum, constant)
}

fn right_angle() -> Number {
    Number::apply(Function::Acos, &[Number::zero()]).expect("a right angle")
}

#[test]
fn functions_of_sums_are_products() {
    let constants = [
        Number::zero(),
        Number::ratio(3, 10),
        right_angle(),
        Number::integer(-2),
    ];
    let factors = ["1", "-1", "2", "0.5", "-1.5", "3", "2.5"];
    let lists = |c: &'static str| factors.map(|d| [c, d]);
    for (factors, constant) in factors
        .into_iter()
        .flat_map(lists)
        .zip(constants.iter().cycle())
    {
        for is_off in [false, true] {
            // cos(x + y) = cos x cos y - sin x sin y, and with another y
            let circle = |g: &mut Graph, a: Id, b: Id| {
                let x = combined(g, [a, b], ["1", "-1"], &Number::zero());
                let y = combined(g, [a, b], factors, constant);
                let sum = g.add(x, y);
                let off = combined(g, [y, b], ["1", "0"], &Number::power_of_ten(-300));
                let y = if is_off { off } else { y };
                let [whole, first, second] = [sum, x, y].map(|angle| {
                    [Function::Cos, Function::Sin].map(|function| g.apply(function, &[angle]))
                });
                let [cosines, sines] = [0, 1].map(|index| g.multiply(first[index], second[index]));
                let product = g.subtract(cosines, sines);
                g.subtract(whole[0], product)
            };
            // tanh, by the exponential of twice its argument: (e - 1) / (e + 1)
            let exponential = |g: &mut Graph, a: Id, b: Id| {
                let x = combined(g, [a, b], factors, constant);
                let tangent = g.apply(Function::Tanh, &[x]);
                let twice = if is_off {
                    g.sum(&[x, x, x])
                } else {
                    g.add(x, x)
                };
                let (power, one) = (g.apply(Function::Exp, &[twice]), g.one());
                let (above, below) = (g.subtract(power, one), g.add(power, one));
                let ratio = g.divide(above, below);
                g.subtract(tangent, ratio)
            };
            assert_eq!(is_proved(circle), !is_off, "{factors:?}");
            // powers of e with constant exponents are independent
            let is_known = !is_off && constant.is_zero();
            assert_eq!(is_proved(exponential), is_known, "{factors:?}");
        }
    }
}

#[test]
fn halves_and_phases() {
    // half angles, and angles that differ by a right angle
    assert!(is_proved(|g, a, b| {
        let half = combined(g, [a, b], ["0.5", "0"], &Number::zero());
        let sine = g.apply(Function::Sin, &[half]);
        let square = g.square(sine);
        let turned = combined(g, [a, b], ["1", "0"], &right_angle());
        let (cosine, one) = (g.apply(Function::Sin, &[turned]), g.one());
        let terms = [square, square, cosine];
        let sum = g.sum(&terms);
        g.subtract(sum, one)
    }));
    // a phase, with its sine and cosine
    for phase in ["0.5", "1.5", "-3"] {
        assert!(is_proved(|g, a, _| {
            let phase = g.number(Number::parse(phase).expect("a number"));
            let sum = g.add(a, phase);
            let whole = g.apply(Function::Sin, &[sum]);
            let [x, y] = [a, phase].map(|angle| {
                [Function::Sin, Function::Cos].map(|function| g.apply(function, &[angle]))
            });
            let [one, other] = [g.multiply(x[0], y[1]), g.multiply(x[1], y[0])];
            let expanded = g.add(one, other);
            g.subtract(whole, expanded)
        }));
    }
}

#[test]
fn large_multiples_are_independent() {
    for factor in ["1000", "1e9", "1e-30"] {
        assert!(!is_proved(|g, a, b| {
            let angle = combined(g, [a, b], [factor, "0"], &Number::zero());
            let [x, y] = [angle, a].map(|angle| g.apply(Function::Sin, &[angle]));
            g.subtract(x, y)
        }));
    }
}
