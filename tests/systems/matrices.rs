//! Mass matrices and Jacobians, tested by what they are used for: accelerations, energies,
//! velocities, work.

use nalgebra::{SVector, Vector3};
use newton_euler::prelude::*;
use newton_euler::state::Coordinates;

use super::compare::{Jointed, Random, close};

// a free base, each kind of joint, and not in the order of the tree
rigid_system!(Reaching {
    inputs: [push[N]],
    bodies: [
        hub {
            mass: 3[kg],
            inertia: principal(0.5, 0.4, 0.6)[kg * m ^ 2],
            points: [p = (0.1, 0.2, 0.3), q = (-0.2, 0.1, 0)],
            forces: [jet = body(push, 0, 0).at(p)],
        },
        boom {
            mass: 0.6[kg],
            inertia: principal(0.05, 0.04, 0.03)[kg * m ^ 2],
            points: [p = (0, 0.1, 0.3), q = (0.1, 0, -0.3)],
        },
        mass_ {
            mass: 0.3[kg],
            inertia: principal(0.02, 0.03, 0.01)[kg * m ^ 2],
            points: [p = (0.1, 0.1, 0), tip = (0.3, -0.1, 0.2)],
        },
        ball {
            mass: 0.8[kg],
            inertia: principal(0.02, 0.03, 0.04)[kg * m ^ 2],
            points: [p = (0, 0.1, 0.2)],
        },
        slider {
            mass: 0.5[kg],
            inertia: principal(0.01, 0.01, 0.02)[kg * m ^ 2],
            points: [p = (0.1, 0, 0)],
        },
        wheel {
            mass: 0.2[kg],
            inertia: principal(0.002, 0.002, 0.001)[kg * m ^ 2]
        },
    ],
    joints: [
        rail = cylindrical(boom.q, mass_.p, body(1, 2, 2)),
        joint = universal(hub.p, boom.p, body(1, 0, 0), body(0, 1, 0)),
        base = free(hub),
        socket = spherical(hub.q, ball.p),
        slide = prismatic(hub.G, slider.p, body(0, 1, 0)),
        spin = revolute(slider.G, wheel.G, body(0, 0, 1)),
    ],
    fields: [weight = mass * world(0.3[m / s ^ 2], 0, -9.81[m / s ^ 2])],
    drives: [motor = (2[N * m] * (3[rad / s] * t).cos()).on(joint.angle_1)],
    outputs: [energy, mass_matrix, jacobian(mass_.tip, ball.G)],
});

fn drawn(numbers: &mut Random) -> ReachingState {
    ReachingState {
        rail: Jointed::random(numbers),
        joint: Jointed::random(numbers),
        base: Jointed::random(numbers),
        socket: Jointed::random(numbers),
        slide: Jointed::random(numbers),
        spin: Jointed::random(numbers),
    }
}

const FREEDOMS: usize = 15;

/// The numbers of an acceleration, or the last ones of a state.
fn numbers_of(columns: &impl newton_euler::columns::Columns<f64>) -> Vec<f64> {
    struct List(Vec<f64>);
    impl newton_euler::columns::Sink<f64> for List {
        fn put(&mut self, number: f64) {
            self.0.push(number);
        }
    }
    let mut list = List(Vec::new());
    columns.write(&mut list);
    list.0
}

/// The rates in a state.
fn rates(state: &ReachingState) -> SVector<f64, FREEDOMS> {
    let all = state.coordinates();
    SVector::from_column_slice(&all.0[all.0.len() - FREEDOMS..])
}

#[test]
fn the_mass_matrix_gives_accelerations_and_energies() {
    let system = Reaching::default();
    let mut numbers = Random::new(71);
    for _ in 0..30 {
        let (state, input) = (
            drawn(&mut numbers),
            ReachingInput {
                push: numbers.number(),
            },
        );
        let matrix = system.mass_matrix(0.4, &state, &input);
        assert_eq!(matrix, matrix.transpose());
        let driving = system.generalized_forces(0.4, &state, &input);
        let found = numbers_of(&system.acceleration(0.4, &state, &input));
        let found = SVector::<f64, FREEDOMS>::from_column_slice(&found);
        let product = matrix * found;
        close(
            "M q'' = f",
            product.as_slice(),
            driving.as_slice(),
            driving.norm(),
            1e-12,
        );
        let v = rates(&state);
        let energy = (v.transpose() * matrix * v)[0] / 2.0;
        close(
            "v M v / 2",
            &[energy],
            &[system.kinetic_energy(&state)],
            1.0,
            1e-13,
        );
    }
}

/// The place of the tip and of the center of the ball, from geometry.
fn places(state: &ReachingState) -> [Vector3<f64>; 2] {
    use nalgebra::UnitQuaternion;
    let base = state.base.attitude;
    let boom = base
        * UnitQuaternion::new(Vector3::x() * state.joint.angle_1)
        * UnitQuaternion::new(Vector3::y() * state.joint.angle_2);
    let axis = Vector3::new(1.0, 2.0, 2.0) / 3.0;
    let mass = boom * UnitQuaternion::new(axis * state.rail.angle);
    let boom_center = state.base.position + base * Vector3::new(0.1, 0.2, 0.3)
        - boom * Vector3::new(0.0, 0.1, 0.3);
    let rail = boom_center + boom * (Vector3::new(0.1, 0.0, -0.3) + axis * state.rail.position);
    let tip = rail + mass * (Vector3::new(0.3, -0.1, 0.2) - Vector3::new(0.1, 0.1, 0.0));
    let ball = state.base.position + base * Vector3::new(-0.2, 0.1, 0.0)
        - base * (state.socket.attitude * Vector3::new(0.0, 0.1, 0.2));
    [tip, ball]
}

#[test]
fn jacobians_give_velocities() {
    let system = Reaching::default();
    let mut numbers = Random::new(72);
    for _ in 0..30 {
        let (state, input) = (drawn(&mut numbers), ReachingInput { push: 0.3 });
        let jacobians = system.jacobian(0.4, &state, &input);
        let v = rates(&state);
        let still = ReachingAcceleration::default();
        let step = 1e-4;
        let moved = |steps: f64| places(&state.moved(&(state.rate(&still) * (steps * step))));
        let slope = |which: usize| {
            ([1.0, 2.0].map(|n| moved(n)[which] - moved(-n)[which])[0] * (2.0 / 3.0)
                - (moved(2.0)[which] - moved(-2.0)[which]) / 12.0)
                / step
        };
        for (which, jacobian) in [jacobians.mass__tip, jacobians.ball_G].iter().enumerate() {
            let velocity = jacobian * v;
            close(
                "velocity",
                &velocity.as_slice()[..3],
                slope(which).as_slice(),
                10.0,
                1e-9,
            );
        }
        // the angular velocity of the ball is that of the base and its own, world axes
        let turning = state.base.attitude
            * (state.base.angular_velocity + state.socket.attitude * state.socket.angular_velocity);
        let found = jacobians.ball_G * v;
        close(
            "angular velocity",
            &found.as_slice()[3..],
            turning.as_slice(),
            1.0,
            1e-13,
        );
    }
}

// in the plane
rigid_system!(Scara {
    motion: planar,
    params: [load = 0.8[kg]],
    bodies: [
        upper {
            mass: 1.2[kg],
            inertia: 0.04[kg * m ^ 2],
            points: [hinge = (-0.28, 0)[m], tip = (0.32, 0)[m]]
        },
        lower {
            mass: load,
            inertia: 0.015[kg * m ^ 2],
            points: [hinge = (-0.22, 0)[m], hand = (0.3, 0)[m]]
        },
    ],
    joints: [
        shoulder = revolute(world(0, 0), upper.hinge),
        elbow = revolute(upper.tip, lower.hinge),
    ],
    outputs: [mass_matrix, jacobian(lower.hand)],
});

#[test]
fn an_arm_in_the_plane() {
    let arm = Scara::default();
    let (a, b) = (0.4, 0.9);
    let state = ScaraState {
        shoulder: Hinge {
            angle: a,
            angular_velocity: 0.0,
        },
        elbow: Hinge {
            angle: b,
            angular_velocity: 0.0,
        },
    };
    let (first, second) = (0.6, 0.52);
    let ScaraJacobians {
        lower_hand: jacobian,
    } = arm.jacobian(0.0, &state, &());
    let expected = [
        -first * f64::sin(a) - second * f64::sin(a + b),
        first * f64::cos(a) + second * f64::cos(a + b),
        1.0,
        -second * f64::sin(a + b),
        second * f64::cos(a + b),
        1.0,
    ];
    close("jacobian", jacobian.as_slice(), &expected, 1.0, 1e-15);
    let matrix = arm.mass_matrix(0.0, &state, &());
    let coupled = 0.015 + 0.8 * (0.22 * 0.22 + first * 0.22 * b.cos());
    let whole = 0.04
        + 1.2 * 0.28 * 0.28
        + 0.015
        + 0.8 * (first * first + 0.22 * 0.22 + 2.0 * first * 0.22 * b.cos());
    let expected = [whole, coupled, coupled, 0.015 + 0.8 * 0.22 * 0.22];
    close("mass matrix", matrix.as_slice(), &expected, 1.0, 1e-15);
}
