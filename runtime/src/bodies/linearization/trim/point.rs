//! The current point of a search for a steady motion: its equations, and their residuals.

use super::conditions::Conditions;
use super::error::{FEW, Off};
use super::least_change::{Change, Equation, Least, least_change};
use super::steady::{About, Asked, Steady};
use crate::bodies::linearization::coordinated::Coordinated;

/// A residual is a failure above this fraction of its size: of the largest term that the equation
/// sums. The steps continue to rounding in any case: this number decides only whether they
/// succeeded.
pub const TOLERANCE: f64 = 1e-11;

/// The rounding of a quantity, as a fraction of its largest value in the search; that of a position
/// or an angle is no less than this part of 1 m or 1 rad. An equation may be off by its effect.
const PRECISION: f64 = 64.0 * f64::EPSILON;

/// The scale of an equation is at least this fraction of the largest.
const SMALLEST: f64 = 1e-6;

/// An acceleration is singular if the rounding of a quantity changes it by this part of its terms,
const UNCERTAIN: f64 = 0.1;

/// and if it changes by this factor more than at the start.
const GROWTH: f64 = 1e6;

/// The current point of a search.
pub struct Here<B: Coordinated<N, M>, const N: usize, const M: usize> {
    pub state: B::State,
    pub input: [f64; M],
    pub about: About<B::Linearization, N, M>,
    /// The largest values of the quantities so far.
    pub far: Change<N, M>,
    /// What the equations are measured in during the steps: plausible changes of them.
    pub scales: [[f64; 3]; N],
    /// The sizes of the terms of each equation: those that decide whether it holds.
    sizes: [[f64; 3]; N],
    /// The largest residual, as a fraction of its size.
    pub worst: f64,
}

impl<B: Coordinated<N, M>, const N: usize, const M: usize> Here<B, N, M> {
    /// The equations of steadiness about a state and an input, reached from values that were at
    /// most as large as `far`.
    pub fn of<C: Conditions<B::State, B::Input>>(
        steady: &Steady<'_, B, C, N>,
        state: B::State,
        input: [f64; M],
        far: &Change<N, M>,
    ) -> Self {
        let about = steady.about::<M>(&state, &input);
        let far = far.with(&about.reach, f64::max);
        let (scales, sizes) = (scales(&about), sizes(&about, &far));
        let rows = about.rows.list().iter().zip(sizes.as_flattened());
        let worst = rows.map(|(row, size)| relative(row.equation.value, *size));
        let worst = worst.fold(0.0_f64, |worst, one| {
            if one > worst || one.is_nan() {
                one
            } else {
                worst
            }
        });
        Self {
            state,
            input,
            about,
            far,
            scales,
            sizes,
            worst,
        }
    }

    fn rows(&self) -> &[Asked<N, M>] {
        self.about.rows.list()
    }

    /// The residual, in units of these scales.
    pub fn merit(&self, scales: &[[f64; 3]; N]) -> f64 {
        let rows = self.rows().iter().zip(scales.as_flattened());
        let relative = rows.map(|(row, scale)| relative(row.equation.value, *scale));
        relative.map(|relative| relative * relative).sum()
    }

    /// The least change of the free quantities that solves the equations to first order.
    pub fn least(&self, free: &Change<N, M>) -> Least<N, M> {
        let rows = self.rows().iter().zip(self.scales.as_flattened());
        let scaled = rows.map(|(row, scale)| {
            let factor = if *scale > 0.0 { 1.0 / scale } else { 0.0 };
            Equation {
                value: row.equation.value * factor,
                by: row.equation.by.map(|entry| entry * factor),
            }
        });
        least_change(scaled, free)
    }

    /// The largest effect of each quantity on an equation.
    pub fn effects(&self) -> Change<N, M> {
        let mut effects = Change::zero();
        let rows = self.rows().iter().zip(self.scales.as_flattened());
        for (row, scale) in rows {
            for (effect, entry) in effects.iter_mut().zip(row.equation.by.iter()) {
                *effect = effect.max(relative(entry, *scale));
            }
        }
        effects
    }

    /// The equations that do not hold, those that are off most.
    pub fn residual(&self) -> [Option<Off>; FEW] {
        let pairs = self.off().zip(self.scales.as_flattened());
        few(pairs.filter_map(|((row, off), scale)| {
            let (name, by) = (row.name, row.equation.value);
            (off > TOLERANCE).then(|| (Off { name, by }, relative(by, *scale)))
        }))
    }

    /// A condition or a constraint without a value here.
    pub fn lost_condition(&self) -> Option<&'static str> {
        let mut rows = self.rows().iter().filter(|row| row.is_angle.is_none());
        let lost = rows.find(|row| !row.equation.value.is_finite());
        lost.map(|row| row.name)
    }

    /// The equations, each with its residual as a fraction of its size.
    pub fn off(&self) -> impl Iterator<Item = (&Asked<N, M>, f64)> {
        let rows = self.rows().iter().zip(self.sizes.as_flattened());
        rows.map(|(row, size)| (row, relative(row.equation.value, *size)))
    }

    /// An acceleration that has no value here to rounding, and the index of the free quantity with
    /// which it changes that fast; `start` has the equations at the start.
    pub fn singular(
        &self,
        start: &[Asked<N, M>],
        free: &Change<N, M>,
    ) -> Option<(&'static str, usize)> {
        let rows = self.rows();
        let mut pairs = rows
            .iter()
            .zip(start)
            .filter(|(row, _)| row.is_angle.is_some());
        pairs.find_map(|(row, start)| {
            let alike = rows.iter().filter(|other| row.is_angle == other.is_angle);
            let terms = alike.map(|other| terms(other, &self.about.reach));
            let bound = UNCERTAIN * terms.fold(0.0, f64::max);
            let slopes = row.equation.by.times(free);
            let slopes = slopes.with(&start.equation.by, |now, then| {
                let has_grown = now.abs() > GROWTH * then.abs();
                if has_grown { now.abs() } else { 0.0 }
            });
            let effects = slopes.times(&self.far).map(|effect| PRECISION * effect);
            // where no term is left, nothing is singular
            let mut effects = effects.iter();
            let column = effects.position(|effect| effect > bound && bound > 0.0);
            column.map(|column| (row.name, column))
        })
    }
}

/// The size of the terms of an equation: that of its sum, or an estimate from its derivatives.
fn terms<const N: usize, const M: usize>(row: &Asked<N, M>, reach: &Change<N, M>) -> f64 {
    let estimate = || row.equation.by.map(f64::abs).dot(reach);
    row.terms.unwrap_or_else(estimate) + row.equation.value.abs()
}

/// What the residual of each equation is compared with: its terms, and the rounding of the
/// quantities on which it depends.
fn sizes<L, const N: usize, const M: usize>(
    about: &About<L, N, M>,
    far: &Change<N, M>,
) -> [[f64; 3]; N] {
    let mut sizes = [[0.0_f64; 3]; N];
    for (row, to) in about.rows.list().iter().zip(sizes.as_flattened_mut()) {
        let rounding = PRECISION * row.equation.by.map(f64::abs).dot(far);
        *to = terms(row, &about.reach) + rounding / TOLERANCE;
    }
    sizes
}

/// Plausible changes of the equations; equations with the same unit have the same scale.
fn scales<L, const N: usize, const M: usize>(about: &About<L, N, M>) -> [[f64; 3]; N] {
    let mut scales = [[0.0_f64; 3]; N];
    let rows = about.rows.list();
    let scale = |row: &Asked<N, M>| {
        let change = row.equation.by.map(f64::abs).dot(&about.reach);
        change + row.equation.value.abs()
    };
    let largest = rows.iter().map(scale).fold(0.0, f64::max);
    for (row, to) in rows.iter().zip(scales.as_flattened_mut()) {
        let alike = rows
            .iter()
            .filter(|other| row.is_angle.is_some() && row.is_angle == other.is_angle);
        let alike = alike.map(scale).fold(scale(row), f64::max);
        *to = alike.max(SMALLEST * largest);
    }
    scales
}

/// A value as a fraction of its size; zero is zero at any size.
fn relative(value: f64, size: f64) -> f64 {
    if value == 0.0 {
        0.0
    } else {
        value.abs() / size
    }
}

/// The largest entries, in descending order, without those that are rounding next to the largest.
pub fn few<T: Copy>(all: impl Iterator<Item = (T, f64)>) -> [Option<T>; FEW] {
    let mut found: [Option<(T, f64)>; FEW] = [None; FEW];
    for mut one in all.map(Some) {
        for place in &mut found {
            let size = |one: &Option<(T, f64)>| one.map_or(0.0, |(_, size)| size);
            if size(&one) > size(place) {
                core::mem::swap(&mut one, place);
            }
        }
    }
    let largest = found[0].map_or(0.0, |(_, size)| size);
    found.map(|one| {
        one.filter(|(_, size)| *size > TOLERANCE * largest)
            .map(|(one, _)| one)
    })
}
