//! Products of series, many at once.

use super::Arithmetic;

/// Terms of the products of WIDTH pairs of series, each of N coefficients.
///
/// The series lie side by side, so that a register holds the same coefficient of several of them:
///
/// ```text
/// sum[k] = Σ_j left[j][k] right[n - j][k],   j = 0 .. n
/// ```
#[derive(Clone, Debug)]
pub struct Products<A, const WIDTH: usize, const N: usize> {
    arithmetic: A,
    left: [[f64; WIDTH]; N],
    right: [[f64; WIDTH]; N],
}

impl<A, const WIDTH: usize, const N: usize> From<A> for Products<A, WIDTH, N> {
    fn from(arithmetic: A) -> Self {
        Self {
            arithmetic,
            left: [[0.0; WIDTH]; N],
            right: [[0.0; WIDTH]; N],
        }
    }
}

impl<A: Arithmetic, const WIDTH: usize, const N: usize> Products<A, WIDTH, N> {
    /// The first coefficients of all pairs.
    #[inline(always)]
    pub fn start(&mut self, pairs: [(f64, f64); WIDTH]) {
        self.left[0] = pairs.map(|(left, _)| left);
        self.right[0] = pairs.map(|(_, right)| right);
    }

    /// Terms n of the products of the COUNT pairs from FIRST on, of which these are coefficients n. One that is not known yet is
    /// given as zero, and later by [`complete`](Self::complete): its partner begins with zero.
    #[inline(always)]
    pub fn terms<const FIRST: usize, const COUNT: usize>(
        &mut self,
        n: usize,
        pairs: [(f64, f64); COUNT],
    ) -> [f64; COUNT] {
        let (left, right) = (pairs.map(|(left, _)| left), pairs.map(|(_, right)| right));
        let mut sums = [0.0; COUNT];
        // what does not wait for the coefficients of this order
        let between = self.left[1..n].iter().zip(self.right[1..n].iter().rev());
        for (left, right) in between {
            sums = self.added(
                sums,
                part::<WIDTH, FIRST, COUNT>(left),
                part::<WIDTH, FIRST, COUNT>(right),
            );
        }
        sums = self.added(sums, part::<WIDTH, FIRST, COUNT>(&self.left[0]), right);
        sums = self.added(sums, left, part::<WIDTH, FIRST, COUNT>(&self.right[0]));
        self.left[n][FIRST..FIRST + COUNT].copy_from_slice(&left);
        self.right[n][FIRST..FIRST + COUNT].copy_from_slice(&right);
        sums
    }

    /// Sums and products, four by four.
    #[inline(always)]
    fn added<const COUNT: usize>(
        &self,
        mut sums: [f64; COUNT],
        left: [f64; COUNT],
        right: [f64; COUNT],
    ) -> [f64; COUNT] {
        let fours = COUNT / 4 * 4;
        for at in (0..fours).step_by(4) {
            let four = |of: &[f64; COUNT]| [of[at], of[at + 1], of[at + 2], of[at + 3]];
            let added = self
                .arithmetic
                .multiply_add(four(&sums), four(&left), four(&right));
            sums[at..at + 4].copy_from_slice(&added);
        }
        for at in fours..COUNT {
            sums[at] += left[at] * right[at];
        }
        sums
    }

    /// Coefficients n that were not known before.
    #[inline(always)]
    pub fn complete(&mut self, n: usize, left: &[(usize, f64)], right: &[(usize, f64)]) {
        for (pair, value) in left {
            self.left[n][*pair] = *value;
        }
        for (pair, value) in right {
            self.right[n][*pair] = *value;
        }
    }
}

/// COUNT numbers of a row, from FIRST on.
#[inline(always)]
fn part<const WIDTH: usize, const FIRST: usize, const COUNT: usize>(
    row: &[f64; WIDTH],
) -> [f64; COUNT] {
    core::array::from_fn(|k| row[FIRST + k])
}
