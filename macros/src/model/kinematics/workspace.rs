//! The workspace of a description.

use crate::model::words::{
    Doubtful, ForeignConstant, ForeignFunction, Frame, Labels, Meaning, Meanings, Variable,
};
use std::collections::HashMap;
use std::ops::Range;

use crate::symbolic::{Components, Graph, Id, Node, Stage};

use super::attitude::Attitude;
use super::turned_vector::{Turn, Turns};
use super::vector::{Vector, Vectors};

/// The workspace of a description: its graph, its vectors in their frames, and the words for its
/// content. Lowering creates it, and mechanics continues with it.
#[derive(Default)]
pub struct Workspace {
    pub graph: Graph,
    pub labels: Labels,
    pub meanings: Meanings,
    /// Rust items of the user, by their index in the graph.
    pub constants: Vec<ForeignConstant>,
    pub functions: Vec<ForeignFunction>,
    /// The paths on this machine of the files with tables.
    pub files: Vec<String>,
    /// The attitude of each frame.
    pub(super) attitudes: Vec<Attitude>,
    /// The carrier of each frame.
    carriers: Vec<Frame>,
    /// The frame that each frame is a copy of, or itself.
    originals: Vec<Frame>,
    pub(super) vectors: Vectors,
    /// For each vector whose length was taken in a frame in which it has fewer components: the square
    /// of the length, and the vector in that frame.
    pub(super) gathered: HashMap<Vector, (Id, Vector)>,
    /// Rotated vectors that are kept apart, while potentials are read.
    pub turns: Option<Turns>,
    /// All other rotated vectors, whose rates are known as vectors.
    pub turned: Vec<Turn>,
    /// For rods: products `u x b`, each with its b, in world axes.
    pub swept: Vec<(Components, Components)>,
    /// Whether a vector was rotated between frames that do not rotate, or whose rotation is not
    /// known yet.
    pub met_still: bool,
    /// Where masses are read as unknown: the symbol of each mass, and its value as written.
    pub unknown_masses: Option<Vec<(Id, Id)>>,
    /// Expressions of the description that may have no value for some parameters.
    pub doubtful: Vec<Doubtful>,
}

impl Workspace {
    /// A workspace that contains only the frame of the ground.
    pub fn new() -> Self {
        Self {
            attitudes: vec![Attitude::Fixed; 1],
            carriers: vec![Frame::WORLD; 1],
            originals: vec![Frame::WORLD; 1],
            ..Self::default()
        }
    }

    /// The same, to read a description in which every mass is unknown.
    pub fn with_unknown_masses() -> Self {
        Self {
            unknown_masses: Some(Vec::new()),
            ..Self::new()
        }
    }

    /// The mass, or a symbol for it where masses are unknown.
    pub fn weighed(&mut self, mass: Id) -> Id {
        let Some(known) = self.unknown_masses.as_ref().map(Vec::len) else {
            return mass;
        };
        let symbol = self.symbol(Stage::Parameter, Meaning::Mass(known));
        let masses = self.unknown_masses.iter_mut();
        masses.for_each(|masses| masses.push((symbol, mass)));
        symbol
    }

    /// A new frame, which can rotate relative to `carrier`. It is parallel until it gets an
    /// attitude.
    pub fn new_frame(&mut self, carrier: Frame) -> Frame {
        self.attitudes.push(Attitude::Fixed);
        self.carriers.push(carrier);
        let frame = Frame::with_index(self.originals.len());
        self.originals.push(frame);
        frame
    }

    pub fn carrier(&self, frame: Frame) -> Frame {
        self.carriers[frame.index()]
    }

    pub fn set_carrier(&mut self, frame: Frame, carrier: Frame) {
        self.carriers[frame.index()] = carrier;
    }

    /// Of the two frames between which a vector was rotated, the one that the other carries.
    pub fn turned_frame(&self, turn: &Turn) -> Frame {
        if self.carrier(turn.from) == turn.to {
            turn.from
        } else {
            turn.to
        }
    }

    /// All rotating frames, without copies.
    pub fn turned_frames(&self) -> Vec<Frame> {
        let mut frames = self.originals.clone();
        frames.sort_unstable();
        frames.dedup();
        frames
    }

    /// The original of this frame, or itself. Motions belong to originals.
    pub(super) fn original(&self, frame: Frame) -> Frame {
        self.originals[frame.index()]
    }

    /// Copies of all frames, with the same attitudes, each relative to the copy of its carrier.
    pub fn copied_frames(&mut self) -> Vec<Frame> {
        let count = self.carriers.len();
        let mut copies = vec![Frame::WORLD];
        for index in 1..count {
            copies.push(self.new_frame(Frame::WORLD));
            self.attitudes[copies[index].index()] = self.attitudes[index];
            self.originals[copies[index].index()] = self.originals[index];
        }
        for index in 1..count {
            let carrier = self.carriers[index];
            self.set_carrier(copies[index], copies[carrier.index()]);
        }
        copies
    }

    /// The frame after `from` on the way to another one: towards the ground first, unless `from`
    /// carries the other.
    pub(super) fn next_frame(&self, from: Frame, to: Frame) -> Frame {
        let mut below = to;
        while below != Frame::WORLD {
            let carrier = self.carrier(below);
            if carrier == from {
                return below;
            }
            below = carrier;
        }
        self.carrier(from)
    }

    /// A new symbol with this meaning, known from `stage` on.
    pub fn symbol(&mut self, stage: Stage, meaning: Meaning) -> Id {
        self.meanings.symbol(&mut self.graph, stage, meaning)
    }

    /// New symbols for the components in `axes`, and zero for the others.
    pub fn symbols(
        &mut self,
        stage: Stage,
        axes: Range<usize>,
        meaning: impl Fn(usize) -> Meaning,
    ) -> Components {
        [0, 1, 2].map(|axis| {
            if axes.contains(&axis) {
                self.symbol(stage, meaning(axis))
            } else {
                self.graph.zero()
            }
        })
    }

    /// The same for a quantity that varies separately and has no name.
    pub fn free_symbols(&mut self, axes: Range<usize>) -> Components {
        [0, 1, 2].map(|axis| {
            if axes.contains(&axis) {
                self.graph.symbol(Stage::State)
            } else {
                self.graph.zero()
            }
        })
    }

    /// The symbol with this meaning, if there is one.
    pub fn symbol_of(&self, meaning: Meaning) -> Option<Id> {
        let known = self.meanings.symbol_of(meaning);
        known.map(|symbol| self.graph.symbol_id(symbol))
    }

    /// The meaning of a symbol; `None` for other expressions.
    pub fn meaning(&self, id: Id) -> Option<Meaning> {
        match self.graph.node(id) {
            Node::Symbol(symbol) => Some(self.meanings.of(*symbol)),
            _ => None,
        }
    }

    /// Whether expressions depend on the motion or on inputs, rather than only on time and
    /// user-defined states.
    pub fn follows_motion(&self, roots: &[Id]) -> bool {
        self.graph.depends_on(roots, |id| {
            let is_course = matches!(self.meaning(id), Some(Meaning::Time | Meaning::Own(_)));
            !is_course && !self.graph.is_early(id)
        })
    }

    /// Whether expressions depend on one of these variables of a motion.
    pub fn depend_on(&self, roots: &[Id], variables: &[Variable]) -> bool {
        self.graph.depends_on(roots, |id| match self.meaning(id) {
            Some(Meaning::Of(_, variable, _)) => variables.contains(&variable),
            _ => false,
        })
    }

    /// The symbols of accelerations that expressions contain.
    pub fn accelerations_in(&self, roots: &[Id]) -> Vec<Id> {
        let is_one = |id: &Id| {
            let meaning = self.meaning(*id);
            matches!(meaning, Some(Meaning::Of(_, variable, _)) if variable.is_acceleration())
        };
        let mut symbols = self.graph.nodes_of(roots);
        symbols.retain(is_one);
        symbols
    }

    /// The rotation of a frame relative to the world.
    pub fn attitude(&self, frame: Frame) -> Attitude {
        self.attitudes[frame.index()]
    }

    pub fn set_attitude(&mut self, frame: Frame, attitude: Attitude) {
        self.attitudes[frame.index()] = attitude;
    }
}
