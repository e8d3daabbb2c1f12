//! The values of the unknowns, once every equation that can be solved is.

use crate::symbolic::graph::{Graph, Id};

use super::system::{Elimination, System, Undetermined};

impl System<'_> {
    /// The values, computed in an order in which each follows those that it depends on.
    pub(super) fn values(mut self) -> Elimination {
        let zero = self.graph.zero();
        let mut values = vec![zero; self.unknowns];
        let open: Vec<usize> = self.open().collect();
        // how undetermined unknowns change the solved ones
        let mut changes = vec![vec![zero; self.unknowns]; open.len()];
        for (change, column) in changes.iter_mut().zip(&open) {
            change[*column] = self.graph.one();
        }
        let order = self.order();
        // a cycle of steps would be a bug; its unknowns become undefined
        for step in (0..self.steps.len()).filter(|step| !order.contains(step)) {
            values[self.steps[step].column] = self.graph.undefined();
        }
        for step in order {
            let step = &self.steps[step];
            let row = &self.rows[step.row];
            let of_others = |graph: &mut Graph, values: &[Id], right: Id| {
                let others = (0..values.len()).filter(|other| *other != step.column);
                others.fold(right, |rest, other| {
                    let known = graph.multiply(row.coefficients[other], values[other]);
                    graph.subtract(rest, known)
                })
            };
            let rest = of_others(self.graph, &values, row.right);
            let value = if self.graph.is_early(step.inverse) {
                self.graph.distribute(step.inverse, rest)
            } else {
                self.graph.multiply(step.inverse, rest)
            };
            values[step.column] = self.graph.quantity(value);
            for change in &mut changes {
                let rest = of_others(self.graph, change, zero);
                change[step.column] = self.graph.multiply(step.inverse, rest);
            }
        }
        let together = open
            .iter()
            .map(|column| self.together(*column, &open, &changes));
        Elimination {
            undetermined: together.collect(),
            values,
            pivots: self.pivots,
            spare: self
                .left
                .iter()
                .map(|row| (*row, self.rows[*row].right))
                .collect(),
            left: self.rows,
        }
    }

    /// The steps, each after those whose unknowns it reads, otherwise in their original order.
    /// Steps that wait for each other are left out.
    fn order(&self) -> Vec<usize> {
        let reads = |step: &usize, other: &usize| {
            let coefficients = &self.rows[self.steps[*step].row].coefficients;
            step != other && !self.graph.is_zero(coefficients[self.steps[*other].column])
        };
        let mut left: Vec<usize> = (0..self.steps.len()).collect();
        let mut order = Vec::new();
        let is_next = |left: &Vec<usize>| {
            let waits = |step: &usize| left.iter().any(|other| reads(step, other));
            left.iter().position(|step| !waits(step))
        };
        while let Some(place) = is_next(&left) {
            order.push(left.remove(place));
        }
        order
    }

    /// `u_c - sum of (du_c / du_j) u_j`, where c is the first unknown that `column` changes.
    fn together(&mut self, column: usize, open: &[usize], changes: &[Vec<Id>]) -> Undetermined {
        let own = open.iter().position(|known| *known == column);
        let is_changed = |of: &usize| {
            let change = own.map(|own| changes[own][*of]);
            !open.contains(of) && change.is_some_and(|change| !self.graph.vanishes(change))
        };
        let others: Vec<usize> = (0..self.unknowns).filter(is_changed).collect();
        let one = self.graph.one();
        let Some(of) = others.first().copied() else {
            let sum = vec![(column, one)];
            return Undetermined {
                column,
                others,
                sum,
            };
        };
        let mut sum = vec![(of, one)];
        for (column, change) in open.iter().zip(changes) {
            if !self.graph.vanishes(change[of]) {
                sum.push((*column, self.graph.negate(change[of])));
            }
        }
        sum.sort_unstable_by_key(|(column, _)| *column);
        Undetermined {
            column,
            others,
            sum,
        }
    }
}
