//! The inertia of a body about a point, given by its entries.

use crate::symbolic::{Components, Graph, Id};

/// The inertia of a body about G, in body axes.
#[derive(Clone, Copy, Debug)]
pub enum Inertia {
    /// The body does not rotate, or no inertia was given.
    Absent,
    /// About the axis through G normal to the plane; for a rod, about every axis through G
    /// perpendicular to it.
    Scalar(Id),
    /// The tensor, by rows.
    Spatial([Components; 3]),
}

impl Inertia {
    /// `J + m (r^2 1 - r r)`: the inertia about a point at the offset `r` from G. For a single
    /// moment, `r` is in the plane or along the rod.
    pub fn displaced(self, graph: &mut Graph, mass: Id, r: Components) -> Self {
        match self {
            Self::Absent => Self::Absent,
            Self::Scalar(moment) => {
                let square = graph.norm_squared(r);
                let added = graph.multiply(mass, square);
                Self::Scalar(graph.add(moment, added))
            }
            Self::Spatial(rows) => Self::Spatial(displaced(graph, mass, r, &rows)),
        }
    }

    /// `J w`
    pub fn times(self, graph: &mut Graph, w: Components) -> Components {
        match self {
            Self::Absent => graph.zeros(),
            Self::Scalar(moment) => graph.scale_vector(moment, w),
            Self::Spatial(rows) => graph.transform(&rows, w),
        }
    }

    /// `J w' + w x J w`: the rate of change of the angular momentum. For a single moment, it is
    /// `J w'`.
    pub fn change(self, graph: &mut Graph, w: Components, rate: Components) -> Components {
        let Self::Spatial(rows) = self else {
            return self.times(graph, rate);
        };
        let momentum = graph.transform(&rows, w);
        let gyroscopic = graph.cross(w, momentum);
        let driven = graph.transform(&rows, rate);
        graph.add_vectors(driven, gyroscopic)
    }

    /// The sum of two inertias of the same kind.
    pub fn plus(self, graph: &mut Graph, other: Self) -> Self {
        match (self, other) {
            (Self::Scalar(a), Self::Scalar(b)) => Self::Scalar(graph.add(a, b)),
            (Self::Spatial(a), Self::Spatial(b)) => {
                Self::Spatial([0, 1, 2].map(|i| graph.add_vectors(a[i], b[i])))
            }
            _ => self,
        }
    }

    /// The inertia with its moments replaced by NaN where they are not positive.
    pub fn positive(self, graph: &mut Graph) -> Self {
        match self {
            Self::Absent => Self::Absent,
            Self::Scalar(moment) => Self::Scalar(graph.positive(moment)),
            Self::Spatial(mut rows) => {
                for (axis, row) in rows.iter_mut().enumerate() {
                    row[axis] = graph.positive(row[axis]);
                }
                Self::Spatial(rows)
            }
        }
    }

    /// All nine entries, by rows; zeros if there is no inertia.
    pub fn rows(self, graph: &mut Graph) -> [Components; 3] {
        let mut rows = [graph.zeros(); 3];
        match self {
            Self::Absent => {}
            Self::Scalar(moment) => rows[2][2] = moment,
            Self::Spatial(spatial) => rows = spatial,
        }
        rows
    }

    /// An inertia of the same kind with these entries.
    pub fn with_rows(self, rows: [Components; 3]) -> Self {
        match self {
            Self::Absent => Self::Absent,
            Self::Scalar(_) => Self::Scalar(rows[2][2]),
            Self::Spatial(_) => Self::Spatial(rows),
        }
    }

    /// The single moment, or the entries xx, yy, zz, xy, yz, zx.
    pub fn distinct_entries(self) -> Vec<Id> {
        match self {
            Self::Absent => Vec::new(),
            Self::Scalar(moment) => vec![moment],
            Self::Spatial(rows) => entries(&rows).to_vec(),
        }
    }

    /// The single moment, or all nine entries, by rows.
    pub fn entries(self) -> Vec<Id> {
        match self {
            Self::Absent => Vec::new(),
            Self::Scalar(moment) => vec![moment],
            Self::Spatial(rows) => rows.into_iter().flatten().collect(),
        }
    }
}

/// `J + m (r^2 1 - r r)`: from the inertia `J` about G, the inertia about a point at the offset
/// `r`.
pub fn displaced(
    graph: &mut Graph,
    mass: Id,
    r: Components,
    rows: &[Components; 3],
) -> [Components; 3] {
    let squares = r.map(|component| graph.square(component));
    [0, 1, 2].map(|i| {
        [0, 1, 2].map(|j| {
            let lever = if i == j {
                graph.add(squares[(i + 1) % 3], squares[(i + 2) % 3])
            } else {
                let product = graph.multiply(r[i], r[j]);
                graph.negate(product)
            };
            let added = graph.multiply(mass, lever);
            graph.add(rows[i][j], added)
        })
    })
}

/// The six entries of a symmetric matrix, in the order xx, yy, zz, xy, yz, zx.
pub fn entries(rows: &[Components; 3]) -> [Id; 6] {
    ENTRIES.map(|(_, row, column)| rows[row][column])
}

/// The names of the distinct entries of a symmetric matrix, with row and column.
pub const ENTRIES: [(&str, usize, usize); 6] = [
    ("xx", 0, 0),
    ("yy", 1, 1),
    ("zz", 2, 2),
    ("xy", 0, 1),
    ("yz", 1, 2),
    ("zx", 2, 0),
];
