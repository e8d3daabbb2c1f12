//! Kinds of motion, and the coordinates that each of them has.

use crate::symbolic::{Components, Graph, Id, Stage};

use super::frame::Attitude;
use super::names::Meaning;

/// Which coordinates a body has.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Motion {
    Planar,
    PlanarTranslation,
    Spatial,
    Translation,
    Rotation,
}

impl Motion {
    pub const ALL: [(&'static str, Self); 5] = [
        ("planar", Self::Planar),
        ("planar_translation", Self::PlanarTranslation),
        ("spatial", Self::Spatial),
        ("translation", Self::Translation),
        ("rotation", Self::Rotation),
    ];

    pub fn word(self) -> &'static str {
        Self::ALL
            .iter()
            .find(|(_, motion)| *motion == self)
            .map_or("", |(word, _)| word)
    }

    /// Vectors have two components and moments are scalars.
    pub fn is_planar(self) -> bool {
        matches!(self, Self::Planar | Self::PlanarTranslation)
    }

    /// G moves.
    pub fn has_position(self) -> bool {
        self != Self::Rotation
    }

    /// The body turns.
    pub fn has_attitude(self) -> bool {
        matches!(self, Self::Planar | Self::Spatial | Self::Rotation)
    }

    /// Number of components of a vector.
    pub fn axes(self) -> usize {
        if self.is_planar() { 2 } else { 3 }
    }
}

/// The symbols of the state. What a motion does not have is zero.
pub struct State {
    pub time: Id,
    pub position: Components,
    pub velocity: Components,
    pub angular_velocity: Components,
    pub linear_acceleration: Components,
    pub angular_acceleration: Components,
}

/// Symbols and what they stand for: symbol `n` of the graph has meaning `n`.
#[derive(Default)]
pub struct Meanings(Vec<Meaning>);

impl Meanings {
    /// A new symbol of `graph`, known from `stage` on.
    pub fn symbol(&mut self, graph: &mut Graph, stage: Stage, meaning: Meaning) -> Id {
        self.0.push(meaning);
        graph.symbol(stage)
    }

    pub fn of(&self, symbol: crate::symbolic::Symbol) -> Meaning {
        self.0[symbol.0 as usize]
    }

    /// Symbols for the axes of `range`, zero along the others.
    fn vector(
        &mut self,
        graph: &mut Graph,
        axes: core::ops::Range<usize>,
        meaning: fn(usize) -> Meaning,
    ) -> Components {
        [0, 1, 2].map(|i| {
            if axes.contains(&i) {
                self.symbol(graph, Stage::State, meaning(i))
            } else {
                graph.zero()
            }
        })
    }
}

/// The symbols of a motion's state and the attitude that they make.
pub fn state_symbols(
    motion: Motion,
    graph: &mut Graph,
    meanings: &mut Meanings,
) -> (State, Attitude) {
    let linear = if motion.has_position() {
        0..motion.axes()
    } else {
        0..0
    };
    let angular = match motion {
        Motion::Planar => 2..3,
        Motion::Spatial | Motion::Rotation => 0..3,
        Motion::PlanarTranslation | Motion::Translation => 0..0,
    };
    let time = meanings.symbol(graph, Stage::State, Meaning::Time);
    let attitude = match motion {
        Motion::Planar => Attitude::Angle(meanings.symbol(graph, Stage::State, Meaning::Angle)),
        Motion::Spatial | Motion::Rotation => {
            let scalar = meanings.symbol(graph, Stage::State, Meaning::Quaternion(0));
            let vector =
                [1, 2, 3].map(|i| meanings.symbol(graph, Stage::State, Meaning::Quaternion(i)));
            Attitude::Quaternion { scalar, vector }
        }
        Motion::PlanarTranslation | Motion::Translation => Attitude::Fixed,
    };
    let state = State {
        time,
        position: meanings.vector(graph, linear.clone(), Meaning::Position),
        velocity: meanings.vector(graph, linear.clone(), Meaning::Velocity),
        angular_velocity: meanings.vector(graph, angular.clone(), Meaning::AngularVelocity),
        linear_acceleration: meanings.vector(graph, linear, Meaning::LinearAcceleration),
        angular_acceleration: meanings.vector(graph, angular, Meaning::AngularAcceleration),
    };
    (state, attitude)
}
