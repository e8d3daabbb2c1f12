//! `inverse`: the drives that go with a given motion.

use quote::quote;

use crate::emit::code::{Site, Source, Writer};
use crate::emit::items::{Addition, write_open};
use crate::mechanics::derive_inverse;
use crate::model::{INVERSE, Motion, Obstacle, Offer, is_drive, written_motion};
use crate::symbolic::{Components, Id, Node};
use crate::syntax::Description;

use super::output::{Given, Output};

const OFFER: Offer = Offer {
    obstacle,
    ..Offer::new(INVERSE)
};

#[derive(Default)]
pub struct Inverse(Option<Vec<Components>>);

fn obstacle(description: &Description) -> Option<Obstacle> {
    if !description.loads.iter().any(is_drive) {
        return Some(Obstacle::Nothing(
            "there are no unknown drives: leave components open, as in `moments: [motor = \
             body(0, 0, _)]`",
        ));
    }
    if !description.constraints.is_empty() {
        return Some(Obstacle::Later(
            "inverse dynamics under constraints is not there yet: use a motion with a support",
        ));
    }
    let is_rod = written_motion(description) == Some(Motion::Rod);
    is_rod.then_some(Obstacle::Later(
        "inverse dynamics of a rod is not there yet: make the drive an input",
    ))
}

impl Output for Inverse {
    fn offer(&self) -> Option<&'static Offer> {
        Some(&OFFER)
    }

    fn derive(&mut self, given: &mut Given<'_>) -> Option<()> {
        self.0 = Some(derive_inverse(given.model, given.work, given.errors)?);
        Some(())
    }

    fn roots(&self) -> Vec<Id> {
        let drives = self.0.iter().flatten();
        drives.flatten().copied().collect()
    }

    /// A `Result` where the configuration may leave drives undetermined.
    fn emit(&self, site: &Site<'_>) -> Addition {
        let outline = site.outline;
        let mut method = site.method(self.0.as_ref(), |writer, solved| {
            let (graph, roots) = (&writer.work.graph, self.roots());
            let is_pivot = |id: &Id| matches!(graph.node(*id), Node::Pivot(..));
            let guarded = Writer {
                is_fallible: graph.reachable(&roots, |_| true).iter().any(is_pivot),
                ..writer.clone()
            };
            write_open(&guarded, "Drives", &outline.drives, solved)
        });
        if self.0.is_none() {
            method.facts.has_pivots = outline.has_turning_drive;
        }
        let has_pivots = method.facts.has_pivots;
        let kind = site.fallible(site.own_type("Drives"), has_pivots);
        let given = [
            Source::Time,
            Source::State,
            Source::Acceleration,
            Source::Input,
        ];
        let methods = [("inverse", &method, &given[..], &kind)];
        let remark =
            " Where the configuration does not determine the drives, `inverse` returns an error.";
        Addition {
            remarks: has_pivots.then_some(remark).into_iter().collect(),
            ..Addition::implement(
                site,
                "Inverse",
                [quote!(type Drives = #kind;), quote!()],
                &methods,
            )
        }
    }
}
