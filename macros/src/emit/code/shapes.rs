//! Shapes: the runtime's types for a kind of motion, and how they are filled with values.

use core::ops::Range;

use proc_macro2::{Ident, Literal, TokenStream};
use quote::{format_ident, quote};

use crate::families::LoadKind;
use crate::model::{AXES, Field, Motion, Orientation, Outline, Pair, Shape, Variable};
use crate::symbolic::{Components, Id};

use super::naming::local;
use super::scalar::{Scalar, private};

/// The shapes of one body.
#[derive(Clone)]
pub struct Shapes {
    pub motion: Motion,
    /// For a state with parts: the name of its struct, and the parts with their shapes.
    parts: Option<(Ident, Vec<(Ident, &'static Shape)>)>,
    is_system: bool,
    pub scalar: Scalar,
    pub private: TokenStream,
}

/// The values of components, in the order in which they were requested.
pub type Values<'a> = std::slice::Iter<'a, TokenStream>;

impl Shapes {
    pub fn of(outline: &Outline) -> Self {
        Self {
            motion: outline.motion,
            parts: outline
                .has_parts()
                .then(|| (outline.name.clone(), outline.parts())),
            is_system: outline.is_system,
            scalar: Scalar::of(outline),
            private: private(outline),
        }
    }

    /// The same in doubles, even for a generic body.
    pub fn double(outline: &Outline) -> Self {
        Self {
            scalar: Scalar::double(outline),
            ..Self::of(outline)
        }
    }

    pub fn state_type(&self) -> TokenStream {
        if let Some((name, _)) = &self.parts {
            let (name, applied) = (format_ident!("{name}State"), self.scalar.applied());
            return quote!(#name #applied);
        }
        self.scalar.holder(self.motion.shape.state)
    }

    pub fn vector_type(&self) -> TokenStream {
        let (private, kind) = (&self.private, self.scalar.kind());
        if self.motion.is_planar {
            quote!(#private::Vector2<#kind>)
        } else {
            quote!(#private::Vector3<#kind>)
        }
    }

    /// The type of a moment; in the plane, a scalar.
    pub fn moment_type(&self) -> TokenStream {
        if self.motion.is_planar {
            self.scalar.kind()
        } else {
            self.vector_type()
        }
    }

    pub fn acceleration_type(&self) -> TokenStream {
        if let Some((name, parts)) = &self.parts {
            let name = format_ident!("{name}Acceleration");
            // the acceleration of a state without coordinates contains no numbers
            let applied = (!parts.is_empty()).then(|| self.scalar.applied());
            return quote!(#name #applied);
        }
        match self.motion.shape.acceleration {
            Some(name) => self.scalar.holder(name),
            None if self.motion.is_hinged() => self.scalar.kind(),
            None => self.vector_type(),
        }
    }

    pub fn wrench_type(&self) -> TokenStream {
        match self.motion {
            _ if !self.motion.knows_position() => self.moment_type(),
            _ if self.motion.is_planar => self.scalar.holder("PlanarWrench"),
            _ => self.scalar.holder("Wrench"),
        }
    }

    pub fn load_type(&self) -> TokenStream {
        let name = if self.motion.is_planar {
            "PlanarLoad"
        } else {
            "Load"
        };
        self.scalar.holder(name)
    }

    /// The type of a matrix with this many rows and columns.
    pub fn matrix_type(&self, size: [usize; 2]) -> TokenStream {
        let (private, kind) = (&self.private, self.scalar.kind());
        let [rows, columns] = size.map(Literal::usize_unsuffixed);
        quote!(#private::SMatrix<#kind, #rows, #columns>)
    }

    /// A matrix, filled column by column.
    pub fn matrix(&self, [rows, columns]: [usize; 2], values: &mut Values<'_>) -> TokenStream {
        let private = &self.private;
        let columns = (0..columns).map(|_| {
            let column = values.by_ref().take(rows);
            quote!([#(#column),*])
        });
        let columns: Vec<TokenStream> = columns.collect();
        quote!(#private::matrix([#(#columns),*]))
    }

    /// The components of a vector.
    pub fn vector_part<'c>(&self, components: &'c Components) -> &'c [Id] {
        &components[..self.motion.axes()]
    }

    /// The components of a moment.
    pub fn moment_part<'c>(&self, components: &'c Components) -> &'c [Id] {
        &components[self.motion.axes_of(LoadKind::Moment)]
    }

    /// The components of a linear and an angular vector that the motion has.
    pub fn pair_part(&self, Pair { linear, angular }: &Pair) -> Vec<Id> {
        let (linear_axes, angular_axes) = (self.motion.linear_axes(), self.motion.angular_axes());
        [&linear[linear_axes], &angular[angular_axes]].concat()
    }

    /// The names of these components.
    fn pair_names(&self) -> Vec<String> {
        let named = |name: &str, axes: Range<usize>| {
            let axes = AXES[axes].iter();
            axes.map(|axis| format!("{name}_{axis}"))
                .collect::<Vec<_>>()
        };
        let linear = named("linear", self.motion.linear_axes());
        let axes = self.motion.angular_axes();
        let angular = match self.motion.orientation {
            Orientation::Fixed => Vec::new(),
            Orientation::Angle => vec!["angular".to_owned()],
            Orientation::Quaternion => named("angular", axes),
            Orientation::Line => named("axis", axes),
        };
        [linear, angular].concat()
    }

    /// The components of a wrench. For a body that only rotates, those of its moment.
    pub fn wrench_part(&self, force: &Components, moment: &Components) -> Vec<Id> {
        let force = if self.motion.knows_position() {
            self.vector_part(force)
        } else {
            &[]
        };
        [force, self.moment_part(moment)].concat()
    }

    /// The acceleration of one joint.
    pub fn joint_acceleration(&self, shape: &Shape, values: &mut Values<'_>) -> TokenStream {
        let mut field = |field: &Field| {
            let parts = values.take(field.names.len());
            if field.names.len() == 1 {
                quote!(#(#parts)*)
            } else {
                quote!(::core::convert::Into::into([#(#parts),*]))
            }
        };
        let Some(kind) = shape.acceleration else {
            return shape.second.iter().map(field).collect();
        };
        let kind = self.scalar.holder(kind);
        let fields = shape.second.iter().map(|second| {
            let (path, value) = (format_ident!("{}", second.path), field(second));
            quote!(#path: #value)
        });
        quote!(#kind { #(#fields),* })
    }

    /// The runtime's type of the acceleration of one joint.
    pub fn joint_acceleration_type(&self, shape: &Shape) -> TokenStream {
        let private = &self.private;
        if let Some(name) = shape.acceleration {
            let (name, applied) = (format_ident!("{name}"), self.scalar.applied());
            return if self.scalar.is_generic() {
                quote!(#private::generic::#name #applied)
            } else {
                quote!(#private::#name)
            };
        }
        self.numbers_type(shape.second.first().map_or(0, |field| field.names.len()))
    }

    /// The type of a scalar, or of a vector of this many numbers.
    pub fn numbers_type(&self, count: usize) -> TokenStream {
        let (private, kind) = (&self.private, self.scalar.kind());
        match count {
            1 => kind,
            2 => quote!(#private::Vector2<#kind>),
            _ => quote!(#private::Vector3<#kind>),
        }
    }

    /// The names of the components of an acceleration.
    pub fn acceleration_names(&self) -> Vec<String> {
        let Some((_, parts)) = &self.parts else {
            return self.pair_names();
        };
        let alone = (!self.is_system).then(|| self.pair_names());
        let joints = parts.get(alone.iter().len()..).unwrap_or_default();
        let names = joints.iter().flat_map(|(joint, shape)| {
            let names = shape.second.iter().flat_map(|field| field.names);
            names.map(move |name| format!("{joint}_{name}"))
        });
        alone.into_iter().flatten().chain(names).collect()
    }

    pub fn vector(&self, values: &mut Values<'_>) -> TokenStream {
        let components = values.take(self.motion.axes());
        quote!(::core::convert::Into::into([#(#components),*]))
    }

    pub fn moment(&self, values: &mut Values<'_>) -> TokenStream {
        if self.motion.is_planar {
            let value = values.next();
            quote!(#value)
        } else {
            self.vector(values)
        }
    }

    /// A load of this kind.
    pub fn load(&self, kind: LoadKind, values: &mut Values<'_>) -> TokenStream {
        match kind {
            LoadKind::Force => self.vector(values),
            LoadKind::Moment => self.moment(values),
        }
    }

    pub fn acceleration(&self, values: &mut Values<'_>) -> TokenStream {
        if let Some((name, parts)) = &self.parts {
            if parts.is_empty() {
                return TokenStream::new();
            }
            let name = format_ident!("{name}Acceleration");
            let fields = parts.iter().map(|(joint, shape)| {
                let value = self.joint_acceleration(shape, values);
                quote!(#joint: #value)
            });
            return quote!(#name { #(#fields),* });
        }
        match self.motion.shape.acceleration {
            Some(_) => {
                let is_rod = self.motion.is_line();
                let part = format_ident!("{}", if is_rod { "axis" } else { "angular" });
                let kind = self.acceleration_type();
                let (linear, change) = (self.vector(values), self.moment(values));
                quote!(#kind { linear: #linear, #part: #change })
            }
            None if self.motion.is_hinged() => {
                let value = values.next();
                quote!(#value)
            }
            None => self.vector(values),
        }
    }

    /// `State { velocity: .., angular_velocity: .., ..*state }`, or `axis_rate` for a rod, with
    /// these velocities or at rest.
    pub fn moving_state(&self, values: &mut Values<'_>, moves: bool) -> TokenStream {
        let state = local("state");
        let Some((name, parts)) = &self.parts else {
            return self.moving_body(&quote!(*#state), values, moves);
        };
        if parts.is_empty() {
            return quote!(*#state);
        }
        let fields = parts.iter().map(|(part, shape)| {
            let value = if shape
                .fields
                .iter()
                .all(|field| field.variable == Variable::Own)
            {
                quote!(#state.#part)
            } else if self.is_system {
                self.moving_joint(part, shape, values, moves)
            } else {
                self.moving_body(&quote!(#state.#part), values, moves)
            };
            quote!(#part: #value)
        });
        let fields: Vec<TokenStream> = fields.collect();
        let name = format_ident!("{name}State");
        quote!(#name { #(#fields),* })
    }

    /// The motion of a single body, at the place that the state gives.
    fn moving_body(
        &self,
        place: &TokenStream,
        values: &mut Values<'_>,
        moves: bool,
    ) -> TokenStream {
        let kind = self.scalar.holder(self.motion.shape.state);
        let field = |name: &str, value: TokenStream| {
            let name = format_ident!("{name}");
            let value = if moves {
                value
            } else {
                quote!(::core::default::Default::default())
            };
            quote!(#name: #value,)
        };
        let mut fields = TokenStream::new();
        if self.motion.translates() {
            fields.extend(field("velocity", self.vector(values)));
        }
        match self.motion.orientation {
            Orientation::Fixed => {}
            Orientation::Angle => {
                let value = values.next();
                fields.extend(field("angular_velocity", quote!(#value)));
            }
            Orientation::Quaternion => {
                fields.extend(field("angular_velocity", self.vector(values)));
            }
            Orientation::Line => fields.extend(field("axis_rate", self.vector(values))),
        }
        quote!(#kind { #fields ..#place })
    }

    /// `Hinge { angular_velocity: .., ..state.elbow }`
    fn moving_joint(
        &self,
        joint: &Ident,
        shape: &Shape,
        values: &mut Values<'_>,
        moves: bool,
    ) -> TokenStream {
        let (state, private) = (local("state"), &self.private);
        let kind = format_ident!("{}", shape.state);
        let rates = shape.fields.iter().filter(|field| {
            matches!(
                field.variable,
                Variable::Velocity | Variable::AngularVelocity
            )
        });
        let rates = rates.map(|field| {
            let name = format_ident!("{}", field.path);
            let parts = values.by_ref().take(field.names.len());
            let value = match (moves, field.names.len()) {
                (false, _) => quote!(::core::default::Default::default()),
                (_, 1) => quote!(#(#parts)*),
                (_, 2) => quote!(#private::Vector2::new(#(#parts),*)),
                _ => quote!(#private::Vector3::new(#(#parts),*)),
            };
            quote!(#name: #value,)
        });
        let rates: TokenStream = rates.collect();
        quote!(#private::generic::#kind { #rates ..#state.#joint })
    }

    pub fn wrench(&self, values: &mut Values<'_>) -> TokenStream {
        if !self.motion.knows_position() {
            return self.moment(values);
        }
        let kind = self.wrench_type();
        let (force, moment) = (self.vector(values), self.moment(values));
        quote!(#kind { force: #force, moment: #moment })
    }
}
