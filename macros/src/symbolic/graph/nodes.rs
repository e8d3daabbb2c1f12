//! The expression graph: an arena of hash-consed nodes.
//!
//! Equal expressions are one node, children come before their parents, and nodes are made only by
//! the simplifying constructors of [`super::build`]; a graph knows symbols as numbers and nothing
//! of what they stand for.

use core::cmp::Ordering;
use core::hash::BuildHasherDefault;
use std::collections::HashMap;

use crate::symbolic::number::{Function, Number, Spectrum};

use super::hash::WordHasher;

/// An expression in a [`Graph`].
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub struct Id(u32);

impl Id {
    pub fn index(self) -> usize {
        self.0 as usize
    }
}

/// A quantity whose value is given from outside.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub struct Symbol(pub u32);

/// When the value of an expression is known.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub enum Stage {
    /// At expansion: folded into the code.
    Constant,
    /// When the body is built: computed once, in the constructor.
    Parameter,
    /// At every evaluation.
    State,
}

/// Comparisons; `>` and `>=` are written with the operands exchanged.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum Comparison {
    Less,
    LessOrEqual,
    Equal,
    NotEqual,
}

impl Comparison {
    /// Of numbers in this order.
    pub fn holds(self, order: Ordering) -> bool {
        match self {
            Self::Less => order.is_lt(),
            Self::LessOrEqual => order.is_le(),
            Self::Equal => order.is_eq(),
            Self::NotEqual => order.is_ne(),
        }
    }
}

/// One operation.
#[derive(Clone, PartialEq, Eq, Hash, Debug)]
pub enum Node {
    Number(Number),
    Truth(bool),
    /// A constant that does not exist: a division by zero, the root of a negative number.
    Undefined,
    Symbol(Symbol),
    /// An expression that stands for itself: a statement of the code, which no rule looks into.
    Quantity(Id),
    Negate(Id),
    Add(Id, Id),
    Subtract(Id, Id),
    Multiply(Id, Id),
    Divide(Id, Id),
    Unary(Function, Id),
    Binary(Function, Id, Id),
    Compare(Comparison, Id, Id),
    And(Id, Id),
    Or(Id, Id),
    Not(Id),
    /// `if condition { first } else { second }`
    Select(Id, Id, Id),
    /// The reciprocal of a divisor that the configuration may make vanish, and the size of the
    /// terms it was summed from: what is no more than their rounding is not divided by.
    Pivot(Id, Id),
}

impl Node {
    /// The operands, left to right.
    pub fn operands(&self) -> impl Iterator<Item = Id> {
        let operands = match *self {
            Self::Number(_) | Self::Truth(_) | Self::Undefined | Self::Symbol(_) => [None; 3],
            Self::Quantity(a) | Self::Negate(a) | Self::Not(a) | Self::Unary(_, a) => {
                [Some(a), None, None]
            }
            Self::Add(a, b)
            | Self::Subtract(a, b)
            | Self::Multiply(a, b)
            | Self::Divide(a, b)
            | Self::Binary(_, a, b)
            | Self::Pivot(a, b)
            | Self::Compare(_, a, b)
            | Self::And(a, b)
            | Self::Or(a, b) => [Some(a), Some(b), None],
            Self::Select(a, b, c) => [Some(a), Some(b), Some(c)],
        };
        operands.into_iter().flatten()
    }
}

/// All expressions of one description.
pub struct Graph {
    nodes: Vec<Node>,
    stages: Vec<Stage>,
    ids: HashMap<Node, Id, BuildHasherDefault<WordHasher>>,
    symbols: Vec<Id>,
    /// Of the tensors whose axes were asked for.
    pub(in crate::symbolic) spectra: HashMap<[Components; 3], Spectrum>,
}

/// The numbers that every graph begins with.
pub(in crate::symbolic) const ZERO: Id = Id(0);
pub(in crate::symbolic) const ONE: Id = Id(1);

impl Default for Graph {
    fn default() -> Self {
        let mut graph = Self {
            nodes: Vec::new(),
            stages: Vec::new(),
            ids: HashMap::default(),
            symbols: Vec::new(),
            spectra: HashMap::new(),
        };
        for number in [Number::zero(), Number::one()] {
            graph.insert(Node::Number(number), Stage::Constant);
        }
        graph
    }
}

impl Graph {
    pub fn node(&self, id: Id) -> &Node {
        &self.nodes[id.index()]
    }

    pub fn stage(&self, id: Id) -> Stage {
        self.stages[id.index()]
    }

    /// Whether the value is known before the state is.
    pub fn is_early(&self, id: Id) -> bool {
        self.stage(id) < Stage::State
    }

    /// Whether all values are.
    pub fn are_early(&self, ids: &[Id]) -> bool {
        ids.iter().all(|id| self.is_early(*id))
    }

    /// A new symbol, known from `stage` on.
    pub fn symbol(&mut self, stage: Stage) -> Id {
        let symbol = Symbol(u32::try_from(self.symbols.len()).unwrap_or(u32::MAX));
        let id = self.insert(Node::Symbol(symbol), stage);
        self.symbols.push(id);
        id
    }

    /// The expression that is this symbol.
    pub fn symbol_id(&self, symbol: Symbol) -> Id {
        self.symbols[symbol.0 as usize]
    }

    /// The one node of this shape. Only constructors call it, on nodes that they cannot simplify.
    pub(in crate::symbolic) fn intern(&mut self, node: Node) -> Id {
        if let Some(&id) = self.ids.get(&node) {
            return id;
        }
        let stage = node.operands().map(|operand| self.stage(operand)).max();
        self.insert(node, stage.unwrap_or(Stage::Constant))
    }

    /// The node of this shape, if there is one already.
    pub(in crate::symbolic) fn find(&self, node: &Node) -> Option<Id> {
        self.ids.get(node).copied()
    }

    fn insert(&mut self, node: Node, stage: Stage) -> Id {
        let id = Id(u32::try_from(self.nodes.len()).unwrap_or(u32::MAX));
        self.nodes.push(node.clone());
        self.stages.push(stage);
        self.ids.insert(node, id);
        id
    }

    /// All nodes that `roots` are made of, children first; `enter` says which are looked into.
    pub fn reachable(&self, roots: &[Id], enter: impl Fn(Id) -> bool) -> Vec<Id> {
        let mut seen = vec![false; self.nodes.len()];
        let mut pending = roots.to_vec();
        let mut found = Vec::new();
        while let Some(id) = pending.pop() {
            if core::mem::replace(&mut seen[id.index()], true) {
                continue;
            }
            found.push(id);
            if enter(id) {
                pending.extend(self.node(id).operands());
            }
        }
        found.sort_unstable();
        found
    }

    /// Whether any of `roots` depends on a symbol that `is_of_interest`.
    pub fn depends_on(&self, roots: &[Id], is_of_interest: impl Fn(Id) -> bool) -> bool {
        let is_symbol = |id: &Id| matches!(self.node(*id), Node::Symbol(_));
        self.reachable(roots, |_| true)
            .iter()
            .filter(|id| is_symbol(id))
            .any(|id| is_of_interest(*id))
    }

    /// The number that an expression has folded to.
    pub fn as_number(&self, id: Id) -> Option<&Number> {
        match self.node(id) {
            Node::Number(number) => Some(number),
            _ => None,
        }
    }

    #[expect(clippy::unused_self, reason = "asked as all else is")]
    pub fn is_zero(&self, id: Id) -> bool {
        id == ZERO
    }

    #[expect(clippy::unused_self, reason = "asked as all else is")]
    pub fn is_one(&self, id: Id) -> bool {
        id == ONE
    }

    pub fn is_undefined(&self, id: Id) -> bool {
        matches!(self.node(id), Node::Undefined)
    }
}

/// Three components in one frame.
pub type Components = [Id; 3];
