//! `linearization`: the derivatives of the rates of a state with respect to state and input, in
//! blocks.

use crate::emit::code::Site;
use crate::emit::items::Addition;
use crate::lower::{LINEARIZATION, Offer};
use crate::mechanics;
use crate::symbolic::Id;

use crate::outputs::output::{Basis, Output};
use crate::outputs::subject::Subject;

use super::coordinates::coordinated;
use super::emitted::{Words, emitted};
use super::matrices::{Placed, Space};
use super::names::check_states_and_inputs;

const OFFER: Offer = Offer {
    is_of_motion: true,
    ..Offer::new(LINEARIZATION)
};

#[derive(Default)]
pub struct Linearization {
    found: Option<mechanics::Linearization>,
    /// The size of the terms of each acceleration.
    sizes: Vec<Id>,
    /// Whether the coordinates of each joint are in world axes.
    in_world: Vec<bool>,
}

impl<S: Subject> Output<S> for Linearization {
    fn offer(&self) -> Option<&'static Offer> {
        Some(&OFFER)
    }

    fn derive(&mut self, basis: &mut Basis<'_, S>) -> Option<()> {
        check_states_and_inputs(basis.outline, basis.errors);
        let model = basis.model;
        let differentiated = model.differentiated(basis.work, basis.equations);
        let found = mechanics::linearize(basis.outline, model, basis.work, differentiated);
        self.sizes = basis.work.graph.magnitudes(&found.accelerations);
        self.found = Some(found);
        let joints = 0..basis.outline.joints.len().max(1);
        self.in_world = joints.map(|joint| basis.model.is_in_world(joint)).collect();
        basis.errors.is_empty().then_some(())
    }

    fn roots(&self) -> Vec<Id> {
        let all = self.found.iter().flat_map(|all| &all.blocks);
        all.flat_map(|block| block.entries.clone()).collect()
    }

    fn emit(&self, site: &Site<'_>) -> Addition {
        let space = Space::of(site.outline);
        let blocks: Vec<Placed> = match &self.found {
            Some(found) => found
                .blocks
                .iter()
                .map(|block| space.placed(block))
                .collect(),
            None => space.all(),
        };
        let words = Words {
            name: "Linearization",
            method: "linearize",
            doc: format!(
                " First derivatives of the rates of the state of [`{}`]. A block `a_by_b` has the derivatives of a by b, with a row for each component of a and a column for each component of b, in SI units. An attitude q changes to `q exp(e)`, with the rotation vector e in body axes.",
                site.outline.name
            ),
        };
        let mut addition = emitted(site, self.found.as_ref(), &blocks, words);
        let double = site.double();
        let entries = self.found.as_ref();
        let patterns = entries.map(|found| space.patterns(&found.blocks));
        addition
            .implementations
            .extend(space.matrices(&double, &blocks, patterns.as_ref()));
        let sizes = self.found.as_ref().map(|_| &self.sizes[..]);
        let coordinated = coordinated(&double, &self.in_world, sizes);
        addition.implementations.extend(coordinated);
        addition
    }
}
