//! What the symbols of the graph stand for.

use std::collections::HashMap;

use crate::symbolic::{Graph, Id, Node, Stage, Symbol};

/// What a symbol stands for; the numbers are components, or indices of declarations.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum Meaning {
    Time,
    Position(usize),
    Velocity(usize),
    /// The angle of a planar body.
    Angle,
    /// Components of the attitude quaternion: 0 is the scalar.
    Quaternion(usize),
    AngularVelocity(usize),
    /// The axis of a rod and its rate, world axes.
    Axis(usize),
    AxisRate(usize),
    /// A parameter, and its component if it is a vector.
    Param(usize, Option<usize>),
    Input(usize, Option<usize>),
    /// A reaction, given from outside, and its component in world axes.
    Reaction(usize, usize),
    /// Acceleration of G, world axes.
    LinearAcceleration(usize),
    /// Angular acceleration, body axes.
    AngularAcceleration(usize),
    /// Of the axis of a rod, world axes.
    AxisAcceleration(usize),
    /// A displacement or a turned vector, as long as it is differentiated by.
    Virtual,
}

/// Symbols and what they stand for.
#[derive(Default)]
pub struct Meanings(HashMap<Symbol, Meaning>);

impl Meanings {
    /// A new symbol of `graph`, known from `stage` on.
    pub fn symbol(&mut self, graph: &mut Graph, stage: Stage, meaning: Meaning) -> Id {
        let id = graph.symbol(stage);
        if let Node::Symbol(symbol) = graph.node(id) {
            self.0.insert(*symbol, meaning);
        }
        id
    }

    pub fn of(&self, symbol: Symbol) -> Meaning {
        self.0.get(&symbol).copied().unwrap_or(Meaning::Virtual)
    }

    /// The symbol that stands for a part of the state, if the motion has it.
    pub fn symbol_of(&self, meaning: Meaning) -> Option<Symbol> {
        let mut known = self.0.iter();
        let found = known.find(|(_, known)| **known == meaning);
        found.map(|(symbol, _)| *symbol)
    }
}
