//! `taylor`: Taylor series of the motion, from the recurrences of its coefficients. They are
//! computed in doubles, even for a generic body.

use proc_macro2::Literal;
use quote::quote;

use crate::emit::code::{Site, Source, local};
use crate::emit::items::{Addition, Best};
use crate::emit::series::{Expansion, write_axes};
use crate::lower::Offer;
use crate::mechanics;
use crate::symbolic::Id;

use super::output::{Basis, Output};
use super::subject::Subject;

const OFFER: Offer = Offer {
    is_of_motion: true,
    ..Offer::new("taylor")
};

#[derive(Default)]
pub struct Taylor(Option<mechanics::Taylor>);

impl<S: Subject> Output<S> for Taylor {
    fn offer(&self) -> Option<&'static Offer> {
        Some(&OFFER)
    }

    fn derive(&mut self, basis: &mut Basis<'_, S>) -> Option<()> {
        let place = basis.outline.place(OFFER.word)?;
        let Basis {
            model,
            equations,
            work,
            errors,
            ..
        } = basis;
        self.0 = model.taylor(work, equations, place, errors);
        Some(())
    }

    fn roots(&self) -> Vec<Id> {
        self.0.iter().flat_map(mechanics::Taylor::roots).collect()
    }

    fn emit(&self, site: &Site<'_>) -> Addition {
        let (site, mut width, mut best) = (site.double(), 0, Best::Series);
        let expand = site.method(self.0.as_ref(), |writer, taylor| {
            let expansion = Expansion::write(writer, taylor);
            (width, best) = (expansion.width, expansion.best);
            expansion.method
        });
        let axes = self.0.as_ref().and_then(|taylor| taylor.axes.as_ref());
        let axes = axes.map(|axes| {
            let method = site.method(Some(axes), write_axes);
            let private = &site.shapes.private;
            let arguments = site.arguments(&method, &[Source::Time, Source::State]);
            method.declared("axes", &arguments, &quote!(#private::Axes))
        });
        let private = &site.shapes.private;
        let [time, input] =
            [Source::Time, Source::Input].map(|one| site.arguments(&expand, &[one]));
        let [state, series, products] = ["state", "series", "products"].map(local);
        let (state_type, width) = (site.shapes.state_type(), Literal::usize_unsuffixed(width));
        let (lints, body) = (expand.lints(), &expand.body);
        let types = quote! {
            type Products<A: #private::Arithmetic, const COUNT: usize> = #private::Products<A, #width, COUNT>;
        };
        let methods = quote! {
            #axes
            #lints
            #[allow(clippy::inline_always)]
            #[inline(always)]
            fn expand<A: #private::Arithmetic, const COUNT: usize>(&self, #time, #state: &#state_type, #input, #products: &mut Self::Products<A, COUNT>, #series: &mut #private::Series<#state_type, COUNT>) {
                #body
            }
        };
        let remark = " `integrate` takes Runge–Kutta steps, which are faster than its series; \
                      `.method(TaylorSeries { tolerance })` selects series.";
        let is_slow = best == Best::RungeKutta;
        Addition {
            best,
            remarks: is_slow.then_some(remark).into_iter().collect(),
            ..Addition::implement(&site, "Taylor", [types, methods], &[])
        }
    }
}
