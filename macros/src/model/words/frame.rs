//! Frames, by index.

/// Axes in which components are written, by index: those of the ground, and those that turn with a
/// body.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub struct Frame(usize);

impl Frame {
    pub const WORLD: Self = Self(0);
    pub const BODY: Self = Self(1);

    /// Of those of a workspace.
    pub fn at(index: usize) -> Self {
        Self(index)
    }

    pub fn index(self) -> usize {
        self.0
    }

    /// As it is written.
    pub fn word(self) -> &'static str {
        if self == Self::WORLD { "world" } else { "body" }
    }
}
