//! Functions of numbers: their names and properties.

/// A function of one or two numbers that is not a rational operation.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum Function {
    Sqrt,
    Cbrt,
    Exp,
    Ln,
    Sin,
    Cos,
    Tan,
    Asin,
    Acos,
    Atan,
    Sinh,
    Cosh,
    Tanh,
    Abs,
    Signum,
    Floor,
    Ceil,
    Atan2,
    Powf,
    Hypot,
    Min,
    Max,
    /// A table. Its second argument is the index of the table times `ORDERS`, plus the order of the
    /// derivative.
    Table,
}

/// More orders of derivatives than any table needs.
pub const ORDERS: i64 = 8;

impl Function {
    /// All functions, under the names that Rust's `f64` gives them.
    pub const ALL: [(&'static str, Self); 22] = [
        ("sqrt", Self::Sqrt),
        ("cbrt", Self::Cbrt),
        ("exp", Self::Exp),
        ("ln", Self::Ln),
        ("sin", Self::Sin),
        ("cos", Self::Cos),
        ("tan", Self::Tan),
        ("asin", Self::Asin),
        ("acos", Self::Acos),
        ("atan", Self::Atan),
        ("sinh", Self::Sinh),
        ("cosh", Self::Cosh),
        ("tanh", Self::Tanh),
        ("abs", Self::Abs),
        ("signum", Self::Signum),
        ("floor", Self::Floor),
        ("ceil", Self::Ceil),
        ("atan2", Self::Atan2),
        ("powf", Self::Powf),
        ("hypot", Self::Hypot),
        ("min", Self::Min),
        ("max", Self::Max),
    ];

    pub fn from_name(name: &str) -> Option<Self> {
        Self::ALL
            .iter()
            .find(|(known, _)| *known == name)
            .map(|(_, function)| *function)
    }

    pub fn name(self) -> &'static str {
        Self::ALL
            .iter()
            .find(|(_, function)| *function == self)
            .map_or("table", |(name, _)| name)
    }

    /// Whether different expressions hold for different arguments.
    pub fn is_piecewise(self) -> bool {
        matches!(
            self,
            Self::Abs
                | Self::Signum
                | Self::Floor
                | Self::Ceil
                | Self::Min
                | Self::Max
                | Self::Table
        )
    }

    /// Whether values at sums are known from values at the terms, by products.
    pub fn makes_products(self) -> bool {
        matches!(
            self,
            Self::Sin | Self::Cos | Self::Tan | Self::Sinh | Self::Cosh | Self::Tanh | Self::Exp
        )
    }

    /// The number of arguments, including the receiver.
    pub fn arity(self) -> usize {
        match self {
            Self::Atan2 | Self::Powf | Self::Hypot | Self::Min | Self::Max | Self::Table => 2,
            _ => 1,
        }
    }
}
