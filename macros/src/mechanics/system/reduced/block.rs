//! Blocks: rows that are solved together, and their solutions.

use crate::symbolic::{Graph, Id};

/// Rows that are solved for the coordinates in them.
pub struct Block {
    pub rows: Vec<usize>,
    pub coordinates: Vec<usize>,
    /// The slopes of these rows along these coordinates.
    pub slopes: Vec<Vec<Id>>,
    /// The values of the coordinates, without the motion along the way that remains, if one does.
    pub fixed: Vec<Id>,
    pub way: Option<Way>,
    /// The reciprocal of the determinant of the rows, or of the inertia along the way.
    pub inverse: Id,
    /// Later rows that contain these coordinates, with their slopes along them.
    pub later: Vec<(usize, Vec<Id>)>,
}

/// The way, a direction of motion, that the rows of a block leave free.
pub struct Way {
    pub along: Vec<Id>,
    /// `M n`
    pub momentum: Vec<Id>,
    /// `fixed` before it is divided by the inertia.
    pub numerators: Vec<Id>,
    /// The coordinate that stands for the others.
    pub coordinate: usize,
}

/// The smallest set of rows that contains as many coordinates as rows, or one more. Of equally
/// small sets, the one with the fewest coordinates.
pub fn next_rows(open: &[(usize, Vec<usize>)]) -> Option<(Vec<usize>, Vec<usize>)> {
    let with = |parts: &[&(usize, Vec<usize>)]| {
        let rows: Vec<usize> = parts.iter().map(|(row, _)| *row).collect();
        let mut coordinates: Vec<usize> = parts.iter().flat_map(|(_, own)| own).copied().collect();
        coordinates.sort_unstable();
        coordinates.dedup();
        let count = coordinates.len();
        (rows.len()..=rows.len() + 1)
            .contains(&count)
            .then_some((rows, coordinates))
    };
    let single = open.iter().filter_map(|row| with(&[row]));
    let pairs = open.iter().enumerate().flat_map(|(place, first)| {
        let others = open[place + 1..].iter();
        others.filter_map(move |second| with(&[first, second]))
    });
    single
        .chain(pairs)
        .min_by_key(|(rows, coordinates)| (rows.len(), coordinates.len()))
}

/// The way that rows leave free, whose components are their minors, and bounds of the squares of
/// these components, from those of the slopes.
pub fn way(graph: &mut Graph, slopes: &[Vec<Id>], sizes: &[Id]) -> (Vec<Id>, Vec<Id>) {
    match (slopes, sizes) {
        ([row], [a, b]) => (vec![row[1], graph.negate(row[0])], vec![*b, *a]),
        ([first, second], [a, b, c]) => {
            let [first, second] = [first, second].map(|row| [row[0], row[1], row[2]]);
            let minors = graph.cross(first, second);
            let sizes = [(b, c), (c, a), (a, b)].map(|(i, j)| graph.multiply(*i, *j));
            (graph.quantities(minors).to_vec(), sizes.to_vec())
        }
        _ => (Vec::new(), Vec::new()),
    }
}

/// The determinant of equally many rows and coordinates, and the values of the coordinates times
/// it.
pub fn solved(graph: &mut Graph, slopes: &[Vec<Id>], right: &[Id]) -> (Id, Vec<Id>) {
    let determinant = |graph: &mut Graph, [a, b]: [Id; 2], [c, d]: [Id; 2]| {
        let (ad, bc) = (graph.multiply(a, d), graph.multiply(b, c));
        graph.subtract(ad, bc)
    };
    match (slopes, right) {
        ([first, second], [r, s]) => {
            let columns = [0, 1].map(|place| [first[place], second[place]]);
            let whole = determinant(graph, columns[0], columns[1]);
            let x = determinant(graph, [*r, *s], columns[1]);
            let y = determinant(graph, columns[0], [*r, *s]);
            (whole, vec![x, y])
        }
        _ => (slopes[0][0], right.to_vec()),
    }
}

/// `p mu`, where `A p = r` and `m . p = 0`.
pub fn numerators(graph: &mut Graph, slopes: &[Vec<Id>], right: &[Id], momentum: &[Id]) -> Vec<Id> {
    match (slopes, right, momentum) {
        ([_], [right], [first, second]) => {
            let (a, b) = (
                graph.multiply(*right, *first),
                graph.multiply(*right, *second),
            );
            vec![graph.negate(b), a]
        }
        ([first, second], [r, s], [a, b, c]) => {
            let turned = [0, 1, 2].map(|place| {
                let less = graph.multiply(*s, first[place]);
                let more = graph.multiply(*r, second[place]);
                let whole = graph.subtract(more, less);
                graph.quantity(whole)
            });
            graph.cross(turned, [*a, *b, *c]).to_vec()
        }
        _ => Vec::new(),
    }
}
