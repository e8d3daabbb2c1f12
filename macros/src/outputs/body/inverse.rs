//! `inverse`: the drives that produce a given motion.

use quote::quote;

use crate::emit::code::{Site, Source, Writer};
use crate::emit::items::{Addition, open_drives, write_open};
use crate::lower::{INVERSE, Offer, is_drive};
use crate::mechanics::derive_inverse;
use crate::symbolic::{Components, Id, Node};

use crate::model::Model;
use crate::outputs::output::{Basis, Output};

const OFFER: Offer = Offer {
    obstacle: |description| {
        let is_there = description.loads.iter().any(is_drive);
        (!is_there).then_some(
            "there are no unknown drives: leave components open, as in `moments: [motor = \
             body(0, 0, _)]`",
        )
    },
    ..Offer::new(INVERSE)
};

#[derive(Default)]
pub struct Inverse(Option<Vec<Components>>);

impl Output<Model> for Inverse {
    fn offer(&self) -> Option<&'static Offer> {
        Some(&OFFER)
    }

    fn derive(&mut self, basis: &mut Basis<'_, Model>) -> Option<()> {
        self.0 = Some(derive_inverse(basis.model, basis.work, basis.errors)?);
        Some(())
    }

    fn roots(&self) -> Vec<Id> {
        let drives = self.0.iter().flatten();
        drives.flatten().copied().collect()
    }

    /// The method returns a `Result` if some configuration may leave drives undetermined.
    fn emit(&self, site: &Site<'_>) -> Addition {
        let outline = site.outline;
        let mut method = site.method(self.0.as_ref(), |writer, solved| {
            let (graph, roots) = (&writer.work.graph, self.roots());
            // divisors known early are checked in `new`
            let is_late = |id: Id| !graph.is_early(id);
            let late = graph
                .reachable(&roots, &is_late)
                .into_iter()
                .filter(|id| is_late(*id));
            let mut nodes = late.map(|id| graph.node(id));
            let guarded = Writer {
                is_fallible: nodes.any(|node| matches!(node, Node::Pivot(..))),
                ..writer.clone()
            };
            let record = open_drives(outline);
            write_open(&guarded, &record, &outline.drives, solved)
        });
        if self.0.is_none() {
            method.facts.guards.pivots = outline.has_turning_drive;
        }
        let has_pivots = method.facts.guards.pivots;
        let kind = site.fallible(site.own_type("Drives"), has_pivots);
        let arguments = [
            Source::Time,
            Source::State,
            Source::Acceleration,
            Source::Input,
        ];
        let methods = [("inverse", &method, &arguments[..], &kind)];
        let remark =
            " Where the configuration does not determine the drives, `inverse` returns an error.";
        let addition = Addition {
            remarks: has_pivots.then_some(remark).into_iter().collect(),
            ..Addition::implement(
                site,
                "Inverse",
                [quote!(type Drives = #kind;), quote!()],
                &methods,
            )
        };
        // an invalid load may be the only drive: its struct is there without it
        if outline.drives.is_empty() {
            return addition.with(outline, &open_drives(outline));
        }
        addition
    }
}
