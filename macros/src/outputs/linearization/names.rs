//! The names of states, inputs and params in derivatives: those of blocks, and of their components.

use std::collections::HashMap;

use proc_macro2::Ident;

use crate::errors::Errors;
use crate::model::{AXES, Declared, Outline, Variable};

/// A part of the state, an input or a param, with the names that it has among derivatives.
struct Named<'o> {
    /// What has a name that can be changed: a joint, a user-defined state, an input, a param.
    owner: Option<(&'o Ident, &'static str)>,
    name: String,
    is_vector: bool,
}

/// Reports names that two blocks or two components of a linearization would share: `velocity_x` of
/// an input, or `arm_angular_velocity` of a hinge `arm` and a slide `arm_angular`.
pub fn check_states_and_inputs(outline: &Outline, errors: &mut Errors) {
    let inputs = named(&outline.inputs, "input");
    check(tangent(outline).chain(inputs), "linearization", errors);
}

/// Reports names that two parameters would share: a vector `wind` and a number `wind_x`.
pub fn check_params(outline: &Outline, errors: &mut Errors) {
    check(named(&outline.params, "param"), "sensitivity", errors);
}

fn check<'o>(parts: impl Iterator<Item = Named<'o>>, output: &str, errors: &mut Errors) {
    let mut seen: HashMap<String, Option<(&Ident, &str)>> = HashMap::new();
    for part in parts {
        let own = part.owner.map(|(owner, _)| owner);
        let shared = part.names().into_iter().find_map(|name| {
            let first = *seen.get(&name)?;
            let is_other = first.map(|(owner, _)| owner) != own;
            is_other.then_some((name, first))
        });
        if let (Some((name, first)), Some((owner, what))) = (shared, part.owner) {
            let has = match first {
                Some((first, other)) if other == what => format!("the {other} `{first}` has"),
                _ if what == "input" => "the state has".to_owned(),
                _ => "the motion has".to_owned(),
            };
            let message = format!(
                "{has} `{name}`, too, and the blocks of `{output}` go by these names: rename the {what}"
            );
            errors.push(owner.span(), message);
            continue;
        }
        for name in part.names() {
            seen.insert(name, part.owner);
        }
    }
}

/// The groups of the state.
fn tangent(outline: &Outline) -> impl Iterator<Item = Named<'_>> {
    outline.tangent().into_iter().map(|group| Named {
        owner: match group.variable {
            Variable::Own => Some((&outline.states[group.first].name, "state")),
            _ if outline.is_system => Some((&outline.joints[group.joint].name, "joint")),
            _ => None,
        },
        name: group.name,
        is_vector: group.size > 1,
    })
}

fn named<'o>(declared: &'o [Declared], what: &'static str) -> impl Iterator<Item = Named<'o>> {
    declared.iter().map(move |one| Named {
        owner: Some((&one.name, what)),
        name: one.name.to_string(),
        is_vector: one.frame.is_some(),
    })
}

impl Named<'_> {
    /// Its name, and those of its components. A vector in the plane has no component along z, but
    /// `lift_z` would be taken for one of `lift`.
    fn names(&self) -> Vec<String> {
        let axes = if self.is_vector { &AXES[..] } else { &[] };
        let parts = axes.iter().map(|axis| format!("{}_{axis}", self.name));
        [self.name.clone()].into_iter().chain(parts).collect()
    }
}
