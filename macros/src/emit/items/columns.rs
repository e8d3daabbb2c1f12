//! A generic body, its parameters and its inputs as columns of scalars, for many bodies at once.

use proc_macro2::{Ident, Literal, TokenStream};
use quote::{format_ident, quote};

use crate::emit::code::private;
use crate::model::{Declared, Outline};

use super::constructor::Constructor;

/// The columns of a body. A body of `f64` has none, nor has a system without motion.
pub fn emit_columns(outline: &Outline, constructor: &Constructor) -> TokenStream {
    if outline.scalar.is_none() || outline.is_still() {
        return TokenStream::new();
    }
    let count = |declared: &[Declared]| -> usize {
        let components = |field: &Declared| field.frame.map_or(1, |_| outline.motion.axes());
        declared.iter().map(components).sum()
    };
    // the body, with all stored fields
    let has_params = !outline.params.is_empty();
    let empty = (!has_params).then(|| quote!(scalar: ::core::marker::PhantomData));
    let params = has_params.then(|| format_ident!("params"));
    let fields: Vec<Ident> = params
        .into_iter()
        .chain(constructor.stored.clone())
        .collect();
    let total = count(&outline.params) + constructor.stored.len();
    let mut columns = emit_struct(outline, "", &fields, total, empty.as_ref());
    for (suffix, declared) in [("Params", &outline.params), ("Input", &outline.inputs)] {
        if !declared.is_empty() {
            let fields: Vec<Ident> = declared.iter().map(|field| field.name.clone()).collect();
            columns.extend(emit_struct(outline, suffix, &fields, count(declared), None));
        }
    }
    let generic = emit_generic(outline);
    quote!(#columns #generic)
}

/// A struct of `count` scalars; `empty` is a field that holds nothing.
fn emit_struct(
    outline: &Outline,
    suffix: &str,
    fields: &[Ident],
    count: usize,
    empty: Option<&TokenStream>,
) -> TokenStream {
    let (private, scalar) = (private(outline), &outline.scalar);
    let name = format_ident!("{}{suffix}", outline.name);
    let count = Literal::usize_unsuffixed(count);
    let underscore = if fields.is_empty() { "_" } else { "" };
    let [source, sink] = ["source", "sink"].map(|name| format_ident!("{underscore}{name}"));
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
    let (params, argument, build, parameters) = if outline.params.is_empty() {
        let build = if outline.is_foreign() {
            quote!(Self::new())
        } else {
            quote!(::core::result::Result::Ok(
                ::core::default::Default::default()
            ))
        };
        (quote!(()), quote!((): ()), build, None)
    } else {
        let params = format_ident!("{name}Params");
        let (argument, build) = (quote!(params: Self::Params), quote!(Self::new(params)));
        (
            quote!(#params<f64>),
            argument,
            build,
            Some(quote!(self.params)),
        )
    };
    quote! {
        impl #private::Generic for #name<f64> {
            type With<#with: #private::Scalar> = #name<#with>;
            type Params = #params;
            fn build(#argument) -> ::core::result::Result<Self, #private::InvalidBody> { #build }
            fn parameters(&self) -> Self::Params { #parameters }
        }
    }
}
