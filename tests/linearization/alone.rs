//! Bodies in systems that are not joined to others: their derivatives are compared with dual
//! numbers, and take as many operations as those of single bodies.

use crate::oracle::{Derived, hold, unmoved};
use nalgebra::{UnitQuaternion, Vector3};
use newton_euler::prelude::*;

rigid_body!(Single {
    motion: spatial,
    mass: 1.5[kg],
    inertia: principal(1, 2, 2.5)[kg * m ^ 2],
    fields: [weight = mass * world(0, 0, -9.81[m / s ^ 2])],
    outputs: [linearization],
});

rigid_system!(Lone {
    bodies: [only {
        mass: 1.5[kg],
        inertia: principal(1, 2, 2.5)[kg * m ^ 2]
    }],
    joints: [orbit = free(only)],
    fields: [weight = mass * world(0, 0, -9.81[m / s ^ 2])],
    outputs: [linearization],
});

// two free bodies on a spring, a driven top beside an arm with a forearm, in another order than that
// of the bodies
rigid_system!(Tied::<T> {
    inputs: [push[N], torque[N * m]],
    bodies: [
        arm {
            mass: 0.9[kg],
            inertia: principal(0.1, 0.08, 0.03)[kg * m ^ 2],
            points: [p = (0, 0.1, 0.3), q = (0.1, 0, -0.3)],
        },
        first {
            mass: 1[kg],
            inertia: principal(1, 2, 2.5)[kg * m ^ 2],
            points: [p = (0.1, 0.2, 0.3)],
            forces: [jet = body(push, 0, 0).at(p)],
        },
        forearm {
            mass: 0.4[kg],
            inertia: principal(0.02, 0.03, 0.015)[kg * m ^ 2],
            points: [p = (0, 0, 0.2)],
        },
        second {
            mass: 2[kg],
            inertia: tensor {
                xx: 3,
                yy: 2,
                zz: 2.5,
                xy: 0.2,
                yz: -0.1
            }[kg * m ^ 2],
            points: [p = (-0.1, 0.2, 0.1)],
        },
        top {
            mass: 0.6[kg],
            inertia: principal(0.02, 0.03, 0.04)[kg * m ^ 2],
            points: [p = (0.05, 0, -0.2)],
        },
    ],
    joints: [
        b = free(second),
        elbow = revolute(arm.q, forearm.p, body(0, 1, 0)),
        ball = spherical(world(3, 0, 0), top.p),
        a = free(first),
        shoulder = revolute(world(0, 3, 0), arm.p, body(0, 1, 0)),
    ],
    drives: [
        motor = torque.on(shoulder),
        rubs = (-0.1 * ball.angular_velocity).on(ball)
    ],
    forces: [
        spring = (5[N / m] * (first.p.position() - second.p.position()).norm())
            .between(first.p, second.p),
        cord = (2[N / m] * (first.G.position() - forearm.G.position()).norm())
            .between(first.G, forearm.G),
    ],
    fields: [weight = mass * world(0, 0, -9.81[m / s ^ 2])],
    outputs: [linearization],
});

fn counted(all: &[newton_euler::operations::Operations]) -> [u32; 3] {
    let mut all = all.iter().filter(|one| one.function == "linearize");
    let one = all.next().expect("it was asked for");
    [one.mul, one.add, one.div]
}

#[test]
fn one_body_as_a_system_takes_as_many_operations() {
    assert_eq!(counted(Lone::OPERATIONS), counted(Single::OPERATIONS));
}

#[test]
fn bodies_that_only_loads_connect() {
    let spatial = |size: f64| Spatial {
        position: Vector3::new(0.4, -0.7, 1.1) * size,
        attitude: UnitQuaternion::from_euler_angles(0.3 * size, -0.9, 1.4),
        velocity: Vector3::new(1.3, 2.1, -0.6) * size,
        angular_velocity: Vector3::new(0.5, -1.4, 0.8) * size,
    };
    let hinge = |angle: f64| Hinge {
        angle,
        angular_velocity: 1.5 - angle,
    };
    let state = TiedState {
        a: spatial(1.0),
        b: spatial(-0.6),
        ball: Rotation {
            attitude: UnitQuaternion::from_euler_angles(0.7, 0.2, -0.4),
            angular_velocity: Vector3::new(2.0, 0.3, -1.1),
        },
        shoulder: hinge(0.4),
        elbow: hinge(-1.2),
    };
    let given = TiedInput {
        push: 1.3,
        torque: -0.6,
    };
    let found = Tied::<f64>::default().linearize(0.0, &state, &given);
    let system = Tied::<Derived>::default();
    let input = |along: usize| TiedInput {
        push: Derived {
            value: 1.3,
            derivatives: [f64::from(u8::from(along == 0))],
        },
        torque: Derived {
            value: -0.6,
            derivatives: [f64::from(u8::from(along == 1))],
        },
    };
    let at = unmoved(&state);
    hold::<_, _, TiedState<Derived>, _, _>(
        &found,
        &state,
        1e-13,
        |state| system.acceleration(Derived::from(0.0), state, &input(9)),
        |j| system.acceleration(Derived::from(0.0), &at, &input(j)),
    );
}
