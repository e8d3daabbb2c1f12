//! `reactions`: the unknown loads in the motion.

use quote::quote;

use crate::emit::code::{COMMON, Site, Writer};
use crate::emit::items::{Addition, open_reactions, write_open};
use crate::lower::{Offer, is_unknown};
use crate::symbolic::{Components, Id};

use crate::model::Model;
use crate::outputs::output::{Basis, Output};

const OFFER: Offer = Offer {
    word: "reactions",
    obstacle: |description| {
        let is_there = description.loads.iter().any(is_unknown);
        (!is_there).then_some(
            "there are no unknown reactions: leave components open, as in `reactions: \
             [pin = world(_, _).at(P)]`",
        )
    },
    is_missed: |outline| !outline.reactions.is_empty(),
    is_of_motion: false,
};

#[derive(Default)]
pub struct Reactions(Option<Vec<Components>>);

impl Output<Model> for Reactions {
    fn offer(&self) -> Option<&'static Offer> {
        Some(&OFFER)
    }

    fn derive(&mut self, basis: &mut Basis<'_, Model>) -> Option<()> {
        self.0 = Some(basis.equations.reactions.clone());
        Some(())
    }

    fn roots(&self) -> Vec<Id> {
        let reactions = self.0.iter().flatten();
        reactions.flatten().copied().collect()
    }

    /// Under constraints, the method returns an error where they do not determine their reactions.
    fn emit(&self, site: &Site<'_>) -> Addition {
        let outline = site.outline;
        let is_fallible = outline.is_constrained;
        let method = site.method(self.0.as_ref(), |writer, solved| {
            let writer = Writer {
                is_fallible,
                ..writer.clone()
            };
            let record = open_reactions(outline);
            write_open(&writer, &record, &outline.reactions, solved)
        });
        let kind = site.fallible(site.reactions_type(), is_fallible);
        let methods = [("reactions", &method, &COMMON[..], &kind)];
        Addition::implement(
            site,
            "Reactions",
            [quote!(type Reactions = #kind;), quote!()],
            &methods,
        )
    }
}
