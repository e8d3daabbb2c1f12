//! The places of the parts of states and accelerations, and their names in equations.

use proc_macro2::{Ident, TokenStream};
use quote::{format_ident, quote};

use crate::model::{AXES, Declared, Field, Jointed, Meaning, Motion, Outline, Variable};

use super::naming::local;
use super::writer::Source;

/// The component of a quantity that a symbol stands for, if it stands for one.
type Component = Box<dyn Fn(Meaning) -> Option<usize>>;

/// Components that are read together: where they come from, and the name of each. A scalar has one.
type Place = (Source, TokenStream, Vec<String>, Component);

/// Where the parts of a state and of an acceleration are.
pub fn places(outline: &Outline) -> Vec<Place> {
    let own = outline.states.iter().enumerate().map(place_of_own);
    if outline.is_system {
        let joints = outline.joints.iter().flat_map(places_of_joint);
        return joints.chain(own).collect();
    }
    let part = outline.has_parts().then(|| quote!(.motion));
    let places = places_of_body(outline.motion, part.as_ref()).into_iter();
    let places = places.map(|(source, path, names, variable)| {
        let component: Component = Box::new(move |meaning| match meaning {
            Meaning::Of(_, known, part) if known == variable => Some(variable.place(part)),
            _ => None,
        });
        (source, path, names, component)
    });
    places.chain(own).collect()
}

/// A user-defined state, in the field with its name.
fn place_of_own((number, own): (usize, &Declared)) -> Place {
    let (state, name) = (local("state"), &own.name);
    let component: Component =
        Box::new(move |meaning| (meaning == Meaning::Own(number)).then_some(0));
    let names = vec![name.to_string()];
    (Source::State, quote!(#state.#name), names, component)
}

/// The parts of the state of a joint and of its acceleration, in the fields with its name.
fn places_of_joint(joint: &Jointed) -> Vec<Place> {
    let (name, frame) = (&joint.name, joint.frame);
    let place = |source: Source, of: &str, field: &'static Field| {
        let of = local(of);
        let path = field.path.split('.').filter(|part| !part.is_empty());
        let path: Vec<Ident> = path.map(|part| format_ident!("{part}")).collect();
        let names = field.names.iter().map(|part| format!("{name}_{part}"));
        let component: Component = Box::new(move |meaning| match meaning {
            Meaning::Of(body, ..) if Some(body) == frame => field.component(meaning),
            _ => None,
        });
        (
            source,
            quote!(#of.#name #(.#path)*),
            names.collect(),
            component,
        )
    };
    let state = joint.shape.fields.iter();
    let state = state.map(|field| place(Source::State, "state", field));
    let second = joint.shape.second.iter();
    let second = second.map(|field| place(Source::Acceleration, "acceleration", field));
    state.chain(second).collect()
}

/// The parts of the state and of the acceleration of a single body; `part` is the field that
/// contains its motion, if that is not the whole state.
fn places_of_body(
    motion: Motion,
    part: Option<&TokenStream>,
) -> Vec<(Source, TokenStream, Vec<String>, Variable)> {
    let [state, acceleration] = ["state", "acceleration"].map(|name| {
        let name = local(name);
        quote!(#name #part)
    });
    let axes = &AXES[..motion.axes()];
    let vector = |prefix: &str| axes.iter().map(|axis| format!("{prefix}{axis}")).collect();
    let angular = |name: &str, prefix: &str| {
        let one = motion.has_angle().then(|| vec![name.to_owned()]);
        one.unwrap_or_else(|| vector(prefix))
    };
    let of_state = |path: TokenStream, names: Vec<String>, variable: Variable| {
        (Source::State, quote!(#state.#path), names, variable)
    };
    // if a motion has coordinates of only one kind, its acceleration is not a struct
    let is_struct = motion.translates() && motion.has_attitude();
    let of_acceleration = |name: &str, names: Vec<String>, variable: Variable| {
        let name = format_ident!("{name}");
        let path = match (is_struct, part) {
            (true, _) => quote!(#acceleration.#name),
            (false, Some(_)) => acceleration.clone(),
            (false, None) => quote!((*#acceleration)),
        };
        (Source::Acceleration, path, names, variable)
    };
    let quaternion = ["qx", "qy", "qz", "qw"].map(str::to_owned).to_vec();
    let (rate, alpha) = (angular("w", "w"), angular("alpha", "alpha_"));
    vec![
        of_state(quote!(position), vector(""), Variable::Position),
        of_state(quote!(angle), vec!["angle".to_owned()], Variable::Angle),
        of_state(quote!(attitude.coords), quaternion, Variable::Quaternion),
        of_state(quote!(axis.into_inner()), vector("u"), Variable::Axis),
        of_state(quote!(velocity), vector("v"), Variable::Velocity),
        of_state(quote!(angular_velocity), rate, Variable::AngularVelocity),
        of_state(quote!(axis_rate), vector("rate_"), Variable::AxisRate),
        of_acceleration("linear", vector("a"), Variable::LinearAcceleration),
        of_acceleration("angular", alpha, Variable::AngularAcceleration),
        of_acceleration("axis", vector("axis_"), Variable::AxisAcceleration),
    ]
}

/// The coordinates of the motion of a single body and their derivatives, with the names of their
/// components in equations.
pub fn motion_symbols(motion: Motion) -> Vec<(Vec<String>, Variable)> {
    let axes = &AXES[..motion.axes()];
    let places = places_of_body(motion, None).into_iter();
    let symbols = places.map(|(source, _, names, variable)| {
        let result = variable.of_acceleration();
        let names = match source {
            Source::Acceleration if names.len() == 1 => vec![result.to_owned()],
            Source::Acceleration => axes.iter().map(|axis| format!("{result}_{axis}")).collect(),
            _ => names,
        };
        (names, variable)
    });
    symbols.collect()
}

/// The same of a joint.
pub fn joint_symbols(joint: &Jointed) -> impl Iterator<Item = (Vec<String>, Variable)> {
    let fields = joint.shape.fields.iter().chain(joint.shape.second);
    fields.map(|field| {
        let names = field.names.iter();
        let names = names.map(|part| format!("{}_{part}", joint.name));
        (names.collect(), field.variable)
    })
}
