//! What the constructors of nodes guarantee: simplification, stages, schedule and cost.

use mounted::symbolic::{Comparison, Function, Graph, Id, Node, Number, Stage};

#[test]
fn equal_expressions_are_one_node() {
    let mut g = Graph::default();
    let (a, b) = (g.symbol(Stage::State), g.symbol(Stage::State));
    assert_eq!(g.add(a, b), g.add(b, a));
    assert_eq!(g.multiply(a, b), g.multiply(b, a));
    let (x, y) = (g.subtract(a, b), g.subtract(b, a));
    assert_eq!(g.negate(x), y);
}

#[test]
fn zeros_and_ones_vanish() {
    let mut g = Graph::default();
    let (a, zero, one) = (g.symbol(Stage::State), g.zero(), g.one());
    assert_eq!(g.add(a, zero), a);
    assert_eq!(g.multiply(a, one), a);
    assert_eq!(g.multiply(a, zero), zero);
    assert_eq!(g.subtract(a, a), zero);
    assert_eq!(g.divide(a, a), one);
    assert_eq!(g.divide(zero, a), zero);
    let undefined = g.divide(a, zero);
    assert!(g.is_undefined(undefined));
    let spread = g.add(undefined, a);
    assert!(g.is_undefined(spread));
}

#[test]
fn like_terms_are_collected() {
    let mut g = Graph::default();
    let (a, k) = (g.symbol(Stage::State), g.symbol(Stage::Parameter));
    let (two, three) = (g.integer(2), g.integer(3));
    let (x, y) = (g.multiply(two, a), g.multiply(three, a));
    let five = g.integer(5);
    assert_eq!(g.add(x, y), g.multiply(five, a));
    let ka = g.multiply(k, a);
    assert_eq!(g.subtract(ka, ka), g.zero());
    let sum = g.add(ka, x);
    // (k + 2) a, with k + 2 computed in the constructor
    assert_eq!(g.late_cost(&[sum]).total(), 1);
}

#[test]
fn a_common_factor_is_taken_out() {
    let mut g = Graph::default();
    let (a, b, k) = (
        g.symbol(Stage::State),
        g.symbol(Stage::State),
        g.symbol(Stage::Parameter),
    );
    let (x, y) = (g.multiply(k, a), g.multiply(k, b));
    let difference = g.subtract(x, y);
    assert_eq!(
        (
            g.late_cost(&[difference]).mul,
            g.late_cost(&[difference]).add
        ),
        (1, 1)
    );
}

/// Moments of inertia of a box: `m (c^2 + a^2) - m (a^2 + b^2) = m (c - b) (c + b)`.
#[test]
fn a_difference_of_squares_is_a_product() {
    let mut g = Graph::default();
    let [m, a, b, c] = core::array::from_fn(|_| g.symbol(Stage::Parameter));
    let moment = |g: &mut Graph, x, y| {
        let (x, y) = (g.square(x), g.square(y));
        let sum = g.add(x, y);
        g.multiply(m, sum)
    };
    let (first, second) = (moment(&mut g, c, a), moment(&mut g, a, b));
    let difference = g.difference(second, first);
    let (less, sum) = (g.subtract(b, c), g.add(b, c));
    let product = g.multiply(less, sum);
    assert_eq!(difference, g.multiply(m, product));
    // what is none stays as it stands
    let (twice, once) = (moment(&mut g, c, c), moment(&mut g, a, b));
    assert_eq!(g.difference(twice, once), g.subtract(twice, once));
    assert_eq!(g.difference(a, b), g.subtract(a, b));
    assert_eq!(g.difference(first, first), g.zero());
}

/// `m (c^2 + a^2) - m (a^2 + 1/4) = m (c - 1/2) (c + 1/2)`, and 0.3 in two parts.
#[test]
fn so_is_one_of_a_number_and_a_square() {
    let mut g = Graph::default();
    let [m, c] = core::array::from_fn(|_| g.symbol(Stage::Parameter));
    let of = |g: &mut Graph, edge: Id| {
        let square = g.square(edge);
        g.multiply(m, square)
    };
    let half = g.number(Number::ratio(1, 2));
    let (with_c, with_half) = (of(&mut g, c), of(&mut g, half));
    let (less, sum) = (g.subtract(c, half), g.add(c, half));
    let product = g.multiply(less, sum);
    assert_eq!(g.difference(with_c, with_half), g.multiply(m, product));

    // two numbers, m being none
    let quarter = g.number(Number::ratio(1, 4));
    let (first, second) = (g.add(with_c, with_half), with_c);
    assert_eq!(g.difference(first, second), g.multiply(quarter, m));

    let edge = g.number(Number::ratio(3, 10));
    let with_edge = of(&mut g, edge);
    let difference = g.difference(with_c, with_edge);
    let value = 0.3 + 1e-12;
    let found = g.evaluate(
        &[difference],
        |symbol| if symbol == c { value } else { 2.0 },
    )[0];
    let [square, expected] = [Number::from_f64(value), Number::ratio(3, 10)].map(|x| x.clone() * x);
    let expected = ((square - expected) * Number::integer(2)).to_f64();
    assert!(
        (found / expected - 1.0).abs() < 4e-16,
        "{found:e} {expected:e}"
    );
}

#[test]
fn what_is_known_early_is_computed_early() {
    let mut g = Graph::default();
    let (a, k, m) = (
        g.symbol(Stage::State),
        g.symbol(Stage::Parameter),
        g.symbol(Stage::Parameter),
    );
    let quotient = g.divide(a, m);
    let product = g.multiply(quotient, k);
    assert_eq!(
        (g.late_cost(&[product]).mul, g.late_cost(&[product]).div),
        (1, 0)
    );
    // (a + k) + (b + m) = (a + b) + (k + m)
    let b = g.symbol(Stage::State);
    let (x, y) = (g.add(a, k), g.add(b, m));
    let sum = g.add(x, y);
    assert_eq!(g.late_cost(&[sum]).add, 2);
    // 5 - (a + 3) = 2 - a
    let (five, three, two) = (g.integer(5), g.integer(3), g.integer(2));
    let inner = g.add(a, three);
    let minus_inner = g.negate(inner);
    assert_eq!(g.add(five, minus_inner), g.subtract(two, a));
}

#[test]
fn a_mass_cancels() {
    let mut g = Graph::default();
    let (m, acceleration) = (g.symbol(Stage::Parameter), g.symbol(Stage::State));
    let (weight, one) = (g.multiply(m, acceleration), g.one());
    let inverse = g.divide(one, m);
    assert_eq!(g.multiply(inverse, weight), acceleration);
}

#[test]
fn signs_move_outwards() {
    let mut g = Graph::default();
    let (a, b) = (g.symbol(Stage::State), g.symbol(Stage::State));
    let (minus_a, product) = (g.negate(a), g.multiply(a, b));
    let negative = g.multiply(minus_a, b);
    assert_eq!(g.negate(product), negative);
    assert_eq!(
        g.apply(Function::Cos, &[minus_a]),
        g.apply(Function::Cos, &[a])
    );
    let (sine, odd) = (
        g.apply(Function::Sin, &[a]),
        g.apply(Function::Sin, &[minus_a]),
    );
    assert_eq!(g.negate(sine), odd);
}

#[test]
fn conditions_of_constants_are_decided() {
    let mut g = Graph::default();
    let (one, two, a) = (g.one(), g.integer(2), g.symbol(Stage::State));
    let less = g.compare(Comparison::Less, one, two);
    assert!(matches!(g.node(less), Node::Truth(true)));
    assert_eq!(g.select(less, a, one), a);
}

#[test]
fn no_rule_looks_into_a_quantity() {
    let mut g = Graph::default();
    let (a, b) = (g.symbol(Stage::State), g.symbol(Stage::State));
    let half = g.number(Number::ratio(1, 2));
    let scaled = g.multiply(half, a);
    let quantity = g.quantity(scaled);
    let product = g.multiply(quantity, b);
    assert!(matches!(*g.node(product), Node::Multiply(x, y) if [x, y].contains(&quantity)));
    assert_eq!(g.quantity(a), a);
    assert_eq!(g.quantity(half), half);
    let program = g.schedule(&[product], Stage::State);
    assert_eq!(program.statements, [scaled]);
    assert_eq!(program.values.copies_of(scaled), [quantity]);
}

#[test]
fn a_program_computes_a_value_once() {
    let mut g = Graph::default();
    let [a, b, c] = [(); 3].map(|()| g.symbol(Stage::State));
    let sum = g.add(a, b);
    let named = g.quantity(sum);
    let (from_sum, from_named) = (g.multiply(c, sum), g.multiply(named, c));
    assert_ne!(from_sum, from_named);
    let difference = g.subtract(from_sum, from_named);
    let program = g.schedule(&[difference], Stage::State);
    assert_eq!(g.cost(&program.nodes).total(), 3);
    assert_eq!(program.statements, [sum, from_sum]);
    assert_eq!(program.values.copies_of(from_sum), [from_named]);
}

#[test]
fn shared_expressions_become_statements() {
    let mut g = Graph::default();
    let (a, b) = (g.symbol(Stage::State), g.symbol(Stage::State));
    let sum = g.add(a, b);
    let square = g.square(sum);
    let program = g.schedule(&[square], Stage::State);
    assert_eq!(program.statements, [sum]);
    assert_eq!(program.symbols, [a, b]);
    assert_eq!(g.cost(&program.nodes).total(), 2);
}

#[test]
fn long_sums_are_split_and_deep_graphs_are_walked_without_recursion() {
    let mut g = Graph::default();
    let symbols: Vec<_> = (0..100_000).map(|_| g.symbol(Stage::State)).collect();
    let sum = g.sum(&symbols);
    let program = g.schedule(&[sum], Stage::State);
    assert!(program.statements.len() > 5000);
    let slope = g.derivative(&[sum], symbols[17])[0];
    assert!(g.is_one(slope));
}

#[test]
fn an_inverse_times_its_matrix_is_one() {
    let mut g = Graph::default();
    let entry = |g: &mut Graph, digits: &str| g.number(Number::parse(digits).expect("a number"));
    let [xx, yy, zz, xy, yz, zx] =
        ["1.3", "1.7", "2.1", "-0.12", "-0.05", "0.07"].map(|digits| entry(&mut g, digits));
    let matrix = [[xx, xy, zx], [xy, yy, yz], [zx, yz, zz]];
    let cofactors = g.cofactors(&matrix);
    let (determinant, one) = (g.dot(matrix[0], cofactors[0]), g.one());
    let reciprocal = g.divide(one, determinant);
    let inverse = cofactors.map(|row| g.scale_vector(reciprocal, row));
    for (i, row) in inverse.into_iter().enumerate() {
        for (j, column) in matrix.into_iter().enumerate() {
            let entry = g.dot(row, column);
            assert_eq!(
                g.as_number(entry).and_then(Number::to_integer),
                Some(i64::from(i == j)),
                "exactly"
            );
        }
    }
}
