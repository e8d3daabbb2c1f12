//! The kinds of joints of a system, one row each.

use crate::model::joints::{
    BALL, CYLINDER, FIXED_AXIS, FIXED_POINT, FREE, HINGE, Motion, PIVOT, PLANAR,
    PLANAR_TRANSLATION, PLANE, ROTATION, SHIFT, SHIFT_IN_THE_PLANE, SLIDE, SPATIAL, Shape,
    TRANSLATION, UNIVERSAL,
};
use crate::model::words::Variable;

/// The parts of a joint, from the carrier to the carried body.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Part {
    /// Rotation about the direction with this index.
    Turn(usize),
    /// Translation along the direction with this index.
    Slide(usize),
    /// Rotation about the first direction, and translation along it.
    Screw,
    /// Rotation in all directions about a point.
    Ball,
    /// Translation in all directions.
    Free,
}

/// The directions of a joint.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Axes {
    /// This many directions are written.
    Written(usize),
    /// One is written, and two are perpendicular to it.
    Normal,
    /// One is written, and one is the normal of the plane.
    InThePlane,
    /// None is written: they are the coordinate axes.
    Own,
}

/// What the arguments of a joint name.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Holds {
    /// A point of the carrier and one of the carried body.
    Points,
    /// Only a body, which moves relative to the ground: the coordinates of its G are from the
    /// origin of the world.
    Center,
}

/// A kind of joint.
#[derive(Debug)]
pub struct JointKind {
    /// Its word in a description.
    pub word: &'static str,
    pub holds: Holds,
    pub axes: Axes,
    pub parts: &'static [Part],
    /// The shape of its state; `None` if it does not move.
    pub shape: Option<&'static Shape>,
    /// How its arguments are written.
    pub form: &'static str,
}

const PRISMATIC: JointKind = JointKind {
    word: "prismatic",
    holds: Holds::Points,
    axes: Axes::Written(1),
    parts: &[Part::Slide(0)],
    shape: Some(&SLIDE),
    form: "prismatic(P, Q, direction)",
};
const WELD: JointKind = JointKind {
    word: "weld",
    holds: Holds::Points,
    axes: Axes::Own,
    parts: &[],
    shape: None,
    form: "weld(P, Q)",
};

/// All kinds in space, in the order in which messages list them.
const JOINTS: [JointKind; 11] = [
    JointKind {
        word: "revolute",
        holds: Holds::Points,
        axes: Axes::Written(1),
        parts: &[Part::Turn(0)],
        shape: Some(&HINGE),
        form: "revolute(P, Q, direction)",
    },
    PRISMATIC,
    JointKind {
        word: "cylindrical",
        holds: Holds::Points,
        axes: Axes::Written(1),
        parts: &[Part::Slide(0), Part::Turn(0)],
        shape: Some(&CYLINDER),
        form: "cylindrical(P, Q, direction)",
    },
    JointKind {
        word: "screw",
        holds: Holds::Points,
        axes: Axes::Written(1),
        parts: &[Part::Screw],
        shape: Some(&HINGE),
        form: "screw(P, Q, direction, pitch)",
    },
    JointKind {
        word: "universal",
        holds: Holds::Points,
        axes: Axes::Written(2),
        parts: &[Part::Turn(0), Part::Turn(1)],
        shape: Some(&UNIVERSAL),
        form: "universal(P, Q, direction_1, direction_2)",
    },
    JointKind {
        word: "spherical",
        holds: Holds::Points,
        axes: Axes::Own,
        parts: &[Part::Ball],
        shape: Some(&BALL),
        form: "spherical(P, Q)",
    },
    JointKind {
        word: "planar",
        holds: Holds::Points,
        axes: Axes::Normal,
        parts: &[Part::Slide(1), Part::Slide(2), Part::Turn(0)],
        shape: Some(&PLANE),
        form: "planar(P, Q, normal)",
    },
    WELD,
    JointKind {
        word: "free",
        holds: Holds::Center,
        axes: Axes::Own,
        parts: &[Part::Free],
        shape: Some(&FREE),
        form: "free(b)",
    },
    JointKind {
        word: "rotation",
        holds: Holds::Center,
        axes: Axes::Own,
        parts: &[Part::Ball],
        shape: Some(&BALL),
        form: "rotation(b)",
    },
    JointKind {
        word: "translation",
        holds: Holds::Center,
        axes: Axes::Own,
        parts: &[Part::Slide(0), Part::Slide(1), Part::Slide(2)],
        shape: Some(&SHIFT),
        form: "translation(b)",
    },
];

const fn translation_in_the_plane(word: &'static str, form: &'static str) -> JointKind {
    JointKind {
        word,
        holds: Holds::Center,
        axes: Axes::Own,
        parts: &[Part::Slide(0), Part::Slide(1)],
        shape: Some(&SHIFT_IN_THE_PLANE),
        form,
    }
}

/// The kinds in the plane.
const PLANE_JOINTS: [JointKind; 7] = [
    JointKind {
        word: "revolute",
        holds: Holds::Points,
        axes: Axes::Own,
        parts: &[Part::Turn(2)],
        shape: Some(&HINGE),
        form: "revolute(P, Q)",
    },
    PRISMATIC,
    JointKind {
        word: "pin_in_slot",
        holds: Holds::Points,
        axes: Axes::InThePlane,
        parts: &[Part::Slide(0), Part::Turn(1)],
        shape: Some(&CYLINDER),
        form: "pin_in_slot(P, Q, direction)",
    },
    WELD,
    JointKind {
        word: "free",
        holds: Holds::Center,
        axes: Axes::Own,
        parts: &[Part::Free],
        shape: Some(&PLANE),
        form: "free(b)",
    },
    translation_in_the_plane("translation", "translation(b)"),
    // the same words as for the `motion` of a single body
    translation_in_the_plane("planar_translation", "planar_translation(b)"),
];

impl JointKind {
    /// The kinds in the plane, or in space.
    pub fn all(is_planar: bool) -> &'static [Self] {
        if is_planar { &PLANE_JOINTS } else { &JOINTS }
    }

    pub fn is_free(&self) -> bool {
        self.parts == [Part::Free]
    }

    /// Whether its state in space contains the attitude of the carried body relative to the ground.
    pub fn has_attitude(&self) -> bool {
        self.holds == Holds::Center && matches!(self.parts, [Part::Free | Part::Ball])
    }

    /// Whether the carried body rotates relative to its carrier.
    pub fn turns(&self) -> bool {
        let mut parts = self.parts.iter();
        parts.any(|part| !matches!(part, Part::Slide(_)))
    }

    /// Whether it is a rotation about one axis and nothing else.
    pub fn is_hinge(&self) -> bool {
        matches!(self.parts, [Part::Turn(_)])
    }

    /// The kind of motion that it gives a single body on the ground, if there is one.
    pub fn motion(&self, is_planar: bool) -> Option<Motion> {
        let motion: Motion = match (self.holds, self.parts, is_planar) {
            (_, [Part::Free], true) => &PLANAR,
            (_, [Part::Free], false) => &SPATIAL,
            (Holds::Center, [Part::Ball], _) => &ROTATION,
            (Holds::Center, _, true) => &PLANAR_TRANSLATION,
            (Holds::Center, _, false) => &TRANSLATION,
            (_, [Part::Ball], _) => &FIXED_POINT,
            (_, [Part::Turn(_)], true) => &PIVOT,
            (_, [Part::Turn(_)], false) => &FIXED_AXIS,
            _ => return None,
        };
        Some(motion)
    }

    pub fn is_screw(&self) -> bool {
        self.parts == [Part::Screw]
    }

    /// The number of written directions.
    pub fn directions(&self) -> usize {
        match self.axes {
            Axes::Written(count) => count,
            Axes::Normal | Axes::InThePlane => 1,
            Axes::Own => 0,
        }
    }

    /// Its parts, each with the index of its coordinate among those of the same kind.
    pub fn numbered(&self) -> impl Iterator<Item = (Part, usize)> {
        let (mut turns, mut slides) = (0, 0);
        self.parts.iter().map(move |part| {
            let next = match part {
                Part::Slide(_) => &mut slides,
                Part::Turn(_) | Part::Screw | Part::Ball | Part::Free => &mut turns,
            };
            *next += 1;
            (*part, *next - 1)
        })
    }

    /// The rates of its coordinates, in the order in which mechanics uses them.
    pub fn freedoms(&self, is_planar: bool) -> Vec<(Variable, usize)> {
        let mut freedoms = Vec::new();
        let (along, about) = (Variable::Velocity, Variable::AngularVelocity);
        for (part, number) in self.numbered() {
            match part {
                Part::Turn(_) | Part::Screw => freedoms.push((about, number)),
                Part::Slide(_) => freedoms.push((along, number)),
                Part::Ball => freedoms.extend((0..3).map(|axis| (about, axis))),
                Part::Free if is_planar => freedoms.extend([(along, 0), (along, 1), (about, 0)]),
                Part::Free => {
                    let both = [along, about].into_iter();
                    freedoms.extend(both.flat_map(|rate| (0..3).map(move |axis| (rate, axis))));
                }
            }
        }
        freedoms
    }
}
