//! `momentum`: linear and angular momentum, in world axes.

use quote::quote;

use crate::emit::code::{COMMON, Method, Site, Source};
use crate::emit::items::Addition;
use crate::lower::Offer;
use crate::mechanics;
use crate::symbolic::{Components, Id};

use super::output::{Basis, Output};
use super::subject::Subject;

const OFFER: Offer = Offer {
    is_missed: |_| true,
    ..Offer::new("momentum")
};

#[derive(Default)]
pub struct Momentum(Option<mechanics::Momentum>);

impl<S: Subject> Output<S> for Momentum {
    fn offer(&self) -> Option<&'static Offer> {
        Some(&OFFER)
    }

    fn derive(&mut self, basis: &mut Basis<'_, S>) -> Option<()> {
        self.0 = Some(basis.model.momentum(basis.work));
        Some(())
    }

    fn roots(&self) -> Vec<Id> {
        let momentum = self.0.iter();
        let vectors =
            momentum.flat_map(|momentum| [momentum.linear, momentum.angular, momentum.about_pole]);
        vectors.flatten().collect()
    }

    fn emit(&self, site: &Site<'_>) -> Addition {
        let shapes = &site.shapes;
        let moment = |of: fn(&mechanics::Momentum) -> &Components| {
            site.method(self.0.as_ref(), |writer, momentum| {
                let outputs = shapes.moment_part(of(momentum));
                Method::write(writer, outputs, |values| shapes.moment(values))
            })
        };
        let (angular, about_pole) = (
            moment(|momentum| &momentum.angular),
            moment(|momentum| &momentum.about_pole),
        );
        // if the motion of G is not modeled, the momentum is unknown
        let is_known = shapes.motion.knows_position();
        let linear = site.method(self.0.as_ref(), |writer, momentum| {
            if !is_known {
                return Method::default();
            }
            let outputs = shapes.vector_part(&momentum.linear);
            Method::write(writer, outputs, |values| shapes.vector(values))
        });
        let of_angular = shapes.moment_type();
        let of_linear = if is_known {
            shapes.vector_type()
        } else {
            quote!(())
        };
        let (name, state, both) = if site.outline.driving.is_empty() {
            let both = &[Source::Time, Source::State][..];
            ("Momentum", &[Source::State][..], both)
        } else {
            ("DrivenMomentum", &COMMON[..], &COMMON[..])
        };
        let methods = [
            ("linear_momentum", &linear, state, &of_linear),
            ("angular_momentum", &angular, state, &of_angular),
            (
                "angular_momentum_about_pole",
                &about_pole,
                both,
                &of_angular,
            ),
        ];
        let types = quote!(type Linear = #of_linear; type Angular = #of_angular;);
        Addition::implement(site, name, [types, quote!()], &methods)
    }
}
