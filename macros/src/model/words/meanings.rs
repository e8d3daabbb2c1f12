//! The meanings of symbols.

use std::collections::HashMap;

use crate::symbolic::{Graph, Id, Node, Stage, Symbol};

use super::frame::Frame;

/// The variables of the motion of a body.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum Variable {
    /// Of G, in world axes.
    Position,
    Velocity,
    LinearAcceleration,
    /// The acceleration in body axes, for loads that depend on it.
    AccelerationInBody,
    /// The angle of a body in the plane, or about the axis of a hinge.
    Angle,
    /// The attitude quaternion: its component 0 is the scalar.
    Quaternion,
    /// In body axes. If there is one angle, they are along its axis, in the place of z.
    AngularVelocity,
    AngularAcceleration,
    /// The axis of a rod, in world axes.
    Axis,
    AxisRate,
    AxisAcceleration,
    /// A user-defined state, and its rate.
    Own,
}

impl Variable {
    /// Whether it is a velocity of any kind, or is treated as one.
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

    /// The place of a component in the runtime's types: a quaternion has its scalar last.
    pub fn place(self, part: usize) -> usize {
        match self {
            Self::Quaternion => (part + 3) % 4,
            _ => part,
        }
    }

    /// Its name in the type of the acceleration.
    pub fn of_acceleration(self) -> &'static str {
        match self {
            Self::LinearAcceleration => "linear",
            Self::AxisAcceleration => "axis",
            _ => "angular",
        }
    }
}

/// The meaning of a symbol. The last number is a component; a number before it is the index of a
/// declaration.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum Meaning {
    Time,
    /// A variable of the motion of a body, which is identified by its frame.
    Of(Frame, Variable, usize),
    /// A parameter, and its component if it is a vector.
    Param(usize, Option<usize>),
    Input(usize, Option<usize>),
    /// A Rust constant of the user.
    Constant(usize),
    /// A user-defined state.
    Own(usize),
    /// A component, in world axes, of a reaction that is given from outside.
    Reaction(usize, usize),
    /// A mass, where masses are read as unknown.
    Mass(usize),
    /// A displacement or a rotated vector, during differentiation.
    Virtual,
}

/// Symbols and their meanings.
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
