//! The joints of a system, as written.

use core::ops::Deref;

use proc_macro2::Ident;

use crate::errors::{Errors, hint, hint_of_joint};
use crate::lower::expressions::{JointNames, Value, missing_member, strip_unit, written_frame};
use crate::model::{Connection, Dimension, Frame, FrameWord, Holds, JointKind, Rates, Variable};
use crate::symbolic::{Components, Id};
use crate::syntax::{CABLE, Called, Definition, Expression, Kind, LINK, call};

use crate::lower::system::reading::reader::Reader;

/// A joint that is read. It is not known yet whether it carries a body or closes a loop.
pub struct ReadJoint {
    pub connection: Connection,
    /// The motion of its coordinates, if it is prescribed.
    pub driven: Option<Rates>,
    /// The inertia along its coordinate only.
    pub armature: Option<Id>,
    /// Where the name of the carried body is written.
    pub mention: proc_macro2::Span,
}

impl Deref for ReadJoint {
    type Target = Connection;

    fn deref(&self) -> &Connection {
        &self.connection
    }
}

impl ReadJoint {
    /// The prescribed acceleration along a freedom, if there is one. The freedom is given by its
    /// rate.
    pub fn given(&self, (rate, part): (Variable, usize)) -> Option<Id> {
        let acceleration = match rate {
            Variable::Velocity => Variable::LinearAcceleration,
            _ => Variable::AngularAcceleration,
        };
        let driven = self.driven.as_ref();
        driven.and_then(|rates| rates.get(acceleration, part))
    }
}

/// The error for something that is not a point.
const EXPECTED: &str =
    "expected a point of a body, such as `arm.tip`, or of the ground, `world(..)`";

/// The error for a vector in body axes without a body.
const DIRECTION: &str =
    "expected a point, such as `arm.tip` or `world(..)`, and this is a direction";

/// A point: a body, by its index, or the ground, and the offset there.
pub type End = (Option<usize>, Components);

/// The kind of joint at the start of an expression, and the methods after it.
pub fn kind_of(value: &Expression, is_planar: bool) -> Option<&'static JointKind> {
    let word = call(value)?.0.0.to_string();
    JointKind::all(is_planar)
        .iter()
        .find(|kind| kind.word == word)
}

fn unknown_kind(word: &Ident, is_planar: bool) -> String {
    if word == "rod" {
        return "a rod has no axes of its own, which joints are written in, and no inertia about its \
                line: write `free(b)` and a small moment of inertia about that line, or a `rigid_body!` \
                with `motion: rod(..)` for a rod alone"
            .to_owned();
    }
    let kinds = JointKind::all(is_planar).iter();
    let all: Vec<&str> = kinds.map(|kind| kind.word).chain([CABLE, LINK]).collect();
    let hint = hint_of_joint(&word.to_string(), &all);
    let mut elsewhere = JointKind::all(!is_planar).iter();
    let otherwise = match (elsewhere.any(|kind| word == kind.word), is_planar) {
        (false, _) => ": expected",
        (true, true) => " in the plane: leave `motion: planar` out, or write",
        (true, false) => " in space: write `motion: planar`, or",
    };
    let all = all.join("`, `");
    format!("there is no joint `{word}`{otherwise} one of `{all}`{hint}")
}

fn check_count(
    kind: &JointKind,
    word: &Ident,
    arguments: &[Expression],
    errors: &mut Errors,
) -> Option<()> {
    let expected = if kind.holds == Holds::Center {
        1
    } else {
        2 + kind.directions() + usize::from(kind.is_screw())
    };
    if arguments.len() == expected {
        return Some(());
    }
    let excess = arguments.get(expected);
    let place = excess.map_or(word.span().into(), |extra| extra.extent);
    let (form, count) = (kind.form, arguments.len());
    let s = if expected == 1 { "" } else { "s" };
    errors.push(
        place,
        format!("`{form}` takes {expected} argument{s}, and this has {count}"),
    );
    None
}

impl Reader<'_> {
    /// Reads all joints. An error in one hides no errors in others.
    pub fn joints(&mut self, errors: &mut Errors) -> Vec<Option<ReadJoint>> {
        let written: Vec<&Definition> = self.system.joints.iter().collect();
        written
            .into_iter()
            .map(|joint| self.joint(joint, errors))
            .collect()
    }

    fn joint(&mut self, joint: &Definition, errors: &mut Errors) -> Option<ReadJoint> {
        self.members.joints.push(JointNames {
            name: joint.name.to_string(),
            values: Vec::new(),
            is_known: false,
            closes: false,
        });
        let value = joint.value.as_ref()?;
        let kinds = JointKind::all(self.system.is_planar);
        let Some((called, mut methods)) = call(value) else {
            let forms = kinds[0].form;
            errors.push(
                value.extent,
                format!("a joint is a kind with its points, such as `{forms}`"),
            );
            return None;
        };
        let (word, arguments) = called;
        let Some(kind) = kind_of(value, self.system.is_planar) else {
            errors.push(word.span(), unknown_kind(word, self.system.is_planar));
            return None;
        };
        check_count(kind, word, arguments, errors)?;
        if kind.holds == Holds::Center {
            return self.joint_of_center(joint, kind, &arguments[0], &methods, errors);
        }
        let (carrier, (body, pin)) = self.joined(kind, called, &mut methods, errors)?;
        let between = (carrier.0, body);
        let turned = self.turned(between, &methods, errors);
        let before = turned.as_deref().unwrap_or_default();
        let directions = self.directions(between, kind, arguments, before, errors);
        let pitch = self.pitch(kind, arguments, errors);
        let driven = self.driven(kind, &methods, errors);
        let armature = self.armature(kind, &methods, errors);
        let (turned, driven) = (turned?, driven?);
        let connection = Connection {
            name: joint.name.clone(),
            written: value.extent.underlining(joint.name.span()),
            kind,
            carrier: carrier.0,
            carried: body,
            place: carrier.1,
            pin,
            directions: directions?,
            pitch: pitch?,
            turned,
        };
        Some(ReadJoint {
            connection,
            driven,
            armature: armature?,
            mention: first_name(&arguments[1]).unwrap_or_else(|| joint.name.span()),
        })
    }

    /// The carrier's end of a joint, and that of the carried body.
    fn joined(
        &mut self,
        kind: &JointKind,
        called: Called<'_>,
        methods: &mut Vec<Called<'_>>,
        errors: &mut Errors,
    ) -> Option<(End, (usize, Components))> {
        let (_, arguments) = called;
        let ends = if self.system.is_drawn() {
            self.drawn_ends(kind, called, methods, errors)?
        } else {
            [0, 1].map(|k| self.anchor(&arguments[k], errors))
        };
        let [Some(carrier), Some(carried)] = ends else {
            return None;
        };
        let message = match carried.0 {
            Some(body) if carrier.0 == Some(body) => {
                "a joint is between two bodies, or a body and the ground: both points are on one body"
            }
            Some(body) => return Some((carrier, (body, carried.1))),
            None => {
                "the second point of a joint is on the body that it carries, and nothing carries the ground: write `world(..)` first"
            }
        };
        errors.push(arguments[1].extent, message);
        None
    }

    /// `free(hub)`
    fn joint_of_center(
        &mut self,
        joint: &Definition,
        kind: &'static JointKind,
        body: &Expression,
        methods: &[(&Ident, &[Expression])],
        errors: &mut Errors,
    ) -> Option<ReadJoint> {
        if let Some((method, _)) = methods.first() {
            errors.push(method.span(), format!("nothing follows `{}`", kind.form));
            return None;
        }
        let named = match &body.kind {
            Kind::Name(name) => {
                let found = self
                    .members
                    .bodies
                    .iter()
                    .position(|body| *name == body.name.as_str());
                found.map(|found| (found, name))
            }
            _ => None,
        };
        let Some((carried, name)) = named else {
            let names = self.members.bodies.iter().map(|body| body.name.as_str());
            let written = first_name_of(body)
                .map(ToString::to_string)
                .unwrap_or_default();
            if self.scope.is_lost(&written) {
                return None;
            }
            let hint = hint(&written, names);
            if let (Kind::Name(name), true) = (&body.kind, hint.is_empty()) {
                return errors.undefined(name, &missing_member(name));
            }
            errors.push(
                body.extent,
                format!(
                    "expected the name of a body, as in `{}(hub)`{hint}",
                    kind.word
                ),
            );
            return None;
        };
        let zeros = self.work.graph.zeros();
        let connection = Connection {
            name: joint.name.clone(),
            written: body.extent.underlining(joint.name.span()),
            kind,
            carrier: None,
            carried,
            place: zeros,
            pin: zeros,
            directions: self.work.graph.unit_vectors().to_vec(),
            pitch: None,
            turned: Vec::new(),
        };
        Some(ReadJoint {
            connection,
            driven: None,
            armature: None,
            mention: name.span(),
        })
    }

    /// A point: a body, by its index, or the ground, and the offset there.
    pub fn anchor(&mut self, written: &Expression, errors: &mut Errors) -> Option<End> {
        if let Kind::Name(name) = &written.kind
            && let Some(body) = self
                .members
                .bodies
                .iter()
                .find(|body| *name == body.name.as_str())
        {
            let point = body.points.first().map_or("G", |(point, _)| point.as_str());
            errors.push(
                name.span(),
                format!("`{name}` is a body: write one of its points, such as `{name}.{point}`"),
            );
            return None;
        }
        let mut joints = self.members.joints.iter();
        match &strip_unit(written).kind {
            Kind::Name(name) if joints.any(|one| *name == one.name.as_str()) => {
                let message = format!("`{name}` is a joint: {EXPECTED}");
                return errors.report(name.span(), message);
            }
            Kind::Tuple(_) => return errors.report(written.extent, EXPECTED),
            _ if written_frame(written).is_some_and(|word| word == FrameWord::Body) => {
                return errors.report(written.extent, DIRECTION);
            }
            _ => {}
        }
        self.at_top(errors, |lowering| {
            let found = match lowering.value(written)? {
                Value::Carried(body, offset) => {
                    let frame = lowering.members.bodies[body].frame;
                    if !lowering.work.is_in(offset, frame) {
                        let message =
                            "expected a point that is fixed in its body, and this one moves in it";
                        return lowering.report(written.extent, message);
                    }
                    return Some((Some(body), lowering.work.part(offset, frame)));
                }
                Value::Vector(vector, dimension) if lowering.work.is_in(vector, Frame::WORLD) => {
                    Some((lowering.work.part(vector, Frame::WORLD), dimension))
                }
                _ => None,
            };
            let Some((position, dimension)) = found else {
                return lowering.report(written.extent, EXPECTED);
            };
            if !dimension.fits(Dimension::LENGTH) {
                let found = dimension.described();
                return lowering.report(
                    written.extent,
                    format!("a point is in m, and this is {found}"),
                );
            }
            lowering.check_early(written, &position, "a point of the ground is fixed")?;
            Some((None, position))
        })
    }
}

pub fn first_name_of(value: &Expression) -> Option<&Ident> {
    value.names().into_iter().next()
}

fn first_name(value: &Expression) -> Option<proc_macro2::Span> {
    first_name_of(value).map(Ident::span)
}
