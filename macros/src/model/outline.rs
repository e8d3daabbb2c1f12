//! The outline of a body: what its types and signatures follow from. It exists for every
//! description, however broken, so that the rest of a user's crate stays as it is.

use proc_macro2::{Ident, TokenStream};

use crate::errors::{Errors, hint};
use crate::symbolic::Number;
use crate::syntax::{Declaration, Description, Expression, Kind};

use super::dimension::Dimension;
use super::frame::Frame;
use super::motion::Motion;

/// Outputs of later versions.
const LATER: [&str; 6] = [
    "reactions",
    "linearization",
    "flow",
    "taylor",
    "inverse",
    "sensitivity",
];

/// What can be asked for beyond the accelerations.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Output {
    Energy,
    Momentum,
    Balance,
}

impl Output {
    pub const ALL: [(&'static str, Self); 3] = [
        ("energy", Self::Energy),
        ("momentum", Self::Momentum),
        ("balance", Self::Balance),
    ];
}

/// The name, motion, parameters, inputs, outputs and keys of a description.
pub struct Outline {
    pub name: Ident,
    /// The path of the runtime crate.
    pub runtime: TokenStream,
    pub doc: Vec<String>,
    pub motion: Motion,
    pub params: Vec<Declared>,
    pub inputs: Vec<Declared>,
    pub outputs: Vec<Output>,
    pub keys: Vec<Ident>,
    /// Names that nothing in the description refers to.
    pub unused: Vec<Ident>,
}

/// A parameter or an input.
pub struct Declared {
    pub name: Ident,
    /// Whether it is a vector, and in which axes its components are written.
    pub frame: Option<Frame>,
    pub dimension: Dimension,
    /// Default of a parameter, one number for each component.
    pub default: Option<Vec<Number>>,
}

impl Outline {
    /// Whether the body can be built from the defaults alone.
    pub fn has_default(&self) -> bool {
        self.params.iter().all(|param| param.default.is_some())
    }
}

/// The outline of `description`; without a valid motion it is taken to be `spatial`.
pub fn outline(description: &Description, errors: &mut Errors) -> Outline {
    let motion = check_motion(description, errors);
    let declared = |declaration: &Declaration| Declared {
        name: declaration.name.clone(),
        frame: declaration.value.iter().flatten().find_map(written_frame),
        dimension: Dimension::ANY,
        default: None,
    };
    Outline {
        name: description.name.clone(),
        runtime: description.runtime.clone(),
        doc: description.doc.clone(),
        motion: motion.unwrap_or(Motion::Spatial),
        params: distinct(&description.params).map(declared).collect(),
        inputs: distinct(&description.inputs).map(declared).collect(),
        outputs: check_outputs(description, errors),
        keys: description.keys.clone(),
        unused: Vec::new(),
    }
}

/// The declarations without those that repeat a name: a struct has a field once.
pub fn distinct(declarations: &[Declaration]) -> impl Iterator<Item = &Declaration> {
    let is_first = |index: usize| {
        declarations[..index]
            .iter()
            .all(|other| other.name != declarations[index].name)
    };
    declarations
        .iter()
        .enumerate()
        .filter(move |(index, _)| is_first(*index))
        .map(|(_, declaration)| declaration)
}

/// The axes in which a declared vector is written, as far as its form tells.
fn written_frame(value: &Expression) -> Option<Frame> {
    match &value.kind {
        Kind::Unit(operand, _) | Kind::Prefix(_, operand) => written_frame(operand),
        Kind::Tuple(_) => Some(Frame::Body),
        Kind::Call(name, _) if name == "body" => Some(Frame::Body),
        Kind::Call(name, _) if name == "world" => Some(Frame::World),
        _ => None,
    }
}

fn check_motion(description: &Description, errors: &mut Errors) -> Option<Motion> {
    let words = || Motion::ALL.iter().map(|(word, _)| *word);
    let Some(word) = &description.motion else {
        if !description.keys.iter().any(|key| key == "motion") {
            let all = words().collect::<Vec<_>>().join("`, `");
            errors.push(
                description.name.span(),
                format!(
                    "`{}` has no motion: write `motion: ..`, one of `{all}`",
                    description.name
                ),
            );
        }
        return None;
    };
    let written = word.to_string();
    let found = Motion::ALL.iter().find(|(known, _)| *known == written);
    if found.is_none() {
        let later = ["pivot", "fixed_point", "fixed_axis", "rod"];
        if later.contains(&written.as_str()) {
            errors.push(
                word.span(),
                format!(
                    "`{written}(..)` is part of the language, but this version does not have it yet"
                ),
            );
        } else {
            let all = words().collect::<Vec<_>>().join("`, `");
            errors.push(
                word.span(),
                format!(
                    "unknown motion `{written}`: expected `{all}`{}",
                    hint(&written, words())
                ),
            );
        }
    }
    found.map(|(_, motion)| *motion)
}

fn check_outputs(description: &Description, errors: &mut Errors) -> Vec<Output> {
    let mut outputs = Vec::new();
    for word in &description.outputs {
        let written = word.to_string();
        match Output::ALL.iter().find(|(known, _)| *known == written) {
            Some((_, output)) if outputs.contains(output) => {
                errors.push(word.span(), format!("`{written}` is asked for twice"))
            }
            Some((_, output)) => outputs.push(*output),
            None if LATER.contains(&written.as_str()) => {
                errors.push(
                    word.span(),
                    format!(
                        "`{written}` is part of the language, but this version does not have it yet"
                    ),
                );
            }
            None => {
                let words = Output::ALL.iter().map(|(word, _)| *word);
                let all = words.clone().collect::<Vec<_>>().join("`, `");
                errors.push(
                    word.span(),
                    format!(
                        "unknown output `{written}`: expected `{all}`{}",
                        hint(&written, words)
                    ),
                );
            }
        }
    }
    outputs
}
