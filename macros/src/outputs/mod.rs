//! What is generated beside the accelerations, one file each: what it derives, what it emits, what
//! it documents. An output that is new is a file, and a line in one of two lists:
//! `solved` and `observed`.

mod balance;
mod constrained;
mod energy;
mod flow;
mod inverse;
mod momentum;
mod output;
mod reactions;
mod structured;
mod system;
mod taylor;

use crate::emit::code::Site;
use crate::emit::items::{Addition, Roots};
use crate::errors::Errors;
use crate::lower::Offer;
use crate::mechanics::{Equations, Report, Switch};
use crate::model::{Model, Outline, Workspace};

pub use system::{SystemOutputs, derive_system_outputs, system_offers};

use output::{Basis, Output, Place};

/// What is solved for, or looked for.
fn solved() -> [Box<dyn Output>; 4] {
    [
        Box::<inverse::Inverse>::default(),
        Box::<flow::Flow>::default(),
        Box::<structured::Structured>::default(),
        Box::<taylor::Taylor>::default(),
    ]
}

/// What is read off the motion.
fn observed() -> [Box<dyn Output>; 5] {
    [
        Box::<energy::Energy>::default(),
        Box::<momentum::Momentum>::default(),
        Box::<balance::Balance>::default(),
        Box::<reactions::Reactions>::default(),
        Box::<constrained::Constrained>::default(),
    ]
}

/// What a description may ask for.
pub fn offers() -> Vec<&'static Offer> {
    let all = observed().into_iter().chain(solved());
    all.filter_map(|output| output.offer()).collect()
}

/// The outputs of one body.
pub struct Outputs(Vec<Box<dyn Output>>);

/// What a body has, not yet derived: what a description with mistakes gets.
pub fn wanted(outline: &Outline) -> Outputs {
    let all = solved().into_iter().chain(observed());
    let wanted = all.filter(|output| output.place(outline).is_some());
    Outputs(wanted.collect())
}

/// Derives what a body has beside its accelerations.
pub fn derive_outputs(
    outline: &Outline,
    model: &Model,
    work: &mut Workspace,
    equations: &Equations,
    errors: &mut Errors,
) -> Option<Outputs> {
    let mut outputs = wanted(outline);
    let mut basis = Basis {
        outline,
        model,
        equations,
        work,
        errors,
    };
    for output in &mut outputs.0 {
        output.derive(&mut basis)?;
    }
    Some(outputs)
}

impl Outputs {
    /// All expressions that code is generated for.
    pub fn roots(&self, equations: &Equations) -> Roots {
        let accelerations = equations.accelerations.entries().into_iter();
        let outputs = self.0.iter().flat_map(|output| output.roots());
        Roots {
            finite: accelerations.chain(outputs).collect(),
            switches: equations.switches.iter().flat_map(Switch::roots).collect(),
            tensor: self.0.iter().find_map(|output| output.tensor()),
        }
    }

    /// Adds to a report what the outputs are like, and which were not asked for.
    pub fn describe(
        &self,
        outline: &Outline,
        (model, work): (&Model, &Workspace),
        report: &mut Report,
    ) {
        for output in &self.0 {
            output.describe(model, work, report);
        }
        let missed = offers()
            .into_iter()
            .filter(|offer| (offer.is_missed)(outline) && outline.rank(offer.word).is_none());
        let missed: Vec<&str> = missed.map(|offer| offer.word).collect();
        if !missed.is_empty() {
            let missed = missed.join(", ");
            report.skipped.push(format!("{missed}: not in `outputs`"));
        }
    }

    /// In their places. Operations are told of what is asked for, and then of the rest.
    pub fn emit(&self, site: &Site<'_>) -> Addition {
        let mut placed: Vec<_> = self
            .0
            .iter()
            .filter_map(|output| Some((output.place(site.outline)?, output.emit(site))))
            .collect();
        placed.sort_by_key(|(place, _)| *place);
        let implementations = placed.iter();
        let implementations = implementations
            .map(|(_, addition)| addition.implementations.clone())
            .collect();
        placed.sort_by_key(|(place, _)| !matches!(place, Place::Asked(_)));
        let mut all = Addition {
            implementations,
            ..Addition::default()
        };
        for (_, addition) in placed {
            all.costs.extend(addition.costs);
            all.remarks.extend(addition.remarks);
            all.best = all.best.max(addition.best);
        }
        all
    }
}
