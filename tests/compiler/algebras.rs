//! What expressions are computed in: exact numbers are what is meant, doubles are certain of nothing that is wrong, and
//! residues know an identity from what is none.

use quote::{format_ident, quote};

use crate::expand_description;
use crate::operations::{OPERATIONS, VALUES, close, slope, symbols};
use crate::symbolic::{
    Algebra, Comparison, Doubles, Exact, Function, Graph, Id, Number, Residues, Stage,
};

fn parse(value: f64) -> Number {
    Number::parse(&value.to_string()).expect("a number")
}

#[test]
fn exact_numbers_change_as_differences_do() {
    for (name, build, meaning) in OPERATIONS {
        let mut graph = Graph::default();
        let given = symbols(&mut graph, [Stage::State; 3]);
        let made = build(&mut graph, given);
        let tape = graph.tape(&[made]);
        for values in VALUES {
            let place = |id: Id| given.iter().position(|symbol| *symbol == id);
            let all = tape.values(&mut Exact, |_, id| Some(parse(values[place(id)?])));
            let value = tape.of(&all, made).as_ref().expect("a value").to_f64();
            assert!(close(value, meaning(values), 8.0 * f64::EPSILON), "{name}");
            for (axis, by) in given.into_iter().enumerate() {
                let rate = |id: Id| (id == by).then(|| Some(Number::one()));
                let changes = tape.changes(&mut Exact, &all, rate);
                let change = tape.of(&changes, made).clone();
                let change = change.map_or(0.0, |change| change.expect("a slope").to_f64());
                let difference = slope(meaning, values, axis);
                assert!(
                    close(change, difference, 1e-8),
                    "{name} by {axis} at {values:?}: {change} and {difference}"
                );
            }
        }
    }
}

/// Less its own value, an operation may be zero; less another one, it is not.
#[test]
fn doubles_are_certain_of_what_is_so() {
    let mut certain = 0;
    for (name, build, _) in OPERATIONS {
        for values in VALUES {
            let mut graph = Graph::default();
            let given = symbols(&mut graph, [Stage::State; 3]);
            let made = build(&mut graph, given);
            let place = |id: Id| given.iter().position(|symbol| *symbol == id);
            let tape = graph.tape(&[made]);
            let exact = tape.values(&mut Exact, |_, id| Some(parse(values[place(id)?])));
            let value = tape.of(&exact, made).clone().expect("a value");
            let other = value.clone() + Number::ratio(1, 1_000_000);
            let [itself, other] = [value, other].map(|value| {
                let value = graph.number(value);
                graph.subtract(made, value)
            });
            let tape = graph.tape(&[itself, other]);
            let near = tape.values(&mut Doubles, |doubles, id| match place(id) {
                Some(index) => doubles.number(&parse(values[index])),
                None => doubles.undefined(),
            });
            assert!(!Doubles.is_not_zero(tape.of(&near, itself)), "{name}");
            certain += usize::from(Doubles.is_not_zero(tape.of(&near, other)));
        }
    }
    // but for conditions, which doubles do not decide
    assert!(certain + 12 > OPERATIONS.len() * VALUES.len(), "{certain}");
}

#[test]
fn what_is_lost_below_the_least_double_is_not_certain() {
    let mut doubles = Doubles;
    let [small, large] =
        [-200, 300].map(|exponent| doubles.number(&Number::power_of_ten(exponent)));
    let lost = doubles.multiply(&small, &small);
    let found = doubles.multiply(&lost, &large);
    let same = doubles.number(&Number::power_of_ten(-100));
    let difference = doubles.subtract(&found, &same);
    assert!(!doubles.is_not_zero(&difference));
    assert!(doubles.is_not_zero(&same));
}

/// Of expressions in two symbols, whether each is zero, and whether residues are sure of that.
fn residues(build: impl Fn(&mut Graph, Id, Id) -> Id) -> (bool, bool) {
    let mut graph = Graph::default();
    let [a, b] = [0; 2].map(|_| graph.symbol(Stage::State));
    let root = build(&mut graph, a, b);
    let tape = graph.tape(&[root]);
    let mut residues = Residues::default();
    let all = tape.values(&mut residues, |residues, id| {
        residues.number(&Number::integer(if id == a {
            123_456_789_123
        } else {
            987_654_321
        }))
    });
    let value = tape.of(&all, root);
    assert!(
        residues.is_zero(value) != residues.is_not_zero(value),
        "a value"
    );
    (residues.is_zero(value), residues.is_final())
}

#[test]
fn residues_know_identities() {
    let binomial = |g: &mut Graph, a: Id, b: Id| {
        let (sum, difference) = (g.add(a, b), g.subtract(a, b));
        let product = g.multiply(sum, difference);
        let (x, y) = (g.square(a), g.square(b));
        let squares = g.subtract(x, y);
        g.subtract(product, squares)
    };
    assert_eq!(residues(binomial), (true, true));
    let beside = |g: &mut Graph, a: Id, b: Id| {
        let tiny = g.number(Number::power_of_ten(-300));
        let tiny = g.multiply(tiny, a);
        let identity = binomial(g, a, b);
        g.add(identity, tiny)
    };
    assert_eq!(residues(beside), (false, true));
    // roots of either sign, and of roots
    for inner in [-1, 1] {
        let root = |g: &mut Graph, a: Id, b: Id| {
            let inner = g.integer(inner);
            let product = g.multiply(inner, a);
            let first = g.apply(Function::Sqrt, &[product]);
            let sum = g.add(first, b);
            let second = g.apply(Function::Sqrt, &[sum]);
            let square = g.square(second);
            let rest = g.subtract(square, b);
            let fourth = g.square(rest);
            g.subtract(fourth, product)
        };
        assert_eq!(residues(root), (true, false));
    }
    let circle = |g: &mut Graph, a: Id, _| {
        let parts = [Function::Sin, Function::Cos].map(|function| g.apply(function, &[a]));
        let [x, y] = parts.map(|part| g.square(part));
        let (sum, one) = (g.add(x, y), g.one());
        g.subtract(sum, one)
    };
    assert_eq!(residues(circle), (true, false));
    // what they do not know
    let inverse = |g: &mut Graph, a: Id, _| {
        let logarithm = g.apply(Function::Ln, &[a]);
        let power = g.apply(Function::Exp, &[logarithm]);
        g.subtract(power, a)
    };
    assert_eq!(residues(inverse), (false, false));
}

#[test]
fn conditions_are_no_matter_of_residues_or_doubles() {
    let mut graph = Graph::default();
    let [a, b] = [0; 2].map(|_| graph.symbol(Stage::State));
    let less = graph.compare(Comparison::Less, a, b);
    let chosen = graph.select(less, a, b);
    let tape = graph.tape(&[chosen]);
    let mut residues = Residues::default();
    let all = tape.values(&mut residues, |residues, _| residues.one());
    assert!(tape.of(&all, chosen).is_none());
    let near = tape.values(&mut Doubles, |doubles, _| doubles.one());
    assert!(!Doubles.is_not_zero(tape.of(&near, chosen)));
}

#[test]
fn short_fractions_are_told_by_their_residue() {
    let mut residues = Residues::default();
    for (above, below) in [
        (0, 1),
        (1, 1),
        (-1, 1),
        (2, 3),
        (-22, 7),
        (9999, 10000),
        (-32767, 32765),
    ] {
        let number = Number::ratio(above, below);
        let residue = residues.number(&number).expect("a value");
        assert_eq!(residue.to_number(), Some(number));
    }
    let long = residues.number(&Number::ratio(123_456_789, 1_000_000_007));
    assert_eq!(long.expect("a value").to_number(), None);
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
