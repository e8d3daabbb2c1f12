//! The expression graph: an arena of hash-consed nodes.
//!
//! Equal expressions are one node, children precede their parents, and only the simplifying
//! constructors of [`super::build`] make nodes. To a graph, symbols are numbers: it does not know
//! their meanings.

use core::cmp::Ordering;
use std::collections::HashMap;

use crate::symbolic::number::{Foreign, Function, Number, Spectrum, Table};

use super::hash::ShortMap;
use super::pending::Pending;

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

/// The stage at which the value of an expression is known.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub enum Stage {
    /// At expansion: folded into the code.
    Constant,
    /// When the body is built: computed once, in the constructor.
    Parameter,
    /// At every evaluation.
    State,
}

/// Comparisons; `>` and `>=` are stored with their operands exchanged.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum Comparison {
    Less,
    LessOrEqual,
    Equal,
    NotEqual,
}

impl Comparison {
    /// Whether the comparison holds for two numbers in this order.
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
#[derive(Clone, PartialEq, Eq, Debug)]
pub enum Node {
    Number(Number),
    Truth(bool),
    /// A constant that does not exist: a division by zero, the root of a negative number.
    Undefined,
    Symbol(Symbol),
    /// An expression that is a statement of the code and counts as atomic: no rule looks inside it.
    Quantity(Id),
    /// A positive quantity, such as a mass: NaN where it is not positive.
    Positive(Id),
    Negate(Id),
    Add(Id, Id),
    Subtract(Id, Id),
    Multiply(Id, Id),
    Divide(Id, Id),
    Unary(Function, Id),
    Binary(Function, Id, Id),
    /// A foreign function; missing arguments are zero.
    Foreign(Foreign, [Id; Foreign::ARGUMENTS]),
    Compare(Comparison, Id, Id),
    And(Id, Id),
    Or(Id, Id),
    Not(Id),
    /// `if condition { first } else { second }`
    Select(Id, Id, Id),
    /// The reciprocal of a divisor that may vanish in some configuration, and the size of the terms
    /// of the divisor: if it is no larger than their rounding error, it is not used.
    Pivot(Id, Id),
}

impl Node {
    /// The operands, left to right.
    pub fn operands(&self) -> impl Iterator<Item = Id> {
        let (operands, count) = self.operands_in_place();
        operands.into_iter().take(count)
    }

    /// The operands, left to right, in an array of three, and how many there are.
    fn operands_in_place(&self) -> ([Id; 3], usize) {
        match *self {
            Self::Number(_) | Self::Truth(_) | Self::Undefined | Self::Symbol(_) => ([ZERO; 3], 0),
            Self::Quantity(a)
            | Self::Positive(a)
            | Self::Negate(a)
            | Self::Not(a)
            | Self::Unary(_, a) => ([a, ZERO, ZERO], 1),
            Self::Add(a, b)
            | Self::Subtract(a, b)
            | Self::Multiply(a, b)
            | Self::Divide(a, b)
            | Self::Binary(_, a, b)
            | Self::Pivot(a, b)
            | Self::Compare(_, a, b)
            | Self::And(a, b)
            | Self::Or(a, b) => ([a, b, ZERO], 2),
            Self::Select(a, b, c) | Self::Foreign(_, [a, b, c]) => ([a, b, c], 3),
        }
    }

    /// The operation and its operands, packed into one unique word; numbers do not fit.
    fn words(&self) -> u128 {
        self.words_with(self.operands_in_place().0)
    }

    /// The same with the images of the operands; those of sums and products are sorted.
    pub(super) fn words_of(&self, image: impl Fn(Id) -> Id) -> u128 {
        let (mut operands, count) = self.operands_in_place();
        for operand in &mut operands[..count] {
            *operand = image(*operand);
        }
        if matches!(self, Self::Add(..) | Self::Multiply(..)) {
            operands[..2].sort_unstable();
        }
        self.words_with(operands)
    }

    fn words_with(&self, [a, b, c]: [Id; 3]) -> u128 {
        let (operation, which): (u8, u32) = match *self {
            Self::Number(_) => (0, 0),
            Self::Truth(holds) => (1, u32::from(holds)),
            Self::Undefined => (2, 0),
            Self::Symbol(Symbol(number)) => (3, number),
            Self::Quantity(_) => (4, 0),
            Self::Negate(_) => (5, 0),
            Self::Add(..) => (6, 0),
            Self::Subtract(..) => (7, 0),
            Self::Multiply(..) => (8, 0),
            Self::Divide(..) => (9, 0),
            Self::Unary(function, _) => (10, function as u32),
            Self::Binary(function, ..) => (11, function as u32),
            Self::Compare(comparison, ..) => (12, comparison as u32),
            Self::And(..) => (13, 0),
            Self::Or(..) => (14, 0),
            Self::Not(_) => (15, 0),
            Self::Select(..) => (16, 0),
            Self::Pivot(..) => (17, 0),
            Self::Foreign(..) => (18, 0),
            Self::Positive(_) => (19, 0),
        };
        // three operands leave room for the operation and the 24 bits of a foreign function; the
        // index of any other function takes the place of a third operand
        let last = if which == 0 { c.0 } else { which };
        let operands = u128::from(a.0) | u128::from(b.0) << 32 | u128::from(last) << 64;
        let foreign = match *self {
            Self::Foreign(foreign, _) => foreign.word(),
            _ => 0,
        };
        operands | u128::from(operation) << 96 | u128::from(foreign) << 104
    }
}

/// The lookup by words.
type ByWords<K> = ShortMap<K, Id>;

/// All expressions of one description.
pub struct Graph {
    nodes: Vec<Node>,
    stages: Vec<Stage>,
    numbers: ByWords<Number>,
    operations: ByWords<u128>,
    /// Tables, by index.
    pub(super) tables: Vec<Table>,
    /// Products of early factors made so far.
    pub(super) products: ByWords<[Id; 2]>,
    /// Negatives made so far, by the node that is negated.
    pub(super) negatives: Vec<Option<Id>>,
    symbols: Vec<Id>,
    /// Principal axes of tensors computed so far.
    pub(in crate::symbolic) spectra: HashMap<[Components; 3], Spectrum>,
}

/// The numbers at the beginning of every graph.
pub(in crate::symbolic) const ZERO: Id = Id(0);
pub(in crate::symbolic) const ONE: Id = Id(1);

impl Default for Graph {
    fn default() -> Self {
        let mut graph = Self {
            nodes: Vec::new(),
            stages: Vec::new(),
            numbers: HashMap::default(),
            operations: HashMap::default(),
            tables: Vec::new(),
            products: HashMap::default(),
            negatives: Vec::new(),
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

    /// Whether all values are known before the state is.
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

    /// The unique node of this shape. Only constructors call it, with nodes that they cannot
    /// simplify.
    pub(in crate::symbolic) fn intern(&mut self, node: Node) -> Id {
        if let Some(id) = self.find(&node) {
            return id;
        }
        // the values of foreign functions are unknown at expansion
        let least = match node {
            Node::Foreign(..) => Stage::Parameter,
            _ => Stage::Constant,
        };
        let stage = node.operands().map(|operand| self.stage(operand)).max();
        let stage = stage.unwrap_or(Stage::Constant).max(least);
        self.insert(node, stage)
    }

    /// The node of this shape, if there is one already.
    pub(in crate::symbolic) fn find(&self, node: &Node) -> Option<Id> {
        match node {
            Node::Number(number) => self.numbers.get(number).copied(),
            operation => self.operations.get(&operation.words()).copied(),
        }
    }

    fn insert(&mut self, node: Node, stage: Stage) -> Id {
        let id = Id(u32::try_from(self.nodes.len()).unwrap_or(u32::MAX));
        match &node {
            Node::Number(number) => self.numbers.insert(number.clone(), id),
            operation => self.operations.insert(operation.words(), id),
        };
        self.nodes.push(node);
        self.stages.push(stage);
        self.negatives.push(None);
        id
    }

    /// All nodes of `roots`, children first; `enter` says whether the operands of a node are
    /// visited.
    pub fn reachable(&self, roots: &[Id], enter: &dyn Fn(Id) -> bool) -> Vec<Id> {
        let mut pending = Pending::default();
        for root in roots {
            pending.insert(root.0);
        }
        let mut found = Vec::new();
        while let Some(id) = pending.take_last().map(Id) {
            found.push(id);
            if enter(id) {
                for operand in self.node(id).operands() {
                    pending.insert(operand.0);
                }
            }
        }
        found.reverse();
        found
    }

    /// `roots` and all their operands, operands first.
    pub fn nodes_of(&self, roots: &[Id]) -> Vec<Id> {
        self.reachable(roots, &|_| true)
    }

    /// Whether any of `roots` depends on a symbol that `is_of_interest`.
    pub fn depends_on(&self, roots: &[Id], is_of_interest: impl Fn(Id) -> bool) -> bool {
        let is_symbol = |id: &Id| matches!(self.node(*id), Node::Symbol(_));
        self.nodes_of(roots)
            .iter()
            .filter(|id| is_symbol(id))
            .any(|id| is_of_interest(*id))
    }

    /// The number that the expression is, if it has folded to one.
    pub fn as_number(&self, id: Id) -> Option<&Number> {
        match self.node(id) {
            Node::Number(number) => Some(number),
            _ => None,
        }
    }

    #[expect(clippy::unused_self, reason = "called as the other predicates are")]
    pub fn is_zero(&self, id: Id) -> bool {
        id == ZERO
    }

    #[expect(clippy::unused_self, reason = "called as the other predicates are")]
    pub fn is_one(&self, id: Id) -> bool {
        id == ONE
    }

    pub fn is_undefined(&self, id: Id) -> bool {
        matches!(self.node(id), Node::Undefined)
    }
}

/// Three components in one frame.
pub type Components = [Id; 3];
