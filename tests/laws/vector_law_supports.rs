//! Bodies held by a pivot, a fixed point or a fixed axis, compared with the vector law written by
//! hand with nalgebra: accelerations from the moments about the support, reactions from both
//! balances.

use nalgebra::{Matrix3, UnitQuaternion, Vector2, Vector3};
use newton_euler::prelude::*;
use proptest::prelude::*;

use crate::oracle::{plane_vectors, rotation, vectors};

/// In the plane, with the moments written about one pole or another.
macro_rules! crank {
    ($name:ident, $pole:expr) => {
        newton_euler::rigid_body!($name {
            motion: pivot(pin).at(post),
            params: [k = 30[N / m], reach = 0.4[m]],
            inputs: [push = body(_, _)[N], pull = world(_, _)[N], twist[N * m]],
            mass: 1.7[kg],
            inertia: 0.31[kg * m ^ 2],
            points: [
                pin = (-reach, 0.3),
                tip = (0.5, 0.25),
                post = world(reach - 2, 3),
                wall = world(1.5, 2),
            ],
            pole: $pole,
            locals: [stretch = wall.position() - tip.position()],
            fields: [weight = mass * world(0, -9.80665)],
            forces: [
                pushed = push.at(tip),
                pulled = pull,
                spring = (k * stretch).at(tip),
                damped = (-2 * tip.velocity()).at(tip),
            ],
            moments: [twisted = twist - 0.1 * angular_velocity],
            reactions: [hold = body(_, _).at(pin), rest = world(2, -1).at(tip)],
            outputs: [reactions, balance, energy],
        });
    };
}

/// In space: the motion, the reactions.
macro_rules! block {
    ($name:ident, $motion:expr, $pole:expr, $reactions:tt) => {
        newton_euler::rigid_body!($name {
            motion: $motion,
            params: [k = 30[N / m], reach = 0.4[m], heave = 1.25[N]],
            inputs: [
                push = body(_, _, _)[N],
                pull = world(_, _, _)[N],
                twist = body(_, _, _)[N * m]
            ],
            mass: 1.7[kg],
            inertia: tensor {
                xx: 0.5,
                yy: 0.6,
                zz: 0.7,
                xy: -0.05,
                yz: 0.04,
                zx: 0.03
            },
            points: [
                foot = (-reach, 0.3, 0.1),
                tip = (0.5, 0.25, -0.2),
                // along (1, -2, 2)/3 and along z from the foot
                far = (0.2 - reach, -0.1, 0.5),
                top = (-reach, 0.3, 0.9),
                wall = world(1.5, 2, -1)
            ],
            pole: $pole,
            locals: [
                stretch = wall.position() - tip.position(),
                _marks = heave * (far.position() - top.position()).norm()
            ],
            fields: [weight = mass * world(0, 0, -9.80665)],
            forces: [
                pushed = push.at(tip),
                pulled = pull,
                spring = (k * stretch).at(tip),
                damped = (-2 * tip.velocity()).at(tip),
            ],
            moments: [twisted = twist],
            reactions: $reactions,
            outputs: [reactions, balance, energy],
        });
    };
}

mod scenes {
    crank!(Crank, G);
    crank!(CrankAboutPin, pin);
    crank!(CrankAboutWall, wall);

    block!(
        Top,
        fixed_point(foot).at(world(0.5, -1, 2)),
        tip,
        [hold = body(_, _, _).at(foot)]
    );
    block!(
        Shaft,
        fixed_axis(foot, body(1, -2, 2)).at(world(0.5, -1, 2)),
        wall,
        [hold = body(_, _, _).at(foot), slide = body(_, 2, _).at(far)]
    );
    block!(
        Gate,
        fixed_axis(foot, world(0, 0, reach)).at(world(0.5, -1, 2)),
        far,
        [
            hold = body(_, _, heave).at(top),
            rail = world(3, -2 * heave, _).at(tip),
            guide = moment(world(_, _, 1.5)),
        ]
    );
}

/// What the block of all scenes in space is made of.
struct Block {
    inertia: Matrix3<f64>,
    foot: Vector3<f64>,
    tip: Vector3<f64>,
}

const MASS: f64 = 1.7;
const ANCHOR: Vector3<f64> = Vector3::new(0.5, -1.0, 2.0);
const WALL: Vector3<f64> = Vector3::new(1.5, 2.0, -1.0);

impl Block {
    fn new() -> Self {
        Self {
            inertia: Matrix3::new(0.5, -0.05, 0.03, -0.05, 0.6, 0.04, 0.03, 0.04, 0.7),
            foot: Vector3::new(-0.4, 0.3, 0.1),
            tip: Vector3::new(0.5, 0.25, -0.2),
        }
    }

    /// Steiner, with c from the foot to G.
    fn about_foot(&self) -> Matrix3<f64> {
        let c = -self.foot;
        self.inertia + (Matrix3::from_diagonal_element(c.norm_squared()) - c * c.transpose()) * MASS
    }

    /// The sum of the given forces and of their moments about the foot, world axes, and the size of the terms.
    fn given(&self, state: &Rotation, [push, pull, twist]: &[Vector3<f64>; 3]) -> Loads {
        let (q, c) = (state.attitude, -self.foot);
        let from_foot = self.tip - self.foot;
        let velocity = q * state.angular_velocity.cross(&from_foot);
        let stretch = WALL - (ANCHOR + q * from_foot);
        let at_tip = q * push + stretch * 30.0 - velocity * 2.0;
        let at_center = pull + Vector3::new(0.0, 0.0, -9.80665 * MASS);
        Loads {
            force: at_tip + at_center,
            moment: (q * from_foot).cross(&at_tip) + (q * c).cross(&at_center) + q * twist,
            size: push.norm()
                + stretch.norm() * 30.0
                + velocity.norm() * 2.0
                + pull.norm()
                + twist.norm()
                + 17.0,
        }
    }
}

struct Loads {
    force: Vector3<f64>,
    moment: Vector3<f64>,
    size: f64,
}

/// Both balances, with all reactions: their sum is `m a_G - F`, their moment about the foot `J ω' + ω × J ω - M`.
///
/// Within 1e-13 of the size of all terms: near a hundred roundings of half a unit, by arms of less than two meters and
/// over those of half a meter between the reactions.
fn balanced(
    state: &Rotation,
    angular: &Vector3<f64>,
    given: &Loads,
    reactions: &[(Vector3<f64>, Vector3<f64>)],
    moments: Vector3<f64>,
) -> Result<(), TestCaseError> {
    let block = Block::new();
    let (q, w, c) = (state.attitude, state.angular_velocity, -block.foot);
    let acceleration = q * (angular.cross(&c) + w.cross(&w.cross(&c)));
    let sum: Vector3<f64> = reactions.iter().map(|(force, _)| force).sum();
    let force = acceleration * MASS - given.force;
    let about = block.about_foot();
    let change = q * (about * angular + w.cross(&(about * w)));
    let arms = reactions
        .iter()
        .map(|(force, point)| (q * (point - block.foot)).cross(force));
    let moment = arms.sum::<Vector3<f64>>() + moments;
    let size = given.size + 4.0 * (angular.norm() + w.norm_squared());
    prop_assert!((sum - force).amax() <= 1e-13 * size, "{sum} is not {force}");
    prop_assert!(
        (moment + given.moment - change).amax() <= 1e-13 * size,
        "{moment} + {} is not {change}",
        given.moment
    );
    Ok(())
}

/// The state of a hinge as one in space.
fn turned(state: &Hinge, axis: Vector3<f64>) -> Rotation {
    Rotation {
        attitude: UnitQuaternion::from_scaled_axis(axis * state.angle),
        angular_velocity: axis * state.angular_velocity,
    }
}

fn is_zero(wrench: &Wrench, size: f64) -> Result<(), TestCaseError> {
    // arms from the poles are shorter than 5 m
    let largest = wrench.force.amax().max(wrench.moment.amax() / 5.0);
    prop_assert!(largest <= 1e-13 * size, "{wrench:?}");
    Ok(())
}

/// The acceleration of a hinge, `d.(M - ω × J ω) / d.J d`.
fn is_acceleration(
    computed: f64,
    state: &Rotation,
    axis: Vector3<f64>,
    given: &Loads,
    extra: Vector3<f64>,
) -> Result<(), TestCaseError> {
    let about = Block::new().about_foot();
    let moment = state.attitude.inverse() * (given.moment + extra);
    let expected = axis.dot(&moment) / axis.dot(&(about * axis));
    // over a moment of inertia of at least half
    prop_assert!(
        (computed - expected).abs() <= 2e-13 * given.size,
        "{computed} is not {expected}"
    );
    Ok(())
}

fn hinge() -> impl Strategy<Value = Hinge> {
    (-7.0..7.0, -3.0..3.0).prop_map(|(angle, angular_velocity)| Hinge {
        angle,
        angular_velocity,
    })
}

fn loads() -> impl Strategy<Value = [Vector3<f64>; 3]> {
    [vectors(20.0), vectors(20.0), vectors(5.0)]
}

proptest! {
    #[test]
    fn fixed_point(state in rotation(), loads in loads()) {
        let (block, top) = (Block::new(), scenes::Top::default());
        let [push, pull, twist] = loads;
        let input = scenes::TopInput { push, pull, twist };
        let given = block.given(&state, &loads);
        let w = state.angular_velocity;
        let moment = state.attitude.inverse() * given.moment;
        let expected = block.about_foot().try_inverse().unwrap() * (moment - w.cross(&(block.about_foot() * w)));
        let computed = top.acceleration(0.0, &state, &input);
        // moments of inertia from 0.6: the terms are divided by that
        prop_assert!((computed - expected).amax() <= 2e-13 * (given.size + 20.0), "{computed} is not {expected}");
        let reactions = top.reactions(0.0, &state, &input);
        balanced(&state, &computed, &given, &[(reactions.hold, block.foot)], Vector3::zeros())?;
        is_zero(&top.residual(0.0, &state, &computed, &reactions, &input), given.size + 100.0)?;
    }

    /// About (1, -2, 2)/3, with one component of the second bearing given.
    #[test]
    fn tilted_axis(hinge in hinge(), loads in loads()) {
        let (block, shaft) = (Block::new(), scenes::Shaft::default());
        let [push, pull, twist] = loads;
        let input = scenes::ShaftInput { push, pull, twist };
        let axis = Vector3::new(1.0, -2.0, 2.0) / 3.0;
        let state = turned(&hinge, axis);
        let given = block.given(&state, &loads);
        let computed = shaft.acceleration(0.0, &hinge, &input);
        is_acceleration(computed, &state, axis, &given, Vector3::zeros())?;
        let reactions = shaft.reactions(0.0, &hinge, &input);
        let far = block.foot + Vector3::new(0.2, -0.4, 0.4);
        let both = [(reactions.hold, block.foot), (reactions.slide, far)];
        balanced(&state, &(axis * computed), &given, &both, Vector3::zeros())?;
        let slide = state.attitude.inverse() * reactions.slide;
        prop_assert!((slide.y - 2.0).abs() <= 1e-13 * given.size);
        is_zero(&shaft.residual(0.0, &hinge, &computed, &reactions, &input), given.size + 100.0)?;
    }

    /// Given parts do work: off the axis, and as a moment about it. The unknown ones do not.
    #[test]
    fn given_parts(hinge in hinge(), loads in loads()) {
        let (block, gate) = (Block::new(), scenes::Gate::default());
        let [push, pull, twist] = loads;
        let input = scenes::GateInput { push, pull, twist };
        let axis = Vector3::z();
        let state = turned(&hinge, axis);
        let given = block.given(&state, &loads);
        let rail = Vector3::new(3.0, -2.5, 0.0);
        let arm = state.attitude * (block.tip - block.foot);
        let extra = arm.cross(&rail) + axis * 1.5;
        let computed = gate.acceleration(0.0, &hinge, &input);
        is_acceleration(computed, &state, axis, &given, extra)?;
        let reactions = gate.reactions(0.0, &hinge, &input);
        prop_assert_eq!((reactions.rail.x, reactions.rail.y), (3.0, -2.5));
        prop_assert_eq!((reactions.hold.z, reactions.guide.z), (1.25, 1.5));
        let top = block.foot + axis * 0.8;
        let both = [(reactions.hold, top), (reactions.rail, block.tip)];
        balanced(&state, &(axis * computed), &given, &both, reactions.guide)?;
        is_zero(&gate.residual(0.0, &hinge, &computed, &reactions, &input), given.size + 100.0)?;
    }

    #[test]
    fn pivot(hinge in hinge(), push in plane_vectors(20.0), pull in plane_vectors(20.0), twist in -5.0..5.0_f64) {
        let (sine, cosine) = hinge.angle.sin_cos();
        let turn = |v: Vector2<f64>| Vector2::new(cosine * v.x - sine * v.y, sine * v.x + cosine * v.y);
        let cross = |a: Vector2<f64>, b: Vector2<f64>| a.perp(&b);
        let rate = hinge.angular_velocity;
        // from the pin, in the world
        let (c, tip) = (turn(Vector2::new(0.4, -0.3)), turn(Vector2::new(0.9, -0.05)));
        let stretch = Vector2::new(1.5, 2.0) - (Vector2::new(-1.6, 3.0) + tip);
        let velocity = Vector2::new(-tip.y, tip.x) * rate;
        let at_tip = turn(push) + stretch * 30.0 - velocity * 2.0 + Vector2::new(2.0, -1.0);
        let at_center = pull + Vector2::new(0.0, -9.80665 * 1.7);
        let moment = cross(tip, at_tip) + cross(c, at_center) + twist - 0.1 * rate;
        let expected = moment / (0.31 + 1.7 * 0.25);
        let size = push.norm() + pull.norm() + stretch.norm() * 30.0 + twist.abs() + velocity.norm() * 2.0 + 20.0;

        let crank = scenes::Crank::default();
        let input = scenes::CrankInput { push, pull, twist };
        let computed = crank.acceleration(0.0, &hinge, &input);
        // over 0.7 kg m²
        prop_assert!((computed - expected).abs() <= 2e-13 * size, "{computed} is not {expected}");
        let acceleration = Vector2::new(-c.y, c.x) * expected - c * rate.powi(2);
        let expected = acceleration * 1.7 - at_tip - at_center;
        let hold = crank.reactions(0.0, &hinge, &input).hold;
        prop_assert!((hold - expected).amax() <= 2e-13 * size, "{hold} is not {expected}");

        // about any pole, and with any reaction but this one it is not zero
        macro_rules! about {
            ($($name:ident $input:ident $reactions:ident),*) => {$(
                let about = scenes::$name::default();
                let input = scenes::$input { push, pull, twist };
                let reactions = scenes::$reactions { hold };
                let zero = about.residual(0.0, &hinge, &computed, &reactions, &input);
                prop_assert!(zero.force.amax() <= 2e-13 * size && zero.moment.abs() <= 1e-12 * size, "{zero:?}");
                let more = scenes::$reactions { hold: hold + Vector2::x() };
                let one = about.residual(0.0, &hinge, &computed, &more, &input);
                prop_assert!((one.force - Vector2::x()).amax() <= 2e-13 * size);
            )*};
        }
        about!(Crank CrankInput CrankReactions, CrankAboutPin CrankAboutPinInput CrankAboutPinReactions, CrankAboutWall CrankAboutWallInput CrankAboutWallReactions);
    }
}
