//! Outputs: the generated code beyond the accelerations. Each output is one file, with its
//! derivation, its code and its documentation. Outputs that both bodies and systems have are here,
//! the others in `body` and `system`.

mod balance;
mod body;
mod by_name;
mod constant;
mod constrained;
mod energy;
mod foreign;
mod linearization;
mod loads;
mod momentum;
mod output;
mod paths;
mod regressor;
mod subject;
mod system;
mod taylor;

use crate::emit::code::Site;
use crate::emit::items::Addition;
use crate::errors::Errors;
use crate::lower::Offer;
use crate::mechanics::Report;
use crate::model::{Outline, Workspace};
use crate::symbolic::Id;

use output::{Basis, Output, Place};

pub use foreign::check_equations;
pub use output::Listed;

/// The outputs that a description may request.
pub fn offers<S: Listed>() -> Vec<&'static Offer> {
    let all = S::offered().into_iter();
    all.filter_map(|output| output.offer()).collect()
}

/// The outputs of a body, or of a system.
pub struct Outputs<S: Listed>(Vec<Box<dyn Output<S>>>);

/// The requested outputs before their derivation; an invalid description gets these.
pub fn wanted<S: Listed>(outline: &Outline) -> Outputs<S> {
    let all = S::outputs().into_iter();
    let is_meaningless = |offer: &Offer| offer.is_of_motion && outline.is_still();
    let wanted = all.filter(|output| {
        output.place(outline).is_some() && !output.offer().is_some_and(is_meaningless)
    });
    Outputs(wanted.collect())
}

/// Derives the requested outputs.
pub fn derive_outputs<S: Listed>(
    outline: &Outline,
    model: &S,
    work: &mut Workspace,
    equations: &S::Equations,
    errors: &mut Errors,
) -> Option<Outputs<S>> {
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
    let Basis { work, errors, .. } = basis;
    for output in &outputs.0 {
        foreign::check_output(&**output, outline, work, errors)?;
    }
    Some(outputs)
}

impl<S: Listed> Outputs<S> {
    /// All expressions that code is generated for.
    pub fn roots(&self) -> Vec<Id> {
        let outputs = self.0.iter().flat_map(|output| output.roots());
        outputs.collect()
    }

    /// The entries of a tensor whose principal axes a body of doubles stores.
    pub fn tensor(&self) -> Option<[Id; 6]> {
        self.0.iter().find_map(|output| output.tensor())
    }

    /// Adds to a report what the outputs say about themselves, and which were not requested.
    pub fn describe(
        &self,
        outline: &Outline,
        (model, work): (&S, &Workspace),
        report: &mut Report,
    ) {
        for output in &self.0 {
            output.describe(model, work, report);
        }
        let missed = offers::<S>()
            .into_iter()
            .filter(|offer| (offer.is_missed)(outline) && outline.rank(offer.word).is_none())
            .filter(|offer| !(outline.is_still() && offer.is_of_motion));
        let missed: Vec<&str> = missed.map(|offer| offer.word).collect();
        if !missed.is_empty() {
            let missed = missed.join(", ");
            report.skipped.push(format!("{missed}: not in `outputs`"));
        }
    }

    /// The code of all outputs, each in its place. The structs and operation counts of the
    /// requested outputs are listed first.
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
            all.structs.extend(addition.structs);
            all.costs.extend(addition.costs);
            all.remarks.extend(addition.remarks);
            all.best = all.best.max(addition.best);
        }
        all
    }
}
