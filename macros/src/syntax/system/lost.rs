//! Fallbacks for a system with unreadable parts.

use proc_macro2::Ident;

use crate::errors::Errors;
use crate::syntax::expression::Expression;

use super::System;

/// Whether an entry that may have defined bodies, or joints, could not be read.
#[derive(Default)]
pub struct Lost {
    pub bodies: bool,
    pub joints: bool,
}

impl System {
    /// All values that are written outside the bodies.
    fn written(&self) -> impl Iterator<Item = &Expression> {
        let loads = self.drives.iter().chain(&self.forces).chain(&self.moments);
        let joints = self.joints.iter().chain(&self.cables);
        let top = self.top.constraints.iter().chain(&self.top.locals);
        let top = top.chain(&self.top.potentials).chain(&self.top.rates);
        let definitions = joints.chain(loads).chain(top);
        let values = definitions.filter_map(|definition| definition.value.as_ref());
        values.chain(&self.points)
    }

    /// Reports a system without bodies. Any unknown name may then be that of a body.
    pub fn check_bodies(&mut self, errors: &mut Errors) {
        if !self.bodies.is_empty() || self.lost.bodies {
            return;
        }
        let name = &self.top.name;
        let message = format!("`{name}` has no bodies: write `bodies: [arm {{ .. }}]`");
        errors.push(name.span(), message);
        self.lost.bodies = true;
    }

    /// If something that defines bodies or joints could not be read, any unknown name may be one of
    /// them.
    pub fn lose_names(&mut self) {
        if !self.lost.bodies && !self.lost.joints {
            return;
        }
        let bodies = self.bodies.iter().flat_map(|body| {
            let loads = body.loads.iter().filter_map(|load| load.vector.as_ref());
            loads.chain(body.locals.iter().filter_map(|local| local.value.as_ref()))
        });
        let names = self.written().chain(bodies).flat_map(Expression::names);
        let top = &self.top;
        let declared = top.params.iter().chain(&top.inputs).map(|one| &one.name);
        let declared = declared.chain(top.foreign().map(|(name, _)| name));
        let members = self.bodies.iter().map(|body| &body.name);
        let joints = self.joints.iter().chain(&self.cables);
        let defined = top.locals.iter().chain(joints).map(|one| &one.name);
        let known: Vec<&Ident> = declared.chain(members).chain(defined).collect();
        let lost: Vec<String> = names
            .filter(|name| !known.contains(name))
            .map(ToString::to_string)
            .collect();
        for body in &mut self.bodies {
            let own = body
                .points
                .iter()
                .chain(&body.locals)
                .map(|one| one.name.to_string());
            let own: Vec<String> = own.collect();
            body.lost
                .extend(lost.iter().filter(|name| !own.contains(name)).cloned());
        }
        self.top.lost.extend(lost);
    }
}
