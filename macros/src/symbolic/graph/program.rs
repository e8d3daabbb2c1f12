//! From a graph to straight-line code: which expressions become statements, and in which order.

use crate::symbolic::number::Function;

use super::hash::ShortMap;
use super::nodes::{Graph, Id, Node, Stage};
use super::values::Values;

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
    /// Which expressions have the value of one of these nodes, and are not computed again.
    pub values: Values,
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
        let (mut nodes, rest): (Vec<Id>, Vec<Id>) =
            reached.into_iter().partition(|id| computed(*id));
        let (symbols, rest): (Vec<Id>, Vec<Id>) = rest
            .into_iter()
            .partition(|id| matches!(self.node(*id), Node::Symbol(_)));
        let hoisted = rest.into_iter().filter(|id| !is_leaf(*id)).collect();

        let values = self.values(&nodes);
        nodes.retain(|id| values.first(*id) == *id);
        let statements = self.statements(&nodes, outputs, &values);
        Program {
            statements,
            outputs: outputs.to_vec(),
            hoisted,
            symbols,
            nodes,
            values,
        }
    }

    /// The `nodes` that get a name.
    fn statements(&self, nodes: &[Id], outputs: &[Id], values: &Values) -> Vec<Id> {
        let computed = |id: &Id| nodes.binary_search(id).is_ok();
        let first = |id: Id| values.first(id);
        let operands = |id: Id| self.node(id).operands().map(first).filter(computed);
        let mut uses = vec![0_u32; nodes.last().map_or(0, |last| last.index() + 1)];
        let mut weights = vec![0_u32; uses.len()];
        let mut readers: ShortMap<Id, Id> = ShortMap::default();
        for reader in nodes {
            for id in operands(*reader) {
                uses[id.index()] += 1;
                readers.entry(id).or_insert(*reader);
            }
        }
        for id in outputs.iter().copied().map(first).filter(computed) {
            uses[id.index()] += 1;
        }
        let is_quantity = |id: &&Id| matches!(self.node(**id), Node::Quantity(_));
        let quantity = |id: Id| {
            let copies = values.copies_of(id).iter();
            copies.chain([&id]).find(is_quantity).copied()
        };
        let mut statements = Vec::new();
        for &id in nodes {
            let inlined: u32 = operands(id).map(|id| weights[id.index()]).sum();
            let negates = matches!(self.node(id), Node::Negate(_));
            let weight = inlined + u32::from(!negates && !is_quantity(&&id));
            let is_shared = uses[id.index()] > 1 && !negates;
            if quantity(id).is_some()
                || is_shared
                || self.is_half_of_a_pair(id, nodes)
                || weight > STATEMENT
            {
                statements.push(id);
            } else {
                weights[id.index()] = weight;
            }
        }
        // a quantity stands where it was made, unless its value is read before
        statements.sort_by_key(|id| {
            let made = quantity(*id).unwrap_or(*id);
            let is_read = readers.get(id).is_some_and(|reader| *reader < made);
            if is_read { *id } else { made }
        });
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
