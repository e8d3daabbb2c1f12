//! The sizes of the terms of sums.
#![allow(clippy::float_cmp, reason = "what is exact is compared exactly")]

use mounted::symbolic::{Comparison, Function, Graph, Id, Stage};

/// The size of what `made` makes of three symbols with these values.
fn magnitude(values: [f64; 3], made: impl FnOnce(&mut Graph, [Id; 3]) -> Id) -> f64 {
    let mut g = Graph::default();
    let symbols = [(); 3].map(|()| g.symbol(Stage::State));
    let root = made(&mut g, symbols);
    let sizes = g.magnitudes(&[root]);
    let value = |id| {
        let places = symbols.iter().zip(values);
        let mut found = places.filter(|(symbol, _)| **symbol == id);
        found.next().map_or(f64::NAN, |(_, value)| value)
    };
    g.evaluate(&sizes, value)[0]
}

#[test]
fn the_largest_term_of_a_sum_counts() {
    let sum = |g: &mut Graph, [a, b, c]: [Id; 3]| g.sum(&[a, b, c]);
    assert_eq!(magnitude([7.0, -9.0, 2.0], sum), 9.0);
    let product = |g: &mut Graph, [a, b, c]: [Id; 3]| {
        let product = g.multiply(a, b);
        g.multiply(product, c)
    };
    assert_eq!(magnitude([-2.0, 3.0, 5.0], product), 30.0);
}

#[test]
fn terms_count_as_much_as_they_contribute() {
    // (a - b) c, also where it is zero
    let product = |g: &mut Graph, [a, b, c]: [Id; 3]| {
        let difference = g.subtract(a, b);
        g.multiply(difference, c)
    };
    assert_eq!(magnitude([4.0, 4.0, -3.0], product), 12.0);
    assert_eq!(magnitude([4.0, 4.0, 0.0], product), 0.0);
    // of two such factors, each is multiplied by the other
    let square = |g: &mut Graph, [a, b, c]: [Id; 3]| {
        let (x, y) = (g.subtract(a, b), g.subtract(a, c));
        g.multiply(x, y)
    };
    assert_eq!(magnitude([4.0, 4.0, 1.0], square), 12.0);
    assert_eq!(magnitude([4.0, 4.0, 4.0], square), 0.0);
    // sin(a - b) to first order
    let sine = |g: &mut Graph, [a, b, _]: [Id; 3]| {
        let difference = g.subtract(a, b);
        g.apply(Function::Sin, &[difference])
    };
    assert_eq!(magnitude([4.0, 4.0, 0.0], sine), 4.0);
}

#[test]
fn what_is_divided_by_counts_as_given() {
    let ratio = |g: &mut Graph, [a, b, c]: [Id; 3]| {
        let difference = g.subtract(b, c);
        g.divide(a, difference)
    };
    assert_eq!(magnitude([3.0, 1.5, 1.0], ratio), 6.0);
    let ratio = |g: &mut Graph, [a, b, c]: [Id; 3]| {
        let difference = g.subtract(a, b);
        g.divide(difference, c)
    };
    assert_eq!(magnitude([3.0, 3.0, -0.5], ratio), 6.0);
}

#[test]
fn norms_and_choices_have_sizes_where_they_are_zero() {
    let root = |g: &mut Graph, [a, b, c]: [Id; 3]| {
        let [a, b] = [a, b].map(|one| g.multiply(one, one));
        let sum = g.add(a, b);
        let root = g.apply(Function::Sqrt, &[sum]);
        g.multiply(root, c)
    };
    assert_eq!(magnitude([0.0, 0.0, 2.0], root), 0.0);
    assert_eq!(magnitude([3.0, 4.0, 2.0], root), 8.0);
    let chosen = |g: &mut Graph, [a, b, c]: [Id; 3]| {
        let (zero, difference) = (g.zero(), g.subtract(a, b));
        let condition = g.compare(Comparison::Less, c, zero);
        let inverse = g.divide(a, c);
        g.select(condition, inverse, difference)
    };
    assert_eq!(magnitude([4.0, 4.0, 0.0], chosen), 4.0);
    assert_eq!(magnitude([4.0, 4.0, -8.0], chosen), 0.5);
}
