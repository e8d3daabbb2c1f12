//! Every operation of the graph, from one table: the simplifying constructors are compared with
//! plain arithmetic and the interpreter, and the derivatives with finite differences.

use mounted::symbolic::{Comparison, Function, Graph, Id, Number, Stage};

/// An operation on three symbols: its name, how the graph makes it, and what it is.
pub type Operation = (
    &'static str,
    fn(&mut Graph, [Id; 3]) -> Id,
    fn([f64; 3]) -> f64,
);

pub const OPERATIONS: [Operation; 36] = [
    ("negate", |g, [a, ..]| g.negate(a), |[a, ..]| -a),
    ("add", |g, [a, b, _]| g.add(a, b), |[a, b, _]| a + b),
    (
        "subtract",
        |g, [a, b, _]| g.subtract(a, b),
        |[a, b, _]| a - b,
    ),
    (
        "difference",
        |g, [a, b, c]| {
            let [x, y] = [g.powi(a, 2), g.powi(b, 2)];
            let [x, y] = [x, y].map(|square| g.multiply(c, square));
            g.difference(x, y)
        },
        |[a, b, c]| c * a * a - c * b * b,
    ),
    (
        "multiply",
        |g, [a, b, _]| g.multiply(a, b),
        |[a, b, _]| a * b,
    ),
    ("divide", |g, [a, b, _]| g.divide(a, b), |[a, b, _]| a / b),
    (
        "pivot",
        |g, [a, b, _]| {
            let size = g.apply(Function::Abs, &[b]);
            g.pivot(a, size)
        },
        |[a, ..]| 1.0 / a,
    ),
    (
        "sum",
        |g, [a, b, c]| g.sum(&[a, b, c]),
        |[a, b, c]| a + b + c,
    ),
    ("square", |g, [a, ..]| g.square(a), |[a, ..]| a * a),
    ("powi", |g, [a, ..]| g.powi(a, 5), |[a, ..]| a.powi(5)),
    (
        "powi negative",
        |g, [a, ..]| g.powi(a, -3),
        |[a, ..]| a.powi(-3),
    ),
    (
        "quantity",
        |g, [a, b, _]| {
            let sum = g.add(a, b);
            g.quantity(sum)
        },
        |[a, b, _]| a + b,
    ),
    (
        "select",
        |g, [a, b, c]| {
            let less = g.compare(Comparison::Less, a, b);
            g.select(less, c, a)
        },
        |[a, b, c]| if a < b { c } else { a },
    ),
    (
        "logic",
        |g, [a, b, c]| {
            let (x, y) = (
                g.compare(Comparison::Less, a, b),
                g.compare(Comparison::LessOrEqual, b, c),
            );
            let (both, either) = (g.and(x, y), g.or(x, y));
            let not = g.not(both);
            let chosen = g.and(not, either);
            g.select(chosen, a, c)
        },
        |[a, b, c]| {
            if !(a < b && b <= c) && (a < b || b <= c) {
                a
            } else {
                c
            }
        },
    ),
    (
        "sqrt",
        |g, [a, ..]| g.apply(Function::Sqrt, &[a]),
        |[a, ..]| a.sqrt(),
    ),
    (
        "cbrt",
        |g, [a, ..]| g.apply(Function::Cbrt, &[a]),
        |[a, ..]| a.cbrt(),
    ),
    (
        "exp",
        |g, [a, ..]| g.apply(Function::Exp, &[a]),
        |[a, ..]| a.exp(),
    ),
    (
        "ln",
        |g, [a, ..]| g.apply(Function::Ln, &[a]),
        |[a, ..]| a.ln(),
    ),
    (
        "sin",
        |g, [a, ..]| g.apply(Function::Sin, &[a]),
        |[a, ..]| a.sin(),
    ),
    (
        "cos",
        |g, [a, ..]| g.apply(Function::Cos, &[a]),
        |[a, ..]| a.cos(),
    ),
    (
        "tan",
        |g, [a, ..]| g.apply(Function::Tan, &[a]),
        |[a, ..]| a.tan(),
    ),
    (
        "asin",
        |g, [a, ..]| g.apply(Function::Asin, &[a]),
        |[a, ..]| a.asin(),
    ),
    (
        "acos",
        |g, [a, ..]| g.apply(Function::Acos, &[a]),
        |[a, ..]| a.acos(),
    ),
    (
        "atan",
        |g, [a, ..]| g.apply(Function::Atan, &[a]),
        |[a, ..]| a.atan(),
    ),
    (
        "sinh",
        |g, [a, ..]| g.apply(Function::Sinh, &[a]),
        |[a, ..]| a.sinh(),
    ),
    (
        "cosh",
        |g, [a, ..]| g.apply(Function::Cosh, &[a]),
        |[a, ..]| a.cosh(),
    ),
    (
        "tanh",
        |g, [a, ..]| g.apply(Function::Tanh, &[a]),
        |[a, ..]| a.tanh(),
    ),
    (
        "abs",
        |g, [a, ..]| g.apply(Function::Abs, &[a]),
        |[a, ..]| a.abs(),
    ),
    (
        "atan2",
        |g, [a, b, _]| g.apply(Function::Atan2, &[a, b]),
        |[a, b, _]| a.atan2(b),
    ),
    (
        "powf",
        |g, [a, b, _]| g.apply(Function::Powf, &[a, b]),
        |[a, b, _]| a.powf(b),
    ),
    (
        "hypot",
        |g, [a, b, _]| g.apply(Function::Hypot, &[a, b]),
        |[a, b, _]| a.hypot(b),
    ),
    (
        "min",
        |g, [a, b, _]| g.apply(Function::Min, &[a, b]),
        |[a, b, _]| a.min(b),
    ),
    (
        "max",
        |g, [a, b, _]| g.apply(Function::Max, &[a, b]),
        |[a, b, _]| a.max(b),
    ),
    (
        "signum",
        |g, [a, ..]| g.apply(Function::Signum, &[a]),
        |[a, ..]| a.signum(),
    ),
    (
        "like terms",
        |g, [a, b, c]| {
            // 3 a b - a b / 2 + c a b
            let (three, half) = (
                g.integer(3),
                g.number(mounted::symbolic::Number::ratio(1, 2)),
            );
            let ab = g.multiply(a, b);
            let (x, y, z) = (
                g.multiply(three, ab),
                g.multiply(half, ab),
                g.multiply(c, ab),
            );
            let difference = g.subtract(x, y);
            g.add(difference, z)
        },
        |[a, b, c]| 2.5 * a * b + c * a * b,
    ),
    (
        "nested signs",
        |g, [a, b, c]| {
            let (x, y) = (g.subtract(a, b), g.negate(c));
            let (product, sum) = (g.multiply(x, y), g.add(x, y));
            let quotient = g.divide(product, sum);
            let negative = g.negate(quotient);
            g.subtract(y, negative)
        },
        |[a, b, c]| -c + (a - b) * -c / (a - b - c),
    ),
];

/// Values inside the domain of every function.
pub const VALUES: [[f64; 3]; 4] = [
    [0.31, 0.74, 0.92],
    [0.83, 0.12, 0.55],
    [0.5, 0.25, 0.125],
    [0.99, 0.98, 0.07],
];

/// Symbols of the given stages.
pub fn symbols(graph: &mut Graph, stages: [Stage; 3]) -> [Id; 3] {
    stages.map(|stage| graph.symbol(stage))
}

pub fn close(a: f64, b: f64, tolerance: f64) -> bool {
    (a - b).abs() <= tolerance * (1.0 + a.abs().max(b.abs()))
}

/// The derivative by one of the values, as a difference of fourth order: to 1e-16 over the step.
pub fn slope(meaning: fn([f64; 3]) -> f64, values: [f64; 3], axis: usize) -> f64 {
    const STEP: f64 = 1e-5;
    let at = |offset: f64| {
        let mut moved = values;
        moved[axis] += offset;
        meaning(moved)
    };
    (8.0 * (at(STEP) - at(-STEP)) - (at(2.0 * STEP) - at(-2.0 * STEP))) / (12.0 * STEP)
}

#[test]
fn every_operation_means_what_it_says() {
    let stages = [
        [Stage::State; 3],
        [Stage::Parameter; 3],
        [Stage::Parameter, Stage::State, Stage::State],
        [Stage::State, Stage::Parameter, Stage::Parameter],
    ];
    for (name, build, meaning) in OPERATIONS {
        for stage in stages {
            let mut graph = Graph::default();
            let given = symbols(&mut graph, stage);
            let made = build(&mut graph, given);
            for values in VALUES {
                let value = graph.evaluate(&[made], |id| {
                    values[given
                        .iter()
                        .position(|symbol| *symbol == id)
                        .expect("a symbol")]
                })[0];
                // reassociation of a few terms
                assert!(
                    close(value, meaning(values), 8.0 * f64::EPSILON),
                    "{name} {stage:?} {values:?}: {value}"
                );
            }
        }
    }
}

#[test]
fn numbers_fold_to_the_same_value() {
    for (name, build, meaning) in OPERATIONS {
        for values in VALUES {
            let mut graph = Graph::default();
            let given = values.map(|value| {
                let number =
                    mounted::symbolic::Number::parse(&value.to_string()).expect("a number");
                graph.number(number)
            });
            let made = build(&mut graph, given);
            let number = graph
                .as_number(made)
                .unwrap_or_else(|| panic!("{name} does not fold"));
            assert!(
                close(number.to_f64(), meaning(values), 8.0 * f64::EPSILON),
                "{name} {values:?}"
            );
        }
    }
}

#[test]
fn substitution_by_numbers_is_exact_evaluation() {
    for (name, build, meaning) in OPERATIONS {
        let mut graph = Graph::default();
        let given = symbols(&mut graph, [Stage::State; 3]);
        let made = build(&mut graph, given);
        for values in VALUES {
            let numbers = values.map(|value| {
                let number =
                    mounted::symbolic::Number::parse(&value.to_string()).expect("a number");
                graph.number(number)
            });
            let value = graph.substitute(&[made], |id| {
                Some(
                    numbers[given
                        .iter()
                        .position(|symbol| *symbol == id)
                        .expect("a symbol")],
                )
            })[0];
            let number = graph
                .as_number(value)
                .unwrap_or_else(|| panic!("{name} does not fold"));
            assert!(
                close(number.to_f64(), meaning(values), 8.0 * f64::EPSILON),
                "{name} {values:?}"
            );
        }
    }
}

#[test]
fn derivatives_are_those_of_differences() {
    for (name, build, meaning) in OPERATIONS {
        let mut graph = Graph::default();
        let given = symbols(&mut graph, [Stage::State; 3]);
        let made = build(&mut graph, given);
        for (axis, by) in given.into_iter().enumerate() {
            let derivative = graph.derivative(&[made], by)[0];
            for values in VALUES {
                let symbolic = graph.evaluate(&[derivative], |id| {
                    values[given
                        .iter()
                        .position(|symbol| *symbol == id)
                        .expect("a symbol")]
                })[0];
                let difference = slope(meaning, values, axis);
                assert!(
                    close(symbolic, difference, 1e-8),
                    "{name} by {axis} at {values:?}: {symbolic} and {difference}"
                );
            }
        }
    }
}

/// Twice each operation and its square root, so that powers and sums of squares are met: one sweep backwards gives
/// what derivatives by each symbol give.
#[test]
fn gradients_are_derivatives() {
    for (name, build, _) in OPERATIONS {
        let mut graph = Graph::default();
        let given = symbols(&mut graph, [Stage::State; 3]);
        let made = build(&mut graph, given);
        let one = graph.one();
        let square = graph.square(made);
        let first = graph.square(given[0]);
        let sum = graph.add(square, first);
        let length = graph.apply(Function::Sqrt, &[sum]);
        let less = graph.subtract(length, one);
        let quotient = graph.divide(given[1], length);
        let shifted = graph.square(less);
        let whole = graph.add(shifted, quotient);
        for root in [made, whole] {
            let gradient = graph.gradient(&[(root, one)], |id| given.contains(&id));
            let derivatives = given.map(|by| graph.derivative(&[root], by)[0]);
            for (by, derivative) in given.into_iter().zip(derivatives) {
                let found = gradient.iter().find(|(symbol, _)| *symbol == by);
                let slope = found.map_or_else(|| graph.zero(), |(_, slope)| *slope);
                for values in VALUES {
                    let symbol = |id| {
                        let place = given.iter().position(|symbol| *symbol == id);
                        values[place.expect("a symbol")]
                    };
                    let both = graph.evaluate(&[slope, derivative], symbol);
                    assert!(
                        close(both[0], both[1], 1e-13),
                        "{name} at {values:?}: {} and {}",
                        both[0],
                        both[1]
                    );
                }
            }
        }
    }
}

/// A branch is differentiated where it is taken, so that what is not a number in the other one does no harm.
#[test]
fn branches_that_are_not_taken_do_no_harm() {
    let mut graph = Graph::default();
    let [x, ..] = symbols(&mut graph, [Stage::State; 3]);
    let (zero, one) = (graph.zero(), graph.one());
    let root = graph.apply(Function::Sqrt, &[x]);
    let inverse = graph.divide(one, root);
    let positive = graph.compare(Comparison::Less, zero, x);
    let guarded = graph.select(positive, inverse, x);
    let doubled = graph.add(guarded, x);
    let slope = graph.gradient(&[(doubled, one)], |id| id == x)[0].1;
    for (at, expected) in [(4.0, 1.0 - 1.0 / 16.0), (0.0, 2.0), (-1.0, 2.0)] {
        let found = graph.evaluate(&[slope], |_| at)[0];
        assert!((found - expected).abs() < 1e-15, "{found} at {at}");
    }
}

/// A number whose nearest rational is minus one times a parameter, and the negative of that.
#[test]
fn a_number_next_to_one_is_not_one() {
    let large = Number::parse("5.4e53").expect("a number");
    let root = |number: Number| Number::apply(Function::Sqrt, &[number]).expect("positive");
    let cosine = large.clone() / root(large.clone() * large + Number::one());
    assert!(!cosine.is_one() && cosine.to_integer().is_none());

    let mut graph = Graph::default();
    let [parameter, ..] = symbols(&mut graph, [Stage::Parameter; 3]);
    let [plus, minus] = [cosine.clone(), -cosine].map(|factor| graph.number(factor));
    let [plus, minus] = [plus, minus].map(|factor| graph.multiply(factor, parameter));
    assert_eq!(graph.negate(plus), minus);
    assert_eq!(graph.negate(minus), plus);
    assert_ne!(plus, parameter);
}
