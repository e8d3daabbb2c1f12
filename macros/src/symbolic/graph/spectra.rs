//! Tensors of numbers in their principal axes, each computed once.

use crate::symbolic::number::{Matrix, Spectrum};

use super::nodes::{Components, Graph};

impl Graph {
    /// The entries of a tensor, if all of them are numbers.
    pub fn constant_matrix(&self, rows: &[Components; 3]) -> Option<Matrix> {
        let number = |i: usize, k: usize| self.as_number(rows[i][k]).cloned();
        let row = |i: usize| Some([number(i, 0)?, number(i, 1)?, number(i, 2)?]);
        Some([row(0)?, row(1)?, row(2)?])
    }

    /// A tensor of numbers in its principal axes, computed once.
    pub fn spectrum(&mut self, rows: &[Components; 3]) -> Option<Spectrum> {
        if let Some(known) = self.spectra.get(rows) {
            return Some(known.clone());
        }
        let spectrum = Spectrum::of(&self.constant_matrix(rows)?);
        self.spectra.insert(*rows, spectrum.clone());
        Some(spectrum)
    }
}
