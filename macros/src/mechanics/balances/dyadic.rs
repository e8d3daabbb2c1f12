//! A constant tensor with an axis of symmetry, given by two numbers and a direction.

use crate::symbolic::{Components, Graph, Id, Number, Symmetry};

/// `isotropic 1 + excess n n`, where the largest component of n is one.
#[derive(Clone, Copy)]
pub struct Dyadic {
    pub isotropic: Id,
    pub excess: Id,
    pub axis: Components,
}

impl Dyadic {
    /// `a (1 - n n / n.n) + b n n / n.n`
    fn new(graph: &mut Graph, across: &Number, along: &Number, axis: [Number; 3]) -> Option<Self> {
        let square = axis.iter().fold(Number::zero(), |sum, component| {
            sum + component.clone() * component.clone()
        });
        let excess = (along.clone() - across.clone()).checked_div(&square)?;
        Some(Self {
            isotropic: graph.number(across.clone()),
            excess: graph.number(excess),
            axis: axis.map(|component| graph.number(component)),
        })
    }

    /// The form of a tensor of numbers that has two equal principal moments and a third one.
    pub fn of(graph: &mut Graph, rows: &[Components; 3]) -> Option<Self> {
        let Symmetry {
            across,
            along,
            axis,
        } = Symmetry::of(&graph.constant_matrix(rows)?)?;
        Self::new(graph, &across, &along, axis)
    }

    /// The same for the inverse of the tensor.
    pub fn of_inverse(graph: &mut Graph, rows: &[Components; 3]) -> Option<Self> {
        let Symmetry {
            across,
            along,
            axis,
        } = Symmetry::of(&graph.constant_matrix(rows)?)?;
        let one = Number::one();
        let (across, along) = (one.checked_div(&across)?, one.checked_div(&along)?);
        Self::new(graph, &across, &along, axis)
    }

    /// `a x + b (n.x) n`
    pub fn transform(self, graph: &mut Graph, x: Components) -> Components {
        let isotropic = x.map(|component| graph.distribute(self.isotropic, component));
        let along = graph.dot(self.axis, x);
        let along = graph.distribute(self.excess, along);
        let along = graph.quantity(along);
        let excess = graph.scale_vector(along, self.axis);
        graph.add_vectors(isotropic, excess)
    }

    /// `a x.x + b (n.x)^2`
    fn quadratic(self, graph: &mut Graph, x: Components) -> Id {
        let (square, along) = (graph.norm_squared(x), graph.dot(self.axis, x));
        let isotropic = graph.multiply(self.isotropic, square);
        let along = graph.square(along);
        let excess = graph.multiply(self.excess, along);
        graph.add(isotropic, excess)
    }
}

/// `J x`
pub fn transform(graph: &mut Graph, rows: &[Components; 3], x: Components) -> Components {
    let full = graph.transform(rows, x);
    let dyadic = Dyadic::of(graph, rows).map(|dyadic| dyadic.transform(graph, x));
    cheapest(graph, full, dyadic)
}

/// `x.J x`, with each product of inertia used once.
pub fn quadratic(graph: &mut Graph, rows: &[Components; 3], x: Components) -> Id {
    let two = graph.integer(2);
    let mut full = graph.zero();
    for i in 0..3 {
        let mut factor = graph.multiply(rows[i][i], x[i]);
        for j in i + 1..3 {
            let twice = graph.multiply(two, rows[i][j]);
            let term = graph.multiply(twice, x[j]);
            factor = graph.add(factor, term);
        }
        let term = graph.multiply(x[i], factor);
        full = graph.add(full, term);
    }
    let dyadic = Dyadic::of(graph, rows).map(|dyadic| [dyadic.quadratic(graph, x)]);
    let [form] = cheapest(graph, [full], dyadic);
    form
}

/// One of two forms of the same quantity: the second if it exists and costs less, otherwise the
/// first.
pub fn cheapest<const N: usize>(graph: &Graph, first: [Id; N], second: Option<[Id; N]>) -> [Id; N] {
    let cost = |form: &[Id; N]| graph.late_cost(form).total();
    match second {
        Some(second) if cost(&second) < cost(&first) => second,
        _ => first,
    }
}
