//! Frames, identified by an index.

/// The axes of components: those of the ground, or those that rotate with a body.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub struct Frame(usize);

impl Frame {
    pub const WORLD: Self = Self(0);

    pub fn with_index(index: usize) -> Self {
        Self(index)
    }

    pub fn index(self) -> usize {
        self.0
    }

    /// Its word in generated names and in messages.
    pub fn word(self) -> &'static str {
        if self == Self::WORLD { "world" } else { "body" }
    }
}

/// The word in a description for the axes of a vector.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum FrameWord {
    World,
    Body,
}

impl FrameWord {
    pub fn text(self) -> &'static str {
        match self {
            Self::World => "world",
            Self::Body => "body",
        }
    }
}
