//! Linear algebra in doubles.

/// A row depends on others if no more than this fraction of it remains without its parts along
/// them.
const DEPENDENT: f64 = 1e-6;

/// A matrix whose diagonal entries are one or more is singular if no more than this is left of one.
const SINGULAR: f64 = 1e-10;

/// Pseudorandom numbers.
pub struct Random(u64);

impl Random {
    pub fn new(seed: u64) -> Self {
        let mut random = Self(seed.wrapping_add(1).wrapping_mul(0x9e37_79b9_7f4a_7c15) | 1);
        random.number();
        random.number();
        random
    }

    /// A number between -1 and 1.
    #[allow(clippy::cast_precision_loss, reason = "53 bits are kept")]
    pub fn number(&mut self) -> f64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        (self.0 >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
    }
}

/// Mutually perpendicular unit vectors.
#[derive(Default)]
pub struct Span(Vec<Vec<f64>>);

impl Span {
    pub fn rank(&self) -> usize {
        self.0.len()
    }

    /// Whether a row is independent of those before it. If so, it is added.
    pub fn take(&mut self, row: Vec<f64>) -> bool {
        let left = self.left(row);
        let is_new = left.is_some();
        self.0.extend(left);
        is_new
    }

    /// The direction of the part of a row that is perpendicular to all of these.
    pub fn left(&self, row: Vec<f64>) -> Option<Vec<f64>> {
        let before = dot(&row, &row).sqrt();
        let mut left = row;
        for known in self.0.iter().chain(&self.0) {
            let part = dot(&left, known);
            for (entry, other) in left.iter_mut().zip(known) {
                *entry -= part * other;
            }
        }
        let norm = dot(&left, &left).sqrt();
        (norm > DEPENDENT * before).then(|| left.iter().map(|entry| entry / norm).collect())
    }
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

/// Solves `(A^T A + damping D) x = -A^T e`, where D is diagonal and positive. If D were of the size of
/// `A^T A`, both factors of a product would become zero together, instead of the nearer one.
pub fn solve(rows: &[Vec<f64>], errors: &[f64], (damping, diagonal): (f64, &[f64])) -> Vec<f64> {
    let count = rows.first().map_or(0, Vec::len);
    let column = |own: usize| rows.iter().map(move |row| row[own]);
    let product = |a: usize, b: usize| column(a).zip(column(b)).map(|(a, b)| a * b).sum::<f64>();
    let mut matrix: Vec<Vec<f64>> = (0..count)
        .map(|own| {
            let right: f64 = column(own).zip(errors).map(|(a, e)| a * e).sum();
            let entries = (0..count).map(|other| product(own, other));
            entries.chain([-right]).collect()
        })
        .collect();
    for (own, row) in matrix.iter_mut().enumerate() {
        row[own] += damping.max(1e-12) * diagonal[own];
    }
    for pivot in 0..count {
        let known = matrix[pivot].clone();
        for row in matrix.iter_mut().skip(pivot + 1) {
            let factor = row[pivot] / known[pivot];
            for (entry, part) in row.iter_mut().zip(&known) {
                *entry -= factor * part;
            }
        }
    }
    let mut values = vec![0.0; count];
    for own in (0..count).rev() {
        let row = &matrix[own];
        let known = dot(&row[own + 1..count], &values[own + 1..]);
        values[own] = (row[count] - known) / row[own];
    }
    values
}

/// Whether a symmetric matrix without negative eigenvalues is positive, beyond rounding.
pub fn is_positive(mut matrix: Vec<Vec<f64>>) -> bool {
    for pivot in 0..matrix.len() {
        let known = matrix[pivot].clone();
        if known[pivot] <= SINGULAR {
            return false;
        }
        for row in matrix.iter_mut().skip(pivot + 1) {
            let factor = row[pivot] / known[pivot];
            for (entry, part) in row.iter_mut().zip(&known) {
                *entry -= factor * part;
            }
        }
    }
    true
}

/// A step of Newton's method, no longer than one and the errors. A longer one leads to distant
/// states, where moments are so much larger than forces that these are taken for nothing.
pub fn bounded(step: Vec<f64>, errors: &[f64]) -> Vec<f64> {
    let largest = |all: &[f64]| all.iter().fold(0.0, |most, one| f64::max(most, one.abs()));
    let share = (1.0 + largest(errors)) / largest(&step).max(f64::MIN_POSITIVE);
    step.into_iter().map(|part| part * share.min(1.0)).collect()
}

pub fn squares(all: &[f64]) -> f64 {
    all.iter().map(|one| one * one).sum()
}
