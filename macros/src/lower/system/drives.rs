//! Drives of joints.

use proc_macro2::Ident;

use crate::errors::Errors;
use crate::model::{Dimension, Field, JointKind, Load, Point, TreeJoint, Variable, Vector};
use crate::symbolic::Id;
use crate::syntax::{Definition, Expression, Kind, call};

use super::between_bodies::{given, read_moment};
use super::load_methods::{behind, behind_operand, report_operand};
use super::reading::names::no_joint;
use super::reading::reader::Reader;

/// The joint and the coordinate in `elbow` or `gimbal.angle_1`.
fn joint_and_coordinate(target: &Expression) -> Option<(&Ident, Option<&Ident>)> {
    match &target.kind {
        Kind::Name(name) => Some((name, None)),
        Kind::Field(inner, word) => match &inner.kind {
            Kind::Name(name) => Some((name, Some(word))),
            _ => None,
        },
        _ => None,
    }
}

/// The same; anything that is neither is reported.
fn joint_named<'e>(
    target: &'e Expression,
    errors: &mut Errors,
) -> Option<(&'e Ident, Option<&'e Ident>)> {
    let found = joint_and_coordinate(target);
    if found.is_some() {
        return found;
    }
    errors.report(
        target.extent,
        "a drive acts on a joint, by its name, or on one of its coordinates",
    )
}

/// The coordinates of a joint on which drives can act: their words, and the fields of the state.
fn coordinates(kind: &JointKind) -> Vec<(&'static str, &'static Field)> {
    let fields = kind.shape.into_iter().flat_map(|shape| shape.fields);
    let fields = fields.filter(|field| {
        use Variable::{Angle, Position, Quaternion};
        matches!(field.variable, Position | Angle | Quaternion)
    });
    let named = fields.map(|field| {
        let (word, _) = field.path.split_once('.').unwrap_or((field.path, ""));
        (word, field)
    });
    named.collect()
}

/// The drive, if it is open, and the number of its components: as many as the rate of its
/// coordinate has, if the joint is known.
pub fn open_drive(
    drive: &Definition,
    kind_of: impl Fn(&Ident) -> Option<&'static JointKind>,
) -> Option<(&Ident, usize)> {
    let (load, targets) = behind(drive.value.as_ref()?, "on")?;
    let Kind::Placeholder = load.kind else {
        return None;
    };
    let target = targets.first().and_then(joint_and_coordinate);
    let kind = target.and_then(|(name, _)| kind_of(name));
    let word = target.and_then(|(_, word)| word);
    let fields = kind.map_or_else(Vec::new, coordinates);
    let mut known = fields.iter();
    let field = known.find(|(path, _)| word.is_none_or(|word| word == path));
    let count = field.map_or(1, |(_, field)| match field.variable {
        Variable::Quaternion => 3,
        _ => field.names.len(),
    });
    Some((&drive.name, count))
}

/// What drives along these freedoms act on: `orbit.position`, `orbit.attitude`. For a joint with
/// one coordinate, its name alone.
pub fn targets(joint: &TreeJoint, freedoms: &[usize], is_planar: bool) -> Vec<String> {
    let (name, all) = (&joint.name, joint.kind.freedoms(is_planar));
    let known = coordinates(joint.kind);
    if known.len() <= 1 {
        return vec![name.to_string()];
    }
    let with = known.iter().filter(|(_, field)| {
        let along = along(field, &all);
        freedoms.iter().any(|freedom| along.contains(freedom))
    });
    with.map(|(word, _)| format!("{name}.{word}")).collect()
}

/// The freedoms along a coordinate.
fn along(field: &Field, all: &[(Variable, usize)]) -> Vec<usize> {
    let rate = match field.variable {
        Variable::Position => Variable::Velocity,
        _ => Variable::AngularVelocity,
    };
    // a quaternion has one component more than its rate, but a freedom exists only for the rate
    let of_field = field.first..field.first + field.names.len();
    let chosen = (0..all.len()).filter(|freedom| {
        let (variable, part) = all[*freedom];
        variable == rate && of_field.contains(&part)
    });
    chosen.collect()
}

/// Reports a joint on which no drive can act.
fn check_drivable(
    joint: &TreeJoint,
    all: &[(Variable, usize)],
    (drive, target): (&Ident, &Expression),
    errors: &mut Errors,
) -> Option<()> {
    let name = &joint.name;
    if joint.is_driven() {
        let message = format!(
            "`{name}` moves as prescribed: its drive is solved for, and is a field of the \
             reactions; leave `{drive}` out"
        );
        return errors.report(target.extent, message);
    }
    if all.is_empty() {
        let place = joint_named(target, errors)?.0.span();
        let message = format!("`{name}` does not move: there is nothing to drive");
        return errors.report(place, message);
    }
    Some(())
}

/// The freedoms along which a drive acts: those of the named coordinate, or of the only one.
fn chosen(
    joint: &TreeJoint,
    all: &[(Variable, usize)],
    (drive, target): (&Ident, &Expression),
    errors: &mut Errors,
) -> Option<Vec<usize>> {
    let name = &joint.name;
    let (_, word) = joint_named(target, errors)?;
    check_drivable(joint, all, (drive, target), errors)?;
    let known = coordinates(joint.kind);
    let words: Vec<&str> = known.iter().map(|(word, _)| *word).collect();
    let Some(word) = word else {
        if words.len() <= 1 {
            return Some((0..all.len()).collect());
        }
        let words: Vec<String> = words.iter().map(|word| format!("{name}.{word}")).collect();
        let all = words.join(")` or `.on(");
        return errors.report(
            target.extent,
            format!("along which coordinate? write `.on({all})`"),
        );
    };
    let Some((_, field)) = known.into_iter().find(|(known, _)| *word == known) else {
        let all = words.join("`, `");
        return errors.report(
            word.span(),
            format!("a drive acts on a coordinate of `{name}`: `{all}`"),
        );
    };
    Some(along(field, all))
}

/// What drives act on: joints, and bodies that are free.
type Driven = (Vec<TreeJoint>, Vec<(usize, Load)>);

impl Reader<'_> {
    /// Adds the drives to the joints. The drives of a free body are loads on it, since no joint
    /// transmits them.
    pub fn drives(&mut self, joints: Vec<TreeJoint>, errors: &mut Errors) -> Option<Driven> {
        let (mut driven, mut is_sound) = ((joints, Vec::new()), true);
        for drive in &self.system.drives {
            is_sound &= self.drive(drive, &mut driven, errors).is_some();
        }
        is_sound.then_some(driven)
    }

    fn drive(
        &mut self,
        drive: &Definition,
        (joints, loads): &mut Driven,
        errors: &mut Errors,
    ) -> Option<()> {
        let value = drive.value.as_ref()?;
        if let Some(word) = behind_operand(value, &["on"]) {
            return report_operand(word, errors);
        }
        let Some((load, [target])) = behind(value, "on") else {
            let is_part = |kind: &Kind| {
                matches!(kind, Kind::Chain(first, rest)
                    if behind(first, "on").is_some()
                        || rest.iter().any(|step| behind(&step.operand, "on").is_some()))
            };
            let message = if is_part(&value.kind) {
                "`.on(..)` follows the whole load, in parentheses: write `(a - b).on(elbow)`"
            } else {
                "a drive acts on a joint: write `torque.on(elbow)`"
            };
            let place = match &value.kind {
                Kind::Method(_, word, arguments) if word != "on" && arguments.len() == 1 => {
                    word.span().into()
                }
                _ => value.extent,
            };
            return errors.report(place, message);
        };
        let (name, coordinate) = joint_named(target, errors)?;
        self.check_joint(name, errors)?;
        let place = joints.iter().position(|joint| joint.name == *name)?;
        let joint = &mut joints[place];
        let all = joint.kind.freedoms(self.system.is_planar);
        let is_open = matches!(load.kind, Kind::Placeholder);
        let chosen = chosen(joint, &all, (&drive.name, target), errors)?;
        if let Some(((word, _), _)) = call(load).filter(|((word, _), _)| *word == "moment") {
            let form = if chosen.len() == 1 {
                "torque"
            } else {
                "world(0, 0, torque)"
            };
            let of = coordinate.map_or(String::new(), |coordinate| format!(".{coordinate}"));
            let message = format!(
                "a drive is written without `moment(..)`, as in `{form}.on({name}{of})`: the coordinate says what it is"
            );
            return errors.report(word.span(), message);
        }
        if is_open {
            return self.open(drive, load, joint, &chosen, errors);
        }
        if joint.kind.is_free() {
            loads.push(self.on_free(drive, load, joint, all[chosen[0]].0, errors)?);
            return Some(());
        }
        let parts = self.load_along(load, joint, all[chosen[0]].0, chosen.len(), errors)?;
        let joint = &mut joints[place];
        for (freedom, part) in chosen.into_iter().zip(&parts) {
            joint.drives[freedom] = self.work.graph.add(joint.drives[freedom], *part);
        }
        joint.driven_by.push((drive.name.clone(), parts));
        Some(())
    }

    /// The components of a drive along coordinates of the same kind. Several components form a
    /// vector.
    fn load_along(
        &mut self,
        load: &Expression,
        joint: &TreeJoint,
        rate: Variable,
        count: usize,
        errors: &mut Errors,
    ) -> Option<Vec<Id>> {
        let (slides, turns) = (self.slides(joint), joint.frames.last().copied()?);
        self.at_top(errors, |lowering| {
            let slips = rate == Variable::Velocity;
            let (expected, what) = match (slips, count) {
                (true, 1) => (Dimension::FORCE, "the drive of a slide"),
                (true, _) => (Dimension::FORCE, "the drive of several slides"),
                (false, 1) => (Dimension::MOMENT, "the drive of a hinge"),
                (false, _) => (Dimension::MOMENT, "the drive of a ball joint"),
            };
            if count == 1 {
                return Some(vec![lowering.scalar(load, expected, what)?]);
            }
            let vector = lowering.vector(load, expected, what)?;
            if !slips {
                return Some(lowering.work.components(vector, turns).to_vec());
            }
            let (frame, directions) = slides;
            let components = lowering.work.components(vector, frame);
            let graph = &mut lowering.work.graph;
            let along = directions
                .into_iter()
                .map(|direction| graph.dot(direction, components));
            Some(along.collect())
        })
    }

    /// The drive of a free body: a force at its G, or a moment.
    fn on_free(
        &mut self,
        drive: &Definition,
        load: &Expression,
        joint: &TreeJoint,
        rate: Variable,
        errors: &mut Errors,
    ) -> Option<(usize, Load)> {
        let (body, is_planar) = (joint.carried, self.system.is_planar);
        let [force, moment] = self.at_top(errors, |lowering| {
            if rate == Variable::Velocity {
                let what = "the drive of a free body along its position";
                let force = lowering.vector(load, Dimension::FORCE, what)?;
                return Some([force, Vector::ZERO]);
            }
            let what = "the drive of a free body about its G";
            let moment = read_moment(lowering, load, is_planar, what)?;
            Some([Vector::ZERO, moment])
        })?;
        let center = Point::Fixed(self.members.bodies[body].frame, self.work.graph.zeros());
        Some((body, given(drive, force, center, moment)))
    }

    /// Whether a drive names a known joint; `None` if an error in the joint is reported.
    fn check_joint(&self, name: &Ident, errors: &mut Errors) -> Option<()> {
        let mut joints = self.members.joints.iter();
        if let Some(known) = joints.find(|joint| *name == joint.name.as_str()) {
            if known.closes {
                let message = format!(
                    "`{name}` closes a loop, and no drive acts on it: write it before the other joint of the \
                     body that it carries, which then closes the loop"
                );
                errors.push(name.span(), message);
            }
            return known.is_known.then_some(());
        }
        if self.scope.is_lost(&name.to_string()) {
            return None;
        }
        let message = if self.members.declared.contains(&name.to_string()) {
            format!("`{name}` is a body, and a drive acts on a joint")
        } else {
            no_joint(self.system, name)
        };
        errors.report(name.span(), message)
    }

    /// Leaves the load along a coordinate unknown, for inverse dynamics.
    fn open(
        &self,
        drive: &Definition,
        load: &Expression,
        joint: &mut TreeJoint,
        chosen: &[usize],
        errors: &mut Errors,
    ) -> Option<()> {
        if !self.is_inverse {
            return errors.report(
                load.extent,
                "an unknown drive is for `outputs: [inverse]`: ask for that, or write a value",
            );
        }
        for freedom in chosen {
            let open = &mut joint.open[*freedom];
            if let Some(other) = open {
                let message = format!("`{other}` is open on this coordinate already");
                return errors.report(drive.name.span(), message);
            }
            *open = Some(drive.name.clone());
        }
        Some(())
    }
}
