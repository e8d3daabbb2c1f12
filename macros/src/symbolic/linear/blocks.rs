//! Which equations can be solved before others: sets that have a part in as many unknowns alone.

use super::system::System;

impl System<'_> {
    /// The smallest of them: its rows, and its unknowns in order. Nothing if each set of rows has a
    /// part in more unknowns than it has rows.
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

    /// A row, and the rows that give what else it has a part in; nothing if no row gives it.
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

    /// Unknowns with a row for each in which it has a part, as many as there can be.
    fn matching(&self) -> Vec<(usize, usize)> {
        let mut matched = Vec::new();
        for row in &self.left {
            self.match_one(*row, &mut matched, &mut Vec::new());
        }
        matched
    }

    /// Finds an unknown for a row; others may have to take another one.
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
