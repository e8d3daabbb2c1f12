//! What functions are written with: what they are given, what is stored, and what the numbers are.

use proc_macro2::Ident;

use crate::model::{Outline, Workspace};
use crate::symbolic::{Id, Program, Stage};

use super::naming::Names;
use super::shapes::Shapes;

/// Names that a function has before its first statement.
const TAKEN: &str = "self time state input acceleration reactions params f64";

/// Where the values of symbols come from.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Source {
    Time,
    State,
    Acceleration,
    Reactions,
    Params,
    Input,
}

/// What most methods are given.
pub const COMMON: [Source; 3] = [Source::Time, Source::State, Source::Input];

/// Expressions that the constructor stores, by their fields.
#[derive(Default)]
pub struct Fields(pub Vec<(Id, Ident)>);

impl Fields {
    pub const NONE: &'static Self = &Self(Vec::new());

    pub fn get(&self, id: Id) -> Option<&Ident> {
        let found = self.0.iter().find(|(field, _)| *field == id);
        found.map(|(_, name)| name)
    }
}

/// What functions are given of the motion.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Told {
    Nothing,
    State,
    /// The numbers of state and input, as in constants.
    Arrays,
}

/// Writes the functions of one body that run at one stage.
#[derive(Clone)]
pub struct Writer<'a> {
    pub work: &'a Workspace,
    pub outline: &'a Outline,
    /// What the constructor has stored, to be read.
    pub fields: &'a Fields,
    /// What the constructor is to store, to be computed under these names.
    pub targets: &'a Fields,
    pub stage: Stage,
    /// Whether the functions return a `Result`, so that a division that cannot be done ends them;
    /// it panics in the others.
    pub is_fallible: bool,
    /// Whether they compute all that is not stored, for functions that are seldom called.
    pub is_whole: bool,
    pub told: Told,
    /// What the numbers are, and the types that hold them.
    pub shapes: Shapes,
}

impl<'a> Writer<'a> {
    /// For functions of the state, in the scalar of the body.
    pub fn new(outline: &'a Outline, work: &'a Workspace, fields: &'a Fields) -> Self {
        Self {
            work,
            outline,
            fields,
            targets: Fields::NONE,
            stage: Stage::State,
            is_fallible: false,
            is_whole: false,
            told: Told::State,
            shapes: Shapes::of(outline),
        }
    }

    /// For functions in doubles, of a generic body too.
    pub fn double(&self) -> Self {
        Self {
            shapes: Shapes::double(self.outline),
            ..self.clone()
        }
    }

    pub fn schedule(&self, outputs: &[Id]) -> Program {
        let graph = &self.work.graph;
        if self.is_whole {
            return graph.schedule_where(outputs, |id| self.fields.get(id).is_none());
        }
        graph.schedule(outputs, self.stage)
    }

    /// Names that are not there for statements: those of arguments, and those of fields, which are
    /// told from statements by `self` in the code and by nothing in its text, or which the
    /// constructor is yet to compute.
    pub fn taken(&self) -> Names {
        let fields = self.fields.0.iter().chain(&self.targets.0);
        let fields = fields.map(|(_, name)| name.to_string());
        let taken = TAKEN.split(' ').map(str::to_owned);
        taken.chain(fields).collect()
    }
}
