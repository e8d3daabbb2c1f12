//! Bodies with `mass: 0[kg]`: frames, which only mark a place.

use crate::syntax::Description;
use crate::syntax::expression::{Expression, Kind};

use super::System;

/// Units of a zero mass.
const UNITS: [&str; 2] = ["kg", "g"];

impl System {
    /// A body without inertia whose mass is written as zero is a frame.
    pub(super) fn take_frames(&mut self) {
        for body in &mut self.bodies {
            if is_frame(body) {
                body.is_frame = true;
                body.mass = None;
            }
        }
    }
}

fn is_frame(body: &Description) -> bool {
    let mass = body.mass.as_ref().and_then(|mass| mass.value.as_ref());
    mass.is_some_and(is_nothing) && body.inertia.is_none() && body.composition.is_none()
}

/// `0`, `0[kg]`
fn is_nothing(mass: &Expression) -> bool {
    match &mass.kind {
        Kind::Number(digits) => digits.parse().is_ok_and(|mass: f64| mass == 0.0),
        Kind::Unit(number, unit) => {
            let [(word, _)] = unit.factors.as_slice() else {
                return false;
            };
            UNITS.contains(&word.to_string().as_str()) && is_nothing(number)
        }
        _ => false,
    }
}
