//! Sines and cosines of fractions of a turn: identities between them and with roots are proved, and
//! nothing else.

use mounted::symbolic::{Function, Number};

fn at(function: Function, argument: &Number) -> Number {
    Number::apply(function, core::slice::from_ref(argument)).expect("a value")
}

/// Sines and cosines of sums of degrees are proved to be sums of products, also where they have
/// roots; others are not mistaken for each other.
#[test]
fn sums_of_fractions_of_a_turn_are_exact() {
    let degrees = |count: i64| Number::pi() * Number::ratio(count, 180);
    let (sine, cosine) = (
        |count: i64| at(Function::Sin, &degrees(count)),
        |count: i64| at(Function::Cos, &degrees(count)),
    );
    for (a, b) in [(10, 20), (5, 45), (7, 8), (71, 85), (50, -20), (100, 156)] {
        let sum = sine(a) * cosine(b) + cosine(a) * sine(b);
        assert_eq!(sum, sine(a + b), "{a}, {b}");
        let other = cosine(a) * cosine(b) - sine(a) * sine(b);
        assert_eq!(other, cosine(a + b), "{a}, {b}");
        assert_ne!(sum.residue(), cosine(a + b).residue(), "{a}, {b}");
        assert_ne!((-sum).residue(), sine(a + b).residue(), "{a}, {b}");
    }
    let twice = |number: Number| number.clone() + number;
    let cubed = cosine(20) * cosine(20) * cosine(20);
    let expected = Number::integer(6) * cosine(20) + Number::one();
    assert_eq!(Number::integer(8) * cubed, expected);
    let root_of_five = at(Function::Sqrt, &Number::integer(5));
    assert_eq!(
        Number::integer(4) * cosine(36),
        Number::one() + root_of_five
    );
    let seventh = |count: i64| at(Function::Cos, &(Number::pi() * Number::ratio(2 * count, 7)));
    let product = Number::integer(8) * seventh(1) * seventh(2) * seventh(3);
    assert_eq!(product, Number::one());
    for count in (5..90).step_by(5) {
        for other in (5..count).step_by(5) {
            assert_ne!(
                sine(count).residue(),
                sine(other).residue(),
                "{count}, {other}"
            );
            assert_ne!(
                sine(count).residue(),
                (-cosine(other)).residue(),
                "{count}, {other}"
            );
        }
        assert_eq!(twice(sine(count) * cosine(count)), sine(2 * count));
    }
}

/// The products of sines of fractions of half a turn are roots, which have the same signs as these.
#[test]
fn roots_agree_with_fractions_of_a_turn() {
    for parts in [
        3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 20, 21, 22, 26, 35, 39, 65, 77, 91,
    ] {
        let mut product = Number::one();
        for count in 1..(parts + 1) / 2 {
            let sine = at(
                Function::Sin,
                &(Number::pi() * Number::ratio(count, parts.unsigned_abs())),
            );
            product = product * Number::integer(2) * sine;
        }
        let square = if parts % 2 == 0 { parts / 2 } else { parts };
        let root = at(Function::Sqrt, &Number::integer(square));
        assert_eq!(product, root, "{parts}");
        assert_ne!(product.residue(), (-root).residue(), "{parts}");
    }
}
