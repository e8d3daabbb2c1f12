//! Constraints in absolute coordinates.

use crate::mechanics::tree::link::{Link, Tree};
use crate::symbolic::{Components, Graph, Id};

use super::super::constraints::{ConstraintRow, Ends};
use super::super::reduced::LinearRow;
use super::absolute::{Absolute, is_turn};
use super::arms::{Arms, quarter_turn};

/// The part of a link in a loop: a vector in its axes, from where the loop enters the link to where
/// it leaves it.
struct Part {
    vector: Components,
    /// How often the loop passes through the joint of the link: forwards minus backwards.
    passes: i32,
}

/// The two rows of a hinge that closes a loop. They keep the sum of the arms of its links constant.
///
/// ```text
/// sum of z x a_i x_i = sum of w_i^2 a_i - ..
/// ```
pub fn of_hinge(
    graph: &mut Graph,
    tree: &Tree,
    absolute: &Absolute,
    arms: &mut Arms<'_>,
    ends: &Ends<'_>,
) -> [LinearRow; 2] {
    let zeros = graph.zeros();
    let mut sum = Sum {
        columns: vec![zeros; absolute.count],
        sizes: vec![graph.zero(); absolute.count],
        right: zeros,
    };
    for (link, part) in parts(graph, tree, ends).into_iter().enumerate() {
        let Some(Part { vector, passes }) = part else {
            continue;
        };
        let arm = arms.world(graph, link, vector);
        let swept = quarter_turn(graph, arm);
        if let Some(own) = absolute.turns[link] {
            sum.by(graph, own, (swept, vector));
        }
        let inwards = graph.scale_vector(absolute.squares[link], arm);
        let turned = graph.scale_vector(absolute.given[link], swept);
        sum.right = graph.add_vectors(sum.right, inwards);
        sum.right = graph.subtract_vectors(sum.right, turned);
        if passes != 0 {
            sum.slides(graph, (&tree.links[link], passes), (absolute, arms), link);
        }
    }
    [0, 1].map(|axis| LinearRow {
        name: format!("{}_{}", ends.closing.name, axis + 1),
        slopes: sum.columns.iter().map(|column| column[axis]).collect(),
        sizes: sum.sizes.clone(),
        right: graph.quantity(sum.right[axis]),
    })
}

/// The sum over the links of a loop, while it is formed.
struct Sum {
    /// One column for each absolute coordinate, and the sums of the squares of its terms.
    columns: Vec<Components>,
    sizes: Vec<Id>,
    right: Components,
}

impl Sum {
    /// Adds the effect of a coordinate: a vector, and the vector that gives its length.
    fn by(&mut self, graph: &mut Graph, own: usize, (column, length): (Components, Components)) {
        self.columns[own] = graph.add_vectors(self.columns[own], column);
        let square = graph.norm_squared(length);
        self.sizes[own] = graph.add(self.sizes[own], square);
    }

    /// Adds the slides of a link if the loop passes through the joint of the link.
    fn slides(
        &mut self,
        graph: &mut Graph,
        (known, passes): (&Link, i32),
        (absolute, arms): (&Absolute, &mut Arms<'_>),
        link: usize,
    ) {
        let sign = graph.integer(i64::from(passes));
        let mut next = absolute.first[link];
        for freedom in &known.freedoms {
            let own = next;
            next += usize::from(freedom.given.is_none());
            if is_turn(graph, freedom) {
                continue;
            }
            let length = freedom.twist.linear;
            let along = graph.scale_vector(sign, length);
            let along = if known.is_free {
                along
            } else {
                arms.world(graph, link, along)
            };
            if let Some(rate) = freedom.given {
                let driven = graph.scale_vector(rate, along);
                self.right = graph.subtract_vectors(self.right, driven);
            } else {
                self.by(graph, own, (along, length));
            }
            if !known.is_free {
                let coriolis = coriolis(graph, arms.turning_rate(link), freedom.rate, along);
                self.right = graph.subtract_vectors(self.right, coriolis);
            }
        }
    }
}

/// `2 w x v`
pub fn coriolis(graph: &mut Graph, w: Id, rate: Id, along: Components) -> Components {
    let across = quarter_turn(graph, along);
    let product = graph.multiply(w, rate);
    let twice = graph.add(product, product);
    let twice = graph.quantity(twice);
    graph.scale_vector(twice, across)
}

/// The part that each link has in the loop of a joint.
fn parts(graph: &mut Graph, tree: &Tree, ends: &Ends<'_>) -> Vec<Option<Part>> {
    let zeros = graph.zeros();
    let mut sums: Vec<Part> = tree
        .links
        .iter()
        .map(|_| Part {
            vector: zeros,
            passes: 0,
        })
        .collect();
    for (end, passes) in [(0, -1), (1, 1)] {
        let (mut at, mut offset) = (ends.links[end], ends.offsets[end]);
        while let Some(link) = at {
            let own = &mut sums[link];
            own.passes += passes;
            own.vector = if passes > 0 {
                graph.add_vectors(own.vector, offset)
            } else {
                graph.subtract_vectors(own.vector, offset)
            };
            (at, offset) = (tree.links[link].carrier, tree.links[link].place);
        }
    }
    let sums = sums.into_iter();
    sums.map(|part| {
        let is_there = part.passes != 0 || !graph.is_zero_vector(&part.vector);
        is_there.then_some(part)
    })
    .collect()
}

/// A row given in joint coordinates, written in absolute ones.
pub fn of_row(graph: &mut Graph, absolute: &Absolute, row: &ConstraintRow) -> LinearRow {
    let slopes = absolute.gathered(graph, &row.slopes);
    let slopes: Vec<Id> = slopes.into_iter().map(|one| graph.quantity(one)).collect();
    let known = absolute.known(graph, &row.slopes);
    let right = graph.subtract(known, row.bias);
    LinearRow {
        name: row.spelled(),
        sizes: slopes.iter().map(|one| graph.square(*one)).collect(),
        slopes,
        right: graph.quantity(right),
    }
}
