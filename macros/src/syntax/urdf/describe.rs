//! The content of a file as a written description.

use proc_macro2::{Ident, Span, TokenStream};
use quote::format_ident;

use crate::errors::{Errors, Extent};
use crate::syntax::expression::{Expression, Kind, Operator, Step};
use crate::syntax::{Definition, Description, Written};

use super::robot::{Inertial, Joint, Link, Motion, Placed, Robot, Substance};
use super::tree::Welded;
use crate::syntax::xml::decimal::{Angle, Decimal};
use crate::syntax::xml::names::ORIGIN;
use crate::syntax::xml::{Beside, Told};

/// Writes expressions. Errors in any of their words underline the string that names the file.
struct Writer {
    span: Span,
}

impl Writer {
    fn word(&self, word: &str) -> Ident {
        Ident::new(word, self.span)
    }

    fn call(&self, word: &str, arguments: Vec<Expression>, extent: Extent) -> Expression {
        Expression {
            kind: Kind::Call(self.word(word), arguments),
            extent,
        }
    }

    fn method(&self, receiver: Expression, word: &str, arguments: Vec<Expression>) -> Expression {
        Expression {
            extent: receiver.extent,
            kind: Kind::Method(Box::new(receiver), self.word(word), arguments),
        }
    }

    /// `body(1, 0, 0)`
    fn unit(&self, axis: usize, extent: Extent) -> Expression {
        let part = |other: usize| {
            let one = if other == axis {
                Decimal::one(extent)
            } else {
                Decimal::zero(extent)
            };
            one.expression()
        };
        self.call("body", vec![part(0), part(1), part(2)], extent)
    }

    fn vector(&self, word: &str, components: &[Decimal; 3], extent: Extent) -> Expression {
        let parts = components.iter().map(Decimal::expression);
        self.call(word, parts.collect(), extent)
    }

    /// `.turned(axis, angle)` for each of the rotations.
    fn turned<'a>(
        &self,
        of: Expression,
        turns: impl Iterator<Item = &'a (usize, Angle)>,
        extent: Extent,
    ) -> Expression {
        turns.fold(of, |of, (axis, angle)| {
            let arguments = vec![self.unit(*axis, extent), angle.expression()];
            self.method(of, "turned", arguments)
        })
    }

    /// The inertia about G, in the axes of the link.
    fn inertia(&self, substance: &Substance) -> Expression {
        let words = ["xx", "yy", "zz", "xy", "yz", "zx"];
        let entries = words.iter().zip(&substance.entries);
        let entries = entries.map(|(word, entry)| (self.word(word), entry.expression()));
        let tensor = Expression {
            kind: Kind::Record(self.word("tensor"), entries.collect()),
            extent: substance.extent,
        };
        // rotating a body applies the rotations in the reverse order
        let turns = substance.center.turns.iter().rev();
        self.turned(tensor, turns, substance.center.extent)
    }

    fn joint(&self, joint: &Joint, carrier: Option<&Ident>, carried: &Ident) -> Expression {
        let extent = joint.extent;
        if joint.kind == Motion::Free {
            let body = Expression {
                kind: Kind::Name(carried.clone()),
                extent,
            };
            return self.call("free", vec![body], extent);
        }
        let place = match carrier {
            Some(carrier) => point(carrier, &joint.ident, joint.origin.extent),
            None => self.vector("world", &joint.origin.place, joint.origin.extent),
        };
        let slides = joint.kind == Motion::Slides && joint.locked.is_some();
        let pin = if slides {
            joint.ident.clone()
        } else {
            self.word(ORIGIN)
        };
        let mut arguments = vec![place, point(carried, &pin, extent)];
        let axis = || self.vector("body", &joint.axis.components, joint.axis.extent);
        let word = match joint.kind {
            _ if joint.is_rigid() => "weld",
            Motion::Turns => "revolute",
            Motion::Slides => "prismatic",
            _ => "planar",
        };
        if word != "weld" {
            arguments.push(axis());
        }
        let written = self.call(word, arguments, extent);
        let turns = joint.origin.turns.iter();
        let written = self.turned(written, turns, joint.origin.extent);
        match (&joint.locked, joint.kind) {
            (Some(angle), Motion::Turns) => {
                self.method(written, "turned", vec![axis(), angle.clone()])
            }
            _ => written,
        }
    }

    /// The point of the carried body that a locked slide holds at the place of the joint.
    fn slid(&self, joint: &Joint, distance: &Expression) -> Definition {
        let axis = self.vector("body", &joint.axis.components, joint.axis.extent);
        let axis = self.method(axis, "normalize", Vec::new());
        let extent = distance.extent;
        let step = chain(distance.clone(), Operator::Multiply, axis, extent);
        let origin = Expression {
            kind: Kind::Name(self.word(ORIGIN)),
            extent,
        };
        Definition {
            name: joint.ident.clone(),
            value: Some(chain(origin, Operator::Subtract, step, extent)),
        }
    }
}

/// `body.point`
fn point(body: &Ident, point: &Ident, extent: Extent) -> Expression {
    let body = Expression {
        kind: Kind::Name(body.clone()),
        extent,
    };
    Expression {
        kind: Kind::Field(Box::new(body), point.clone()),
        extent,
    }
}

fn chain(first: Expression, operator: Operator, operand: Expression, extent: Extent) -> Expression {
    let step = Step {
        operator,
        place: extent,
        operand,
    };
    Expression {
        kind: Kind::Chain(Box::new(first), vec![step]),
        extent,
    }
}

/// `place - center`: a point of a body, measured from its G.
fn from_center(place: &[Decimal; 3], center: Option<&Placed>, extent: Extent) -> Expression {
    let parts = [0, 1, 2].map(|axis| {
        let place = &place[axis];
        match center.map(|center| &center.place[axis]) {
            Some(center) if !center.is_zero() && place.is_zero() => center.negated().expression(),
            Some(center) if !center.is_zero() => {
                let (operator, distance) = if center.is_negative() {
                    (Operator::Add, center.negated())
                } else {
                    (Operator::Subtract, center.clone())
                };
                chain(place.expression(), operator, distance.expression(), extent)
            }
            _ => place.expression(),
        }
    });
    Expression {
        kind: Kind::Tuple(parts.into()),
        extent,
    }
}

impl Beside<'_> {
    /// Writes bodies for the links and definitions for the joints.
    pub fn describe(
        self,
        robot: &Robot,
        file: (&str, Span),
        told: &mut Told,
        errors: &mut Errors,
    ) -> Option<(Vec<Description>, Vec<Definition>)> {
        let (root, carried) = robot.tree(file, errors)?;
        let writer = Writer { span: file.1 };
        let written = self.is_carried(&robot.links[root].ident);
        let root_moves = written == Some(Welded::No);
        robot.check_masses(&carried, (root, root_moves), &self.massive(robot), errors);
        robot.check_floating(&carried, root_moves, errors);
        // a root without mass is the ground, and no body, unless the description carries it
        let link = &robot.links[root];
        let is_absent = matches!(link.inertial, Inertial::Absent) && !self.gives_mass(&link.ident);
        let is_ground = is_absent && written.is_none();
        let mut joints = Vec::new();
        for joint in &robot.joints {
            let is_root = is_ground && joint.parent == root;
            let carrier = (!is_root).then(|| &robot.links[joint.parent].ident);
            let value = writer.joint(joint, carrier, &robot.links[joint.child].ident);
            joints.push(Definition {
                name: joint.ident.clone(),
                value: Some(value),
            });
        }
        if written.is_none() {
            let (name, ident) = (&link.name, &link.ident);
            told.read_as.push(if is_ground {
                format!("link `{name}` is the ground")
            } else {
                joints.push(writer.to_ground(link));
                format!(
                    "link `{name}` is fixed to the ground: `joints: [root = free({ident})]` lets it move"
                )
            });
        }
        let links = (0..robot.links.len()).filter(|number| !(is_ground && *number == root));
        let bodies = links.map(|number| writer.body(self.runtime, number, robot));
        Some((bodies.collect(), joints))
    }
}

impl Writer {
    /// A weld of the root to the ground.
    fn to_ground(&self, link: &Link) -> Definition {
        let zeros = [0, 1, 2].map(|_| Decimal::zero(link.extent));
        let ground = self.vector("world", &zeros, link.extent);
        let origin = point(&link.ident, &self.word(ORIGIN), link.extent);
        let value = self.call("weld", vec![ground, origin], link.extent);
        Definition {
            name: format_ident!("{}_to_ground", link.ident, span = self.span),
            value: Some(value),
        }
    }

    /// A link as a body: its origin and those of the joints on it are points.
    fn body(&self, runtime: &TokenStream, number: usize, robot: &Robot) -> Description {
        let link = &robot.links[number];
        let mut body = Description::new(link.ident.clone(), runtime.clone());
        let center = match &link.inertial {
            Inertial::Known(substance) => Some(&substance.center),
            Inertial::Absent | Inertial::Reported => None,
        };
        match &link.inertial {
            Inertial::Absent => body.is_frame = true,
            Inertial::Reported => {
                body.mass = Some(Written { value: None });
                body.inertia = Some(Written { value: None });
            }
            Inertial::Known(substance) => {
                body.mass = Some(Written {
                    value: Some(substance.mass.expression()),
                });
                body.inertia = Some(Written {
                    value: Some(self.inertia(substance)),
                });
            }
        }
        let zeros = [0, 1, 2].map(|_| Decimal::zero(link.extent));
        body.points.push(Definition {
            name: self.word(ORIGIN),
            value: Some(from_center(&zeros, center, link.extent)),
        });
        for joint in &robot.joints {
            if joint.parent == number {
                body.points.push(Definition {
                    name: joint.ident.clone(),
                    value: Some(from_center(
                        &joint.origin.place,
                        center,
                        joint.origin.extent,
                    )),
                });
            }
            if joint.child == number
                && joint.kind == Motion::Slides
                && let Some(distance) = &joint.locked
            {
                body.points.push(self.slid(joint, distance));
            }
        }
        body.given = body
            .points
            .iter()
            .map(|point| point.name.to_string())
            .collect();
        body
    }
}
