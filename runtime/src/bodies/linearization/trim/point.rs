//! The current point of a search for a steady motion: its equations, and their residuals.

use super::conditions::Conditions;
use super::error::{FEW, Off};
use super::least_change::{Change, Equation, Least, least_change};
use super::steady::{About, Asked, Steady};
use crate::bodies::linearization::coordinated::Coordinated;

/// A residual of an equation is a failure above this fraction of the terms of its sum. The steps
/// continue to rounding in any case: this number decides only whether they succeeded.
pub const TOLERANCE: f64 = 1e-9;

/// The size of an equation is at least this fraction of the largest.
const ROUNDING: f64 = 1e-6;

/// The current point of a search.
pub struct Here<B: Coordinated<N, M>, const N: usize, const M: usize> {
    pub state: B::State,
    pub input: [f64; M],
    pub about: About<B::Linearization, N, M>,
    /// The sizes of the terms of each equation.
    pub sizes: [[f64; 3]; N],
    pub worst: f64,
}

impl<B: Coordinated<N, M>, const N: usize, const M: usize> Here<B, N, M> {
    /// The equations of steadiness about a state and an input.
    pub fn of<C: Conditions<B::State, B::Input>>(
        steady: &Steady<'_, B, C, N>,
        state: B::State,
        input: [f64; M],
    ) -> Self {
        let about = steady.about::<M>(&state, &input);
        let sizes = sizes(&about);
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
            sizes,
            worst,
        }
    }

    /// The residual, in units of these sizes.
    pub fn merit(&self, sizes: &[[f64; 3]; N]) -> f64 {
        let rows = self.about.rows.list().iter().zip(sizes.as_flattened());
        let relative = rows.map(|(row, size)| relative(row.equation.value, *size));
        relative.map(|relative| relative * relative).sum()
    }

    /// The least change of the free quantities that solves the equations to first order.
    pub fn least(&self, free: &Change<N, M>) -> Least<N, M> {
        let rows = self.about.rows.list().iter().zip(self.sizes.as_flattened());
        let scaled = rows.map(|(row, size)| {
            let factor = if *size > 0.0 { 1.0 / size } else { 0.0 };
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
        let rows = self.about.rows.list().iter().zip(self.sizes.as_flattened());
        for (row, size) in rows {
            for (effect, entry) in effects.iter_mut().zip(row.equation.by.iter()) {
                *effect = effect.max(relative(entry, *size));
            }
        }
        effects
    }

    /// The equations that are off most.
    pub fn residual(&self) -> [Option<Off>; FEW] {
        let (rows, sizes) = (self.about.rows.list(), self.sizes.as_flattened());
        few(rows.iter().zip(sizes).map(|(row, size)| {
            let by = row.equation.value;
            let name = row.name;
            (Off { name, by }, relative(by, *size))
        }))
    }
}

/// The sizes of the terms of the equations; equations with the same unit have the same size.
fn sizes<L, const N: usize, const M: usize>(about: &About<L, N, M>) -> [[f64; 3]; N] {
    let mut sizes = [[0.0_f64; 3]; N];
    let rows = about.rows.list();
    let size = |row: &Asked<N, M>| {
        let terms = row.equation.by.map(f64::abs).dot(&about.reach);
        terms + row.equation.value.abs()
    };
    let largest = rows.iter().map(size).fold(0.0, f64::max);
    for (row, to) in rows.iter().zip(sizes.as_flattened_mut()) {
        let alike = rows
            .iter()
            .filter(|other| row.is_angle.is_some() && row.is_angle == other.is_angle);
        let alike = alike.map(size).fold(size(row), f64::max);
        *to = alike.max(ROUNDING * largest);
    }
    sizes
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
