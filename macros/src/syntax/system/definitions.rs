//! Joints, loads and other entries of a system that are written `name = value`.

use proc_macro2::{Delimiter, TokenTree};

use crate::errors::Errors;
use crate::syntax::Definition;
use crate::syntax::entries::{holds_keys, parse_name, parse_value};
use crate::syntax::expression::call;
use crate::syntax::tokens::is_punct;

use super::{CABLE, LINK, System};

impl System {
    /// `name = value` in a list other than `bodies`.
    pub(super) fn parse_definition(
        &mut self,
        list: &str,
        entry: &[TokenTree],
        errors: &mut Errors,
    ) {
        let Some((name, rest)) = parse_name(&mut self.top, list, entry, errors) else {
            self.lost.joints |= list == "joints";
            return;
        };
        let value = parse_value(&name, rest, errors);
        let definition = Definition { name, value };
        match list {
            "joints" if is_called(&definition, CABLE) => self.cables.push(definition),
            // a link carries nothing: it is a constraint
            "joints" if is_called(&definition, LINK) => self.top.constraints.push(definition),
            "joints" => self.joints.push(definition),
            "drives" => self.drives.push(definition),
            "locked" => self.locked.push(definition),
            "forces" => self.forces.push(definition),
            _ => self.moments.push(definition),
        }
    }

    /// Reports and reads a joint in the list of bodies, if the entry is `name = kind(..)`.
    pub(super) fn parse_joint_among_bodies(
        &mut self,
        entry: &[TokenTree],
        errors: &mut Errors,
    ) -> bool {
        let [
            TokenTree::Ident(name),
            sign,
            TokenTree::Ident(kind),
            TokenTree::Group(group),
            ..,
        ] = entry
        else {
            return false;
        };
        let is_call = group.delimiter() == Delimiter::Parenthesis && !holds_keys(group);
        if !is_punct(sign, '=') || !is_call {
            return false;
        }
        let message = format!("a joint belongs in `joints`: move `{name} = {kind}(..)` there");
        errors.push(name.span(), message);
        self.parse_definition("joints", entry, errors);
        true
    }
}

/// Whether a joint is `kind(..)`, with or without methods after it.
fn is_called(joint: &Definition, kind: &str) -> bool {
    let called = joint.value.as_ref().and_then(call);
    called.is_some_and(|((word, _), _)| word == kind)
}
