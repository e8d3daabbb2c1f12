//! A generic body, its parameters and its inputs as columns of scalars, for many bodies at once.

use proc_macro2::{Ident, Literal, TokenStream};
use quote::{format_ident, quote};

use crate::model::{Declared, Outline};

use super::constructor::Constructor;
use super::paths::private;

/// A struct of scalars, and how many there are.
struct Columns {
    name: Ident,
    fields: Vec<Ident>,
    /// Fields that hold nothing.
    empty: Option<TokenStream>,
    count: usize,
}

/// Nothing for a body of `f64`.
pub fn emit_columns(outline: &Outline, constructor: &Constructor) -> TokenStream {
    let Some(scalar) = &outline.scalar else {
        return TokenStream::new();
    };
    let mut structs = vec![whole(outline, constructor)];
    for (suffix, declared) in [("Params", &outline.params), ("Input", &outline.inputs)] {
        if !declared.is_empty() {
            structs.push(Columns {
                name: format_ident!("{}{suffix}", outline.name),
                fields: declared.iter().map(|field| field.name.clone()).collect(),
                empty: None,
                count: count(outline, declared),
            });
        }
    }
    let columns = structs
        .iter()
        .map(|columns| emit_struct(outline, scalar, columns));
    let generic = emit_generic(outline);
    quote!(#(#columns)* #generic)
}

/// The body with all that it stores.
fn whole(outline: &Outline, constructor: &Constructor) -> Columns {
    let has_params = !outline.params.is_empty();
    let params = has_params.then(|| format_ident!("params"));
    Columns {
        name: outline.name.clone(),
        fields: params
            .into_iter()
            .chain(constructor.stored.clone())
            .collect(),
        empty: (!has_params).then(|| quote!(scalar: ::core::marker::PhantomData)),
        count: count(outline, &outline.params) + constructor.stored.len(),
    }
}

fn count(outline: &Outline, declared: &[Declared]) -> usize {
    let components = |field: &Declared| field.frame.map_or(1, |_| outline.motion.axes());
    declared.iter().map(components).sum()
}

fn emit_struct(outline: &Outline, scalar: &Ident, columns: &Columns) -> TokenStream {
    let private = private(outline);
    let Columns {
        name,
        fields,
        empty,
        ..
    } = columns;
    let count = Literal::usize_unsuffixed(columns.count);
    let (source, sink) = if fields.is_empty() {
        (format_ident!("_source"), format_ident!("_sink"))
    } else {
        (format_ident!("source"), format_ident!("sink"))
    };
    quote! {
        #[allow(clippy::inline_always)]
        impl<#scalar: #private::Scalar> #private::Columns<#scalar> for #name<#scalar> {
            const COUNT: usize = #count;
            #[inline(always)]
            fn read(#source: &mut impl #private::Source<#scalar>) -> Self {
                Self { #(#fields: #private::Columns::read(#source),)* #empty }
            }
            #[inline(always)]
            fn write(&self, #sink: &mut impl #private::Sink<#scalar>) {
                #(#private::Columns::write(&self.#fields, #sink);)*
            }
        }
    }
}

fn emit_generic(outline: &Outline) -> TokenStream {
    let (name, private) = (&outline.name, private(outline));
    let with = format_ident!("{name}Scalar");
    let (params, build, parameters) = if outline.params.is_empty() {
        (
            quote!(()),
            quote!(((): ()) -> ::core::result::Result<Self, #private::InvalidBody> {
                ::core::result::Result::Ok(::core::default::Default::default())
            }),
            quote!({}),
        )
    } else {
        let params = format_ident!("{name}Params");
        (
            quote!(#params<f64>),
            quote!((params: Self::Params) -> ::core::result::Result<Self, #private::InvalidBody> {
                Self::new(params)
            }),
            quote!({ self.params }),
        )
    };
    quote! {
        impl #private::Generic for #name<f64> {
            type With<#with: #private::Scalar> = #name<#with>;
            type Params = #params;
            fn build #build
            fn parameters(&self) -> Self::Params #parameters
        }
    }
}
