//! The motion of a system: in the plane, or in space.

use proc_macro2::{Ident, Span};

use crate::errors::{Errors, hint};
use crate::syntax::sizes::most_are;
use crate::syntax::{Description, Motion};

use super::System;

impl System {
    /// Whether the system moves in the plane.
    pub(super) fn check_motion(&mut self, errors: &mut Errors) -> bool {
        let Some(motion) = &self.top.motion else {
            return false;
        };
        if motion.word == "planar" && motion.support.is_none() {
            return true;
        }
        let hint = hint(&motion.word.to_string(), ["planar"]);
        errors.push(
            motion.word.span(),
            format!("a system moves in the plane, `motion: planar`, or in space: then leave `motion` out{hint}"),
        );
        self.misplaced.motion.clone_from(&self.top.motion);
        !hint.is_empty()
    }

    /// Whether its motion has a wrong word, which is reported.
    pub fn has_wrong_motion(&self) -> bool {
        self.misplaced.motion.is_some()
    }

    /// Where the motion is written, or would be.
    pub fn place_of_motion(&self) -> Span {
        let written = self.top.motion.as_ref().map(|motion| &motion.word);
        written.unwrap_or(&self.top.name).span()
    }

    /// Makes the system and all its bodies move in the plane, or in space.
    pub fn move_in(&mut self, is_planar: bool) {
        self.is_planar = is_planar;
        let word = if is_planar { "planar" } else { "spatial" };
        let motion = |place| {
            Some(Motion {
                word: Ident::new(word, place),
                support: None,
            })
        };
        for body in &mut self.bodies {
            body.motion = motion(body.name.span());
        }
        self.top.motion = motion(self.place_of_motion());
    }

    /// Whether most of its vectors have components in the plane, or in space.
    pub fn shows(&self, is_planar: bool) -> bool {
        let bodies = self.bodies.iter().flat_map(Description::values);
        let beside = self.joints.iter().chain(&self.forces);
        let beside = beside.filter_map(|definition| definition.value.as_ref());
        let bodies = bodies.chain(self.top.values());
        most_are(bodies.chain(beside), is_planar)
    }
}
