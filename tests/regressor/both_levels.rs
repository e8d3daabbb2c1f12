//! Systems with fields in their bodies and beside them: rows of a description with other mass
//! properties, times the true ones, are the true loads.

use nalgebra::{Rotation2, UnitQuaternion, Vector2, Vector3};
use newton_euler::prelude::*;

use super::close;
use super::coordinates::Random;

rigid_system!(Arm {
    motion: planar,
    params: [
        upper_mass = 1[kg],
        shell = 1[kg],
        payload = 1[kg],
        upper_inertia = 1[kg * m ^ 2],
        lower_inertia = 1[kg * m ^ 2],
        along = 0[m],
    ],
    inputs: [torque[N * m]],
    bodies: [
        upper {
            mass: upper_mass,
            inertia: upper_inertia,
            points: [pin = (-0.3[m] - along, 0.02), end = (0.2[m] - along, 0.02)],
        },
        lower {
            mass: shell + payload,
            inertia: lower_inertia,
            points: [pin = (-0.22[m] - along, -0.03)],
            fields: [
                current = mass * world(0.4[m / s ^ 2], 0),
                lift = world(0, 3[N]),
                // of the payload alone, so a load
                pull = payload * world(0.6[m / s ^ 2], 0),
            ],
        },
    ],
    joints: [
        shoulder = revolute(world(0, 0), upper.pin),
        elbow = revolute(upper.end, lower.pin)
    ],
    drives: [motor = torque.on(elbow)],
    fields: [
        weight = mass * world(0, -9.81[m / s ^ 2]),
        gust = mass * world(0.3[m / s ^ 3] * t, 0) + world(0.7[N], 0),
    ],
    outputs: [regressor],
});

#[test]
fn of_an_arm_with_any_mass_properties() {
    let mut random = Random(31);
    for _ in 0..100 {
        let mut size = || 1.5 + random.number();
        let true_ones = ArmParams {
            upper_mass: size(),
            shell: size(),
            payload: size(),
            upper_inertia: size(),
            lower_inertia: size(),
            along: 0.1 * size(),
        };
        let arm = Arm::new(true_ones).expect("all are positive");
        let others = Arm::new(ArmParams {
            upper_mass: size(),
            shell: size(),
            payload: size(),
            upper_inertia: size(),
            lower_inertia: size(),
            along: 0.0,
        });
        let others = others.expect("all are positive");
        let mut joint = || Hinge {
            angle: 3.0 * random.number(),
            angular_velocity: 2.0 * random.number(),
        };
        let state = ArmState {
            shoulder: joint(),
            elbow: joint(),
        };
        let (time, input) = (1.7, ArmInput { torque: 0.9 });
        let motion = arm.acceleration(time, &state, &input);
        let own = arm.inertial_parameters();
        for description in [&arm, &others] {
            let rows = description.regressor(time, &state, &motion, &input);
            let sum = rows.upper * own.upper + rows.lower * own.lower;
            // about the pins, what is not proportional to a mass: forces at each G
            let [shoulder, elbow] = [state.shoulder.angle, state.elbow.angle];
            let upper = Rotation2::new(shoulder);
            let lower = Rotation2::new(shoulder + elbow);
            let to_end = upper * Vector2::new(0.5, 0.0);
            let to_upper = upper * Vector2::new(0.3 + true_ones.along, -0.02);
            let to_lower = lower * Vector2::new(0.22 + true_ones.along, 0.03);
            let on_upper = Vector2::new(0.7, 0.0);
            let on_lower = Vector2::new(0.7 + 0.6 * true_ones.payload, 3.0);
            let expected = [
                to_upper.perp(&on_upper) + (to_end + to_lower).perp(&on_lower),
                to_lower.perp(&on_lower) + 0.9,
            ];
            close(sum.as_slice(), &expected, 1e-13);
        }
    }
}

rigid_system!(Freed {
    inputs: [torque[N * m], thrust[N]],
    bodies: [
        hub {
            mass: 5[kg],
            inertia: principal(1, 0.8, 1.2)[kg * m ^ 2],
            points: [q = (0.3, 0.1, 0)],
            forces: [engine = body(0, 0, thrust)],
        },
        ball {
            mass: 0.6[kg],
            inertia: principal(0.05, 0.04, 0.03)[kg * m ^ 2],
            points: [p = (0, 0.1, 0.3)],
            fields: [current = mass * world(0.4[m / s ^ 2], -0.3[m / s ^ 3] * t, 0.2[m / s ^ 2])],
        },
        arm {
            mass: 0.8[kg],
            inertia: principal(0.02, 0.03, 0.03)[kg * m ^ 2],
            points: [p = (-0.2, 0, 0)],
            fields: [drift = mass * world(-1[m / s ^ 2], 0.5[m / s ^ 2], 0)],
        },
    ],
    joints: [
        base = free(hub),
        socket = spherical(hub.q, ball.p),
        elbow = revolute(hub.G, arm.p, body(0, 1, 0)).turned(body(1, 0, 0), 40[deg]),
    ],
    fields: [weight = mass * world(0, 0, -9.81[m / s ^ 2])],
    drives: [motor = torque.on(elbow)],
    outputs: [regressor],
});

#[test]
fn of_bodies_that_fall_in_different_ways() {
    let mut random = Random(32);
    let freed = Freed::default();
    let own = freed.inertial_parameters();
    for _ in 0..50 {
        let place = random.coordinates();
        let state = FreedState {
            base: Spatial {
                position: place.position,
                attitude: place.attitude,
                velocity: place.velocity,
                angular_velocity: place.angular_velocity,
            },
            socket: Rotation {
                attitude: UnitQuaternion::new(random.vector(2.0)),
                angular_velocity: random.vector(3.0),
            },
            elbow: Hinge {
                angle: place.angle,
                angular_velocity: 2.0,
            },
        };
        let input = FreedInput {
            torque: 1.7,
            thrust: 11.0,
        };
        let motion = freed.acceleration(0.8, &state, &input);
        let rows = freed.regressor(0.8, &state, &motion, &input);
        let sum = rows.hub * own.hub + rows.ball * own.ball + rows.arm * own.arm;
        let force = place.attitude * Vector3::new(0.0, 0.0, 11.0);
        let mut expected = vec![force.x, force.y, force.z];
        expected.extend([0.0; 6]);
        expected.push(1.7);
        close(sum.as_slice(), &expected, 1e-12);
    }
}
