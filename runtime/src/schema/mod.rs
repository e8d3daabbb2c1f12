//! The language of descriptions, for editors. For them, the macros name each word of a description
//! as a field of one of these structs, or of a generated one: that gives it hover text, completion,
//! definition, references and rename. Only editors compile this.

mod keys;
mod units;
mod words;

pub use keys::{Body, System};
pub use units::Units;
pub use words::{Joints, Members, Motions, Outputs, SystemOutputs, Words};

/// A struct with a field for each word; words in one row have one text.
macro_rules! language {
    ($(#[$doc:meta])* $name:ident { $($text:literal $($word:ident)+;)* }) => {
        $(#[$doc])*
        #[derive(Debug)]
        #[non_exhaustive]
        #[allow(non_snake_case)]
        pub struct $name {
            $($(#[doc = $text] pub $word: (),)+)*
        }
    };
}
use language;

/// Types of names that a description defines: they say what a name stands for.
macro_rules! kinds {
    ($($(#[$doc:meta])* $name:ident;)*) => {
        $($(#[$doc])* #[derive(Clone, Copy, Debug)] pub struct $name;)*
    };
}

kinds! {
    /// A constant of a run.
    Param;
    /// A quantity given at each evaluation.
    Input;
    /// A user-defined state.
    OwnState;
    /// A constant of the surrounding Rust code.
    Constant;
    /// A function of the surrounding Rust code.
    Function;
    /// A point of a body, or of space.
    Point;
    /// A named expression.
    Local;
    /// A body of a system.
    BodyOfSystem;
    /// A joint of a system.
    Jointed;
    /// The load of a constraint.
    Reaction;
    /// An expression that the motion keeps at zero.
    Constraint;
    /// A load or a claim.
    Entry;
    /// Nothing else has a name here.
    Nothing;
}
