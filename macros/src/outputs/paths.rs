//! Rotations in closed form, as code: a path of the runtime that begins at a state.

use proc_macro2::TokenStream;
use quote::{format_ident, quote};

use crate::emit::code::{PRINCIPAL_AXES, Shapes, Values, local};
use crate::lower::{FLOW, Offer};
use crate::mechanics::{Free, Rotation};

/// How closed forms are requested.
pub const OFFER_OF_FLOW: Offer = Offer {
    obstacle: |description| {
        let has_states = !description.states.is_empty();
        has_states.then_some(
            "there is no closed form of `states` of one's own: leave out `flow`, and the motion is integrated",
        )
    },
    ..Offer::new(FLOW)
};

/// The start of a rotation.
pub struct Start<'a> {
    pub shapes: &'a Shapes,
    /// The state of the body or the joint.
    pub place: TokenStream,
    /// The same, as a reference.
    pub reference: TokenStream,
    /// Whether its center of mass moves, too.
    pub translates: bool,
}

/// `FreeRotation`, `Pendulum`, ...
pub fn rotation_type(shapes: &Shapes, rotation: &Rotation) -> Option<TokenStream> {
    let private = &shapes.private;
    Some(match rotation {
        Rotation::None => return None,
        Rotation::Free(_) => quote!(#private::FreeRotation),
        Rotation::Top(_) => quote!(#private::LagrangeTop),
        Rotation::Axial(_) => quote!(#private::AxialTorque),
        Rotation::Gyrostat(_) => quote!(#private::Gyrostat),
        Rotation::GreatCircle => quote!(#private::GreatCircle),
        Rotation::Uniform(_) => quote!(#private::Parabola<1>),
        Rotation::Pendulum { .. } => quote!(#private::Pendulum),
    })
}

impl Start<'_> {
    /// The path of a rotation, which takes the next values.
    pub fn rotation(&self, rotation: &Rotation, values: &mut Values<'_>) -> Option<TokenStream> {
        let (private, place) = (&self.shapes.private, &self.place);
        Some(match rotation {
            Rotation::None => return None,
            Rotation::GreatCircle => {
                quote!(#private::GreatCircle::new(#place.axis, #place.axis_rate))
            }
            Rotation::Uniform(_) => {
                let acceleration = values.next();
                quote!(#private::Parabola {
                    position: ::core::convert::Into::into([#place.angle]),
                    velocity: ::core::convert::Into::into([#place.angular_velocity]),
                    acceleration: ::core::convert::Into::into([#acceleration]),
                })
            }
            Rotation::Pendulum { .. } => {
                let (rate, hanging) = (values.next(), values.next());
                let state = self.hinge();
                quote!(#private::Pendulum::new(#rate, #hanging, #state))
            }
            Rotation::Free(free) => self.free(free, values),
            Rotation::Top(_) => {
                let (moments, axis, couple) = (list(values, 2), list(values, 3), list(values, 3));
                let state = self.turning("Rotation", "attitude");
                quote!(#private::lagrange_top(#moments, #axis, #couple, #state))
            }
            Rotation::Axial(_) => {
                let (moments, axis, torque) = (list(values, 2), list(values, 3), values.next());
                let state = self.turning("Rotation", "attitude");
                quote!(#private::axial_torque(#moments, #axis, #torque, #state))
            }
            Rotation::Gyrostat(_) => {
                let (axis, spin, along) = (list(values, 3), list(values, 2), values.next());
                let state = self.turning("Rotation", "attitude");
                quote!(#private::gyrostat(#axis, #spin, #along, #state))
            }
        })
    }

    /// The state of a rotation about an axis.
    pub fn hinge(&self) -> TokenStream {
        self.turning("Hinge", "angle")
    }

    /// `state`; or, if the center of mass moves too,
    /// `&Rotation { attitude: state.attitude, angular_velocity: state.angular_velocity }`.
    fn turning(&self, kind: &str, coordinate: &str) -> TokenStream {
        let (private, place) = (&self.shapes.private, &self.place);
        let (kind, coordinate) = (format_ident!("{kind}"), format_ident!("{coordinate}"));
        if self.translates {
            quote!(&#private::#kind { #coordinate: #place.#coordinate, angular_velocity: #place.angular_velocity })
        } else {
            self.reference.clone()
        }
    }

    /// `FreeRotation::principal([..], [[..], [..], [..]], state)`, and so on.
    fn free(&self, free: &Free, values: &mut Values<'_>) -> TokenStream {
        let private = &self.shapes.private;
        let state = self.turning("Rotation", "attitude");
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
}

/// `[..]`, filled from the next values.
pub fn list(values: &mut Values<'_>, count: usize) -> TokenStream {
    let part = values.take(count);
    quote!([#(#part),*])
}
