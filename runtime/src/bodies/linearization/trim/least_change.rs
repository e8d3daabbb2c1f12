//! The least change of the free unknowns that solves linear equations, or minimizes their residual.

use nalgebra::SVector;

use crate::bodies::linearization::orthogonal::{Turning, orthogonalize};

/// A change of state and input; for an equation, its derivatives.
#[derive(Clone, Copy, Debug)]
pub struct Change<const N: usize, const M: usize> {
    pub state: SVector<f64, N>,
    pub input: SVector<f64, M>,
}

impl<const N: usize, const M: usize> Change<N, M> {
    pub fn zero() -> Self {
        Self {
            state: SVector::zeros(),
            input: SVector::zeros(),
        }
    }

    /// Combines two changes component by component.
    #[must_use]
    pub fn with(&self, other: &Self, of: impl Fn(f64, f64) -> f64 + Copy) -> Self {
        Self {
            state: self.state.zip_map(&other.state, of),
            input: self.input.zip_map(&other.input, of),
        }
    }

    #[must_use]
    pub fn times(&self, other: &Self) -> Self {
        self.with(other, |a, b| a * b)
    }

    #[must_use]
    pub fn map(&self, of: impl Fn(f64) -> f64 + Copy) -> Self {
        Self {
            state: self.state.map(of),
            input: self.input.map(of),
        }
    }

    pub fn iter(&self) -> impl Iterator<Item = f64> {
        self.state.iter().chain(self.input.iter()).copied()
    }

    pub fn iter_mut(&mut self) -> impl Iterator<Item = &mut f64> {
        self.state.iter_mut().chain(self.input.iter_mut())
    }

    /// The largest size.
    pub fn largest(&self) -> f64 {
        self.iter().map(f64::abs).fold(0.0, f64::max)
    }

    pub fn dot(&self, other: &Self) -> f64 {
        self.state.dot(&other.state) + self.input.dot(&other.input)
    }

    fn sum(&self, cosine: f64, other: &Self, sine: f64) -> Self {
        Self {
            state: self.state * cosine + other.state * sine,
            input: self.input * cosine + other.input * sine,
        }
    }
}

/// `value + by · change = 0`
#[derive(Clone, Copy, Debug)]
pub struct Equation<const N: usize, const M: usize> {
    pub value: f64,
    pub by: Change<N, M>,
}

/// The solution of the equations.
pub struct Least<const N: usize, const M: usize> {
    pub change: Change<N, M>,
    /// The number of independent changes that the equations determine.
    pub rank: usize,
    /// The sum of squares of the residual.
    pub left: f64,
    /// The effect that each held unknown would have on the residual.
    pub helps: Change<N, M>,
}

/// An equation in the free unknowns, with the held ones.
#[derive(Clone, Copy)]
struct Row<const N: usize, const M: usize> {
    value: f64,
    free: Change<N, M>,
    held: Change<N, M>,
}

impl<const N: usize, const M: usize> Turning for Row<N, M> {
    fn dot(&self, other: &Self) -> f64 {
        self.free.dot(&other.free)
    }

    fn sum(&self, cosine: f64, other: &Self, sine: f64) -> Self {
        Self {
            value: self.value * cosine + other.value * sine,
            free: self.free.sum(cosine, &other.free, sine),
            held: self.held.sum(cosine, &other.held, sine),
        }
    }
}

/// A derivative below this fraction of the largest in its row is rounding.
const ROUNDING: f64 = 1e-14;

/// A singular value below this fraction of the largest counts as zero.
const RANK: f64 = 1e-10;

/// The least change in mean square that solves the equations, or minimizes their residual. Each
/// unknown is weighted by its effect, so units do not matter. `free` is one for unknowns that may
/// change, and zero for the others. There is room for the rows of `3 N` equations.
pub fn least_change<const N: usize, const M: usize>(
    equations: impl ExactSizeIterator<Item = Equation<N, M>>,
    free: &Change<N, M>,
) -> Least<N, M> {
    let empty = Row {
        value: 0.0,
        free: Change::zero(),
        held: Change::zero(),
    };
    let mut room = [[empty; 3]; N];
    let rows = &mut room.as_flattened_mut()[..equations.len().min(3 * N)];
    let mut effects = Change::<N, M>::zero();
    for (row, equation) in rows.iter_mut().zip(equations) {
        let floor = ROUNDING * equation.by.largest();
        let by = equation
            .by
            .map(|entry| if entry.abs() > floor { entry } else { 0.0 });
        row.value = equation.value;
        row.held = by.times(&free.map(|free| 1.0 - free));
        row.free = by.times(free);
        for (effect, entry) in effects.iter_mut().zip(row.free.iter()) {
            *effect = effect.max(entry.abs());
        }
    }
    let scale = effects.map(|effect| if effect > 0.0 { 1.0 / effect } else { 0.0 });
    for row in rows.iter_mut() {
        row.free = row.free.times(&scale);
    }
    orthogonalize(rows);
    let largest = rows.iter().map(|row| row.free.dot(&row.free));
    let floor = RANK * RANK * largest.fold(0.0, f64::max);
    let mut least = Least {
        change: Change::zero(),
        rank: 0,
        left: 0.0,
        helps: Change::zero(),
    };
    for row in rows {
        let square = row.free.dot(&row.free);
        if square > floor {
            least.change = least.change.sum(1.0, &row.free, -row.value / square);
            least.rank += 1;
        } else {
            let value = row.value.abs();
            least.left += value * value;
            let helps = row.held.map(|entry| value * entry.abs());
            least.helps = least.helps.sum(1.0, &helps, 1.0);
        }
    }
    least.change = least.change.times(&scale);
    least
}
