//! States and inputs as lists of numbers, for the search for steady motions.

use proc_macro2::{Literal, TokenStream};
use quote::{format_ident, quote};

use crate::emit::code::{COMMON, Method, Site, Writer, local};
use crate::model::{AXES, Group, Outline, Variable};
use crate::symbolic::Id;

/// `impl Coordinated<STATES, INPUTS> for Body`; `in_world` says of each joint whether its
/// coordinates are in world axes, and `sizes` are those of the terms of the accelerations.
pub fn coordinated(site: &Site<'_>, in_world: &[bool], sizes: Option<&[Id]>) -> TokenStream {
    let (outline, private) = (site.outline, &site.shapes.private);
    let groups = outline.tangent();
    let places = places(&groups, in_world).into_iter();
    let places = places.map(|place| quote!(#private::Place::#place));
    let states: usize = groups.iter().map(|group| group.size).sum();
    let sizes = terms(site, sizes, states);
    let (states, input) = (Literal::usize_unsuffixed(states), site.input_type());
    let (read, written, count) = components(outline);
    let count = Literal::usize_unsuffixed(count);
    let (given, list) = (local("input"), local("components"));
    let [given_name, list_name] = if outline.inputs.is_empty() {
        [quote!((): &()), quote!([]: [f64; 0])]
    } else {
        [quote!(#given: &Self::Input), quote!(#list: [f64; #count])]
    };
    let made = if outline.inputs.is_empty() {
        quote!()
    } else {
        let name = format_ident!("{}Input", outline.name);
        quote!(#name { #(#written)* })
    };
    let violations = outline.is_constrained.then(|| violations(site, &input));
    let arguments = quote!(<#states, #count>);
    let header = site.header_with("Coordinated", &arguments);
    quote! {
        #header {
            const PLACES: &'static [#private::Place] = &[#(#places),*];

            fn components(#given_name) -> [f64; #count] {
                [#(#read),*]
            }

            fn input(#list_name) -> Self::Input {
                #made
            }

            #sizes
            #violations
        }
    }
}

/// `terms`: the sizes of the terms of each acceleration, behind zeros for the coordinates.
fn terms(site: &Site<'_>, sizes: Option<&[Id]>, states: usize) -> TokenStream {
    let method = site.method(sizes, |writer, sizes| {
        let writer = Writer {
            is_whole: true,
            ..writer.clone()
        };
        let zeros = core::iter::repeat_n(quote!(0.0), states - sizes.len());
        Method::write(&writer, sizes, |values| quote!([#(#zeros,)* #(#values),*]))
    });
    let states = Literal::usize_unsuffixed(states);
    let arguments = site.arguments(&method, &COMMON);
    method.declared("terms", &arguments, &quote!([f64; #states]))
}

/// `each_violation` of a body under constraints.
fn violations(site: &Site<'_>, input: &TokenStream) -> TokenStream {
    let (state_type, private) = (site.shapes.state_type(), &site.shapes.private);
    let [time, state, given] = ["time", "state", "input"].map(local);
    let [each, one] = ["each", "violation"].map(local);
    let body = quote!(Self as #private::Constrained);
    quote! {
        fn each_violation(
            &self,
            #time: f64,
            #state: &#state_type,
            #given: &#input,
            #each: &mut dyn ::core::ops::FnMut(#private::Violation),
        ) {
            for #one in <#body>::violations(self, #time, #state, #given) {
                #each(#one);
            }
        }
    }
}

/// The kind of each coordinate.
fn places(groups: &[Group], in_world: &[bool]) -> Vec<TokenStream> {
    let is_place = |group: &&Group| !group.variable.is_rate() && group.variable != Variable::Own;
    let places = groups.iter().filter(is_place).flat_map(|group| {
        let is_in_world = in_world.get(group.joint).copied().unwrap_or_default();
        let is_free = is_in_world && groups.iter().any(|other| is_position(group, other));
        (0..group.size).map(move |part| place(group, part, [is_in_world, is_free]))
    });
    places.collect()
}

/// Whether `group` is the position of the joint whose rotation is `other`.
fn is_position(group: &Group, other: &Group) -> bool {
    other.joint == group.joint && other.variable == Variable::Position && other.size > 1
}

fn place(group: &Group, part: usize, [is_in_world, is_free]: [bool; 2]) -> TokenStream {
    let part = Literal::usize_unsuffixed(part);
    match group.variable {
        Variable::Position if is_free => quote!(Position(#part)),
        Variable::Quaternion if is_in_world => quote!(Attitude(#part)),
        Variable::Quaternion => quote!(Relative(#part)),
        Variable::Axis => quote!(Axis(#part)),
        Variable::Angle if is_free => quote!(Heading),
        Variable::Angle => quote!(Angle),
        _ => quote!(Length),
    }
}

/// How inputs become components, how components become inputs, and the number of components.
fn components(outline: &Outline) -> (Vec<TokenStream>, Vec<TokenStream>, usize) {
    let (given, list) = (local("input"), local("components"));
    let (mut read, mut written) = (Vec::new(), Vec::new());
    for input in &outline.inputs {
        let name = &input.name;
        let first = read.len();
        let at = |part: usize| {
            let place = Literal::usize_unsuffixed(first + part);
            quote!(#list[#place])
        };
        if input.frame.is_some() {
            let size = outline.motion.axes();
            let axes = AXES[..size].iter().map(|axis| format_ident!("{axis}"));
            read.extend(axes.map(|axis| quote!(#given.#name.#axis)));
            let parts = (0..size).map(at);
            written.push(quote!(#name: ::core::convert::Into::into([#(#parts),*]),));
        } else {
            read.push(quote!(#given.#name));
            let part = at(0);
            written.push(quote!(#name: #part,));
        }
    }
    let count = read.len();
    (read, written, count)
}
