//! Switch times: times at which the equations change because of a condition on time.
//!
//! Compared expressions are split into pieces. In each piece, time enters in one of these forms:
//!
//! ```text
//! k t + c          switches at      -c / k
//! k t + c + m n    with n whole:    every m / k from -c / k on
//! f sin(k t + c) + b, and with cos: twice in every 2 pi / k
//! ```
//!
//! Here k, c, m, f and b are numbers, parameters and inputs. For `abs`, `min`, `max` and `if`, the
//! pieces are those of both sides; for `floor` and `ceil`, they contain an integer. A time that is
//! found in this way may not be a switch; then it ends a step needlessly. But no switch of these
//! forms is missed, up to [`MOST_PIECES`].

use std::collections::HashMap;

use crate::model::{Meaning, Workspace};
use crate::symbolic::{Comparison, Function, Graph, Id, Node, Number};

/// A time at which equations change.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Switch {
    At(Id),
    /// A time, and the size of the terms whose rounding errors it contains.
    Near(Id, Id),
    /// Periodic times, given by one of them and the period.
    Every(Id, Id),
}

impl Switch {
    pub fn roots(&self) -> Vec<Id> {
        match *self {
            Self::At(time) => vec![time],
            Self::Near(time, other) | Self::Every(time, other) => vec![time, other],
        }
    }
}

/// The most pieces of one expression; an expression with more is not searched.
const MOST_PIECES: usize = 128;

/// `slope t + sum of terms + whole n + wave`
#[derive(Clone)]
struct Piece {
    slope: Id,
    terms: Vec<Id>,
    whole: Option<Id>,
    wave: Option<Wave>,
}

/// `factor sin(slope t + rest)`, or with the cosine.
#[derive(Clone, Copy)]
struct Wave {
    function: Function,
    factor: Id,
    slope: Id,
    rest: Id,
}

/// The pieces of each expression; `None` if one does not have these forms.
type Pieces = HashMap<Id, Option<Vec<Piece>>>;

/// The switch times of `roots`, each once.
///
/// `derivatives` has the number of given derivatives of each input. An input with derivatives
/// moves.
pub fn derive_switches(
    time: Id,
    derivatives: &[usize],
    work: &mut Workspace,
    roots: &[Id],
) -> Vec<Switch> {
    let graph = &work.graph;
    let order = graph.reachable(roots, &|id| !graph.is_early(id));
    if order.binary_search(&time).is_err() {
        return Vec::new();
    }
    let is_held = |symbol: Id| match work.meaning(symbol) {
        Some(Meaning::Param(..)) => true,
        Some(Meaning::Input(input, _)) => derivatives.get(input).is_none_or(|count| *count == 0),
        _ => false,
    };
    let mut held: HashMap<Id, bool> = HashMap::new();
    for id in &order {
        let mut operands = graph.node(*id).operands().peekable();
        let is_made = operands.peek().is_some();
        let is_known = graph.is_early(*id)
            || is_held(*id)
            || is_made && operands.all(|operand| held.get(&operand) == Some(&true));
        held.insert(*id, is_known);
    }
    let graph = &mut work.graph;
    let (mut pieces, mut switches) = (Pieces::new(), Vec::new());
    for id in order {
        let found = if held[&id] {
            Some(vec![Piece::constant(graph, id)])
        } else if id == time {
            Some(vec![Piece::time(graph)])
        } else {
            add_switches(graph, &pieces, id, &mut switches);
            pieces_of(graph, &pieces, id)
        };
        pieces.insert(id, found.filter(|found| found.len() <= MOST_PIECES));
    }
    switches
}

impl Piece {
    fn constant(graph: &Graph, id: Id) -> Self {
        Self {
            slope: graph.zero(),
            terms: vec![id],
            whole: None,
            wave: None,
        }
    }

    fn time(graph: &Graph) -> Self {
        Self {
            slope: graph.one(),
            terms: Vec::new(),
            whole: None,
            wave: None,
        }
    }

    fn scaled(&self, graph: &mut Graph, factor: Id) -> Self {
        let mut times = |id: Id| graph.multiply(factor, id);
        Self {
            slope: times(self.slope),
            terms: self.terms.iter().map(|term| times(*term)).collect(),
            whole: self.whole.map(&mut times),
            wave: self.wave.map(|wave| Wave {
                factor: times(wave.factor),
                ..wave
            }),
        }
    }

    /// Whether it is `slope t + sum of terms`.
    fn is_line(&self) -> bool {
        self.whole.is_none() && self.wave.is_none()
    }

    /// The sine or cosine of a piece that is linear in time.
    fn waved(&self, graph: &mut Graph, function: Function) -> Option<Self> {
        let wave = Wave {
            function,
            factor: graph.one(),
            slope: self.slope,
            rest: graph.sum(&self.terms),
        };
        let zero = graph.zero();
        self.is_line().then(|| Self {
            wave: Some(wave),
            ..Self::constant(graph, zero)
        })
    }

    /// The sum. `None` if it would contain two integers or two waves.
    fn plus(&self, graph: &mut Graph, other: &Self) -> Option<Self> {
        let has_two = self.whole.is_some() && other.whole.is_some()
            || self.wave.is_some() && other.wave.is_some();
        (!has_two).then(|| Self {
            slope: graph.add(self.slope, other.slope),
            terms: [self.terms.as_slice(), &other.terms].concat(),
            whole: self.whole.or(other.whole),
            wave: self.wave.or(other.wave),
        })
    }

    /// The times at which the piece is zero, or at which the argument of its integer is an integer.
    fn zeros(&self, graph: &mut Graph) -> Vec<Switch> {
        let rest = graph.sum(&self.terms);
        match (self.whole, self.wave) {
            (None, None) if !graph.is_zero(self.slope) => {
                let zero = zero(graph, self.slope, rest);
                let size = size(graph, self.slope, &self.terms);
                let is_exact = self.terms.len() < 2 || is_as_large(graph, zero, size);
                vec![if is_exact {
                    Switch::At(zero)
                } else {
                    Switch::Near(zero, size)
                }]
            }
            (Some(whole), None) if !graph.is_zero(self.slope) => {
                let period = graph.divide(whole, self.slope);
                vec![Switch::Every(zero(graph, self.slope, rest), period)]
            }
            (None, Some(wave)) if graph.is_zero(self.slope) => wave.zeros(graph, rest),
            _ => Vec::new(),
        }
    }
}

impl Wave {
    /// The times at which the wave equals `-rest`.
    fn zeros(&self, graph: &mut Graph, rest: Id) -> Vec<Switch> {
        let against = graph.negate(rest);
        let level = graph.divide(against, self.factor);
        let half_turn = graph.number(Number::pi());
        let (first, second) = if self.function == Function::Sin {
            let angle = graph.apply(Function::Asin, &[level]);
            (angle, graph.subtract(half_turn, angle))
        } else {
            let angle = graph.apply(Function::Acos, &[level]);
            (angle, graph.negate(angle))
        };
        let turn = graph.add(half_turn, half_turn);
        let period = graph.divide(turn, self.slope);
        let at = [first, second].map(|angle| {
            let rest = graph.subtract(self.rest, angle);
            zero(graph, self.slope, rest)
        });
        at.map(|time| Switch::Every(time, period)).to_vec()
    }
}

/// `-rest / slope`
fn zero(graph: &mut Graph, slope: Id, rest: Id) -> Id {
    let against = graph.negate(rest);
    graph.divide(against, slope)
}

/// The size of the terms of such a zero.
fn size(graph: &mut Graph, slope: Id, terms: &[Id]) -> Id {
    let sizes: Vec<Id> = terms
        .iter()
        .map(|term| graph.apply(Function::Abs, &[*term]))
        .collect();
    let (sum, slope) = (graph.sum(&sizes), graph.apply(Function::Abs, &[slope]));
    graph.divide(sum, slope)
}

/// Whether the terms of a number, which have this size, are not much larger than the number.
fn is_as_large(graph: &Graph, number: Id, size: Id) -> bool {
    let value = |id: Id| graph.as_number(id).map(|number| number.to_f64().abs());
    matches!((value(number), value(size)), (Some(number), Some(size)) if size <= 4.0 * number)
}

/// The switches added by one operation.
fn add_switches(graph: &mut Graph, pieces: &Pieces, id: Id, switches: &mut Vec<Switch>) {
    let known = |id: Id| pieces.get(&id).cloned().flatten();
    let (at, is_whole) = match *graph.node(id) {
        Node::Compare(Comparison::Less | Comparison::LessOrEqual, a, b)
        | Node::Binary(Function::Min | Function::Max, a, b) => {
            let (Some(a), Some(b)) = (known(a), known(b)) else {
                return;
            };
            let minus = graph.integer(-1);
            let b: Vec<Piece> = b.iter().map(|b| b.scaled(graph, minus)).collect();
            (sums(graph, &a, &b), false)
        }
        Node::Unary(Function::Abs | Function::Signum, a) => (known(a), false),
        Node::Unary(Function::Floor | Function::Ceil, a) => (known(a), true),
        _ => return,
    };
    for mut piece in at.into_iter().flatten() {
        if is_whole {
            let one = graph.one();
            if piece.whole.replace(one).is_some() {
                continue;
            }
        }
        for switch in piece.zeros(graph) {
            let is_there = switch.roots().iter().all(|id| !graph.is_undefined(*id));
            if is_there && !switches.contains(&switch) {
                switches.push(switch);
            }
        }
    }
}

/// The sums of each piece of the first list and each piece of the second.
fn sums(graph: &mut Graph, a: &[Piece], b: &[Piece]) -> Option<Vec<Piece>> {
    if a.len() * b.len() > MOST_PIECES {
        return None;
    }
    let pairs = a.iter().flat_map(|a| b.iter().map(move |b| (a, b)));
    pairs.map(|(a, b)| a.plus(graph, b)).collect()
}

/// The term, if there is a single piece with a single term.
fn held(graph: &Graph, pieces: Option<&[Piece]>) -> Option<Id> {
    let [piece] = pieces? else {
        return None;
    };
    match piece.terms[..] {
        [term] if piece.is_line() && graph.is_zero(piece.slope) => Some(term),
        _ => None,
    }
}

/// The pieces of one operation, from those of its operands.
fn pieces_of(graph: &mut Graph, pieces: &Pieces, id: Id) -> Option<Vec<Piece>> {
    let known = |id: Id| pieces.get(&id).cloned().flatten();
    let scaled = |graph: &mut Graph, pieces: &[Piece], factor: Id| -> Vec<Piece> {
        let pieces = pieces.iter();
        pieces.map(|piece| piece.scaled(graph, factor)).collect()
    };
    let minus = graph.integer(-1);
    match *graph.node(id) {
        Node::Quantity(a) | Node::Positive(a) => known(a),
        Node::Negate(a) => known(a).map(|a| scaled(graph, &a, minus)),
        Node::Add(a, b) => sums(graph, &known(a)?, &known(b)?),
        Node::Subtract(a, b) => {
            let b = scaled(graph, &known(b)?, minus);
            sums(graph, &known(a)?, &b)
        }
        Node::Multiply(a, b) => {
            let (a, b) = (known(a), known(b));
            match (held(graph, a.as_deref()), held(graph, b.as_deref())) {
                (Some(factor), _) => Some(scaled(graph, &b?, factor)),
                (_, Some(factor)) => Some(scaled(graph, &a?, factor)),
                _ => None,
            }
        }
        Node::Divide(a, b) => {
            let divisor = held(graph, known(b).as_deref())?;
            let one = graph.one();
            let factor = graph.divide(one, divisor);
            Some(scaled(graph, &known(a)?, factor))
        }
        Node::Unary(Function::Abs, a) => {
            let a = known(a)?;
            let opposite = scaled(graph, &a, minus);
            Some([a, opposite].concat())
        }
        Node::Unary(Function::Signum, _) => {
            let one = graph.one();
            let signs = [one, minus].map(|sign| Piece::constant(graph, sign));
            Some(signs.to_vec())
        }
        Node::Unary(Function::Floor | Function::Ceil, a) => {
            known(a)?;
            let (zero, one) = (graph.zero(), Some(graph.one()));
            Some(vec![Piece {
                whole: one,
                ..Piece::constant(graph, zero)
            }])
        }
        Node::Unary(function @ (Function::Sin | Function::Cos), a) => {
            let pieces = known(a)?.into_iter();
            pieces.map(|piece| piece.waved(graph, function)).collect()
        }
        Node::Binary(Function::Min | Function::Max, a, b) | Node::Select(_, a, b) => {
            Some([known(a)?, known(b)?].concat())
        }
        _ => None,
    }
}
