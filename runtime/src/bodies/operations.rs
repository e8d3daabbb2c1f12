//! Operation counts of generated functions.

use core::fmt;

/// The stage in which an expression is evaluated.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Stage {
    /// Once, in the constructor.
    Parameter,
    /// At every evaluation.
    State,
}

/// The operations of one generated function in one stage; negations are not counted.
///
/// ```
/// use newton_euler::operations::{Operations, Stage};
///
/// let planar =
///     Operations { add: 1, mul: 2, trig: 2, ..Operations::none("acceleration", Stage::State) };
/// assert_eq!(planar.total(), 3);
/// assert_eq!(
///     planar.to_string(),
///     "acceleration                 state      \
///      mul   2  add   1  div   0  sqrt   0  trig   2  other   0",
/// );
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Operations {
    /// The name of the function.
    pub function: &'static str,
    /// The counted stage.
    pub stage: Stage,
    /// Multiplications.
    pub mul: u32,
    /// Additions and subtractions.
    pub add: u32,
    /// Divisions.
    pub div: u32,
    /// Square roots.
    pub sqrt: u32,
    /// Sines, cosines, exponentials and other transcendental functions.
    pub trig: u32,
    /// Everything else: comparisons, choices, absolute values, roundings.
    pub other: u32,
}

impl Operations {
    /// A function without operations, to fill in.
    #[must_use]
    pub const fn none(function: &'static str, stage: Stage) -> Self {
        Self {
            function,
            stage,
            mul: 0,
            add: 0,
            div: 0,
            sqrt: 0,
            trig: 0,
            other: 0,
        }
    }

    /// Counts of mul, add, div, sqrt, trig and other, in this order, once in the constructor.
    #[must_use]
    pub const fn parameter(function: &'static str, counts: [u32; 6]) -> Self {
        Self::counted(function, Stage::Parameter, counts)
    }

    /// The same at every evaluation.
    #[must_use]
    pub const fn state(function: &'static str, counts: [u32; 6]) -> Self {
        Self::counted(function, Stage::State, counts)
    }

    const fn counted(function: &'static str, stage: Stage, counts: [u32; 6]) -> Self {
        let [mul, add, div, sqrt, trig, other] = counts;
        Self {
            function,
            stage,
            mul,
            add,
            div,
            sqrt,
            trig,
            other,
        }
    }

    /// Arithmetic operations: multiplications, additions and divisions.
    #[must_use]
    pub const fn total(&self) -> u32 {
        self.mul + self.add + self.div
    }
}

impl fmt::Display for Operations {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let stage = match self.stage {
            Stage::Parameter => "parameter",
            Stage::State => "state",
        };
        write!(
            f,
            "{:<28} {stage:<9}  mul {:>3}  add {:>3}  div {:>3}  sqrt {:>3}  trig {:>3}  other {:>3}",
            self.function, self.mul, self.add, self.div, self.sqrt, self.trig, self.other,
        )
    }
}
