//! Inverse dynamics under constraints and of rods: the drives that produced a motion are found
//! again from the motion.

use nalgebra::{UnitQuaternion, UnitVector3, Vector2, Vector3};
use newton_euler::prelude::*;
use newton_euler::state::RodAcceleration;

/// A body with unknown drives, and the same one with drives that are given.
macro_rules! driven {
    ($name:ident, $given:ident: [$($common:tt)*], $key:ident: [$($unknown:tt)*], inputs: $inputs:tt, [$($known:tt)*]) => {
        rigid_body!($name { $($common)* $key: [$($unknown)*], outputs: [inverse], });
        rigid_body!($given { $($common)* inputs: $inputs, $key: [$($known)*], });
    };
}

// a wheel that rolls down a plane, braked: one way to move, one motor
driven!(Wheel, WheelDriven: [
    motion: planar,
    mass: 2[kg],
    inertia: 0.07[kg * m ^ 2],
    points: [contact = G - 0.3[m] * world(0, 1)],
    fields: [weight = mass * world(4, -9)[m / s ^ 2]],
    constraints: [rolling = contact.velocity()],
    reactions: [ground = world(_, _).at(contact)],
], moments: [motor = _], inputs: [torque[N * m]], [motor = torque]);

// a block that a rail guides, with friction that follows the normal force, and a winch
driven!(Block, BlockDriven: [
    motion: planar_translation,
    mass: 1.4[kg],
    locals: [along = world(0.8, 0.6), across = world(-0.6, 0.8)],
    fields: [weight = mass * world(0, -9.80665[m / s ^ 2])],
    constraints: [rail = position.dot(across) - 0.2[m]],
    reactions: [normal = _ * across, clamp = moment(_)],
    joint_forces: [friction = -0.3 * normal.dot(across) * along],
], forces: [winch = _ * world(1, 0)], inputs: [pull[N]], [winch = pull * world(1, 0)]);

// a top on a foot that slides on the ground and is turned by two motors: three ways to turn
driven!(Top, TopDriven: [
    motion: spatial,
    mass: 0.8[kg],
    inertia: tensor { xx: 0.03, yy: 0.04, zz: 0.02, xy: 0.002, yz: 0.001, zx: -0.003 }[kg * m ^ 2],
    points: [foot = (0.01, 0.02, -0.2), tip = (0, 0.05, 0.3)],
    fields: [weight = mass * world(0, 0, -9.80665[m / s ^ 2])],
    constraints: [ground = foot.position()],
    reactions: [carried = world(_, _, _).at(foot)],
], forces: [thread = world(_, _, 0).at(tip)], inputs: [pull = world(_, _, _)[N]], [thread = pull.at(tip)]);

// a top on a pivot, its tip guided at one height, with two wheels
driven!(Guided, GuidedDriven: [
    motion: fixed_point(foot),
    mass: 0.9[kg],
    inertia: tensor { xx: 0.05, yy: 0.06, zz: 0.02, xy: 0.002, yz: 0.001, zx: -0.003 }[kg * m ^ 2],
    points: [foot = (0.02, 0.01, -0.2), tip = (0, 0, 0.25)],
    fields: [weight = mass * world(0, 0, -9.80665[m / s ^ 2])],
    constraints: [height = tip.position().in_world().z - 0.31[m]],
    reactions: [guide = world(0, 0, _).at(tip), ground = world(_, _, _).at(foot)],
    joint_forces: [friction = (-0.1 * guide.in_world().z * world(0, 1, 0)).at(tip)],
], moments: [wheels = body(_, 0, _)], inputs: [torque = body(_, _, _)[N * m]], [wheels = torque]);

// a rod: thrust at one end, and a couple across it
driven!(Boom, BoomDriven: [
    motion: rod(body(1, 0, 0)),
    mass: 2[kg],
    inertia: rod(1.5[m]),
    fields: [weight = mass * world(0, 0, -9.80665[m / s ^ 2])],
    forces: [drag = -0.3[kg / s] * velocity],
], moments: [couple = _ * axis.cross(world(0.6, 0, 0.8))], inputs: [turn[N * m]], [couple = turn * axis.cross(world(0.6, 0, 0.8))]);

rigid_body!(Crane {
    motion: rod(body(1, 0, 0)),
    mass: 2[kg],
    inertia: rod(1.5[m]),
    points: [end = (0.75, 0, 0), other = (-0.75, 0, 0)],
    forces: [
        first = world(_, _, _).at(end),
        second = (_ * world(0, 1, 0)).at(other)
    ],
    outputs: [inverse],
});

rigid_body!(CraneDriven {
    motion: rod(body(1, 0, 0)),
    mass: 2[kg],
    inertia: rod(1.5[m]),
    inputs: [first_force = world(_, _, _)[N], second_force[N]],
    points: [end = (0.75, 0, 0), other = (-0.75, 0, 0)],
    forces: [
        first = first_force.at(end),
        second = (second_force * world(0, 1, 0)).at(other)
    ],
});

#[test]
fn a_wheel_and_a_block() {
    for torque in [-3.0, 0.0, 0.4] {
        let state = Planar {
            position: [0.4, 0.3].into(),
            angle: 0.7,
            velocity: [-0.6, 0.0].into(),
            angular_velocity: 2.0,
        };
        let acceleration =
            WheelDriven::default().acceleration(0.0, &state, &WheelDrivenInput { torque });
        let found = Wheel::default().inverse(0.0, &state, &acceleration, &());
        assert!(
            (found.motor - torque).abs() < 1e-13,
            "{} for {torque}",
            found.motor
        );

        let state = PlanarTranslation {
            position: [-0.12, 0.16].into(),
            velocity: [0.8, 0.6].into(),
        };
        let pull = 5.0 * torque;
        let acceleration =
            BlockDriven::default().acceleration(0.0, &state, &BlockDrivenInput { pull });
        let found = Block::default().inverse(0.0, &state, &acceleration, &());
        let expected = Vector2::new(pull, 0.0);
        assert!(
            (found.winch - expected).norm() < 1e-12,
            "{} for {expected}",
            found.winch
        );
    }
}

#[test]
fn a_top_on_its_foot() {
    for step in 0..8 {
        let attitude =
            UnitQuaternion::from_scaled_axis(Vector3::new(0.3, 0.2 * f64::from(step), -0.4));
        let angular_velocity = Vector3::new(0.5, -1.0, 3.0);
        let arm = attitude * Vector3::new(-0.01, -0.02, 0.2);
        let state = Spatial {
            position: arm,
            attitude,
            velocity: (attitude * angular_velocity).cross(&arm),
            angular_velocity,
        };
        let pull = Vector3::new(1.3, -0.6, 0.0);
        let acceleration = TopDriven::default().acceleration(0.0, &state, &TopDrivenInput { pull });
        let found = Top::default()
            .inverse(0.0, &state, &acceleration, &())
            .unwrap();
        assert!(
            (found.thread - pull).norm() < 1e-11,
            "{} for {pull}",
            found.thread
        );
    }
}

#[test]
fn a_guided_top() {
    let (guided, given) = (Guided::default(), GuidedDriven::default());
    for step in 0..8 {
        let turn = Vector3::new(0.6, 0.2 * f64::from(step), 0.3);
        let mut state = Rotation {
            attitude: UnitQuaternion::from_scaled_axis(turn),
            angular_velocity: [1.0, -0.7, 5.0].into(),
        };
        given
            .project(0.0, &mut state, &GuidedDrivenInput::default())
            .unwrap();
        let torque = Vector3::new(0.3, 0.0, -1.1);
        let acceleration = given.acceleration(0.0, &state, &GuidedDrivenInput { torque });
        let found = guided.inverse(0.0, &state, &acceleration, &()).unwrap();
        assert!(
            (found.wheels - torque).norm() < 1e-11,
            "{} for {torque}",
            found.wheels
        );
    }
}

#[test]
fn rods() {
    for step in 0..8 {
        let axis = UnitVector3::new_normalize(Vector3::new(0.3, 0.9, -0.3 * f64::from(step)));
        let rate = axis.cross(&Vector3::new(1.0, -2.0, 0.4));
        let state = Rod {
            position: [1.0, 2.0, 3.0].into(),
            axis,
            velocity: [-1.0, 0.5, 0.2].into(),
            axis_rate: rate,
        };
        let turn = 1.7;
        let acceleration: RodAcceleration =
            BoomDriven::default().acceleration(0.0, &state, &BoomDrivenInput { turn });
        let found = Boom::default()
            .inverse(0.0, &state, &acceleration, &())
            .unwrap();
        let expected = turn * axis.cross(&Vector3::new(0.6, 0.0, 0.8));
        assert!(
            (found.couple - expected).norm() < 1e-12,
            "{} for {expected}",
            found.couple
        );

        let (first, second) = (Vector3::new(0.5, 3.0, -2.0), -1.2);
        let input = CraneDrivenInput {
            first_force: first,
            second_force: second,
        };
        let acceleration = CraneDriven::default().acceleration(0.0, &state, &input);
        let found = Crane::default()
            .inverse(0.0, &state, &acceleration, &())
            .unwrap();
        assert!(
            (found.first - first).norm() < 1e-11,
            "{} for {first}",
            found.first
        );
        assert!((found.second - Vector3::new(0.0, second, 0.0)).norm() < 1e-11);
    }
}

// a top on a guide; what its foot carries rubs at the tip, on a support and with a constraint for it
macro_rules! rubbed_top {
    ($($name:ident { $motion:ident $(($foot:ident))?, [$($held:tt)*] })*) => {$(
        rigid_body!($name {
            motion: $motion $(($foot))?,
            mass: 0.9[kg],
            inertia: principal(0.05, 0.06, 0.02)[kg * m ^ 2],
            points: [foot = (0, 0, -0.2), tip = (0, 0, 0.25)],
            fields: [weight = mass * world(0, 0, -9.8)],
            constraints: [$($held)* height = tip.position().in_world().z - 0.31[m]],
            reactions: [guide = world(0, 0, _).at(tip), ground = world(_, _, _).at(foot)],
            forces: [rub = (-0.1 * ground).at(tip)],
            moments: [motor = body(0, _, _)],
            outputs: [inverse],
        });
    )*};
}

rubbed_top! {
    RubbedTop { fixed_point(foot), [] }
    LooseRubbedTop { spatial, [held = foot.position(),] }
}

#[test]
fn drives_beside_friction_of_a_support() {
    for (turn, accelerations) in [
        ([0.3, 0.2, 0.1], [0.5, 0.1, -0.4]),
        ([-0.4, 0.7, 1.1], [-1.0, 0.6, 2.0]),
    ] {
        let attitude = UnitQuaternion::from_scaled_axis(turn.into());
        let mut state = Rotation {
            attitude,
            angular_velocity: [0.1, 0.5, 2.0].into(),
        };
        RubbedTop::default().project(0.0, &mut state, &()).unwrap();
        // a motion that the guide allows
        let arm = state.attitude * Vector3::new(0.0, 0.0, 0.45);
        let up = state.attitude.inverse() * arm.cross(&Vector3::z());
        let w = state.angular_velocity;
        let swept = (state.attitude * w.cross(&w.cross(&Vector3::new(0.0, 0.0, 0.45)))).z;
        let mut angular = Vector3::from(accelerations);
        angular -= up * ((angular.dot(&up) + swept) / up.norm_squared());
        let foot = state.attitude * Vector3::new(0.0, 0.0, -0.2);
        let about = |vector: Vector3<f64>| vector.cross(&-foot);
        let spin = state.attitude * w;
        let whole = Spatial {
            position: -foot,
            velocity: about(spin),
            attitude: state.attitude,
            angular_velocity: w,
        };
        let linear = about(state.attitude * angular) + spin.cross(&about(spin));
        let one = RubbedTop::default().inverse(0.0, &state, &angular, &());
        let acceleration = SpatialAcceleration { linear, angular };
        let other = LooseRubbedTop::default().inverse(0.0, &whole, &acceleration, &());
        let (one, other) = (one.unwrap().motor, other.unwrap().motor);
        assert!(
            (one - other).norm() < 1e-11 * (1.0 + other.norm()),
            "{one} {other}"
        );
    }
}
