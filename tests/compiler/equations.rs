//! Equations whose coefficients depend on the state, and the backward chain rule.

use mounted::symbolic::{Equation, Function, Graph, Id, Node, Number, Size, Stage, free};

fn row(g: &mut Graph, coefficients: &[Id], right: i64) -> Equation {
    Equation {
        coefficients: coefficients.to_vec(),
        right: g.integer(right),
        sample: g.samples(coefficients, |id| free(id, 0)),
        active: None,
        sizes: vec![Size::Terms; coefficients.len()],
    }
}

#[test]
fn numbers_are_solved_exactly_and_without_guards() {
    let mut g = Graph::default();
    let entries = [[2, 1, -1], [-3, -1, 2], [-2, 1, 2]];
    let rows = entries
        .into_iter()
        .zip([8, -11, -3])
        .map(|(entries, right)| {
            let coefficients = entries.map(|entry| g.integer(entry));
            row(&mut g, &coefficients, right)
        });
    let rows = rows.collect();
    let solved = g.solve(rows, 3);
    let values = solved
        .values
        .iter()
        .map(|id| g.as_number(*id).and_then(Number::to_integer));
    assert_eq!(values.collect::<Vec<_>>(), [Some(2), Some(3), Some(-1)]);
    assert!(solved.pivots.is_empty() && solved.spare.is_empty() && solved.undetermined.is_empty());
}

#[test]
fn what_depends_on_the_state_is_guarded() {
    let mut g = Graph::default();
    let (a, b) = (g.symbol(Stage::State), g.symbol(Stage::State));
    let zero = g.zero();
    let rows = vec![row(&mut g, &[a, zero], 6), row(&mut g, &[b, a], 2)];
    let solved = g.solve(rows, 2);
    // both by the same divisor
    assert_eq!(solved.pivots.len(), 1);
    assert!(
        solved
            .pivots
            .iter()
            .all(|(_, id)| matches!(g.node(*id), Node::Pivot(..)))
    );
    let values = g.evaluate(&solved.values, |id| if id == a { 3.0 } else { -1.5 });
    assert!((values[0] - 2.0).abs() < 1e-15 && (values[1] - 5.0 / 3.0).abs() < 1e-15);
}

#[test]
fn dependent_rows_are_left_over() {
    let mut g = Graph::default();
    let (a, b) = (g.symbol(Stage::State), g.symbol(Stage::State));
    let twice = [a, b].map(|id| g.add(id, id));
    let rows = vec![row(&mut g, &[a, b], 1), row(&mut g, &twice, 2)];
    let solved = g.solve(rows, 2);
    assert_eq!(solved.spare.len(), 1);
    assert_eq!(solved.spare[0].0, 1);
    let [undetermined] = &solved.undetermined[..] else {
        panic!("one is not determined");
    };
    assert_eq!(undetermined.column, 1);
    // a u + b v is determined
    let [(0, one), (1, factor)] = undetermined.sum[..] else {
        panic!("both together are");
    };
    assert!(g.is_one(one));
    let factor = g.evaluate(&[factor], |id| if id == a { 2.0 } else { 3.0 });
    assert!((factor[0] - 1.5).abs() < 1e-15);
}

/// Slopes that are handed down from a root add up to its derivatives.
#[test]
fn the_chain_rule_backwards_is_the_chain_rule() {
    let mut g = Graph::default();
    let (x, y) = (g.symbol(Stage::State), g.symbol(Stage::State));
    let root = {
        let (sine, product) = (g.apply(Function::Sin, &[x]), g.multiply(x, y));
        let (square, sum) = (g.square(y), g.add(sine, product));
        let root = g.apply(Function::Sqrt, &[square]);
        let ratio = g.divide(sum, root);
        let angle = g.apply(Function::Atan2, &[ratio, y]);
        let condition = g.compare(mounted::symbolic::Comparison::Less, x, y);
        let choice = g.select(condition, angle, product);
        let choice = g.quantity(choice);
        g.subtract(choice, sine)
    };
    let one = g.one();
    let mut slopes = [g.zero(); 2];
    for (leaf, slope) in g.gradient(&[(root, one)], |id| id == x || id == y) {
        slopes[usize::from(leaf == y)] = slope;
    }
    let expected = [x, y].map(|symbol| g.derivative(&[root], symbol)[0]);
    for (at_x, at_y) in [(0.3, 0.9), (1.4, 0.6), (-0.7, 2.0)] {
        let symbols = |id| if id == x { at_x } else { at_y };
        let (found, expected) = (g.evaluate(&slopes, symbols), g.evaluate(&expected, symbols));
        for (found, expected) in found.into_iter().zip(expected) {
            assert!((found - expected).abs() < 1e-14, "{found} for {expected}");
        }
    }
}

/// What a leaf is made of does not matter: the slope along it is that along a symbol in its place.
#[test]
fn an_expression_can_be_a_leaf() {
    let mut g = Graph::default();
    let (x, y, z) = (
        g.symbol(Stage::State),
        g.symbol(Stage::State),
        g.symbol(Stage::State),
    );
    let one = g.one();
    let made = {
        let divided = g.divide(x, y);
        g.add(divided, y)
    };
    let mut slope = |leaf: Id| {
        let (square, product) = (g.square(leaf), g.multiply(leaf, x));
        let root = g.apply(Function::Sqrt, &[square]);
        let ratio = g.divide(product, root);
        let sine = g.apply(Function::Sin, &[leaf]);
        let sum = g.add(ratio, sine);
        let by = g.gradient(&[(sum, one)], |id| id == leaf);
        assert_eq!(by.len(), 1);
        by[0].1
    };
    let slopes = [slope(made), slope(z)];
    let slopes = g.evaluate(&slopes, |id| {
        if id == x {
            0.3
        } else if id == y {
            0.5
        } else {
            1.1
        }
    });
    assert_eq!(slopes[0].to_bits(), slopes[1].to_bits());
}
