//! Counting operations.

use core::ops::AddAssign;

use crate::symbolic::number::Function;

use super::nodes::{Graph, Id, Node};

/// Operations of a program; a negation is free.
#[derive(Clone, Copy, Default, PartialEq, Eq, Debug)]
pub struct Cost {
    pub mul: u32,
    pub add: u32,
    pub div: u32,
    pub sqrt: u32,
    /// Trigonometric and other transcendental functions, and foreign functions.
    pub trig: u32,
    /// Comparisons, choices, absolute values, roundings.
    pub other: u32,
}

impl Cost {
    pub fn total(self) -> u32 {
        self.mul + self.add + self.div + self.sqrt + self.trig + self.other
    }
}

impl AddAssign for Cost {
    fn add_assign(&mut self, more: Self) {
        self.mul += more.mul;
        self.add += more.add;
        self.div += more.div;
        self.sqrt += more.sqrt;
        self.trig += more.trig;
        self.other += more.other;
    }
}

impl Graph {
    /// The cost of computing each of `nodes` once.
    pub fn cost(&self, nodes: &[Id]) -> Cost {
        let mut cost = Cost::default();
        for id in nodes {
            match self.node(*id) {
                Node::Multiply(..) => cost.mul += 1,
                Node::Add(..) | Node::Subtract(..) => cost.add += 1,
                Node::Divide(..) => cost.div += 1,
                Node::Pivot(..) => {
                    cost.div += 1;
                    cost.other += 1;
                }
                Node::Unary(Function::Sqrt, _) => cost.sqrt += 1,
                Node::Unary(
                    Function::Abs | Function::Signum | Function::Floor | Function::Ceil,
                    _,
                )
                | Node::Binary(Function::Min | Function::Max, ..)
                | Node::Compare(..)
                | Node::And(..)
                | Node::Or(..)
                | Node::Not(_)
                | Node::Select(..)
                | Node::Positive(_) => cost.other += 1,
                Node::Unary(..) | Node::Binary(..) | Node::Foreign(..) => cost.trig += 1,
                Node::Number(_)
                | Node::Truth(_)
                | Node::Undefined
                | Node::Symbol(_)
                | Node::Quantity(_)
                | Node::Negate(_) => {}
            }
        }
        cost
    }

    /// The cost of the late operations in `roots`.
    pub fn late_cost(&self, roots: &[Id]) -> Cost {
        let late = |id: Id| !self.is_early(id);
        let nodes: Vec<Id> = self
            .reachable(roots, &late)
            .into_iter()
            .filter(|id| late(*id))
            .collect();
        self.cost(&nodes)
    }
}
