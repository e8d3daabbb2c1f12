//! Links and joints of a file.

use proc_macro2::Ident;
use roxmltree::Node;

use crate::errors::{Extent, hint_of_joint};
use crate::syntax::expression::Expression;

use crate::syntax::xml::decimal::{Angle, Decimal};
use crate::syntax::xml::reader::Reader;

use super::mimic::Mimic;

/// The content of a file, as far as it could be read.
#[derive(Default)]
pub struct Robot {
    pub links: Vec<Link>,
    pub joints: Vec<Joint>,
    /// Whether a part could not be read, which is reported.
    pub is_lost: bool,
    /// Names of links that could not be taken over, which is reported.
    pub lost: Vec<String>,
    pub notes: Notes,
}

/// What a user should know about how a file was read.
#[derive(Default)]
pub struct Notes {
    /// Right angles that are written as decimals.
    pub right_angles: Vec<String>,
    /// The numbers of joints with damping or friction, and with limits.
    pub damped: usize,
    pub limited: usize,
}

pub struct Link {
    pub name: String,
    pub ident: Ident,
    pub inertial: Inertial,
    pub extent: Extent,
}

/// The mass properties of a link.
pub enum Inertial {
    /// There are none: it is a frame.
    Absent,
    /// They have an error, which is reported.
    Reported,
    Known(Box<Substance>),
}

pub struct Substance {
    pub center: Placed,
    pub mass: Decimal,
    /// The entries xx, yy, zz, xy, yz, zx of the inertia.
    pub entries: [Decimal; 6],
    /// The place of the inertia in the file.
    pub extent: Extent,
}

/// `<origin>`: a place, and rotations about z, y and x in sequence.
pub struct Placed {
    pub place: [Decimal; 3],
    pub turns: Vec<(usize, Angle)>,
    pub extent: Extent,
}

pub struct Joint {
    pub name: String,
    pub ident: Ident,
    pub kind: Motion,
    /// Indices of the links that it connects.
    pub parent: usize,
    pub child: usize,
    pub origin: Placed,
    pub axis: Axis,
    /// The joint that it follows.
    pub mimic: Option<Mimic>,
    pub locked: Option<Expression>,
    pub extent: Extent,
}

/// The axis of a joint, in the axes of the child.
pub struct Axis {
    pub components: [Decimal; 3],
    pub extent: Extent,
}

/// The kind of motion of a joint.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Motion {
    Fixed,
    Turns,
    Slides,
    Plane,
    Free,
}

const MOTIONS: [(&str, Motion); 6] = [
    ("revolute", Motion::Turns),
    ("continuous", Motion::Turns),
    ("prismatic", Motion::Slides),
    ("fixed", Motion::Fixed),
    ("floating", Motion::Free),
    ("planar", Motion::Plane),
];
const INERTIA: [&str; 6] = ["ixx", "iyy", "izz", "ixy", "iyz", "ixz"];
const ANGLES: [&str; 3] = ["roll", "pitch", "yaw"];

impl Reader<'_> {
    /// `<link name="..">`
    pub fn link(&mut self, node: Node<'_, '_>, ident: Ident, name: &str, robot: &mut Robot) {
        self.owner = format!(" of link `{name}`");
        let children = self.children(node, &["inertial", "visual", "collision"], &[]);
        for tag in ["visual", "collision"] {
            if children.iter().any(|child| child.tag_name().name() == tag) {
                self.skip(tag);
            }
        }
        let inertial = match self.one(&children, "inertial") {
            None => Inertial::Absent,
            Some(node) => self
                .substance(node, &mut robot.notes)
                .map_or(Inertial::Reported, |found| {
                    found.map_or(Inertial::Absent, |found| Inertial::Known(Box::new(found)))
                }),
        };
        let extent = self.at(node);
        robot.links.push(Link {
            name: name.to_owned(),
            ident,
            inertial,
            extent,
        });
    }

    /// `<inertial>`. The inner `None` stands for a link without mass and inertia.
    #[allow(clippy::option_option, reason = "outer: reported; inner: nothing")]
    fn substance(&mut self, node: Node<'_, '_>, notes: &mut Notes) -> Option<Option<Substance>> {
        let children = self.children(node, &["origin", "mass", "inertia"], &[]);
        let [origin, mass, inertia] =
            ["origin", "mass", "inertia"].map(|name| self.one(&children, name));
        let center = self.placed(origin.unwrap_or(node), origin.is_some(), notes);
        let mut missing = |found: Option<_>, tag: &str| {
            if found.is_none() {
                self.report::<()>(node, format!("it has no `<{tag}>`"));
            }
            found
        };
        let (mass, inertia) = (missing(mass, "mass"), missing(inertia, "inertia"));
        let mass = mass.and_then(|mass| {
            self.check_attributes(mass, &["value"]);
            self.number(mass, "value")
        });
        let entries = inertia.and_then(|inertia| {
            self.check_attributes(inertia, &INERTIA);
            let all = INERTIA.map(|name| self.number(inertia, name));
            let all: Vec<Decimal> = all.into_iter().collect::<Option<_>>()?;
            let extent = self.at(inertia);
            Some((<[Decimal; 6]>::try_from(all).ok()?, extent))
        });
        let (center, mass, (entries, extent)) = (center?, mass?, entries?);
        if mass.is_zero() && entries.iter().all(Decimal::is_zero) {
            return Some(None);
        }
        Some(Some(Substance {
            center,
            mass,
            entries,
            extent,
        }))
    }

    /// `<origin xyz=".." rpy="..">`, or zero if it is missing: then `node` is the element that
    /// lacks it.
    fn placed(&mut self, node: Node<'_, '_>, is_there: bool, notes: &mut Notes) -> Option<Placed> {
        let extent = self.at(node);
        if !is_there {
            return Some(Placed {
                place: [0, 1, 2].map(|_| Decimal::zero(extent)),
                turns: Vec::new(),
                extent,
            });
        }
        self.check_attributes(node, &["xyz", "rpy"]);
        let (place, angles) = (self.three(node, "xyz"), self.three(node, "rpy"));
        let (place, angles) = (place?, angles?);
        let mut turns = Vec::new();
        for axis in [2, 1, 0] {
            let Some(angle) = angles[axis].angle() else {
                continue;
            };
            if let Angle::Right(count, written) = &angle {
                let (file, line, owner) = (self.file, self.line(node), &self.owner);
                notes.right_angles.push(format!(
                    "{file}:{line}{owner}: {} {} is {} degrees",
                    ANGLES[axis],
                    written.text(),
                    count * 90
                ));
            }
            if !matches!(angle, Angle::Right(0, _)) {
                turns.push((axis, angle));
            }
        }
        Some(Placed {
            place,
            turns,
            extent,
        })
    }

    /// `<joint name=".." type="..">`
    pub fn joint(
        &mut self,
        node: Node<'_, '_>,
        (ident, name): (Ident, &str),
        locked: Option<Expression>,
        robot: &mut Robot,
    ) -> Option<Joint> {
        self.owner = format!(" of joint `{name}`");
        let known = [
            "origin", "parent", "child", "axis", "mimic", "limit", "dynamics",
        ];
        let skipped = ["calibration", "safety_controller"];
        let children = self.children(node, &known, &skipped);
        let [origin, parent, child, axis, mimic, limit, dynamics] =
            known.map(|name| self.one(&children, name));
        let kind = self.kind(node);
        let origin = self.placed(origin.unwrap_or(node), origin.is_some(), &mut robot.notes);
        let [parent, child] = [(parent, "parent"), (child, "child")]
            .map(|(found, tag)| self.end(node, found, tag, robot));
        let axis = self.axis(node, axis, kind);
        let moves = kind.is_some_and(|kind| kind != Motion::Fixed) && locked.is_none();
        let mimic = match mimic.filter(|_| moves) {
            Some(node) => Some(self.mimic(node)?),
            None => None,
        };
        robot.notes.limited += usize::from(moves && limit.is_some());
        robot.notes.damped += usize::from(moves && dynamics.is_some_and(is_damped));
        if let (Some(parent), Some(child)) = (parent, child)
            && parent == child
        {
            self.report::<()>(node, "its parent and its child are one link");
            return None;
        }
        Some(Joint {
            name: name.to_owned(),
            ident,
            kind: kind?,
            parent: parent?,
            child: child?,
            origin: origin?,
            axis: axis?,
            mimic,
            locked,
            extent: self.at(node),
        })
    }

    fn kind(&mut self, node: Node<'_, '_>) -> Option<Motion> {
        let word = self.attribute(node, "type")?;
        let found = MOTIONS.iter().find(|(known, _)| *known == word);
        if found.is_none() {
            let all = MOTIONS.map(|(known, _)| known);
            let hint = hint_of_joint(word, &all);
            let all = all.join("`, `");
            self.report::<()>(
                node,
                format!("there is no type `{word}`: expected one of `{all}`{hint}"),
            );
        }
        found.map(|(_, motion)| *motion)
    }

    /// `<parent link="..">` or `<child link="..">`
    fn end(
        &mut self,
        joint: Node<'_, '_>,
        found: Option<Node<'_, '_>>,
        tag: &str,
        robot: &Robot,
    ) -> Option<usize> {
        let Some(node) = found else {
            return self.report(joint, format!("it has no `<{tag}>`"));
        };
        self.check_attributes(node, &["link"]);
        let name = self.attribute(node, "link")?;
        let place = robot.links.iter().position(|link| link.name == name);
        if place.is_none() && !robot.lost.iter().any(|lost| lost == name) {
            let names = robot.links.iter().map(|link| link.name.as_str());
            self.no_such::<()>(node, ("link", name), names);
        }
        place
    }

    /// `<axis xyz="..">`; the x axis if it is missing.
    fn axis(
        &mut self,
        joint: Node<'_, '_>,
        found: Option<Node<'_, '_>>,
        kind: Option<Motion>,
    ) -> Option<Axis> {
        let extent = self.at(found.unwrap_or(joint));
        let (zero, one) = (Decimal::zero(extent), Decimal::one(extent));
        let components = match found {
            None => [one, zero.clone(), zero],
            Some(node) => {
                self.check_attributes(node, &["xyz"]);
                self.attribute(node, "xyz")?;
                self.three(node, "xyz")?
            }
        };
        let has_axis = matches!(kind, Some(Motion::Turns | Motion::Slides | Motion::Plane));
        if let Some(node) = found
            && has_axis
            && components.iter().all(Decimal::is_zero)
        {
            return self.report(node, "the zero vector has no direction");
        }
        Some(Axis { components, extent })
    }
}

/// Whether `<dynamics>` sets damping or friction.
fn is_damped(node: Node<'_, '_>) -> bool {
    let says = |name| {
        let value: Option<&str> = node.attribute(name);
        value.is_some_and(|value| value.trim().parse().is_ok_and(|value: f64| value != 0.0))
    };
    says("damping") || says("friction")
}
