//! From a graph to straight-line code: which expressions become statements, and in which order.

use crate::symbolic::number::Function;

use super::nodes::{Graph, Id, Node, Stage};

/// A statement with more operations than this is split.
const STATEMENT: u32 = 14;

/// Straight-line code that computes `outputs`.
pub struct Program {
    /// The named expressions, in order: an operand precedes its use.
    pub statements: Vec<Id>,
    pub outputs: Vec<Id>,
    /// Expressions of an earlier stage that the code reads, except symbols and numbers.
    pub hoisted: Vec<Id>,
    /// Symbols that the code reads.
    pub symbols: Vec<Id>,
    /// All nodes that this program computes, children first.
    pub nodes: Vec<Id>,
}

impl Graph {
    /// Schedules `outputs` for evaluation at `stage`. An expression becomes a statement if it is a
    /// quantity, if it is used more than once, or if the statement around it would grow too long. A
    /// condition is not a number, so it is never stored at an earlier stage.
    pub fn schedule(&self, outputs: &[Id], stage: Stage) -> Program {
        self.schedule_where(outputs, |id| self.stage(id) == stage)
    }

    /// The same for all expressions for which `is_due` holds.
    pub fn schedule_where(&self, outputs: &[Id], is_due: impl Fn(Id) -> bool) -> Program {
        let is_leaf = |id: Id| self.node(id).operands().next().is_none();
        let is_condition = |id: Id| {
            matches!(
                self.node(id),
                Node::Compare(..) | Node::And(..) | Node::Or(..) | Node::Not(_)
            )
        };
        let computed = |id: Id| !is_leaf(id) && (is_due(id) || is_condition(id));
        let reached = self.reachable(outputs, &computed);
        let (nodes, rest): (Vec<Id>, Vec<Id>) = reached.into_iter().partition(|id| computed(*id));
        let (symbols, rest): (Vec<Id>, Vec<Id>) = rest
            .into_iter()
            .partition(|id| matches!(self.node(*id), Node::Symbol(_)));
        let hoisted = rest.into_iter().filter(|id| !is_leaf(*id)).collect();

        let statements = self.statements(&nodes, outputs, computed);
        Program {
            statements,
            outputs: outputs.to_vec(),
            hoisted,
            symbols,
            nodes,
        }
    }

    /// The `nodes` that get a name. All of them are `computed`.
    fn statements(&self, nodes: &[Id], outputs: &[Id], computed: impl Fn(Id) -> bool) -> Vec<Id> {
        let operands = |id: Id| self.node(id).operands().filter(|id| computed(*id));
        let mut uses = vec![0_u32; nodes.last().map_or(0, |last| last.index() + 1)];
        let mut weights = vec![0_u32; uses.len()];
        let read = nodes.iter().flat_map(|id| operands(*id));
        for id in read.chain(outputs.iter().copied().filter(|id| computed(*id))) {
            uses[id.index()] += 1;
        }
        let mut statements = Vec::new();
        for &id in nodes {
            let inlined: u32 = operands(id).map(|id| weights[id.index()]).sum();
            let is_quantity = matches!(self.node(id), Node::Quantity(_));
            let negates = matches!(self.node(id), Node::Negate(_));
            let is_named = |inner: Id| statements.binary_search(&inner).is_ok();
            if is_quantity && self.node(id).operands().any(is_named) {
                // this only renames an existing statement
                continue;
            }
            let weight = inlined + u32::from(!negates && !is_quantity);
            let is_shared = uses[id.index()] > 1 && !negates;
            if is_quantity || is_shared || self.is_half_of_a_pair(id, nodes) || weight > STATEMENT {
                statements.push(id);
            } else {
                weights[id.index()] = weight;
            }
        }
        statements
    }

    /// The cosine that belongs to the sine `id`, or the sine that belongs to a cosine, if it
    /// exists.
    pub fn other_half(&self, id: Id) -> Option<Id> {
        match *self.node(id) {
            Node::Unary(Function::Sin, angle) => self.find(&Node::Unary(Function::Cos, angle)),
            Node::Unary(Function::Cos, angle) => self.find(&Node::Unary(Function::Sin, angle)),
            _ => None,
        }
    }

    /// Whether this is a sine or cosine whose counterpart is computed as well: then both are
    /// computed together.
    fn is_half_of_a_pair(&self, id: Id, nodes: &[Id]) -> bool {
        self.other_half(id)
            .is_some_and(|other| nodes.binary_search(&other).is_ok())
    }
}
