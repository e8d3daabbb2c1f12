//! Rotated vectors, kept apart.
//!
//! As its body rotates, a rotated vector changes by `phi x r`. So a potential can be differentiated
//! without differentiating the rotation. For this, where potentials are read, the components of a
//! vector in other axes are new symbols, which stand for the rotated vector until the potential is
//! differentiated.

use std::collections::HashMap;

use crate::model::words::Frame;
use crate::symbolic::{Components, Graph, Id, Stage};

/// A vector, and its components in other axes, or the symbols that stand for them.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Turn {
    /// The axes in which it was written, and those into which it was rotated.
    pub from: Frame,
    pub to: Frame,
    pub vector: Components,
    pub turned: Components,
}

/// The vectors that were rotated so far; each comes after those that it contains.
pub struct Turns {
    pub list: Vec<Turn>,
    known: HashMap<(Components, Frame, Frame), usize>,
    by_symbol: HashMap<Id, usize>,
    /// The number of components.
    axes: usize,
    /// The axes in which the length of a vector is taken if it has parts in both axes.
    mixed: Frame,
    /// Whether the length of such a vector was taken.
    pub met_mixed: bool,
    /// Frames that rotate separately, including those that a joint holds at a fixed angle.
    apart: Vec<Frame>,
}

impl Turns {
    pub fn new(axes: usize, mixed: Frame) -> Self {
        Self {
            list: Vec::new(),
            known: HashMap::new(),
            by_symbol: HashMap::new(),
            axes,
            mixed,
            met_mixed: false,
            apart: Vec::new(),
        }
    }

    /// The same for bodies whose frames rotate separately.
    pub fn of_bodies(axes: usize, bodies: impl Iterator<Item = Frame>) -> Self {
        let mut turns = Self::new(axes, Frame::WORLD);
        turns.apart.extend(bodies);
        turns
    }

    pub fn are_apart(&self, body: Frame) -> bool {
        self.apart.contains(&body)
    }

    /// The rotated vector that has this symbol as a component.
    pub fn of(&self, symbol: Id) -> Option<&Turn> {
        self.list.get(*self.by_symbol.get(&symbol)?)
    }

    pub fn choose_axes(&mut self) -> Frame {
        self.met_mixed = true;
        self.mixed
    }

    /// The symbols of `vector` in the axes of `to`; the same vector always has the same symbols.
    pub fn turn(
        &mut self,
        graph: &mut Graph,
        vector: Components,
        from: Frame,
        to: Frame,
    ) -> Components {
        let key = (vector, from, to);
        if let Some(index) = self.known.get(&key) {
            return self.list[*index].turned;
        }
        let axes = self.axes;
        let turned = [0, 1, 2].map(|axis| {
            if axis < axes {
                graph.symbol(Stage::State)
            } else {
                graph.zero()
            }
        });
        let index = self.list.len();
        self.known.insert(key, index);
        self.by_symbol
            .extend(turned[..axes].iter().map(|symbol| (*symbol, index)));
        self.list.push(Turn {
            from,
            to,
            vector,
            turned,
        });
        turned
    }
}
