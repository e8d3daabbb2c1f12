//! What the symbols of the graph stand for.

use std::collections::HashMap;

use crate::symbolic::{Graph, Id, Node, Stage, Symbol};

use super::frame::Frame;

/// What the motion of a body is told by.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum Variable {
    /// Of G, world axes.
    Position,
    Velocity,
    LinearAcceleration,
    /// The same in body axes, of what loads follow it.
    AccelerationInBody,
    /// By which the body is turned in the plane, or about the axis of a hinge.
    Angle,
    /// The attitude quaternion: its component 0 is the scalar.
    Quaternion,
    /// Body axes; that of an angle is along its axis, in the place of z.
    AngularVelocity,
    AngularAcceleration,
    /// The axis of a rod, world axes.
    Axis,
    AxisRate,
    AxisAcceleration,
    /// A state of one's own, and its rate.
    Own,
}

impl Variable {
    /// Whether it is a velocity of any kind, or stands among them.
    pub fn is_rate(self) -> bool {
        matches!(
            self,
            Self::Velocity | Self::AngularVelocity | Self::AxisRate | Self::Own
        )
    }

    /// Whether it is an acceleration of any kind.
    pub fn is_acceleration(self) -> bool {
        matches!(
            self,
            Self::LinearAcceleration
                | Self::AccelerationInBody
                | Self::AngularAcceleration
                | Self::AxisAcceleration
        )
    }

    /// What an acceleration is called in the state's acceleration.
    pub fn of_acceleration(self) -> &'static str {
        match self {
            Self::LinearAcceleration => "linear",
            Self::AxisAcceleration => "axis",
            _ => "angular",
        }
    }
}

/// What a symbol stands for; the last number is a component, one before it the index of a
/// declaration.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum Meaning {
    Time,
    /// Of the motion of a body, which its frame tells.
    Of(Frame, Variable, usize),
    /// A parameter, and its component if it is a vector.
    Param(usize, Option<usize>),
    Input(usize, Option<usize>),
    /// A constant of the Rust of the user.
    Constant(usize),
    /// A state of one's own.
    Own(usize),
    /// A reaction, given from outside, and its component in world axes.
    Reaction(usize, usize),
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

    /// The symbols of all accelerations.
    pub fn accelerations(&self) -> impl Iterator<Item = Symbol> {
        let all = self.0.iter();
        all.filter_map(|(symbol, meaning)| match meaning {
            Meaning::Of(_, variable, _) if variable.is_acceleration() => Some(*symbol),
            _ => None,
        })
    }

    /// The symbol that stands for a part of the state, if the motion has it.
    pub fn symbol_of(&self, meaning: Meaning) -> Option<Symbol> {
        let mut known = self.0.iter();
        let found = known.find(|(_, known)| **known == meaning);
        found.map(|(symbol, _)| *symbol)
    }
}
