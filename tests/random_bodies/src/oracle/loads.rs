//! Each load separately: its force, its moment about G and about the held point, its potential.

use crate::description::body::{Input, Key, Load, Local, Param, What};
use crate::description::expression::{Axes, Condition, Place, Scalar, Vector as Written};

use super::arithmetic::Values;
use super::inertia::sum;
use super::number::Number;
use super::scene::Scene;
use super::vector::Vector;

#[derive(Clone, Copy)]
pub struct Wrench {
    pub force: Vector,
    pub about_center: Vector,
    pub about_held: Vector,
}

/// A load in a state.
pub struct Acting {
    pub wrench: Wrench,
    /// From the world's origin, where the load has a point of its own.
    pub point: Option<Vector>,
    /// What it adds to the potential energy.
    pub energy: Number,
}

impl Wrench {
    pub const ZERO: Self = Self {
        force: Vector::ZERO,
        about_center: Vector::ZERO,
        about_held: Vector::ZERO,
    };

    /// A force at a place.
    pub fn of_force(scene: &Scene<'_>, force: Vector, place: &Place) -> Self {
        Self {
            force,
            about_center: scene.arm(place).cross(force),
            about_held: scene.arm_from_held(place).cross(force),
        }
    }

    pub fn couple(moment: Vector) -> Self {
        Self {
            force: Vector::ZERO,
            about_center: moment,
            about_held: moment,
        }
    }

    /// That of a potential: its moment is derived about the point that is held, if there is one, and moved to G.
    pub fn derived(self, scene: &Scene<'_>) -> Self {
        let carried = scene.arm_from_held(&Place::Center).size * self.force.size;
        let size = self.about_center.size.max(carried);
        Self {
            about_center: Vector {
                size,
                ..self.about_center
            },
            ..self
        }
    }

    pub fn and(self, other: Self) -> Self {
        Self {
            force: self.force + other.force,
            about_center: self.about_center + other.about_center,
            about_held: self.about_held + other.about_held,
        }
    }
}

/// The load, if it is given; of one that is known in part, `None`.
pub fn acting(scene: &Scene<'_>, load: &Load) -> Option<Acting> {
    let couple = |moment: Vector| Acting {
        wrench: Wrench::couple(moment),
        point: None,
        energy: Number::ZERO,
    };
    let acting = match &load.what {
        What::Force(vector, place) => {
            let force = scene.vector(vector);
            let wrench = Wrench::of_force(scene, force, place);
            let energy = if load.key == Key::Fields && is_uniform(scene, vector, place) {
                -force.dot(scene.position(place))
            } else {
                Number::ZERO
            };
            Acting {
                wrench,
                point: Some(scene.position(place)),
                energy,
            }
        }
        What::Moment(vector) => couple(scene.vector(vector)),
        What::PlaneMoment(scalar) => couple(Vector::normal(scene.scalar(scalar))),
        What::Charges(field, charges) => {
            let field = scene.vector(field);
            let each = charges.iter().map(|(charge, place)| {
                let force = field.scaled(scene.scalar(charge));
                let of_charge = Wrench::of_force(scene, force, place);
                (of_charge, -force.dot(scene.position(place)))
            });
            let each: Vec<(Wrench, Number)> = each.collect();
            let wrench = each
                .iter()
                .fold(Wrench::ZERO, |all, (one, _)| all.and(*one));
            Acting {
                wrench: wrench.derived(scene),
                point: None,
                energy: sum(each.iter().map(|(_, energy)| *energy)),
            }
        }
        What::Potential(potential) => scene.potential(potential),
        What::OpenForce(..) | What::OpenMoment(..) | What::OpenAlong(..) => return None,
    };
    Some(acting)
}

/// The same in world axes for every state, on a point of the body.
pub fn is_uniform(scene: &Scene<'_>, vector: &Written, place: &Place) -> bool {
    let body = scene.constants.body;
    let is_on_body = match place {
        Place::Center => true,
        Place::Named(i) => body.points[*i].axes == Axes::Body,
        Place::Shifted(..) => false,
    };
    is_on_body && is_fixed(scene, Axes::World, vector)
}

/// Whether the components in these axes are the same for every state.
fn is_fixed(scene: &Scene<'_>, axes: Axes, vector: &Written) -> bool {
    let body = scene.constants.body;
    let are = |own: Axes| own == axes || !body.motion.turns();
    let fixed = |a: &Written| is_fixed(scene, axes, a);
    let held = body.motion.support().map(|support| support.point);
    match vector {
        Written::Written(own, components) => {
            are(*own) && components.iter().all(|one| is_constant(scene, one))
        }
        Written::Param(i) => matches!(body.params[*i], Param::Vector(own, _) if are(own)),
        Written::Input(i) => matches!(body.inputs[*i], Input::Vector(own) if are(own)),
        Written::Local(i) => match &body.locals[*i] {
            Local::Vector(vector) => fixed(vector),
            Local::Scalar(_) => false,
        },
        Written::Cross(a, b) => is_parallel(scene, a, b) || fixed(a) && fixed(b),
        Written::Sum(a, b) | Written::Difference(a, b) => fixed(a) && fixed(b),
        Written::Negative(a) | Written::Normalized(a) => fixed(a),
        // nothing, and where the body is held
        Written::Scaled(zero, _) if zero.is_zero() => true,
        Written::PointVelocity(Place::Named(i)) => held == Some(*i),
        Written::PointPosition(Place::Named(i)) => {
            are(Axes::World) && (held == Some(*i) || body.points[*i].axes == Axes::World)
        }
        Written::Scaled(s, a) | Written::Over(a, s) | Written::Turned(s, a) => {
            is_constant(scene, s) && fixed(a)
        }
        Written::If(condition, a, b) => is_decided(scene, condition) && fixed(a) && fixed(b),
        _ => false,
    }
}

/// Whether it is the same for every state.
fn is_constant(scene: &Scene<'_>, scalar: &Scalar) -> bool {
    let constant = |a: &Scalar| is_constant(scene, a);
    let fixed = |vectors: &[&Written]| {
        let in_axes = |axes: Axes| vectors.iter().all(|vector| is_fixed(scene, axes, vector));
        in_axes(Axes::World) || in_axes(Axes::Body)
    };
    match scalar {
        Scalar::Literal(_)
        | Scalar::Param(_)
        | Scalar::Input(_)
        | Scalar::State(_)
        | Scalar::Constant
        | Scalar::Time
        | Scalar::Mass => true,
        Scalar::Local(i) => match &scene.constants.body.locals[*i] {
            Local::Scalar(scalar) => constant(scalar),
            Local::Vector(_) => false,
        },
        Scalar::Component(vector, axes, _) => is_fixed(scene, *axes, vector),
        Scalar::Norm(a) | Scalar::NormSquared(a) => fixed(&[a]),
        Scalar::Dot(a, b) => fixed(&[a, b]),
        // whatever these are, nothing is left
        Scalar::PlaneCross(a, b) => is_parallel(scene, a, b) || fixed(&[a, b]),
        Scalar::Negative(a)
        | Scalar::Unary(_, a)
        | Scalar::Power(a, _)
        | Scalar::Called(a)
        | Scalar::Table(a, ..) => constant(a),
        Scalar::Grid(at, ..) => at.iter().all(constant),
        Scalar::Sum(a, b)
        | Scalar::Difference(a, b)
        | Scalar::Product(a, b)
        | Scalar::Quotient(a, b)
        | Scalar::Binary(_, a, b) => constant(a) && constant(b),
        Scalar::If(condition, a, b) => is_decided(scene, condition) && constant(a) && constant(b),
        Scalar::Angle
        | Scalar::AngularRate
        | Scalar::AngularAcceleration
        | Scalar::Attitude(_)
        | Scalar::Reaction(..) => false,
    }
}

/// Whether it holds for every state or for none.
fn is_decided(scene: &Scene<'_>, condition: &Condition) -> bool {
    match condition {
        Condition::Less(a, b) | Condition::AtLeast(a, b) => {
            is_constant(scene, a) && is_constant(scene, b)
        }
        Condition::And(a, b) | Condition::Or(a, b) => is_decided(scene, a) && is_decided(scene, b),
        Condition::Not(a) => is_decided(scene, a),
    }
}

/// Whether both are constants times the same vector.
fn is_parallel(scene: &Scene<'_>, a: &Written, b: &Written) -> bool {
    let [a, b] = [a, b].map(|vector| format!("{:?}", without_factor(scene, vector)));
    a == b
}

fn without_factor<'a>(scene: &Scene<'_>, vector: &'a Written) -> &'a Written {
    match vector {
        Written::Scaled(factor, inner) if is_constant(scene, factor) => {
            without_factor(scene, inner)
        }
        Written::Negative(inner) => without_factor(scene, inner),
        other => other,
    }
}
