//! Linear equations in 106 bits.

use crate::wide::Wide;

/// What is found of `A x = b`, `A` by rows.
pub struct Solution {
    /// Zero where nothing determines them.
    pub values: Vec<Wide>,
    pub rank: usize,
    /// The largest right side that is left of rows that are used up.
    pub left: f64,
    /// The smallest pivot.
    pub least: f64,
}

/// Pivots below this, relative to the first, are none.
const NOTHING: f64 = 1e-13;

/// By elimination with the largest pivots of all.
pub fn solve(mut rows: Vec<Vec<Wide>>, mut right: Vec<Wide>) -> Solution {
    let width = rows.first().map_or(0, Vec::len);
    let mut columns: Vec<usize> = (0..width).collect();
    let (mut rank, mut largest, mut least) = (0, 0.0_f64, f64::INFINITY);
    while rank < rows.len().min(width) {
        let mut best = (0.0, rank, rank);
        for (i, row) in rows.iter().enumerate().skip(rank) {
            for (j, column) in columns.iter().enumerate().skip(rank) {
                let size = row[*column].high.abs();
                if size > best.0 {
                    best = (size, i, j);
                }
            }
        }
        largest = largest.max(best.0);
        if best.0 <= NOTHING * largest {
            break;
        }
        least = least.min(best.0);
        rows.swap(rank, best.1);
        right.swap(rank, best.1);
        columns.swap(rank, best.2);
        let pivot = columns[rank];
        for i in rank + 1..rows.len() {
            let share = rows[i][pivot] / rows[rank][pivot];
            for column in &columns[rank..] {
                rows[i][*column] = rows[i][*column] - share * rows[rank][*column];
            }
            right[i] = right[i] - share * right[rank];
        }
        rank += 1;
    }
    let mut values = vec![Wide::ZERO; width];
    for i in (0..rank).rev() {
        let known = columns[i + 1..rank].iter();
        let known: Wide = known.map(|column| rows[i][*column] * values[*column]).sum();
        values[columns[i]] = (right[i] - known) / rows[i][columns[i]];
    }
    let rest = right[rank..].iter();
    let left = rest.fold(0.0, |left: f64, one| left.max(one.high.abs()));
    Solution {
        values,
        rank,
        left,
        least,
    }
}

/// `A x`
pub fn times(rows: &[Vec<Wide>], x: &[Wide]) -> Vec<Wide> {
    let product = |row: &Vec<Wide>| row.iter().zip(x).map(|(a, x)| *a * *x).sum();
    rows.iter().map(product).collect()
}
