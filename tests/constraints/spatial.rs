//! Constraints in space: a fixed point derived in two ways, rolling balls, and two nonholonomic
//! tops.

use nalgebra::{UnitQuaternion, Vector3};
use newton_euler::{integrate, prelude::*};
use proptest::prelude::*;

use crate::oracle::rotation;

const GRAVITY: f64 = 9.80665;

mod top {
    newton_euler::rigid_body!(Constrained {
        motion: spatial,
        mass: 2[kg],
        inertia: tensor {
            xx: 0.3,
            yy: 0.4,
            zz: 0.5,
            xy: 0.05,
            yz: -0.02,
            zx: 0.04
        },
        points: [tip = (0.1, 0, -0.4)[m]],
        fields: [weight = mass * world(0, 0, -9.80665[m / s ^ 2])],
        constraints: [held = tip.position()],
        reactions: [pin = world(_, _, _).at(tip)],
        outputs: [reactions, balance],
    });

    newton_euler::rigid_body!(Supported {
        motion: fixed_point(tip),
        mass: 2[kg],
        inertia: tensor {
            xx: 0.3,
            yy: 0.4,
            zz: 0.5,
            xy: 0.05,
            yz: -0.02,
            zx: 0.04
        },
        points: [tip = (0.1, 0, -0.4)[m]],
        fields: [weight = mass * world(0, 0, -9.80665[m / s ^ 2])],
        reactions: [pin = world(_, _, _).at(tip)],
        outputs: [reactions],
    });
}

proptest! {
    /// To 1e-12 of the weight and the centrifugal force: three eliminations, each through a divisor of at least a third of its terms.
    #[test]
    fn a_fixed_point_is_a_constraint_and_a_support(turning in rotation()) {
        let (constrained, supported) = (top::Constrained::default(), top::Supported::default());
        let center = turning.attitude * Vector3::new(-0.1, 0.0, 0.4);
        let w = turning.attitude * turning.angular_velocity;
        let state = Spatial {
            position: center,
            attitude: turning.attitude,
            velocity: w.cross(&center),
            angular_velocity: turning.angular_velocity,
        };
        let size = GRAVITY + w.norm_squared();
        for violation in constrained.violations(0.0, &state, &()) {
            prop_assert!(violation.position.unwrap().abs() < 1e-14 && violation.velocity.abs() < 1e-14);
        }
        let acceleration = constrained.acceleration(0.0, &state, &());
        let expected = supported.acceleration(0.0, &turning, &());
        prop_assert!((acceleration.angular - expected).norm() < 1e-12 * size);
        let reactions = constrained.reactions(0.0, &state, &()).unwrap();
        let expected = supported.reactions(0.0, &turning, &()).pin;
        prop_assert!((reactions.pin - expected).norm() < 1e-12 * size);
        let residual = constrained.residual(0.0, &state, &acceleration, &reactions, &());
        prop_assert!(residual.force.norm() < 1e-12 * size && residual.moment.norm() < 1e-12 * size);
    }
}

/// Balls that roll on the plane z = 0, under a pull along x.
mod ball {
    newton_euler::rigid_body!(Even {
        motion: spatial,
        params: [r = 0.2[m]],
        mass: 2[kg],
        inertia: principal(0.05, 0.05, 0.05)[kg * m ^ 2],
        points: [contact = G - r * world(0, 0, 1)],
        fields: [weight = mass * world(3, 0, -9.80665)[m / s ^ 2]],
        constraints: [
            touching = position.in_world().z - r,
            along = contact.velocity().in_world().x,
            aside = contact.velocity().in_world().y,
        ],
        reactions: [ground = world(_, _, _).at(contact)],
        outputs: [reactions],
    });

    newton_euler::rigid_body!(Uneven {
        motion: spatial,
        params: [r = 0.2[m]],
        mass: 2[kg],
        inertia: principal(0.03, 0.04, 0.05)[kg * m ^ 2],
        points: [contact = G - r * world(0, 0, 1)],
        fields: [weight = mass * world(0, 0, -9.80665)[m / s ^ 2]],
        constraints: [
            touching = position.in_world().z - r,
            along = contact.velocity().in_world().x,
            aside = contact.velocity().in_world().y,
        ],
        reactions: [ground = world(_, _, _).at(contact)],
        outputs: [reactions, energy, momentum],
    });
}

fn rolling(attitude: UnitQuaternion<f64>, angular_velocity: Vector3<f64>) -> Spatial {
    let w = attitude * angular_velocity;
    Spatial {
        position: [0.0, 0.0, 0.2].into(),
        attitude,
        velocity: w.cross(&Vector3::new(0.0, 0.0, 0.2)),
        angular_velocity,
    }
}

/// The rows of the constraints and the moments of their reactions are the same vectors, turned once.
#[test]
fn a_ball_takes_two_rotations() {
    let mut rows = ball::Uneven::OPERATIONS.iter();
    let row = rows.find(|row| row.function == "acceleration").unwrap();
    assert!(row.mul <= 66 && row.add <= 29 && row.div == 2, "{row}");
}

/// Down an incline a ball rolls with `a = f / (1 + J / m r^2)`, however it spins.
#[test]
fn a_ball_rolls_down_an_incline() {
    let attitude = UnitQuaternion::from_scaled_axis(Vector3::new(0.4, -1.1, 0.7));
    let state = rolling(attitude, Vector3::new(1.0, -2.0, 3.0));
    let ball = ball::Even::default();
    let acceleration = ball.acceleration(0.0, &state, &());
    let expected = 3.0 / (1.0 + 0.05 / (2.0 * 0.04));
    assert!((acceleration.linear - Vector3::new(expected, 0.0, 0.0)).norm() < 1e-14);
    let angular = attitude * acceleration.angular;
    assert!((angular - Vector3::new(0.0, expected / 0.2, 0.0)).norm() < 1e-13);
    let ground = ball.reactions(0.0, &state, &()).unwrap().ground;
    let needed = Vector3::new(2.0 * (expected - 3.0), 0.0, 2.0 * GRAVITY);
    assert!((ground - needed).norm() < 1e-13);
}

/// Chaplygin: energy and the angular momentum about the contact, which has no moment there, are conserved.
#[test]
fn an_uneven_ball_keeps_its_momentum_about_the_contact() {
    let ball = ball::Uneven::default();
    let start = rolling(UnitQuaternion::identity(), Vector3::new(1.0, 2.0, 0.5));
    let about_contact = |state: &Spatial| {
        let lever = Vector3::new(0.0, 0.0, 0.2);
        ball.angular_momentum(state) + lever.cross(&ball.linear_momentum(state))
    };
    let later = integrate::cf4_projected(&ball, &start, &(), 0.0..10.0, 2000).unwrap();
    assert!((about_contact(&later) - about_contact(&start)).norm() < 1e-9);
    assert!((ball.kinetic_energy(&later) - ball.kinetic_energy(&start)).abs() < 1e-9);
    assert!((later.attitude.angle()) > 0.1 && (later.position.z - 0.2).abs() < 1e-16 * 2.0);
    for violation in ball.violations(0.0, &later, &()) {
        assert!(violation.velocity.abs() < 1e-15);
    }
}

newton_euler::rigid_body!(Suslov {
    doc: "A body that cannot turn about its own z axis.",
    motion: rotation,
    inertia: tensor {
        xx: 1,
        yy: 2,
        zz: 2.5,
        yz: 0.4
    },
    constraints: [blocked = angular_velocity.in_body().z],
    reactions: [drag = moment(body(0, 0, _))],
    outputs: [reactions, energy],
});

/// With no third component: `J11 w1' = -w2 (J13 w1 + J23 w2)`, `J22 w2' = w1 (J13 w1 + J23 w2)`: the energy is conserved.
#[test]
fn suslovs_body_does_not_spin() {
    let (body, w) = (Suslov::default(), Vector3::new(0.7, -1.2, 0.0));
    let state = Rotation {
        attitude: UnitQuaternion::from_scaled_axis(Vector3::new(1.0, 0.5, 0.2)),
        angular_velocity: w,
    };
    let acceleration = body.acceleration(0.0, &state, &());
    let coupled = 0.4 * w.y;
    let expected = Vector3::new(-w.y * coupled, w.x * coupled / 2.0, 0.0);
    assert!((acceleration - expected).norm() < 1e-15 * 4.0);
    let later = integrate::cf4_projected(&body, &state, &(), 0.0..20.0, 2000).unwrap();
    assert!((body.kinetic_energy(&later) - body.kinetic_energy(&state)).abs() < 1e-9);
    assert!(later.angular_velocity.z.abs() < 1e-16);
}

mod vanishing {
    newton_euler::rigid_body!(Rubbed {
        motion: spatial,
        params: [mu],
        mass: 7[kg],
        inertia: sphere(0.3[m]),
        points: [tip = (4, 0, 0.27)[m]],
        fields: [weight = mass * world(0, -9.80665[m / s ^ 2], 0)],
        constraints: [
            wall = tip.position().in_world().x,
            slope = velocity.in_world().y - 5 * (-0.3[1 / s] * t).exp() * velocity.in_world().x,
        ],
        reactions: [floor = world(0, _, 0), side = world(_, 0, 0).at(tip)],
        forces: [rubbing = world(mu * floor.in_world().y, 0, 0)],
    });

    newton_euler::rigid_body!(Smooth {
        motion: spatial,
        mass: 7[kg],
        inertia: sphere(0.3[m]),
        points: [tip = (4, 0, 0.27)[m]],
        fields: [weight = mass * world(0, -9.80665[m / s ^ 2], 0)],
        constraints: [
            wall = tip.position().in_world().x,
            slope = velocity.in_world().y - 5 * (-0.3[1 / s] * t).exp() * velocity.in_world().x,
        ],
        reactions: [floor = world(0, _, 0), side = world(_, 0, 0).at(tip)],
    });

    newton_euler::rigid_body!(Skew {
        motion: translation,
        params: [m, s, p, same],
        mass: m,
        forces: [push = world(1, 2, 3)[N]],
        constraints: [
            first = velocity.in_world().x - (s - same) * velocity.in_world().y,
            second = velocity.in_world().y - p * velocity.in_world().x,
        ],
        reactions: [b = world(0, _, 0), a = world(_, 0, 0)],
    });
}

proptest! {
    /// A parameter that is zero takes a term away, and not a divisor.
    #[test]
    fn a_coefficient_of_friction_may_be_zero(turning in rotation(), time in 0.0..3.0) {
        let state = Spatial {
            attitude: turning.attitude,
            angular_velocity: turning.angular_velocity,
            velocity: Vector3::new(0.1, -0.2, 0.3),
            ..Spatial::default()
        };
        let smooth = vanishing::Smooth::default().acceleration(time, &state, &());
        for mu in [0.0, 1e-17] {
            let rubbed = vanishing::Rubbed::new(vanishing::RubbedParams { mu }).unwrap();
            let found = rubbed.acceleration(time, &state, &());
            let size = 1.0 + smooth.linear.norm() + smooth.angular.norm();
            let apart = (found.linear - smooth.linear).norm()
                + (found.angular - smooth.angular).norm();
            prop_assert!(apart < 1e-11 * size, "{found:?} for {smooth:?} with {mu}");
        }
    }
}

#[test]
fn slopes_may_be_zero() {
    for (s, p) in [(0.0, 0.0), (0.0, 0.5), (0.5, 0.0)] {
        let skew = vanishing::Skew::new(vanishing::SkewParams {
            m: 2.0,
            s: s + 0.3,
            p,
            same: 0.3,
        })
        .unwrap();
        let found = skew.acceleration(0.0, &Translation::default(), &());
        assert_eq!(found, Vector3::new(0.0, 0.0, 1.5), "{s}, {p}");
    }
}
