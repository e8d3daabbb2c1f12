//! The rotation of the axes of a link relative to those of its carrier.

use crate::symbolic::{Components, Function, Graph, Id};

type Rows = [Components; 3];

/// The rotation from the axes of a link to those of its carrier.
#[derive(Clone, Copy, PartialEq)]
pub enum Turning {
    Parallel,
    /// About one of the coordinate axes.
    About {
        axis: usize,
        cosine: Id,
        sine: Id,
    },
    /// Given by a matrix.
    By(Rows),
}

impl Turning {
    /// The rotation about any unit vector: `c 1 + (1 - c) d d + s [d]x`.
    pub fn about(graph: &mut Graph, direction: Components, cosine: Id, sine: Id) -> Self {
        let is_unit = |a: Id| graph.as_number(a).is_some_and(|a| a.abs().is_one());
        let is_axis = |axis: &usize| is_unit(direction[*axis]) && graph.is_along(direction, *axis);
        if let Some(axis) = (0..3).find(is_axis) {
            let sine = graph.multiply(direction[axis], sine);
            return Self::About { axis, cosine, sine };
        }
        let one = graph.one();
        let rest = graph.subtract(one, cosine);
        let rest = graph.quantity(rest);
        let sweep = graph.scale_vector(sine, direction);
        let sweep = graph.quantities(sweep);
        Self::By([0, 1, 2].map(|i| {
            [0, 1, 2].map(|j| {
                let along = graph.multiply(direction[i], direction[j]);
                let along = graph.multiply(rest, along);
                let entry = if i == j {
                    graph.add(along, cosine)
                } else {
                    let k = 3 - i - j;
                    if (i + 1) % 3 == j {
                        graph.subtract(along, sweep[k])
                    } else {
                        graph.add(along, sweep[k])
                    }
                };
                graph.quantity(entry)
            })
        }))
    }

    /// The rotation by an angle about one of the coordinate axes.
    pub fn by_angle(graph: &mut Graph, axis: usize, angle: Id) -> Self {
        let cosine = graph.apply(Function::Cos, &[angle]);
        let sine = graph.apply(Function::Sin, &[angle]);
        Self::About { axis, cosine, sine }
    }

    /// The rotation by a unit quaternion: `1 + 2 w [q]x + 2 [q]x [q]x`.
    pub fn quaternion(graph: &mut Graph, w: Id, q: Components) -> Self {
        let twice = graph.add_vectors(q, q);
        let twice = graph.quantities(twice);
        let product = |graph: &mut Graph, a: Id, b: Id| {
            let product = graph.multiply(a, b);
            graph.quantity(product)
        };
        let by_scalar = twice.map(|part| product(graph, w, part));
        let squares = [0, 1, 2].map(|i| product(graph, twice[i], q[i]));
        let one = graph.one();
        let mut rows = [graph.zeros(); 3];
        for i in 0..3 {
            let (j, k) = ((i + 1) % 3, (i + 2) % 3);
            let across = graph.add(squares[j], squares[k]);
            let entry = graph.subtract(one, across);
            rows[i][i] = graph.quantity(entry);
            let mixed = product(graph, twice[i], q[j]);
            let (less, more) = (
                graph.subtract(mixed, by_scalar[k]),
                graph.add(mixed, by_scalar[k]),
            );
            (rows[i][j], rows[j][i]) = (graph.quantity(less), graph.quantity(more));
        }
        Self::By(rows)
    }

    /// The same rotation, given by its matrix.
    pub fn as_matrix(self, graph: &mut Graph) -> Self {
        let columns = graph
            .unit_vectors()
            .map(|unit| self.to_carrier(graph, unit));
        Self::By(transposed(&columns))
    }

    /// The rotation that first applies `then`, and after it this one.
    pub fn after(self, graph: &mut Graph, then: Self) -> Self {
        let columns = graph.unit_vectors().map(|unit| {
            let once = then.to_carrier(graph, unit);
            let twice = self.to_carrier(graph, once);
            graph.quantities(twice)
        });
        Self::By(transposed(&columns))
    }

    /// The same rotation if both axes are themselves rotated by `rows`, a matrix of right angles.
    pub fn seen_turned(self, graph: &mut Graph, rows: Rows) -> Self {
        match self {
            Self::Parallel => self,
            Self::About { axis, cosine, sine } => {
                let column = [0, 1, 2].map(|row| rows[row][axis]);
                let along = (0..3).find(|row| !graph.is_zero(column[*row]));
                let axis = along.unwrap_or(axis);
                let sine = graph.multiply(column[axis], sine);
                Self::About { axis, cosine, sine }
            }
            Self::By(own) => Self::By(Self::By(rows).matrix(graph, &own)),
        }
    }

    /// A vector of the link, in the axes of the carrier.
    pub fn to_carrier(self, graph: &mut Graph, v: Components) -> Components {
        match self {
            Self::Parallel => v,
            Self::About { axis, cosine, sine } => about(graph, axis, cosine, sine, v),
            Self::By(rows) => graph.transform(&rows, v),
        }
    }

    /// A vector of the carrier, in the axes of the link.
    pub fn to_link(self, graph: &mut Graph, v: Components) -> Components {
        match self {
            Self::Parallel => v,
            Self::About { axis, cosine, sine } => {
                let sine = graph.negate(sine);
                about(graph, axis, cosine, sine, v)
            }
            Self::By(rows) => graph.transform(&transposed(&rows), v),
        }
    }

    /// `R T R^T` for a symmetric tensor. About an axis, its entries are `T_11 - s p`, `T_22 + s p`
    /// and `c p - T_12`, where `p = s (T_11 - T_22) + 2 c T_12`.
    pub fn tensor(self, graph: &mut Graph, tensor: &Rows) -> Rows {
        match self {
            Self::Parallel => *tensor,
            Self::About { axis, cosine, sine } => {
                let (i, j) = ((axis + 1) % 3, (axis + 2) % 3);
                let column = [tensor[0][axis], tensor[1][axis], tensor[2][axis]];
                let column = about(graph, axis, cosine, sine, column);
                let [[ii, ij], [_, jj]] = block(
                    graph,
                    [cosine, sine],
                    [[tensor[i][i], tensor[i][j]], [tensor[j][i], tensor[j][j]]],
                );
                let mut turned = *tensor;
                for row in 0..3 {
                    turned[row][axis] = column[row];
                    turned[axis][row] = column[row];
                }
                turned[i][i] = ii;
                turned[j][j] = jj;
                (turned[i][j], turned[j][i]) = (ij, ij);
                turned
            }
            Self::By(rows) => {
                let half = matrix_product(graph, &rows, tensor);
                let half = half.map(|row| graph.quantities(row));
                let mut turned = *tensor;
                for i in 0..3 {
                    for j in i..3 {
                        let entry = graph.dot(half[i], rows[j]);
                        (turned[i][j], turned[j][i]) = (entry, entry);
                    }
                }
                turned
            }
        }
    }

    /// `R B R^T` for any matrix.
    pub fn matrix(self, graph: &mut Graph, matrix: &Rows) -> Rows {
        match self {
            Self::Parallel => *matrix,
            Self::About { axis, cosine, sine } => {
                let (i, j) = ((axis + 1) % 3, (axis + 2) % 3);
                let column = [matrix[0][axis], matrix[1][axis], matrix[2][axis]];
                let column = about(graph, axis, cosine, sine, column);
                let row = about(graph, axis, cosine, sine, matrix[axis]);
                let [[ii, ij], [ji, jj]] = block(
                    graph,
                    [cosine, sine],
                    [[matrix[i][i], matrix[i][j]], [matrix[j][i], matrix[j][j]]],
                );
                let mut turned = *matrix;
                for other in [i, j] {
                    turned[other][axis] = column[other];
                    turned[axis][other] = row[other];
                }
                (turned[i][i], turned[i][j], turned[j][i], turned[j][j]) = (ii, ij, ji, jj);
                turned
            }
            Self::By(rows) => {
                let half = matrix_product(graph, &rows, matrix);
                let half = half.map(|row| graph.quantities(row));
                half.map(|row| rows.map(|other| graph.dot(row, other)))
            }
        }
    }
}

/// A vector turned about an axis.
fn about(graph: &mut Graph, axis: usize, cosine: Id, sine: Id, v: Components) -> Components {
    let (i, j) = ((axis + 1) % 3, (axis + 2) % 3);
    let [ci, cj] = [i, j].map(|part| graph.multiply(cosine, v[part]));
    let [si, sj] = [i, j].map(|part| graph.multiply(sine, v[part]));
    let mut turned = v;
    (turned[i], turned[j]) = (graph.subtract(ci, sj), graph.add(si, cj));
    turned
}

/// The block, across the axis, of a matrix that is rotated about this axis.
fn block(
    graph: &mut Graph,
    [cosine, sine]: [Id; 2],
    [[ii, ij], [ji, jj]]: [[Id; 2]; 2],
) -> [[Id; 2]; 2] {
    let (difference, sum) = (graph.subtract(ii, jj), graph.add(ij, ji));
    let (by_sine, by_cosine) = (
        graph.multiply(sine, difference),
        graph.multiply(cosine, sum),
    );
    let p = graph.add(by_sine, by_cosine);
    let p = graph.quantity(p);
    let (sp, cp) = (graph.multiply(sine, p), graph.multiply(cosine, p));
    let (sp, cp) = (graph.quantity(sp), graph.quantity(cp));
    [
        [graph.subtract(ii, sp), graph.subtract(cp, ji)],
        [graph.subtract(cp, ij), graph.add(jj, sp)],
    ]
}

pub fn transposed(rows: &Rows) -> Rows {
    [0, 1, 2].map(|i| [0, 1, 2].map(|j| rows[j][i]))
}

fn matrix_product(graph: &mut Graph, a: &Rows, b: &Rows) -> Rows {
    let columns = transposed(b);
    a.map(|row| columns.map(|column| graph.dot(row, column)))
}
