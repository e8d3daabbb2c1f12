//! The motion in closed form: a path of the runtime, begun at a state.

use proc_macro2::{Literal, TokenStream};
use quote::{format_ident, quote};

use crate::mechanics::{Flow, Free, Turning};
use crate::model::{Orientation, Outline};
use crate::symbolic::Id;

use super::code::Writer;
use super::constructor::PRINCIPAL_AXES;
use super::functions::Function;
use super::naming::local;
use super::shapes::{Shapes, Values};

/// `Flight<FreeRotation, 3>`, `Pendulum`, ...
pub fn path_type(shapes: &Shapes, turning: &Turning) -> TokenStream {
    let private = &shapes.private;
    with_center(
        shapes,
        match turning {
            Turning::None => None,
            Turning::Free(_) => Some(quote!(#private::FreeRotation)),
            Turning::Top(_) => Some(quote!(#private::LagrangeTop)),
            Turning::Axial(_) => Some(quote!(#private::AxialTorque)),
            Turning::GreatCircle => Some(quote!(#private::GreatCircle)),
            Turning::Uniform(_) => Some(quote!(#private::Parabola<1>)),
            Turning::Pendulum { .. } => Some(quote!(#private::Pendulum)),
        },
    )
}

/// A path of this kind of motion, for a body that has none.
pub fn any_path(outline: &Outline) -> TokenStream {
    let shapes = Shapes::double(outline);
    let private = &shapes.private;
    let rotation = match shapes.motion.orientation {
        Orientation::Fixed => None,
        Orientation::Quaternion => Some(quote!(#private::FreeRotation)),
        Orientation::Line => Some(quote!(#private::GreatCircle)),
        Orientation::Angle => Some(quote!(#private::Parabola<1>)),
    };
    with_center(&shapes, rotation)
}

fn with_center(shapes: &Shapes, rotation: Option<TokenStream>) -> TokenStream {
    let private = &shapes.private;
    let axes = Literal::usize_unsuffixed(shapes.motion.axes());
    match rotation {
        None => quote!(#private::Parabola<#axes>),
        Some(rotation) if shapes.motion.translates => {
            quote!(#private::Flight<#rotation, #axes>)
        }
        Some(rotation) => rotation,
    }
}

/// `Flight { center: Parabola { .. }, rotation: FreeRotation::principal(..) }`, or the one part that there is.
pub fn write_path(writer: &Writer<'_>, shapes: &Shapes, flow: &Flow) -> Function {
    let linear = if shapes.motion.translates {
        shapes.vector_part(&flow.linear)
    } else {
        &[]
    };
    let outputs = [linear, &path_roots(writer.outline, &flow.turning)].concat();
    Function::write(writer, &outputs, |values| {
        let center = shapes.motion.translates.then(|| center(shapes, values));
        let rotation = rotation(shapes, &flow.turning, values);
        match (center, rotation) {
            (Some(center), Some(rotation)) => {
                let private = &shapes.private;
                quote!(#private::Flight { center: #center, rotation: #rotation })
            }
            (center, rotation) => quote!(#center #rotation),
        }
    })
}

/// What the path reads of a body: entries of a tensor only where it has no principal axes.
fn path_roots(outline: &Outline, turning: &Turning) -> Vec<Id> {
    match turning {
        Turning::Free(Free::Tensor(entries)) if outline.scalar.is_some() => entries.to_vec(),
        _ => turning.roots(),
    }
}

/// `Parabola { position: state.position, velocity: state.velocity, acceleration: [..].into() }`
fn center(shapes: &Shapes, values: &mut Values<'_>) -> TokenStream {
    let (private, state, acceleration) = (&shapes.private, local("state"), shapes.vector(values));
    quote!(#private::Parabola { position: #state.position, velocity: #state.velocity, acceleration: #acceleration })
}

fn rotation(shapes: &Shapes, turning: &Turning, values: &mut Values<'_>) -> Option<TokenStream> {
    let (private, state) = (&shapes.private, local("state"));
    Some(match turning {
        Turning::None => return None,
        Turning::GreatCircle => quote!(#private::GreatCircle::new(#state.axis, #state.axis_rate)),
        Turning::Uniform(_) => {
            let acceleration = values.next();
            quote!(#private::Parabola {
                position: [#state.angle].into(),
                velocity: [#state.angular_velocity].into(),
                acceleration: [#acceleration].into(),
            })
        }
        Turning::Pendulum { .. } => {
            let (rate, hanging) = (values.next(), values.next());
            let state = turning_state(shapes, "Hinge", "angle");
            quote!(#private::Pendulum::new(#rate, #hanging, #state))
        }
        Turning::Free(free) => free_rotation(shapes, free, values),
        Turning::Top(_) => lagrange_top(shapes, values),
        Turning::Axial(_) => axial_torque(shapes, values),
    })
}

/// `state`, or of a body that moves too `&Rotation { attitude: state.attitude, angular_velocity: state.angular_velocity }`
fn turning_state(shapes: &Shapes, kind: &str, coordinate: &str) -> TokenStream {
    let (private, state) = (&shapes.private, local("state"));
    let (kind, coordinate) = (format_ident!("{kind}"), format_ident!("{coordinate}"));
    if shapes.motion.translates {
        quote!(&#private::#kind { #coordinate: #state.#coordinate, angular_velocity: #state.angular_velocity })
    } else {
        quote!(#state)
    }
}

/// `FreeRotation::principal([..], [[..], [..], [..]], state)` and so on.
fn free_rotation(shapes: &Shapes, free: &Free, values: &mut Values<'_>) -> TokenStream {
    let private = &shapes.private;
    let state = turning_state(shapes, "Rotation", "attitude");
    let is_stored = values.len() == 0;
    let mut next = |count| list(values, count);
    match free {
        Free::Steady => quote!(#private::FreeRotation::steady(#state)),
        Free::Symmetric(..) => {
            let (moments, axis) = (next(2), next(3));
            quote!(#private::symmetric_rotation(#moments, #axis, #state))
        }
        Free::Along(_) => {
            let moments = next(3);
            quote!(#private::rotation_along(#moments, #state))
        }
        Free::Principal(..) => {
            let (moments, axes) = (next(3), [next(3), next(3), next(3)]);
            quote!(#private::principal_rotation(#moments, [#(#axes),*], #state))
        }
        Free::Tensor(_) if is_stored => {
            let axes = local(PRINCIPAL_AXES);
            quote!(#private::rotation_about(&self.#axes, #state))
        }
        Free::Tensor(_) => {
            let entries = next(6);
            quote!(#private::rotation_about(&#private::principal_axes(#entries), #state))
        }
    }
}

/// `lagrange_top([..], [..], [..], state)`
fn lagrange_top(shapes: &Shapes, values: &mut Values<'_>) -> TokenStream {
    let private = &shapes.private;
    let state = turning_state(shapes, "Rotation", "attitude");
    let (moments, axis, couple) = (list(values, 2), list(values, 3), list(values, 3));
    quote!(#private::lagrange_top(#moments, #axis, #couple, #state))
}

/// `axial_torque([..], [..], torque, state)`
fn axial_torque(shapes: &Shapes, values: &mut Values<'_>) -> TokenStream {
    let private = &shapes.private;
    let state = turning_state(shapes, "Rotation", "attitude");
    let (moments, axis, torque) = (list(values, 2), list(values, 3), values.next());
    quote!(#private::axial_torque(#moments, #axis, #torque, #state))
}

/// `[..]` of the values that follow.
fn list(values: &mut Values<'_>, count: usize) -> TokenStream {
    let part = values.take(count);
    quote!([#(#part),*])
}
