//! `drawing: zero_pose`, and the places of bodies in a drawing.

use proc_macro2::{Ident, TokenTree};

use crate::errors::Errors;
use crate::syntax::Description;
use crate::syntax::entries::key_value;
use crate::syntax::expression::{Expression, Kind};
use crate::syntax::tokens::start;

use super::System;

/// The place of the center of mass G of a body in a drawing.
pub enum Center {
    At(Expression),
    Missing,
    Reported,
}

impl System {
    /// `drawing: zero_pose`
    pub(super) fn parse_drawing(&mut self, key: &Ident, rest: &[TokenTree], errors: &mut Errors) {
        let value = key_value(key, rest, errors);
        if self.is_drawn() {
            errors.push(
                key.span(),
                "`drawing` is given twice: leave one of them out",
            );
            return;
        }
        self.centers = Some(Vec::new());
        self.top.keys.push(key.clone());
        match value {
            [TokenTree::Ident(word)] if word == "zero_pose" => {}
            [first, ..] => {
                let message = "a drawing shows the pose in which all coordinates are zero: write `drawing: zero_pose`";
                errors.push(start(first), message);
            }
            [] => {}
        }
    }

    pub fn is_drawn(&self) -> bool {
        self.centers.is_some()
    }

    /// Takes `.at(..)` from inertias and masses.
    pub(super) fn take_centers(&mut self, errors: &mut Errors) {
        if let Some(centers) = &mut self.centers {
            // next to a file, the drawing itself is an error
            let is_reported = self.file.is_some();
            let bodies = self.bodies.iter_mut();
            centers.extend(bodies.map(|body| match take_center(body, errors) {
                Center::Missing if is_reported => Center::Reported,
                center => center,
            }));
        }
    }
}

fn take_center(body: &mut Description, errors: &mut Errors) -> Center {
    let mut center = Center::Missing;
    for written in [&mut body.inertia, &mut body.mass].into_iter().flatten() {
        let Some(value) = &mut written.value else {
            center = Center::Reported;
            continue;
        };
        let Some((method, mut places)) = take_place(value) else {
            continue;
        };
        let message = match (&center, places.len()) {
            (Center::At(_), _) => "G is in one place: write `.at(..)` behind the inertia alone",
            (_, 1) => {
                center = places.pop().map_or(Center::Reported, Center::At);
                continue;
            }
            _ => "`.at` takes one place: write `.at((x, y, z)[m])`",
        };
        errors.push(method.span(), message);
        center = Center::Reported;
    }
    center
}

/// Removes `.at(..)` from the methods after a value, and returns its argument.
fn take_place(value: &mut Expression) -> Option<(Ident, Vec<Expression>)> {
    match &mut value.kind {
        Kind::Method(inner, method, places) if method == "at" => {
            let found = (method.clone(), std::mem::take(places));
            *value = (**inner).clone();
            Some(found)
        }
        Kind::Method(inner, ..) | Kind::Unit(inner, _) => take_place(inner),
        _ => None,
    }
}
