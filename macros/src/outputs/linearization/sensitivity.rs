//! `sensitivity`: the derivatives of the accelerations with respect to parameters, in blocks.

use crate::emit::code::Site;
use crate::emit::items::Addition;
use crate::lower::Offer;
use crate::mechanics;
use crate::outputs::output::{Basis, Output};
use crate::outputs::subject::Subject;
use crate::symbolic::Id;

use super::emitted::{Words, emitted};
use super::matrices::Space;
use super::names::check_params;

const OFFER: Offer = Offer {
    is_of_motion: true,
    ..Offer::new("sensitivity")
};

#[derive(Default)]
pub struct Sensitivity(Option<mechanics::Linearization>);

impl<S: Subject> Output<S> for Sensitivity {
    fn offer(&self) -> Option<&'static Offer> {
        Some(&OFFER)
    }

    fn derive(&mut self, basis: &mut Basis<'_, S>) -> Option<()> {
        let place = basis.outline.place(OFFER.word);
        if let Some(place) = place.filter(|_| basis.outline.params.is_empty()) {
            let message = "there are no `params`, and `sensitivity` is the derivative of the accelerations with respect to them";
            basis.errors.push(place, message);
            return None;
        }
        check_params(basis.outline, basis.errors);
        let differentiated = basis.model.differentiated(basis.work, basis.equations);
        let found = mechanics::sensitivity(basis.outline, basis.work, differentiated);
        self.0 = Some(found);
        Some(())
    }

    fn roots(&self) -> Vec<Id> {
        let all = self.0.iter().flat_map(|all| &all.blocks);
        all.flat_map(|block| block.entries.clone()).collect()
    }

    fn emit(&self, site: &Site<'_>) -> Addition {
        let space = Space::of(site.outline);
        let blocks = match &self.0 {
            Some(found) => found
                .blocks
                .iter()
                .map(|block| space.placed(block))
                .collect(),
            None => space.by_params(),
        };
        let words = Words {
            name: "Sensitivity",
            method: "sensitivity",
            doc: format!(
                " First derivatives of the accelerations of [`{}`] by its parameters, with state and input held. A block `a_by_b` has the derivatives of a by b, with a row for each component of a and a column for each component of b, in SI units.",
                site.outline.name
            ),
        };
        let mut addition = emitted(site, self.0.as_ref(), &blocks, words);
        let matrix = space.by_params_matrix(&site.double(), &blocks);
        addition.implementations.extend(matrix);
        addition
    }
}
