//! Fields act on every body, so none has the mass of one of them in place of `mass`.

use proc_macro2::Ident;

use crate::errors::Errors;
use crate::syntax::{self, Expression, Kind};

/// Reports fields with the mass of one body, and without the mass of each.
pub fn check_fields(system: &syntax::System, errors: &mut Errors) {
    let bodies: Vec<&Ident> = system.bodies.iter().map(|body| &body.name).collect();
    if bodies.len() < 2 {
        return;
    }
    let fields = system
        .top
        .loads
        .iter()
        .filter(|field| field.charges.is_none());
    for vector in fields.filter_map(|field| field.vector.as_ref()) {
        if let Some((body, mass)) = mass_of_one(vector, &bodies) {
            let message = format!(
                "a field acts on every body, and this is the mass of `{body}`: write `mass` for that of each, or a force \
                 in the braces of `{body}`"
            );
            errors.push(mass.extent, message);
        }
    }
}

/// The first mass of one of these bodies, unless `mass` stands beside it.
fn mass_of_one<'e>(
    vector: &'e Expression,
    bodies: &[&Ident],
) -> Option<(&'e Ident, &'e Expression)> {
    let (mut found, mut has_own) = (None, false);
    vector.visit(|part| match &part.kind {
        Kind::Name(name) => has_own |= name == "mass",
        Kind::Field(of, field) if field == "mass" => {
            if let Kind::Name(body) = &of.kind
                && bodies.contains(&body)
            {
                found = found.or(Some((body, part)));
            }
        }
        _ => {}
    });
    found.filter(|_| !has_own)
}
