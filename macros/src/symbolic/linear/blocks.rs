//! Sets of equations that can be solved before the others: those with as many unknowns as
//! equations.

use super::system::System;

impl System<'_> {
    /// The smallest such set: its rows, and its unknowns in order. `None` if each set of rows
    /// involves more unknowns than it has rows.
    pub(super) fn first_block(&self) -> Option<(Vec<usize>, Vec<usize>)> {
        let matched = self.matching();
        let closed = matched
            .iter()
            .filter_map(|(_, row)| self.closure(*row, &matched));
        let mut rows = closed.min_by_key(Vec::len)?;
        rows.sort_unstable();
        let own = |(column, row): &(usize, usize)| rows.contains(row).then_some(*column);
        let mut columns: Vec<usize> = matched.iter().filter_map(own).collect();
        columns.sort_unstable();
        Some((rows, columns))
    }

    /// A row, and the rows that give its other unknowns; `None` if no row gives one of them.
    fn closure(&self, row: usize, matched: &[(usize, usize)]) -> Option<Vec<usize>> {
        let mut rows = vec![row];
        let mut next = 0;
        while let Some(row) = rows.get(next).copied() {
            for column in self.open().filter(|column| self.is_there(row, *column)) {
                let (_, other) = matched.iter().find(|(known, _)| *known == column)?;
                if !rows.contains(other) {
                    rows.push(*other);
                }
            }
            next += 1;
        }
        Some(rows)
    }

    /// Assigns rows to unknowns that they contain, for as many unknowns as possible.
    fn matching(&self) -> Vec<(usize, usize)> {
        let mut matched = Vec::new();
        for row in &self.left {
            self.match_one(*row, &mut matched, &mut Vec::new());
        }
        matched
    }

    /// Finds an unknown for a row; other rows may be reassigned.
    fn match_one(
        &self,
        row: usize,
        matched: &mut Vec<(usize, usize)>,
        tried: &mut Vec<usize>,
    ) -> bool {
        let columns: Vec<usize> = self
            .open()
            .filter(|column| self.is_there(row, *column))
            .collect();
        for column in columns {
            if tried.contains(&column) {
                continue;
            }
            tried.push(column);
            let place = matched.iter().position(|(known, _)| *known == column);
            let is_free = match place {
                None => true,
                Some(place) => self.match_one(matched[place].1, matched, tried),
            };
            if is_free {
                matched.retain(|(known, _)| *known != column);
                matched.push((column, row));
                return true;
            }
        }
        false
    }
}
