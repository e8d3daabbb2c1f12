//! Independent rows of residues, such as gradients at a random state.

use crate::symbolic::number::Residue;

/// Rows that do not depend on each other.
#[derive(Clone, Default)]
pub struct Span(Vec<Reduced>);

/// A row from which the leading entries of those before it are eliminated.
#[derive(Clone)]
struct Reduced {
    lead: usize,
    row: Vec<Residue>,
    /// The numbers of the rows in this combination.
    of: Vec<usize>,
}

impl Span {
    pub fn rank(&self) -> usize {
        self.0.len()
    }

    /// Adds a row with this number if it is independent of the rows before it. Otherwise returns the
    /// numbers of the rows that it depends on.
    pub fn admit(&mut self, number: usize, row: &[Residue]) -> Option<Vec<usize>> {
        let (mut row, mut of) = (row.to_vec(), Vec::new());
        for known in &self.0 {
            if row[known.lead].is_zero() {
                continue;
            }
            let inverse = known.row[known.lead].reciprocal();
            let factor = -(row[known.lead] * inverse.unwrap_or(Residue::ZERO));
            for (entry, part) in row.iter_mut().zip(&known.row) {
                *entry = *entry + factor * *part;
            }
            of.extend(known.of.iter().copied());
        }
        of.sort_unstable();
        of.dedup();
        let Some(lead) = row.iter().position(|entry| !entry.is_zero()) else {
            return Some(of);
        };
        of.push(number);
        self.0.push(Reduced { lead, row, of });
        None
    }
}
