//! The syntax of a description: its keys, entries and expressions, with their places.
//!
//! Each bracket is split at its commas, and every entry is parsed alone, so that a bad entry hides
//! no others. It is reported, and the name that it would have defined stays known, without a value.
//! Nothing is looked up here, and nothing has a meaning yet.

mod bare_unit;
mod brackets;
mod entries;
mod expression;
mod head;
mod mjcf;
mod motion;
mod nesting;
mod read;
mod screen;
mod sizes;
mod system;
mod tokens;
mod unit;
mod urdf;
mod words;
mod xml;

use proc_macro2::{Ident, TokenStream};

use crate::errors::Extent;

use crate::families::Family;
use crate::families::LoadKind;
pub use entries::{Composition, Constant, Function, Part, key_meant, parse_description};
pub use expression::{Called, Expression, Kind, Operator, Prefix, Step, call};
pub use motion::{ROD, SUPPORTS};
pub use system::{CABLE, Center, File, LINK, System, file_beside, parse_lone_body, parse_system};
pub use unit::UnitExpression;
pub use words::{BUILT_IN, NOT, joined};

/// A whole description.
#[derive(Clone)]
pub struct Description {
    pub name: Ident,
    /// Whether it has no mass, as a link of a file that only marks a place.
    pub is_frame: bool,
    /// Names of points that come from a file; they need not be used.
    pub given: Vec<String>,
    /// The scalar over which the body is generic.
    pub scalar: Option<Ident>,
    /// The path of the runtime, as the wrapper macro passes it.
    pub runtime: TokenStream,
    /// All keys as written, known or unknown, each once.
    pub keys: Vec<Ident>,
    /// Names of entries that could not be read. This is already reported, so references to them
    /// cause no further errors.
    pub lost: Vec<String>,
    pub doc: Vec<String>,
    pub motion: Option<Motion>,
    pub mass: Option<Written>,
    pub inertia: Option<Written>,
    /// `inertia: compose([..])`, which gives mass, G and inertia together.
    pub composition: Option<Composition>,
    /// Rust constants and functions of the user.
    pub constants: Vec<Constant>,
    pub functions: Vec<Function>,
    /// The documentation of params, inputs and states, by name.
    pub texts: Vec<(String, Vec<String>)>,
    pub params: Vec<Declaration>,
    pub inputs: Vec<Declaration>,
    /// User-defined states, and the rate of each.
    pub states: Vec<Declaration>,
    pub rates: Vec<Definition>,
    pub points: Vec<Definition>,
    pub locals: Vec<Definition>,
    pub loads: Vec<Load>,
    pub potentials: Vec<Definition>,
    pub constraints: Vec<Definition>,
    pub checks: Vec<Check>,
    pub pole: Option<Written>,
    pub outputs: Vec<Ident>,
}

impl Description {
    /// An empty description.
    fn new(name: Ident, runtime: TokenStream) -> Self {
        Self {
            name,
            is_frame: false,
            given: Vec::new(),
            scalar: None,
            runtime,
            keys: Vec::new(),
            lost: Vec::new(),
            doc: Vec::new(),
            motion: None,
            mass: None,
            inertia: None,
            composition: None,
            constants: Vec::new(),
            functions: Vec::new(),
            texts: Vec::new(),
            params: Vec::new(),
            inputs: Vec::new(),
            states: Vec::new(),
            rates: Vec::new(),
            points: Vec::new(),
            locals: Vec::new(),
            loads: Vec::new(),
            potentials: Vec::new(),
            constraints: Vec::new(),
            checks: Vec::new(),
            pole: None,
            outputs: Vec::new(),
        }
    }
}

impl Description {
    /// The names of Rust items of the user, and their kinds.
    pub fn foreign(&self) -> impl Iterator<Item = (&Ident, &'static str)> {
        let constants = self.constants.iter().map(|one| (&one.name, "constant"));
        let functions = self.functions.iter().map(|one| (&one.name, "function"));
        constants.chain(functions)
    }
}

/// The value of a key or of an entry. `None` means that an error was reported; it causes no further
/// errors.
pub type Value = Option<Expression>;

/// `key: value`, for a known key.
#[derive(Clone)]
pub struct Written {
    pub value: Value,
}

/// `motion: word`; for a body with a support, or a rod, `motion: word(arguments)`.
#[derive(Clone)]
pub struct Motion {
    pub word: Ident,
    /// The arguments of the word, and of `.at(..)` after it.
    pub support: Option<Support>,
}

/// `(point)`, `(point, direction)` or `(direction)`, and `.at(anchor)`.
#[derive(Clone)]
pub struct Support {
    pub arguments: Vec<Value>,
    pub anchor: Option<Value>,
    pub extent: Extent,
}

/// `name`, `name[unit]` or `name = value`: a parameter, an input or a user-defined state.
#[derive(Clone)]
pub struct Declaration {
    pub name: Ident,
    pub unit: Option<UnitExpression>,
    /// The value after the `=`, if there is one.
    pub value: Option<Value>,
    /// `.moving`, after the name of an input that is given with its rate and acceleration.
    pub moving: Option<Ident>,
    /// 1 for the rate and 2 for the acceleration of a `.moving` input, which are declared with it;
    /// else 0.
    pub order: usize,
}

impl Declaration {
    /// The rate and the acceleration of a `.moving` input.
    fn derivative(&self, order: usize) -> Self {
        let word = self.name.to_string();
        let suffix = if order == 1 { "rate" } else { "acceleration" };
        let name = format!("{}_{suffix}", word.trim_start_matches("r#"));
        Self {
            name: Ident::new(&name, self.name.span()),
            unit: self.unit.clone(),
            value: self.value.clone(),
            moving: None,
            order,
        }
    }
}

/// `name = value`: a point, a local, a potential, a constraint, or the rate of a state.
#[derive(Clone)]
pub struct Definition {
    pub name: Ident,
    pub value: Value,
}

/// `name = vector`, `name = vector.at(point)`, `name = moment(vector)` or `name = vector.on([..])`.
#[derive(Clone)]
pub struct Load {
    pub name: Ident,
    pub family: Family,
    pub kind: LoadKind,
    pub vector: Value,
    /// The argument of `.at(..)`, if given.
    pub point: Option<Value>,
    /// The argument of `.on([..])`, if given: the vector is then a field, not a force.
    pub charges: Option<Vec<Charge>>,
}

/// `name = left < right`, joined by `&&`, followed by `.given(..)`.
#[derive(Clone)]
pub struct Check {
    pub name: Ident,
    pub claims: Vec<Claim>,
    pub given: Vec<Given>,
}

/// One comparison.
#[derive(Clone)]
pub struct Claim {
    pub left: Expression,
    pub step: Step,
    pub extent: Extent,
}

/// `target = value`
#[derive(Clone)]
pub struct Given {
    pub target: Expression,
    pub value: Expression,
}

/// `charge.at(point)`
#[derive(Clone)]
pub struct Charge {
    pub charge: Value,
    pub point: Value,
}
