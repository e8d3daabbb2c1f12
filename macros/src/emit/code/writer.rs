//! What functions are written with: their arguments, stored fields, and number types.

use proc_macro2::Ident;

use crate::model::{Outline, Workspace};
use crate::symbolic::{Id, Program, Stage};

use super::naming::Names;
use super::shapes::Shapes;

/// Names that exist before the first statement of a function.
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

/// The arguments of most methods.
pub const COMMON: [Source; 3] = [Source::Time, Source::State, Source::Input];

/// Expressions that the constructor stores, each with its field.
#[derive(Default)]
pub struct Fields(pub Vec<(Id, Ident)>);

impl Fields {
    pub const NONE: &'static Self = &Self(Vec::new());

    pub fn get(&self, id: Id) -> Option<&Ident> {
        let found = self.0.iter().find(|(field, _)| *field == id);
        found.map(|(_, name)| name)
    }
}

/// How functions receive the motion.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Told {
    Nothing,
    State,
    /// As arrays with the numbers of state and input, for evaluation in constants.
    Arrays,
}

/// Writes the functions of one body that run at one stage.
#[derive(Clone)]
pub struct Writer<'a> {
    pub work: &'a Workspace,
    pub outline: &'a Outline,
    /// The fields that the constructor has stored, which can be read.
    pub fields: &'a Fields,
    /// The fields that the constructor is to compute and store, with their names.
    pub targets: &'a Fields,
    pub stage: Stage,
    /// Whether the functions return a `Result`, so that an impossible division returns an error. In
    /// other functions, it panics.
    pub is_fallible: bool,
    /// Whether the functions compute everything that is not stored, as functions that are rarely
    /// called do.
    pub is_whole: bool,
    pub told: Told,
    /// The number type, and the numeric types.
    pub shapes: Shapes,
}

impl<'a> Writer<'a> {
    /// Writes functions of the state, in the scalar of the body.
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

    /// Writes functions in doubles, even for a generic body.
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

    /// The names that are taken before any statement: those of arguments and of fields. In code,
    /// `self` distinguishes fields from statements, but in the text nothing does. Fields that the
    /// constructor has not computed yet count, too.
    pub fn taken(&self) -> Names {
        let fields = self.fields.0.iter().chain(&self.targets.0);
        let fields = fields.map(|(_, name)| name.to_string());
        let taken = TAKEN.split(' ').map(str::to_owned);
        taken.chain(fields).collect()
    }
}
