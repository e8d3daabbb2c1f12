//! `flow`: the motion of a system in closed form, with a path of the runtime for each joint.
//! Elliptic functions are computed in doubles.

use proc_macro2::{Ident, Literal, TokenStream};
use quote::{format_ident, quote};

use crate::emit::code::{Method, Shapes, Site, Values, Writer, local};
use crate::emit::items::{Addition, Best};
use crate::lower::Offer;
use crate::mechanics::{Counter, Course, Free, Report, Rotation, SystemFlow, derive_system_flow};
use crate::model::{Shape, System, Variable, Workspace};
use crate::outputs::output::{Basis, Output};
use crate::outputs::paths::{OFFER_OF_FLOW, Start, rotation_type};
use crate::symbolic::Id;

const OFFER: Offer = Offer {
    is_of_motion: true,
    ..OFFER_OF_FLOW
};

#[derive(Default)]
pub struct Flow(Option<SystemFlow>);

impl Output<System> for Flow {
    fn offer(&self) -> Option<&'static Offer> {
        Some(&OFFER)
    }

    fn derive(&mut self, basis: &mut Basis<'_, System>) -> Option<()> {
        let place = basis.outline.place(OFFER.word)?;
        let (system, equations) = (basis.model, basis.equations);
        let flow = derive_system_flow(system, basis.work, place, equations, basis.errors)?;
        self.0 = Some(flow);
        Some(())
    }

    fn roots(&self) -> Vec<Id> {
        let joints = self.0.iter().flat_map(|flow| &flow.joints);
        joints.flat_map(|(.., course)| roots(course, 3)).collect()
    }

    fn describe(&self, _: &System, _: &Workspace, report: &mut Report) {
        let flow = self.0.iter();
        let lists = flow.map(|flow| ("Closed form", flow.describe()));
        report.lists.extend(lists);
    }

    fn emit(&self, site: &Site<'_>) -> Addition {
        let site = site.double();
        let (shapes, outline, flow) = (&site.shapes, site.outline, self.0.as_ref());
        let found = flow.map(|flow| {
            let joints = flow.joints.iter();
            let fields = joints.map(|(name, shape, course)| {
                let kind = path_type(shapes, shape, course);
                (name.clone(), kind)
            });
            fields.collect()
        });
        let fields: Vec<(Ident, TokenStream)> = found.unwrap_or_else(|| {
            let parts = outline.parts().into_iter();
            let fields = parts.map(|(name, shape)| (name, any_path(shapes, shape)));
            fields.collect()
        });
        let name = format_ident!("{}Path", outline.name);
        let path = site.method(flow, |writer, flow| write_path(writer, flow, &name));
        let (state, state_type) = (local("state"), shapes.state_type());
        let path = path.declared("path", &quote!(#state: &#state_type), &quote!(#name));
        let mut addition =
            Addition::implement(&site, "Flow", [quote!(type Path = #name;), path], &[]);
        addition
            .implementations
            .extend(declared(&site, &name, &fields));
        addition.structs.push(name);
        addition.best = Best::ClosedForm;
        addition
    }
}

/// `pub struct SatellitePath { hub: Flight<Gyrostat, 3>, wheel: Accelerated<Hinge> }`, and its
/// evaluation as a path, joint by joint.
fn declared(site: &Site<'_>, name: &Ident, fields: &[(Ident, TokenStream)]) -> TokenStream {
    let (private, outline, time) = (&site.shapes.private, site.outline, local("time"));
    let state_type = site.shapes.state_type();
    let kind = format_ident!("{}State", outline.name);
    let doc = format!(
        " The motion of [`{}`] from a state on, joint by joint.",
        outline.name
    );
    let names: Vec<&Ident> = fields.iter().map(|(joint, _)| joint).collect();
    let docs = names.iter().map(|joint| format!(" `{joint}`"));
    let kinds = fields.iter().map(|(_, kind)| kind);
    quote! {
        #[doc = #doc]
        #[allow(clippy::struct_field_names, non_snake_case)]
        #[derive(Clone, Copy, Debug, PartialEq)]
        pub struct #name { #(#[doc = #docs] pub #names: #kinds,)* }

        impl #private::Path for #name {
            type State = #state_type;

            fn at(&self, #time: f64) -> Self::State {
                #kind { #(#names: #private::Path::at(&self.#names, #time),)* }
            }

            fn pace(&self, #time: f64) -> f64 {
                let paces = [#(#private::Path::pace(&self.#names, #time)),*];
                let paces = ::core::iter::IntoIterator::into_iter(paces);
                ::core::iter::Iterator::fold(paces, f64::INFINITY, f64::min)
            }
        }
    }
}

/// The expressions that the start of a path reads; its vectors have `axes` components.
fn roots(course: &Course, axes: usize) -> Vec<Id> {
    match course {
        Course::Uniform(accelerations) => accelerations.clone(),
        Course::Counter(counter) => [&counter.pendulum[..], &[counter.acceleration]].concat(),
        Course::Turning(rotation, center) => {
            let vectors = center.iter();
            let vectors = vectors.flat_map(|center| [Some(center.acceleration), center.offset]);
            let vectors = vectors
                .flatten()
                .flat_map(|vector| vector.into_iter().take(axes));
            vectors.chain(rotation_roots(rotation)).collect()
        }
    }
}

fn rotation_roots(rotation: &Rotation) -> Vec<Id> {
    match rotation {
        Rotation::Free(Free::Tensor(entries)) => entries.to_vec(),
        _ => rotation.roots(),
    }
}

/// `SatellitePath { hub: .., wheel: .. }`
fn write_path(writer: &Writer<'_>, flow: &SystemFlow, name: &Ident) -> Method {
    let axes = writer.shapes.motion.axes();
    let courses = flow.joints.iter().map(|(.., course)| course);
    let outputs: Vec<Id> = courses.flat_map(|course| roots(course, axes)).collect();
    Method::write(writer, &outputs, |values| {
        let fields = flow.joints.iter().map(|(joint, shape, course)| {
            let path = joint_path(writer, joint, (shape, course), values);
            quote!(#joint: #path)
        });
        let fields: Vec<TokenStream> = fields.collect();
        quote!(#name { #(#fields),* })
    })
}

/// `CounterSwing::new(&state.wheel, (Pendulum::new(..), &state.bob), 1.0, ..)`
fn counter_path(
    writer: &Writer<'_>,
    place: &TokenStream,
    counter: &Counter,
    values: &mut Values<'_>,
) -> TokenStream {
    let (shapes, state) = (&writer.shapes, local("state"));
    let (private, swing) = (&shapes.private, &counter.swing);
    let swing = quote!(#state.#swing);
    let start = Start {
        shapes,
        place: swing.clone(),
        reference: quote!(&#swing),
        translates: counter.translates,
    };
    let (rate, hanging) = (values.next(), values.next());
    let hinge = start.hinge();
    let sign = if counter.is_opposite {
        quote!(-1.0)
    } else {
        quote!(1.0)
    };
    let total = values.next();
    quote! {
        #private::CounterSwing::new(
            &#place,
            (#private::Pendulum::new(#rate, #hanging, #hinge), #hinge),
            #sign,
            #total,
        )
    }
}

fn joint_path(
    writer: &Writer<'_>,
    joint: &Ident,
    (shape, course): (&Shape, &Course),
    values: &mut Values<'_>,
) -> TokenStream {
    let (shapes, state) = (&writer.shapes, local("state"));
    let (private, place) = (&shapes.private, quote!(#state.#joint));
    let (rotation, center) = match course {
        Course::Counter(counter) => {
            return counter_path(writer, &place, counter, values);
        }
        Course::Uniform(_) => {
            let acceleration = shapes.joint_acceleration(shape, values);
            return quote!(#private::Accelerated { start: #place, acceleration: #acceleration });
        }
        Course::Turning(rotation, center) => (rotation, center),
    };
    let start = Start {
        shapes,
        place: place.clone(),
        reference: quote!(&#place),
        translates: center.is_some(),
    };
    let Some(center) = center else {
        let path = start.rotation(rotation, values);
        return quote!(#path);
    };
    let acceleration = shapes.vector(values);
    let offset = center.offset.map(|_| shapes.vector(values));
    let path = start.rotation(rotation, values);
    let Some(offset) = offset else {
        return quote!(#private::Flight {
            center: #private::Parabola { position: #place.position, velocity: #place.velocity, acceleration: #acceleration },
            rotation: #path,
        });
    };
    let axes = Literal::usize_unsuffixed(shapes.motion.axes());
    quote!(#private::FlyingPoint::<_, #axes>::new(#offset, #acceleration, #path, &#place))
}

/// `Accelerated<Hinge>`, `Flight<Gyrostat, 3>`, ...
fn path_type(shapes: &Shapes, shape: &Shape, course: &Course) -> TokenStream {
    let private = &shapes.private;
    let (rotation, center) = match course {
        Course::Uniform(_) => return accelerated(shapes, shape),
        Course::Counter(_) => return quote!(#private::CounterSwing),
        Course::Turning(rotation, center) => (rotation, center),
    };
    let rotation = rotation_type(shapes, rotation);
    let axes = Literal::usize_unsuffixed(shapes.motion.axes());
    match center.as_ref().map(|center| center.offset) {
        None => quote!(#rotation),
        Some(None) => quote!(#private::Flight<#rotation, #axes>),
        Some(Some(_)) => quote!(#private::FlyingPoint<#rotation, #axes>),
    }
}

fn accelerated(shapes: &Shapes, shape: &Shape) -> TokenStream {
    let (private, kind) = (&shapes.private, shapes.scalar.holder(shape.state));
    quote!(#private::Accelerated<#kind>)
}

/// Some type of path for a joint, in a system without a closed form.
fn any_path(shapes: &Shapes, shape: &Shape) -> TokenStream {
    let private = &shapes.private;
    let has = |variable| shape.fields.iter().any(|field| field.variable == variable);
    match (has(Variable::Quaternion), has(Variable::Position)) {
        (false, _) => accelerated(shapes, shape),
        (true, false) => quote!(#private::FreeRotation),
        (true, true) => quote!(#private::Flight<#private::FreeRotation, 3>),
    }
}
