//! Kinds of loads, by their keys and their nature.

/// The families of loads of (1.3) and (1.4), by their keys.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Family {
    Reaction,
    Joint,
    External,
    Field,
}

/// A force or a moment.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum LoadKind {
    Force,
    Moment,
}
