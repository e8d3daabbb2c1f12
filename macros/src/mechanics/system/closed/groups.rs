//! Rows that are solved for together, and their rank.

use crate::symbolic::Graph;

use super::super::constraints::ConstraintRow;
use super::rows::Owner;

/// Rows of one joint that have the same dimension, and which of them are independent.
#[derive(Clone)]
pub struct Group {
    pub rows: Vec<usize>,
    /// For each row, whether it is independent of those before it in closed states. Other choices
    /// of rows are possible.
    pub is_independent: Vec<bool>,
}

impl Group {
    pub fn rank(&self) -> usize {
        self.is_independent.iter().filter(|is_new| **is_new).count()
    }

    pub fn is_full(&self) -> bool {
        self.rank() == self.rows.len()
    }
}

/// The rows of the groups all of whose rows are independent.
pub fn full(groups: &[Group]) -> Vec<usize> {
    let full = groups.iter().filter(|group| group.is_full());
    full.flat_map(|group| group.rows.clone()).collect()
}

/// The groups of rows; `independent` marks the rows that are independent of those before them.
pub fn groups(graph: &Graph, kept: &[(Owner, ConstraintRow)], independent: &[bool]) -> Vec<Group> {
    let mut groups: Vec<(Option<(usize, bool)>, Group)> = Vec::new();
    for (number, ((owner, _), is_new)) in kept.iter().zip(independent).enumerate() {
        let own = owner.joint_part(graph);
        match groups.last_mut() {
            Some((last, group)) if own.is_some() && *last == own => {
                group.rows.push(number);
                group.is_independent.push(*is_new);
            }
            _ => {
                let (rows, is_independent) = (vec![number], vec![*is_new]);
                groups.push((
                    own,
                    Group {
                        rows,
                        is_independent,
                    },
                ));
            }
        }
    }
    groups.into_iter().map(|(_, group)| group).collect()
}
