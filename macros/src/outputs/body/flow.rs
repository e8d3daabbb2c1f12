//! `flow`: the motion in closed form, as a path of the runtime that begins at a state. Elliptic
//! functions are computed in doubles, whatever the scalar.

use proc_macro2::{Literal, TokenStream};
use quote::quote;

use crate::emit::code::{Method, Shapes, Site, Values, Writer, local};
use crate::emit::items::{Addition, Best};
use crate::lower::Offer;
use crate::mechanics::{self, Free, Report, Rotation, derive_flow};
use crate::model::{Model, Orientation, Outline, Workspace};
use crate::symbolic::Id;

use crate::outputs::output::{Basis, Output};
use crate::outputs::paths::{OFFER_OF_FLOW, Start, rotation_type};

#[derive(Default)]
pub struct Flow(Option<mechanics::Flow>);

impl Output<Model> for Flow {
    fn offer(&self) -> Option<&'static Offer> {
        Some(&OFFER_OF_FLOW)
    }

    fn derive(&mut self, basis: &mut Basis<'_, Model>) -> Option<()> {
        let (place, model) = (basis.outline.place(OFFER_OF_FLOW.word)?, basis.model);
        self.0 = Some(derive_flow(
            model,
            basis.work,
            place,
            basis.equations.accelerations,
            basis.errors,
        )?);
        Some(())
    }

    fn roots(&self) -> Vec<Id> {
        self.0.iter().flat_map(mechanics::Flow::roots).collect()
    }

    fn tensor(&self) -> Option<[Id; 6]> {
        self.0.as_ref()?.tensor()
    }

    fn describe(&self, model: &Model, _: &Workspace, report: &mut Report) {
        let flow = self.0.iter();
        report
            .lists
            .extend(flow.map(|flow| ("Closed form", flow.describe(model.motion))));
    }

    fn emit(&self, site: &Site<'_>) -> Addition {
        let (site, flow) = (site.double(), self.0.as_ref());
        let shapes = &site.shapes;
        let kind = match flow {
            Some(flow) => path_type(shapes, &flow.rotation),
            None => any_path(shapes),
        };
        let path = site.method(flow, write_path);
        let (state, state_type) = (local("state"), shapes.state_type());
        let path = path.declared("path", &quote!(#state: &#state_type), &kind);
        Addition {
            best: Best::ClosedForm,
            ..Addition::implement(&site, "Flow", [quote!(type Path = #kind;), path], &[])
        }
    }
}

/// The type of the path: `Flight<FreeRotation, 3>`, `Pendulum`, ...
fn path_type(shapes: &Shapes, rotation: &Rotation) -> TokenStream {
    with_center(shapes, rotation_type(shapes, rotation))
}

/// Some type of path, for a body without a closed form.
fn any_path(shapes: &Shapes) -> TokenStream {
    let private = &shapes.private;
    let rotation = match shapes.motion.orientation {
        Orientation::Fixed => None,
        Orientation::Quaternion => Some(quote!(#private::FreeRotation)),
        Orientation::Line => Some(quote!(#private::GreatCircle)),
        Orientation::Angle => Some(quote!(#private::Parabola<1>)),
    };
    with_center(shapes, rotation)
}

fn with_center(shapes: &Shapes, rotation: Option<TokenStream>) -> TokenStream {
    let private = &shapes.private;
    let axes = Literal::usize_unsuffixed(shapes.motion.axes());
    match rotation {
        None => quote!(#private::Parabola<#axes>),
        Some(rotation) if shapes.motion.translates() => {
            quote!(#private::Flight<#rotation, #axes>)
        }
        Some(rotation) => rotation,
    }
}

/// `Flight { center: Parabola { .. }, rotation: FreeRotation::principal(..) }`, or only one of
/// these parts.
fn write_path(writer: &Writer<'_>, flow: &mechanics::Flow) -> Method {
    let shapes = &writer.shapes;
    let linear = &flow.linear[shapes.motion.linear_axes()];
    let outputs = [linear, &path_roots(writer.outline, &flow.rotation)].concat();
    Method::write(writer, &outputs, |values| {
        let center = shapes.motion.translates().then(|| center(shapes, values));
        let state = local("state");
        let start = Start {
            shapes,
            place: quote!(#state),
            reference: quote!(#state),
            translates: shapes.motion.translates(),
        };
        let rotation = start.rotation(&flow.rotation, values);
        match (center, rotation) {
            (Some(center), Some(rotation)) => {
                let private = &shapes.private;
                quote!(#private::Flight { center: #center, rotation: #rotation })
            }
            (center, rotation) => quote!(#center #rotation),
        }
    })
}

/// The expressions that the path reads. It reads the entries of a tensor only if there are no
/// principal axes.
fn path_roots(outline: &Outline, rotation: &Rotation) -> Vec<Id> {
    match rotation {
        Rotation::Free(Free::Tensor(entries)) if outline.scalar.is_some() => entries.to_vec(),
        _ => rotation.roots(),
    }
}

/// `Parabola { position: state.position, velocity: state.velocity, acceleration: [..].into() }`
fn center(shapes: &Shapes, values: &mut Values<'_>) -> TokenStream {
    let (private, state, acceleration) = (&shapes.private, local("state"), shapes.vector(values));
    quote!(#private::Parabola { position: #state.position, velocity: #state.velocity, acceleration: #acceleration })
}
