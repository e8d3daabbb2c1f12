//! Many sums of products of series at once.

use super::Arithmetic;

/// Terms of sums of products of series with N coefficients; all sums together have WIDTH
/// products.
///
/// The series lie side by side, so a register holds the same coefficient of several of them.
/// For sums from place FIRST on in LANES lanes, with COUNT products each,
///
/// ```text
/// sum[k] = Σ_p weight[p][k] Σ_j left[j][p][k] right[n - j][p][k],   j = 0 .. n
/// ```
///
/// first products of all lanes, then the second ones, and so on.
#[derive(Clone, Debug)]
pub struct Products<A, const WIDTH: usize, const N: usize> {
    arithmetic: A,
    weights: Aligned<WIDTH>,
    /// With their weights.
    left: [Aligned<WIDTH>; N],
    right: [Aligned<WIDTH>; N],
}

/// The same coefficient of several series, aligned for fast reading of registers.
#[derive(Clone, Copy, Debug)]
#[repr(align(64))]
struct Aligned<const WIDTH: usize>([f64; WIDTH]);

impl<A, const WIDTH: usize, const N: usize> From<A> for Products<A, WIDTH, N> {
    fn from(arithmetic: A) -> Self {
        let zero = Aligned([0.0; WIDTH]);
        Self {
            arithmetic,
            weights: zero,
            left: [zero; N],
            right: [zero; N],
        }
    }
}

// Code for an arithmetic is written in loops: a closure that is not inlined would not be compiled
// for its instructions.
impl<A: Arithmetic, const WIDTH: usize, const N: usize> Products<A, WIDTH, N> {
    /// The weights and the first coefficients of sums: `(weight, left, right)`.
    #[cfg_attr(not(unoptimized), inline(always))]
    pub fn start<const FIRST: usize, const LANES: usize, const COUNT: usize>(
        &mut self,
        sums: [[(f64, f64, f64); COUNT]; LANES],
    ) {
        for (k, sum) in sums.iter().enumerate() {
            for (p, (weight, left, right)) in sum.iter().enumerate() {
                let place = FIRST + p * LANES + k;
                self.weights.0[place] = *weight;
                self.left[0].0[place] = weight * left;
                self.right[0].0[place] = *right;
            }
        }
    }

    /// Terms n of sums, from the coefficients up to n of their factors. A coefficient that is not
    /// known yet is given as zero, and added later by [`complete`](Self::complete): its partner
    /// begins with zero.
    #[cfg_attr(not(unoptimized), inline(always))]
    pub fn terms<const FIRST: usize, const LANES: usize, const COUNT: usize>(
        &mut self,
        n: usize,
        sums: [[(f64, f64); COUNT]; LANES],
    ) -> [f64; LANES] {
        let arithmetic = self.arithmetic;
        let place = |p: usize| FIRST + p * LANES;
        let (mut left, mut right) = ([[0.0; LANES]; COUNT], [[0.0; LANES]; COUNT]);
        for p in 0..COUNT {
            for k in 0..LANES {
                left[p][k] = sums[k][p].0;
                right[p][k] = sums[k][p].1;
            }
            left[p] = arithmetic.multiply_add([0.0; LANES], left[p], self.weights.part(place(p)));
        }
        // first the terms of earlier orders, while the last order is still being computed; then
        // those of the last order
        let mut terms = [[0.0; LANES]; COUNT];
        let early = 2..n.max(3) - 1;
        let right_rows = self.right[early.clone()].iter().rev();
        for (left, right) in self.left[early].iter().zip(right_rows) {
            self.add::<FIRST, LANES, COUNT>(&mut terms, left, right);
        }
        if n > 2 {
            self.add::<FIRST, LANES, COUNT>(&mut terms, &self.left[1], &self.right[n - 1]);
        }
        if n > 1 {
            self.add::<FIRST, LANES, COUNT>(&mut terms, &self.left[n - 1], &self.right[1]);
        }
        for p in 0..COUNT {
            let (first_left, first_right) =
                (self.left[0].part(place(p)), self.right[0].part(place(p)));
            terms[p] = arithmetic.multiply_add(terms[p], first_left, right[p]);
            terms[p] = arithmetic.multiply_add(terms[p], left[p], first_right);
            // an operation stores a row as a whole, so it can be read again at once
            let right = self.times(right[p], 1.0);
            self.left[n].0[place(p)..place(p) + LANES].copy_from_slice(&left[p]);
            self.right[n].0[place(p)..place(p) + LANES].copy_from_slice(&right);
        }
        let mut total = terms[0];
        for term in &terms[1..] {
            total = arithmetic.multiply_add(total, *term, [1.0; LANES]);
        }
        total
    }

    /// Adds terms that are linear in coefficients of the same order: `(weight, coefficient)`.
    #[cfg_attr(not(unoptimized), inline(always))]
    pub fn plus<const LANES: usize, const COUNT: usize>(
        &self,
        mut sums: [f64; LANES],
        linear: [[(f64, f64); COUNT]; LANES],
    ) -> [f64; LANES] {
        let (mut weights, mut coefficients) = ([[0.0; LANES]; COUNT], [[0.0; LANES]; COUNT]);
        for p in 0..COUNT {
            for k in 0..LANES {
                (weights[p][k], coefficients[p][k]) = linear[k][p];
            }
            sums = self
                .arithmetic
                .multiply_add(sums, weights[p], coefficients[p]);
        }
        sums
    }

    /// Numbers times a factor, side by side in registers: the result of an operation stays in place
    /// from one order to the next.
    #[cfg_attr(not(unoptimized), inline(always))]
    pub fn times<const COUNT: usize>(&self, numbers: [f64; COUNT], factor: f64) -> [f64; COUNT] {
        let zeros = [0.0; COUNT];
        self.arithmetic
            .multiply_add(zeros, numbers, [factor; COUNT])
    }

    /// Adds the products of two rows to separate sums, so that additions do not wait for each
    /// other.
    #[cfg_attr(not(unoptimized), inline(always))]
    fn add<const FIRST: usize, const LANES: usize, const COUNT: usize>(
        &self,
        terms: &mut [[f64; LANES]; COUNT],
        left: &Aligned<WIDTH>,
        right: &Aligned<WIDTH>,
    ) {
        for (p, term) in terms.iter_mut().enumerate() {
            let place = FIRST + p * LANES;
            let (left, right) = (left.part(place), right.part(place));
            *term = self.arithmetic.multiply_add(*term, left, right);
        }
    }

    /// Adds coefficients n that were not known before, by the places of their products.
    #[cfg_attr(not(unoptimized), inline(always))]
    pub fn complete(&mut self, n: usize, left: &[(usize, f64)], right: &[(usize, f64)]) {
        for (place, value) in left {
            self.left[n].0[*place] = self.weights.0[*place] * value;
        }
        for (place, value) in right {
            self.right[n].0[*place] = *value;
        }
    }
}

impl<const WIDTH: usize> Aligned<WIDTH> {
    /// COUNT numbers from a place on.
    #[cfg_attr(not(unoptimized), inline(always))]
    fn part<const COUNT: usize>(&self, place: usize) -> [f64; COUNT] {
        let mut part = [0.0; COUNT];
        part.copy_from_slice(&self.0[place..place + COUNT]);
        part
    }
}
