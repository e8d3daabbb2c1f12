//! What methods are written with: in the scalar of the body, or in doubles.

use proc_macro2::TokenStream;
use quote::{format_ident, quote};

use crate::model::Outline;

use super::method::Method;
use super::shapes::Shapes;
use super::writer::{Source, Writer};

/// The types of a body, and the writer of its methods.
pub struct Site<'a> {
    pub outline: &'a Outline,
    pub shapes: Shapes,
    /// `None` for an invalid description.
    writer: Option<Writer<'a>>,
}

impl<'a> Site<'a> {
    pub fn new(outline: &'a Outline, writer: Option<Writer<'a>>) -> Self {
        Self {
            outline,
            shapes: Shapes::of(outline),
            writer,
        }
    }

    /// The same in doubles, even for a generic body.
    pub fn double(&self) -> Self {
        Self {
            outline: self.outline,
            shapes: Shapes::double(self.outline),
            writer: self.writer.as_ref().map(Writer::double),
        }
    }

    /// The method for a derived result. Without a result, a method that is never run.
    pub fn method<D: ?Sized>(
        &self,
        derived: Option<&D>,
        write: impl FnOnce(&Writer<'a>, &D) -> Method,
    ) -> Method {
        let both = self.writer.as_ref().zip(derived);
        both.map_or_else(Method::never, |(writer, derived)| write(writer, derived))
    }

    /// `impl Trait for Body`; for a generic body, `impl<T: Scalar> Trait for Body<T>`.
    pub fn header(&self, name: &str) -> TokenStream {
        self.header_with(name, &TokenStream::new())
    }

    /// `impl Trait<..> for Body`
    pub fn header_with(&self, name: &str, arguments: &TokenStream) -> TokenStream {
        let Shapes {
            private, scalar, ..
        } = &self.shapes;
        let (declared, applied) = (scalar.declared(), scalar.applied());
        let (body, name) = (&self.outline.name, format_ident!("{name}"));
        quote!(impl #declared #private::#name #arguments for #body #applied)
    }

    /// The type of the inputs; `()` for a body without inputs.
    pub fn input_type(&self) -> TokenStream {
        let is_there = !self.outline.inputs.is_empty();
        is_there
            .then(|| self.own_type("Input"))
            .unwrap_or(quote!(()))
    }

    /// The type of the unknown reactions, if there are any.
    pub fn reactions_type(&self) -> TokenStream {
        let outline = self.outline;
        let is_there = outline.has_reactions();
        is_there
            .then(|| self.own_type("Reactions"))
            .unwrap_or(quote!(()))
    }

    /// `BodyInput<T>`
    pub fn own_type(&self, suffix: &str) -> TokenStream {
        let name = format_ident!("{}{suffix}", self.outline.name);
        let applied = self.shapes.scalar.applied();
        quote!(#name #applied)
    }

    /// `kind`, or `Result<kind, Singular>` if the result may not exist.
    pub fn fallible(&self, kind: TokenStream, is_fallible: bool) -> TokenStream {
        if !is_fallible {
            return kind;
        }
        let private = &self.shapes.private;
        quote!(::core::result::Result<#kind, #private::Singular>)
    }

    /// `time: f64, state: &State, ..`. Unused arguments begin with an underscore.
    pub fn arguments(&self, method: &Method, sources: &[Source]) -> TokenStream {
        let shapes = &self.shapes;
        let arguments = sources.iter().map(|source| {
            let (name, kind) = match source {
                Source::Time => ("time", shapes.scalar.kind()),
                Source::State => ("state", by_reference(&shapes.state_type())),
                Source::Acceleration => ("acceleration", by_reference(&shapes.acceleration_type())),
                Source::Reactions => ("reactions", by_reference(&self.reactions_type())),
                Source::Params => ("params", self.own_type("Params")),
                Source::Input => ("input", by_reference(&self.input_type())),
            };
            let name = method.argument(*source, name);
            quote!(#name: #kind)
        });
        quote!(#(#arguments),*)
    }
}

fn by_reference(kind: &TokenStream) -> TokenStream {
    quote!(&#kind)
}
