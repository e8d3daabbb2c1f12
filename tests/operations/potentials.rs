//! Variables that a potential does not contain cost nothing, and those that it contains cost as
//! much as by hand.
#![allow(clippy::float_cmp, reason = "what is exact is compared exactly")]

use nalgebra::Vector3;
use newton_euler::operations::Operations;
use newton_euler::prelude::*;

/// What one acceleration costs.
fn acceleration(operations: &[Operations]) -> Operations {
    let found = operations.iter().find(|row| row.function == "acceleration");
    *found.expect("every body has one")
}

mod pruned {
    newton_euler::rigid_body!(Tether {
        motion: spatial,
        mass: 2,
        inertia: principal(1, 2, 2.5),
        points: [post = world(1, 2, 3)],
        // at G: no moment
        potentials: [spring = 10 * ((position - post.position()).norm() - 0.5).powi(2)],
    });
    newton_euler::rigid_body!(Ball {
        motion: spatial,
        mass: 2,
        inertia: principal(1, 2, 2.5),
        points: [hook = (0.1, 0.2, 0.3), post = world(1, 2, 3)],
        // no rest length: linear, without root and division, and whole at zero length
        potentials: [spring = 10 * (hook.position() - post.position()).norm().powi(2)],
        outputs: [balance],
    });
    newton_euler::rigid_body!(Compass {
        motion: spatial,
        mass: 2,
        inertia: principal(1, 2, 2.5),
        potentials: [magnet = -body(0, 0, 2).dot(world(1e-5, 0, 3e-5))],
        outputs: [balance],
    });
    newton_euler::rigid_body!(Weight {
        motion: spatial,
        mass: 2,
        inertia: principal(1, 2, 2.5),
        potentials: [weight = mass * 9.5 * position.in_world().z],
    });
}

#[test]
fn what_a_potential_does_not_depend_on_is_not_there() {
    let says = |skipped: &[&str], what: &str| skipped.iter().any(|line| line.contains(what));
    assert!(says(
        pruned::Tether::SKIPPED,
        "the moment of `spring`: its potential does not depend on the attitude"
    ));
    assert!(says(
        pruned::Compass::SKIPPED,
        "the force of `magnet`: its potential does not depend on the position"
    ));
    assert!(says(
        pruned::Weight::SKIPPED,
        "position, velocity, attitude: the accelerations do not depend on them"
    ));
    assert!(
        !pruned::Tether::EQUATIONS.contains("qw"),
        "{}",
        pruned::Tether::EQUATIONS
    );
    let compass = pruned::Compass {}.applied(0.0, &Spatial::default(), &());
    assert_eq!(compass.force, Vector3::zeros());
    assert_eq!(compass.moment, Vector3::new(0.0, 2e-5, 0.0));
    let acceleration = pruned::Weight {}.acceleration(0.0, &Spatial::default(), &());
    assert_eq!(
        (acceleration.linear, acceleration.angular),
        (Vector3::z() * -9.5, Vector3::zeros())
    );
}

/// A spring without a rest length at zero length: no direction, and none is needed.
#[test]
fn linear_spring_at_zero_length() {
    let row = acceleration(pruned::Ball::OPERATIONS);
    assert_eq!((row.div, row.sqrt), (0, 0), "{row}");
    let state = Spatial {
        position: Vector3::new(0.9, 1.8, 2.7),
        ..Spatial::default()
    };
    let wrench = pruned::Ball {}.applied(0.0, &state, &());
    assert!(wrench.force.amax() < 1e-14 && wrench.moment.amax() < 1e-14);
}

mod counts {
    newton_euler::rigid_body!(Sprung {
        motion: spatial,
        params: [k = 20, rest = 0.5],
        mass: 2,
        inertia: principal(1, 1, 1),
        points: [hook = (0.3, 0.1, -0.2), post = world(1, 2, 3)],
        potentials: [spring = k / 2 * ((post.position() - hook.position()).norm() - rest).powi(2)],
    });
    newton_euler::rigid_body!(SprungOnAxis {
        motion: spatial,
        params: [k = 20, rest = 0.5],
        mass: 2,
        inertia: principal(1, 1, 1),
        points: [hook = (0, 0, -0.2), post = world(1, 2, 3)],
        potentials: [spring = k / 2 * ((post.position() - hook.position()).norm() - rest).powi(2)],
    });
    newton_euler::rigid_body!(Orbiting {
        motion: spatial,
        params: [mu = 3.986004418e14],
        mass: 2,
        inertia: principal(120, 150, 90),
        locals: [r = position.norm(), n = position.in_body()],
        potentials: [gravity = -mu * mass / r
            + 1.5 * mu / r.powi(5) * (120 * n.x.powi(2) + 150 * n.y.powi(2) + 90 * n.z.powi(2)),],
    });
}

/// As many operations as whoever writes the forces by hand needs, in the same manner of turning vectors.
#[test]
fn operations() {
    let count = |operations: &[Operations]| {
        let row = acceleration(operations);
        assert_eq!((row.div, row.sqrt), (1, 1), "{row}");
        row.mul + row.add
    };
    // R c 24, with its constant part in the 3 of d; |d| 5, k (|d| - l0) / |d| 3, Rᵀd 30, times that 3, c × 9;
    // a = F / m 6
    assert!(count(counts::Sprung::OPERATIONS) <= 24 + 6 + 5 + 3 + 30 + 3 + 9 + 6);
    // R c 10; Rᵀd without z 20
    assert!(count(counts::SprungOnAxis::OPERATIONS) <= 10 + 6 + 5 + 3 + 26 + 2 + 2 + 6);
    // Rᵀr 30, R J r 33, |r| 5, powers and factors 14, J r . r 8, K 9, a 15, ω × J ω 9
    assert!(count(counts::Orbiting::OPERATIONS) <= 30 + 33 + 5 + 14 + 8 + 9 + 15 + 9);
}
