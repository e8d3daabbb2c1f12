//! The outline of a body, which determines its types and signatures. Every description has one,
//! however broken, so that the rest of a user's crate still compiles.

use std::collections::HashSet;

use proc_macro2::Ident;

use crate::errors::{Errors, hint, hint_of_motion};
use crate::families::LoadKind;
use crate::lower::expressions::{
    has_placeholder, is_drive, is_turning_drive, is_unknown, written_frame, written_motion,
};
use crate::model::{Asked, Declared, Dimension, Joint, MOTIONS, Motion, Outline};
use crate::symbolic::Number;
use crate::syntax::{self, Declaration, Description, Expression, Kind, ROD, SUPPORTS};

/// Outputs that systems have and bodies do not.
const OF_SYSTEMS: [&str; 2] = ["mass_matrix", "jacobian"];

/// The output that solves for drives. Without it, no drive may be unknown.
pub const INVERSE: &str = "inverse";

/// The output that needs the description with unknown masses.
pub const REGRESSOR: &str = "regressor";

/// The outputs that need derivatives of the equations.
pub const LINEARIZATION: &str = "linearization";
pub const FLOW: &str = "flow";

/// An output that a description may request, beyond the accelerations.
pub struct Offer {
    pub word: &'static str,
    /// Why a description cannot request it, and what to write instead.
    pub obstacle: fn(&Description) -> Option<&'static str>,
    /// Whether `SKIPPED` lists it if it is not requested.
    pub is_missed: fn(&Outline) -> bool,
    /// Whether it has no meaning if nothing moves by itself.
    pub is_of_motion: bool,
}

impl Offer {
    /// An output that every description may request, and that is not listed if it is not requested.
    pub const fn new(word: &'static str) -> Self {
        Self {
            word,
            obstacle: |_| None,
            is_missed: |_| false,
            is_of_motion: false,
        }
    }
}

/// The outline of `description` under this motion.
pub fn outline_under(
    motion: Motion,
    description: &Description,
    offers: &[&'static Offer],
    errors: &mut Errors,
) -> Outline {
    check_motion(description, errors);
    let declared = |declarations| {
        let each =
            distinct(declarations).map(|declaration| declared(declaration, description, motion));
        each.collect()
    };
    Outline {
        name: description.name.clone(),
        scalar: description.scalar.clone(),
        runtime: description.runtime.clone(),
        doc: description.doc.clone(),
        motion,
        is_system: false,
        joints: Vec::new(),
        bodies: Vec::new(),
        holding: Vec::new(),
        held: None,
        points: Vec::new(),
        driving: Vec::new(),
        kept: Vec::new(),
        foreign: description
            .foreign()
            .map(|(name, _)| name.clone())
            .collect(),
        params: declared(&description.params),
        inputs: declared(&description.inputs),
        states: declared(&description.states),
        outputs: check_outputs(description, offers, errors),
        reactions: by_name(description, is_unknown),
        drives: by_name(description, is_drive),
        has_turning_drive: description.loads.iter().any(is_turning_drive)
            || !description.constraints.is_empty()
            || written_motion(description).is_some_and(Joint::is_line),
        is_constrained: !description.constraints.is_empty(),
        loads: description
            .loads
            .iter()
            .filter(|load| !is_unknown(load) && !is_drive(load))
            .count()
            + description.potentials.len(),
        open: Vec::new(),
        unused: Vec::new(),
    }
}

/// A declaration, as far as it is known before names are looked up.
fn declared(declaration: &Declaration, description: &Description, motion: Motion) -> Declared {
    let frame = declaration.value.iter().flatten().find_map(written_frame);
    let has_default = declaration
        .value
        .as_ref()
        .is_some_and(|value| !value.as_ref().is_some_and(has_placeholder));
    let components = frame.map_or(1, |_| motion.axes());
    let mut texts = description.texts.iter();
    let text = texts.find(|(name, _)| declaration.name == name);
    Declared {
        name: declaration.name.clone(),
        text: text.map_or_else(Vec::new, |(_, lines)| lines.clone()),
        frame,
        dimension: Dimension::ANY,
        unit: None,
        moves: declaration.moving.is_some(),
        order: declaration.order,
        default: has_default.then(|| vec![Number::zero(); components]),
    }
}

/// The declarations without repeated names, because a struct cannot have a field twice.
pub fn distinct(declarations: &[Declaration]) -> impl Iterator<Item = &Declaration> {
    let mut seen = HashSet::new();
    declarations
        .iter()
        .filter(move |declaration| seen.insert(declaration.name.to_string()))
}

fn check_motion(description: &Description, errors: &mut Errors) {
    let words = || MOTIONS.iter().map(|motion| motion.word);
    let all = || words().collect::<Vec<_>>().join("`, `");
    let name = &description.name;
    let Some(syntax::Motion { word, support }) = &description.motion else {
        // a key without a value is already reported, and so is a system
        if !description.is_system() && !description.keys.iter().any(|key| key == "motion") {
            errors.push(
                name.span(),
                format!(
                    "`{name}` has no motion: write `motion: ..`, one of `{}`",
                    all()
                ),
            );
        }
        return;
    };
    let written = word.to_string();
    if written == ROD && support.is_none() {
        errors.push(
            word.span(),
            "`rod` along which axis? write `rod(body(1, 0, 0))` with its direction in the body",
        );
    } else if SUPPORTS.contains(&written.as_str()) && support.is_none() {
        errors.push(
            word.span(),
            format!("`{written}` about which point? write `{written}(P)` with a point of the body"),
        );
    } else if written_motion(description).is_none() {
        let hint = hint_of_motion(&written, words());
        errors.push(
            word.span(),
            format!(
                "unknown motion `{written}`: expected one of `{}`{hint}",
                all()
            ),
        );
    }
}

/// The `wanted` loads, each name once.
fn by_name(description: &Description, wanted: fn(&syntax::Load) -> bool) -> Vec<(Ident, LoadKind)> {
    let mut seen = HashSet::new();
    let unknown = description.loads.iter().filter(|load| wanted(load));
    let loads = unknown.map(|load| (load.name.clone(), load.kind));
    loads
        .filter(|(name, _)| seen.insert(name.to_string()))
        .collect()
}

/// Whether an error was reported for an entry that may be meant as an unknown load.
fn is_reported(description: &Description) -> bool {
    let is_partly_open = |value: &Expression| {
        let mut found = false;
        value.visit(|part| found |= matches!(part.kind, Kind::Placeholder));
        found
    };
    let is_inverse = description.outputs.iter().any(|output| output == INVERSE);
    let is_right = |load: &syntax::Load| is_unknown(load) || is_inverse && is_drive(load);
    let wrong =
        |load: &syntax::Load| load.vector.as_ref().is_none_or(is_partly_open) && !is_right(load);
    !description.lost.is_empty() || description.loads.iter().any(wrong)
}

fn check_outputs(
    description: &Description,
    offers: &[&'static Offer],
    errors: &mut Errors,
) -> Vec<Asked> {
    let mut outputs: Vec<Asked> = Vec::new();
    for word in &description.outputs {
        let (written, place) = (word.to_string(), word.span());
        let Some(offer) = offers.iter().find(|offer| offer.word == written) else {
            errors.push(place, unknown_output(&written, offers));
            continue;
        };
        let obstacle = (offer.obstacle)(description).filter(|_| !is_reported(description));
        if outputs.iter().any(|asked| asked.word == written) {
            errors.push(place, format!("`{written}` is requested twice"));
        } else if let Some(obstacle) = obstacle {
            errors.push(place, obstacle);
        } else {
            outputs.push(Asked {
                word: offer.word,
                place: place.into(),
                is_of_motion: offer.is_of_motion,
            });
        }
    }
    outputs
}

fn unknown_output(written: &str, offers: &[&'static Offer]) -> String {
    if OF_SYSTEMS.contains(&written) {
        return format!(
            "`{written}` is an output of systems: write the body in `bodies` of `rigid_system!`, on a joint such as \
             `whole = free(body)`"
        );
    }
    let words = offers.iter().map(|offer| offer.word);
    let all = words.clone().collect::<Vec<_>>().join("`, `");
    let hint = hint(written, words);
    format!("unknown output `{written}`: expected one of `{all}`{hint}")
}
