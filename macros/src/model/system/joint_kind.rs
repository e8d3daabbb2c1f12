//! The kinds of joints of a system, a row each.

use crate::model::joints::{BALL, CYLINDER, FREE, HINGE, PLANE, SLIDE, Shape, UNIVERSAL};

/// What a joint is made of, from the carrier to what it carries.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Part {
    /// About a direction, by its number.
    Turn(usize),
    /// Along one.
    Slide(usize),
    /// About and along the first.
    Screw,
    /// In all directions about a point.
    Ball,
    /// In all directions.
    Free,
}

/// A kind of joint.
#[derive(Debug)]
pub struct JointKind {
    /// Its word in a description.
    pub word: &'static str,
    pub parts: &'static [Part],
    /// How many directions are written.
    pub directions: usize,
    /// Of its state; nothing is known of what does not move.
    pub shape: Option<&'static Shape>,
    /// How it is written.
    pub form: &'static str,
}

const PRISMATIC: JointKind = JointKind {
    word: "prismatic",
    parts: &[Part::Slide(0)],
    directions: 1,
    shape: Some(&SLIDE),
    form: "prismatic(P, Q, direction)",
};
const WELD: JointKind = JointKind {
    word: "weld",
    parts: &[],
    directions: 0,
    shape: None,
    form: "weld(P, Q)",
};

/// All of space, in the order in which messages list them.
const JOINTS: [JointKind; 8] = [
    JointKind {
        word: "revolute",
        parts: &[Part::Turn(0)],
        directions: 1,
        shape: Some(&HINGE),
        form: "revolute(P, Q, direction)",
    },
    PRISMATIC,
    JointKind {
        word: "cylindrical",
        parts: &[Part::Slide(0), Part::Turn(0)],
        directions: 1,
        shape: Some(&CYLINDER),
        form: "cylindrical(P, Q, direction)",
    },
    JointKind {
        word: "screw",
        parts: &[Part::Screw],
        directions: 1,
        shape: Some(&HINGE),
        form: "screw(P, Q, direction, pitch)",
    },
    JointKind {
        word: "universal",
        parts: &[Part::Turn(0), Part::Turn(1)],
        directions: 2,
        shape: Some(&UNIVERSAL),
        form: "universal(P, Q, direction_1, direction_2)",
    },
    JointKind {
        word: "spherical",
        parts: &[Part::Ball],
        directions: 0,
        shape: Some(&BALL),
        form: "spherical(P, Q)",
    },
    WELD,
    JointKind {
        word: "free",
        parts: &[Part::Free],
        directions: 0,
        shape: Some(&FREE),
        form: "free(b)",
    },
];

/// Those of the plane.
const PLANE_JOINTS: [JointKind; 4] = [
    JointKind {
        word: "revolute",
        parts: &[Part::Turn(0)],
        directions: 0,
        shape: Some(&HINGE),
        form: "revolute(P, Q)",
    },
    PRISMATIC,
    WELD,
    JointKind {
        word: "free",
        parts: &[Part::Free],
        directions: 0,
        shape: Some(&PLANE),
        form: "free(b)",
    },
];

impl JointKind {
    /// Those that there are in the plane, or in space.
    pub fn all(is_planar: bool) -> &'static [Self] {
        if is_planar { &PLANE_JOINTS } else { &JOINTS }
    }

    /// It is written with the body alone.
    pub fn is_free(&self) -> bool {
        self.parts == [Part::Free]
    }

    pub fn is_screw(&self) -> bool {
        self.parts == [Part::Screw]
    }
}
