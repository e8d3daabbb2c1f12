//! The structs of a body: itself, its parameters, its inputs, its reactions.

use proc_macro2::{Ident, TokenStream};
use quote::{format_ident, quote};

use crate::emit::code::{Scalar, Shapes, allow_constants, local_name, private};
use crate::model::{Declared, Outline};

use super::constructor::Constructor;
use super::docs::{Documentation, declared_doc, params_rows};
use super::open::{open_drives, open_reactions};
use super::record::{Field, Record, snake_case};

/// The fields of a struct: one for each declared quantity.
fn declared_fields(outline: &Outline, declared: &[Declared]) -> Vec<Field> {
    let shapes = Shapes::of(outline);
    let fields = declared.iter().map(|declared| Field {
        name: declared.name.clone(),
        doc: declared_doc(declared),
        kind: match declared.frame {
            None => shapes.scalar.kind(),
            Some(_) => shapes.vector_type(),
        },
        unit: Some(declared.plain_unit()),
        default: default_value(outline, declared),
    });
    fields.collect()
}

/// The structs of inputs, reactions and drives, if there are any.
fn records(outline: &Outline) -> impl Iterator<Item = Record> {
    let input = Record {
        suffix: "Input",
        doc: format!(
            " Inputs of [`{}`] at each evaluation, in SI units.",
            outline.name
        ),
        fields: declared_fields(outline, &outline.inputs),
        has_default: true,
    };
    let all = [input, open_reactions(outline), open_drives(outline)];
    let all = all.into_iter();
    all.filter(|record| !record.fields.is_empty())
}

fn default_value(outline: &Outline, declared: &Declared) -> Option<TokenStream> {
    let (private, scalar) = (private(outline), Scalar::of(outline));
    let kind = scalar.kind();
    let at_hand = quote!(<#kind as ::core::default::Default>::default());
    let numbers = declared.default.as_ref()?.iter();
    let numbers = numbers.map(|number| scalar.constant(number, &at_hand));
    Some(match (declared.frame, outline.motion.axes()) {
        (None, _) => quote!(#(#numbers)*),
        (Some(_), 2) => quote!(#private::Vector2::new(#(#numbers),*)),
        (Some(_), _) => quote!(#private::Vector3::new(#(#numbers),*)),
    })
}

pub fn emit_items(
    outline: &Outline,
    constructor: &Constructor,
    documentation: &Documentation,
) -> TokenStream {
    let (name, scalar) = (&outline.name, Scalar::of(outline));
    let Documentation { lines, constants } = documentation;
    let beside = records(outline).map(|record| record.declared(outline));
    let beside: TokenStream = beside.chain(emit_state(outline)).collect();
    let (declared, applied, kind) = (scalar.declared(), scalar.applied(), scalar.kind());
    if outline.is_built() {
        return emit_built(outline, constructor, documentation, &beside);
    }
    let marker = scalar.is_generic();
    let marker = marker.then(|| quote!(scalar: ::core::marker::PhantomData<#kind>));
    quote! {
        #lines
        #[derive(Clone, Debug, Default)]
        #[allow(unreachable_pub)]
        pub struct #name #declared { #marker }
        #beside
        impl #declared #name #applied { #constants }
    }
}

/// The state of a system and its acceleration, joint by joint. A body with user-defined states has
/// them, too.
fn emit_state(outline: &Outline) -> Option<TokenStream> {
    if !outline.has_parts() {
        return None;
    }
    let (name, shapes) = (&outline.name, Shapes::of(outline));
    let private = &shapes.private;
    let [state, acceleration] =
        ["State", "Acceleration"].map(|suffix| format_ident!("{name}{suffix}"));
    let parts = if outline.is_system {
        "of each joint"
    } else {
        "of its motion"
    };
    let own = if outline.states.is_empty() {
        ["", ""]
    } else {
        [
            ", and user-defined states",
            ", and the rates of user-defined states",
        ]
    };
    let [of_state, of_acceleration] = [
        format!(" The state of [`{name}`]: the state {parts}{}.", own[0]),
        format!(
            " The acceleration of [`{name}`]: the acceleration {parts}{}.",
            own[1]
        ),
    ];
    let scalar = outline.scalar.iter();
    if outline.is_still() {
        let (applied, still) = (shapes.scalar.applied(), shapes.scalar.holder("Still"));
        return Some(quote! {
            #[doc = #of_state]
            pub type #state #applied = #still;
            #[doc = #of_acceleration]
            pub type #acceleration = ();
        });
    }
    let all = outline.parts();
    let fields = all.iter().map(|(name, shape)| {
        let kind = format_ident!("{}", shape.state);
        let second = shapes.joint_acceleration_type(shape);
        let [first_doc, second_doc] = docs_of_part(outline, name);
        let own = outline.states.iter().find(|state| state.name == *name);
        let unit = own.map(Declared::plain_unit).into_iter();
        quote!(#[doc = #first_doc] #name: #kind #(#unit)* #[doc = #second_doc] => #second)
    });
    let lints = snake_case(all.iter().map(|(name, _)| name)).into_iter();
    let lints: TokenStream = lints.map(|lint| quote!(#[allow(#lint)])).collect();
    Some(quote! {
        #private::system_state! {
            #[doc = #of_state] #lints #state
            #[doc = #of_acceleration] #lints #acceleration #(<#scalar>)* { #(#fields),* }
        }
    })
}

/// The documentation of a part of a state, and of its acceleration.
fn docs_of_part(outline: &Outline, name: &Ident) -> [String; 2] {
    let mut states = outline.states.iter();
    let Some(state) = states.find(|state| state.name == *name) else {
        let joint = format!(" The joint `{name}`.");
        return if outline.is_system {
            [joint.clone(), joint]
        } else {
            [" The motion", " The acceleration"].map(|what| format!("{what} of the body."))
        };
    };
    let unit = state.rate_in_unit();
    [declared_doc(state), format!(" The rate of `{name}`{unit}.")]
}

/// The struct of a body that is built from parameters; `beside` are the structs next to it.
fn emit_built(
    outline: &Outline,
    constructor: &Constructor,
    documentation: &Documentation,
    beside: &TokenStream,
) -> TokenStream {
    let (name, scalar, private) = (&outline.name, Scalar::of(outline), private(outline));
    let (declared, applied, kind) = (scalar.declared(), scalar.applied(), scalar.kind());
    let Documentation { lines, constants } = documentation;
    let Constructor {
        stored, axes, body, ..
    } = constructor;
    let record = Record {
        suffix: "Params",
        doc: format!(" Parameters of [`{name}`], in SI units."),
        fields: declared_fields(outline, &outline.params),
        has_default: false,
    };
    let (has_params, axes) = (!outline.params.is_empty(), axes.iter());
    let params = has_params.then(|| {
        let name = record.name(outline);
        quote!(#name #applied)
    });
    let param_struct = has_params.then(|| record.declared(outline));
    let marker = (!has_params && scalar.is_generic())
        .then(|| quote!(scalar: ::core::marker::PhantomData<#kind>,));
    let params: Vec<TokenStream> = params.into_iter().collect();
    let constants_of_new = allow_constants(body);
    let default = emit_default(outline);
    let what = if has_params { "parameter" } else { "constant" };
    let new_doc =
        format!(" Checks the {what}s, and computes everything that depends on them alone.");
    let rows = params_rows(outline).into_iter();
    let rows = rows.map(|row| format!(" - {row}"));
    let error_doc =
        format!(" A {what} is not finite, or no body can have the resulting mass or inertia.");
    quote! {
        #lines
        #[derive(Clone, Debug)]
        pub struct #name #declared { #(params: #params,)* #marker #(#stored: #kind,)* #(#axes: #private::PrincipalAxes)* }
        #param_struct
        #beside
        impl #declared #name #applied {
            #constants
            #[doc = #new_doc]
            #(#[doc = #rows])*
            #[doc = ""]
            #[doc = " # Errors"]
            #[doc = #error_doc]
            #constants_of_new
            pub fn new(#(params: #params)*) -> ::core::result::Result<Self, #private::InvalidBody> { #body }
            #(
                /// The parameters of this body.
                #[must_use]
                pub fn params(&self) -> &#params { &self.params }
            )*
        }
        #default
    }
}

/// Since the fields that a body stores depend on each other, the items of a body with fields are in
/// their own module: no code next to the call can change a single field. `added` are structs of
/// outputs.
pub fn with_private_fields(outline: &Outline, items: TokenStream, added: &[Ident]) -> TokenStream {
    if !outline.is_built() {
        return items;
    }
    let name = &outline.name;
    let module = format_ident!("equations_of_{name}");
    let others = [
        ("State", outline.has_parts()),
        ("Acceleration", outline.has_parts()),
        ("Params", !outline.params.is_empty()),
    ];
    let others = others.iter().filter(|(_, is_there)| *is_there);
    let others = others.map(|(suffix, _)| format_ident!("{name}{suffix}"));
    let records = records(outline).map(|record| record.name(outline));
    let others = others.chain(records).chain(added.iter().cloned());
    quote! {
        #[allow(non_snake_case, unreachable_pub)]
        mod #module { #items }
        #[allow(unused_imports, unreachable_pub)]
        pub use #module::{#name, #(#others),*};
    }
}

/// The default parameters, and the default body if it is known to be possible with them.
fn emit_default(outline: &Outline) -> Option<TokenStream> {
    if outline.params.is_empty() || !outline.has_default_params() {
        return None;
    }
    let name = &outline.name;
    let params = format_ident!("{name}Params");
    let names = outline.params.iter().map(|param| &param.name);
    let values = outline
        .params
        .iter()
        .filter_map(|param| default_value(outline, param));
    let values = quote!(#(#names: #values),*);
    let constants = allow_constants(&values);
    let scalar = Scalar::of(outline);
    let (declared, applied) = (scalar.declared(), scalar.applied());
    let checked = if scalar.is_generic() {
        "the defaults make a body in the precision of `f64`"
    } else {
        "the defaults were checked at expansion"
    };
    let of_body = outline.has_default().then(|| quote! {
        impl #declared ::core::default::Default for #name #applied {
            fn default() -> Self {
                Self::new(<#params #applied as ::core::default::Default>::default()).expect(#checked)
            }
        }
    });
    Some(quote! {
        impl #declared ::core::default::Default for #params #applied {
            #constants
            fn default() -> Self { Self { #values } }
        }
        #of_body
    })
}

/// Names that nothing refers to, written so that the compiler warns about them. Their type is one that
/// no constant has: for a name of one letter, rustc would propose the constant `_` of the same type.
pub fn emit_unused(outline: &Outline) -> Option<TokenStream> {
    let names = outline.unused.iter();
    let names = names.map(|name| Ident::new(&local_name(&name.to_string()), name.span()));
    let is_there = !outline.unused.is_empty();
    is_there.then(|| quote!(const _: fn() = || { #(let #names = [(); 0];)* };))
}
