//! The test for zeros: what it proves, and what it must not prove.

use std::ops::ControlFlow;

use quote::{format_ident, quote};

use crate::expand_description;
use crate::operations::{OPERATIONS, symbols};
use mounted::symbolic::{
    Algebra, Comparison, Function, Graph, Id, Number, Residue, Stage, free, until_decided,
};

/// Whether an expression in two symbols is proved to be zero.
pub fn is_proved(build: impl Fn(&mut Graph, Id, Id) -> Id) -> bool {
    let mut graph = Graph::default();
    let [a, b] = [0; 2].map(|_| graph.symbol(Stage::State));
    let root = build(&mut graph, a, b);
    graph.vanishes(root)
}

fn binomial(g: &mut Graph, a: Id, b: Id) -> Id {
    let (sum, difference) = (g.add(a, b), g.subtract(a, b));
    let product = g.multiply(sum, difference);
    let (x, y) = (g.square(a), g.square(b));
    let squares = g.subtract(x, y);
    g.subtract(product, squares)
}

#[test]
fn rational_identities_are_proved() {
    assert!(is_proved(binomial));
    assert!(!is_proved(|g, a, b| {
        let tiny = g.number(Number::power_of_ten(-300));
        let tiny = g.multiply(tiny, a);
        let identity = binomial(g, a, b);
        g.add(identity, tiny)
    }));
    // a multiple of the prime, 2^127 - 1
    for digits in [
        "170141183460469231731687303715884105727",
        "2305843009213693951",
    ] {
        assert!(!is_proved(|g, a, _| {
            let prime = g.number(Number::parse(digits).expect("a number"));
            g.multiply(prime, a)
        }));
    }
}

/// What is as good as constant over many scales is not constant.
#[test]
fn what_saturates_does_not_vanish() {
    for function in [Function::Tanh, Function::Atan, Function::Exp] {
        for center in [-1_000_000, -10, 10, 1_000_000] {
            assert!(!is_proved(|g, t, _| {
                let (center, rate) = (g.integer(center), g.integer(1000));
                let shifted = g.subtract(t, center);
                let steep = g.multiply(rate, shifted);
                let value = g.apply(function, &[steep]);
                let one = g.one();
                if function == Function::Exp {
                    value
                } else {
                    g.add(one, value)
                }
            }));
        }
    }
}

#[test]
fn roots_have_both_signs() {
    for sign in [-1, 1] {
        // sqrt((a - b)^2) + sign (a - b)
        assert!(!is_proved(|g, a, b| {
            let (difference, sign) = (g.subtract(a, b), g.integer(sign));
            let square = g.square(difference);
            let (root, other) = (
                g.apply(Function::Sqrt, &[square]),
                g.multiply(sign, difference),
            );
            g.add(root, other)
        }));
        // the square of a root, of what is positive or negative
        assert!(is_proved(|g, a, b| {
            let sign = g.integer(sign);
            let product = g.multiply(sign, a);
            let root = g.apply(Function::Sqrt, &[product]);
            let sum = g.add(root, b);
            let (square, rest) = (g.square(sum), g.multiply(b, b));
            let twice = g.multiply(root, b);
            let parts = [product, rest, twice, twice];
            let expanded = g.sum(&parts);
            g.subtract(square, expanded)
        }));
    }
    // zero but for one of 2^count signs
    for count in [1, 3, 6, 9] {
        assert!(!is_proved(|g, a, b| {
            let factors = (0..count).map(|k| {
                let k = g.integer(k);
                let multiple = g.multiply(k, b);
                let sum = g.add(a, multiple);
                let square = g.square(sum);
                let root = g.apply(Function::Sqrt, &[square]);
                g.subtract(root, sum)
            });
            let factors: Vec<Id> = factors.collect();
            factors
                .into_iter()
                .reduce(|product, factor| g.multiply(product, factor))
                .expect("one")
        }));
    }
}

#[test]
fn every_branch_counts() {
    let zero_but_beyond = |function: Function, place: i64| {
        move |g: &mut Graph, a: Id, _: Id| {
            let (place, zero) = (g.integer(place), g.zero());
            let shifted = g.subtract(a, place);
            g.apply(function, &[shifted, zero])
        }
    };
    for place in [-1_000_000, 0, 100] {
        assert!(!is_proved(zero_but_beyond(Function::Max, place)));
        assert!(!is_proved(zero_but_beyond(Function::Min, place)));
    }
    // sign(a) |a| = a
    assert!(is_proved(|g, a, _| {
        let (size, sign) = (
            g.apply(Function::Abs, &[a]),
            g.apply(Function::Signum, &[a]),
        );
        let product = g.multiply(size, sign);
        g.subtract(product, a)
    }));
    assert!(!is_proved(|g, a, _| {
        let size = g.apply(Function::Abs, &[a]);
        g.subtract(size, a)
    }));
    assert!(!is_proved(|g, a, _| {
        let floor = g.apply(Function::Floor, &[a]);
        let product = g.multiply(floor, a);
        g.multiply(product, floor)
    }));
    // an identity of both sides is one, and one of a single side is not
    for (scale_first, scale_second, proved) in [(2, 2, true), (2, 1, false), (1, 2, false)] {
        assert_eq!(
            proved,
            is_proved(|g, a, b| {
                let condition = g.compare(Comparison::Less, a, b);
                let [first, second] = [(scale_first, a), (scale_second, b)].map(|(scale, of)| {
                    let scale = g.integer(scale);
                    g.multiply(scale, of)
                });
                let (two, scaled) = (g.integer(2), g.select(condition, first, second));
                let chosen = g.select(condition, a, b);
                let twice = g.multiply(two, chosen);
                g.subtract(twice, scaled)
            })
        );
    }
}

/// Where there are too many branches to take one by one, choices are symbols.
#[test]
fn many_branches_are_told_at_once() {
    let lengths = |g: &mut Graph, a: Id, b: Id| -> Vec<Id> {
        let lengths = (1..12).map(|k| {
            let k = g.integer(k);
            let multiple = g.multiply(k, b);
            let sum = g.add(a, multiple);
            let size = g.apply(Function::Abs, &[sum]);
            g.apply(Function::Sqrt, &[size])
        });
        lengths.collect()
    };
    assert!(is_proved(|g, a, b| {
        let lengths = lengths(g, a, b);
        let (sum, mut rest) = (g.sum(&lengths), lengths);
        rest.reverse();
        let two = g.integer(2);
        let doubled: Vec<Id> = rest.iter().map(|length| g.multiply(two, *length)).collect();
        let (twice, doubled) = (g.multiply(two, sum), g.sum(&doubled));
        let (squared, product) = (g.square(twice), g.multiply(twice, doubled));
        g.subtract(squared, product)
    }));
    assert!(!is_proved(|g, a, b| {
        let lengths = lengths(g, a, b);
        g.sum(&lengths)
    }));
}

/// A division by what is zero on some branch has no value there.
#[test]
fn what_has_no_value_is_not_zero() {
    assert!(!is_proved(|g, a, b| {
        let size = g.apply(Function::Abs, &[a]);
        let difference = g.subtract(size, a);
        let quotient = g.divide(b, difference);
        let zero = binomial(g, a, b);
        g.multiply(zero, quotient)
    }));
}

/// A product of `count` factors is one where as many conditions hold, and zero elsewhere. `whole` minus
/// this product vanishes there if it is one, and never if it is two; of seven conditions, not all
/// branches are tried.
#[test]
fn branches_that_are_not_tried_may_vanish() {
    for (whole, count, may_vanish) in [(1, 1, true), (2, 1, false), (1, 7, true)] {
        let mut graph = Graph::default();
        let (zero, one, whole) = (graph.zero(), graph.one(), graph.integer(whole));
        let product = (0..count).fold(one, |product, _| {
            let x = graph.symbol(Stage::State);
            let is_less = graph.compare(Comparison::Less, x, zero);
            let factor = graph.select(is_less, one, zero);
            graph.multiply(product, factor)
        });
        let root = graph.subtract(whole, product);
        let of = |id| free(id, 0);
        let samples = graph.samples(&[root], of);
        assert_eq!(graph.may_vanish(root, of), may_vanish, "{count} conditions");
        assert_eq!(
            samples[0].is_nonzero_where_tried(),
            !may_vanish || count > 6
        );
    }
}

/// Up to six choices are tried one by one; of more, the first branch and the one with symbols.
#[test]
fn branches_are_tried_until_decided() {
    for (roots, most, tried) in [(1, 9, 2), (6, 99, 64), (7, 99, 2), (6, 5, 5)] {
        let mut graph = Graph::default();
        let squares: Vec<Id> = (0..roots)
            .map(|_| {
                let x = graph.symbol(Stage::State);
                graph.apply(Function::Sqrt, &[x])
            })
            .collect();
        let tape = graph.tape(&squares);
        let mut count = 0;
        until_decided(|residues| {
            tape.values(residues, |_, id| Some(free(id, 0)));
            count += 1;
            if count == most {
                ControlFlow::Break(())
            } else {
                ControlFlow::Continue(())
            }
        });
        assert_eq!(count, tried, "{roots} roots");
    }
}

/// Values change along with their operands as derivatives say.
#[test]
fn residues_change_as_derivatives_do() {
    for (name, build, _) in OPERATIONS {
        let mut graph = Graph::default();
        let given = symbols(&mut graph, [Stage::State; 3]);
        let made = build(&mut graph, given);
        for by in given {
            let derivative = graph.derivative(&[made], by)[0];
            let tape = graph.tape(&[made, derivative]);
            until_decided(|residues| {
                let values = tape.values(residues, |_, id| Some(free(id, 1)));
                let one = residues.one();
                let changes = tape.changes(residues, &values, |id| (id == by).then_some(one));
                let change = tape.of(&changes, made).unwrap_or(Some(Residue::ZERO));
                assert!(change.is_some(), "{name}");
                assert_eq!(change, *tape.of(&values, derivative), "{name}");
                ControlFlow::Continue(())
            });
        }
    }
}

#[test]
fn short_fractions_are_told_by_their_residue() {
    let residue = |number: Number| {
        let mut value = None;
        until_decided(|residues| {
            value = residues.number(&number);
            ControlFlow::Break(())
        });
        value.expect("a value")
    };
    for (above, below) in [
        (0, 1),
        (1, 1),
        (-1, 1),
        (2, 3),
        (-22, 7),
        (9999, 10000),
        (-32767, 32765),
        (123_456_789, 1_000_000_007),
    ] {
        let number = Number::ratio(above, below);
        assert_eq!(residue(number.clone()).to_number(), Some(number));
    }
    let long = Number::ratio(123_456_789_123_456_789, 1_000_000_007);
    assert_eq!(residue(long).to_number(), None);
}

/// Symbols that are as far from each other as those before and after them: the numbers they are given must not be.
#[test]
fn inputs_that_balance_at_equal_distances_do_not_vanish() {
    let names: Vec<_> = ('a'..='m')
        .map(|letter| format_ident!("{letter}"))
        .collect();
    for window in names.windows(5) {
        let (first, middle, last) = (&window[0], &window[2], &window[4]);
        let description = quote!(Craft {
            motion: spatial,
            inputs: [#(#names),*],
            mass: 1,
            inertia: principal(1, 1, 1),
            moments: [torque = body(0, 0, #first - 2 * #middle + #last)],
        });
        let text = expand_description(description).to_string();
        assert!(text.contains("is_force_free : true"));
        assert!(!text.contains("is_torque_free : true"), "{middle}");
    }
}

/// A residue has a root of one sign or the other: what vanishes for numbers of one sign alone does not vanish, and is not symmetric.
#[test]
fn roots_have_the_sign_of_doubles() {
    for sign in ["+", "-"] {
        let sum: proc_macro2::TokenStream = format!("(a * a).sqrt() {sign} a").parse().unwrap();
        for symbols in 0..4 {
            let others = (0..symbols).map(|k| format_ident!("other_{k}"));
            let expansion = expand_description(quote!(Pushed {
                motion: translation,
                inputs: [#(#others[N],)* a[N]],
                mass: 1[kg],
                forces: [push = world(0, 0, #sum)],
            }));
            let text = expansion.to_string();
            assert!(!text.contains("is_force_free : true"), "{sum}");
        }
    }
    for axis in ["x", "y", "z"] {
        let size = [format_ident!("x"), format_ident!("y"), format_ident!("z")]
            .map(|name| (name == axis, quote!(position.in_world().#name)))
            .map(|(is_bent, part)| {
                if is_bent {
                    quote!((#part * #part).sqrt())
                } else {
                    part
                }
            });
        let [x, y, z] = size;
        let expansion = expand_description(quote!(Held {
            motion: translation,
            mass: 1[kg],
            forces: [hold = -1[N / m] * world(#x, #y, #z)],
        }));
        let text = expansion.to_string();
        assert!(!text.contains("Symmetry :: Every"), "{axis}: {text}");
    }
    // a multiple of the prime
    let expansion = expand_description(quote!(Pushed {
        motion: translation,
        mass: 1[kg],
        forces: [push = world(0, 2305843009213693951[N], 0)],
    }));
    assert!(!expansion.to_string().contains("is_force_free : true"));
}

/// `floor(a)` is one on a step, so `floor(a) - 1` vanishes there, and so may all that depends on steps;
/// what only seems to depend on them does not.
#[test]
fn what_depends_on_a_step_may_vanish() {
    let mut graph = Graph::default();
    let [a, b] = [Stage::State; 2].map(|stage| graph.symbol(stage));
    let (one, step) = (graph.one(), graph.apply(Function::Floor, &[a]));
    let before = graph.subtract(step, one);
    let [product, other] = [graph.multiply(b, before), graph.multiply(b, step)];
    let difference = graph.subtract(other, product);
    for (root, may_vanish) in [
        (step, true),
        (product, true),
        (difference, false),
        (b, false),
    ] {
        assert_eq!(graph.may_vanish(root, |id| free(id, 0)), may_vanish);
    }
}
