//! Systems: in trees of all kinds of joints, rows times parameters are the torques of inverse
//! dynamics; with loops, they give the power that enters.

use nalgebra::{SMatrix, SVector, UnitQuaternion};
use newton_euler::prelude::*;

use super::close;
use super::coordinates::Random;

rigid_system!(Tree {
    bodies: [
        a {
            mass: 1.2[kg],
            inertia: principal(0.1, 0.2, 0.15)[kg * m ^ 2],
            points: [p = (0.1, 0.2, 0.1), q = (-0.2, 0.1, 0.3)],
        },
        b {
            mass: 0.7[kg],
            inertia: tensor {
                xx: 0.3,
                yy: 0.35,
                zz: 0.25,
                xy: 0.01,
                yz: 0.02,
                zx: -0.03
            }[kg * m ^ 2],
            points: [p = (0.25, 0.1, -0.1), q = (0, -0.3, 0.2)],
        },
        c {
            mass: 0.9[kg],
            inertia: principal(0.12, 0.2, 0.16)[kg * m ^ 2],
            points: [p = (-0.1, 0.2, 0.3), q = (0.3, 0.1, 0)],
        },
        d {
            mass: 0.4[kg],
            inertia: principal(0.05, 0.06, 0.04)[kg * m ^ 2],
            points: [p = (0.1, 0.12, 0.2)],
        },
        e {
            mass: 0.5[kg],
            inertia: principal(0.07, 0.05, 0.06)[kg * m ^ 2],
            points: [p = (0.2, -0.1, 0.1)],
        },
    ],
    joints: [
        // not in the order in which they carry
        nut = screw(c.q, d.p, body(3, 0, -4), 0.15[m]),
        turn = revolute(world(0.5, 0.2, -0.1), a.p, body(2, -1, 2)),
        slide = prismatic(a.q, b.p, body(1, 2, -2)),
        both = cylindrical(b.q, c.p, body(0, 3, 4)),
        cross = universal(a.q, e.p, body(1, 0, 0), body(0, 3, 4)).turned(body(0, 0, 1), 90[deg]),
    ],
    fields: [weight = mass * world(0, 0, -9.81[m / s ^ 2])],
    drives: [
        a = _.on(turn),
        b = _.on(slide),
        c = _.on(both.position),
        d = _.on(both.angle),
        e = _.on(nut),
        f = _.on(cross.angle_1),
        g = _.on(cross.angle_2),
    ],
    outputs: [inverse, regressor],
});

#[test]
fn of_a_tree_they_add_up_to_inverse_dynamics() {
    let mut random = Random(11);
    let tree = Tree::default();
    let own = tree.inertial_parameters();
    for _ in 0..100 {
        let mut state = TreeState::default();
        let mut given = TreeAcceleration::default();
        for joint in [&mut state.nut, &mut state.turn] {
            (joint.angle, joint.angular_velocity) = (3.0 * random.number(), 3.0 * random.number());
        }
        (state.slide.position, state.slide.velocity) = (random.number(), 2.0 * random.number());
        (state.both.position, state.both.velocity) = (random.number(), 2.0 * random.number());
        (state.both.angle, state.both.angular_velocity) = (random.number(), 3.0);
        (state.cross.angle_1, state.cross.angle_2) = (random.number(), random.number());
        state.cross.angular_velocity_1 = 2.0 * random.number();
        state.cross.angular_velocity_2 = 2.0 * random.number();
        (given.nut, given.turn, given.slide) = (random.number(), random.number(), random.number());
        given.both.linear = random.number();
        given.both.angular = random.number();
        given.cross = random.vector(4.0).xy();
        let rows = tree.regressor(0.0, &state, &given, &());
        let sum =
            rows.a * own.a + rows.b * own.b + rows.c * own.c + rows.d * own.d + rows.e * own.e;
        let needed = tree.inverse(0.0, &state, &given, &());
        // as the joints are written
        let needed = [
            needed.e, needed.a, needed.b, needed.c, needed.d, needed.f, needed.g,
        ];
        close(sum.as_slice(), &needed, 1e-13);
        // what carries nothing of a body takes nothing of it
        assert_eq!(rows.a.row(0).norm(), 0.0);
        assert_eq!(rows.d.rows(5, 2).norm(), 0.0);
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
            points: [p = (0, 0.1, 0.3)]
        },
        arm {
            mass: 0.8[kg],
            inertia: principal(0.02, 0.03, 0.03)[kg * m ^ 2],
            points: [p = (-0.2, 0, 0)]
        },
    ],
    joints: [
        base = free(hub),
        socket = spherical(hub.q, ball.p),
        elbow = revolute(hub.G, arm.p, body(0, 1, 0)),
    ],
    fields: [weight = mass * world(0, 0, -9.81[m / s ^ 2])],
    drives: [motor = torque.on(elbow)],
    outputs: [regressor, energy],
});

#[test]
fn of_a_free_base_they_are_what_acts_on_it() {
    let mut random = Random(12);
    let freed = Freed::default();
    let own = freed.inertial_parameters();
    assert_eq!(
        own.hub.as_slice(),
        [5.0, 0.0, 0.0, 0.0, 1.0, 0.8, 1.2, 0.0, 0.0, 0.0]
    );
    for _ in 0..100 {
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
        let motion = freed.acceleration(0.0, &state, &input);
        let rows = freed.regressor(0.0, &state, &motion, &input);
        let sum = rows.hub * own.hub + rows.ball * own.ball + rows.arm * own.arm;
        // thrust along world axes; nothing but the motor turns what is joined
        let force = place.attitude * nalgebra::Vector3::new(0.0, 0.0, 11.0);
        let mut expected = vec![force.x, force.y, force.z];
        expected.extend([0.0; 6]);
        expected.push(1.7);
        close(sum.as_slice(), &expected, 1e-12);
    }
}

rigid_system!(FourBar {
    motion: planar,
    inputs: [torque[N * m]],
    bodies: [
        crank {
            mass: 0.4[kg],
            inertia: 0.002[kg * m ^ 2],
            points: [o = (-0.1, 0), a = (0.1, 0)]
        },
        coupler {
            mass: 0.9[kg],
            inertia: 0.02[kg * m ^ 2],
            points: [a = (-0.25, 0.05), b = (0.25, 0)]
        },
        rocker {
            mass: 0.7[kg],
            inertia: 0.01[kg * m ^ 2],
            points: [c = (-0.2, 0.01), b = (0.2, 0)]
        },
    ],
    joints: [
        ground = revolute(world(0, 0), crank.o),
        first = revolute(crank.a, coupler.a),
        second = revolute(world(0.5, 0), rocker.c),
        closing = revolute(coupler.b, rocker.b),
    ],
    fields: [weight = mass * world(0, -9.81[m / s ^ 2])],
    drives: [
        motor = torque.on(ground),
        friction = (-0.1[N * m * s] * second.angular_velocity).on(second)
    ],
    outputs: [regressor],
});

#[test]
fn with_loops_they_tell_the_power() {
    let bars = FourBar::default();
    let own = bars.inertial_parameters();
    let input = FourBarInput { torque: 0.3 };
    let mut state = FourBarState {
        ground: Hinge {
            angle: 0.6,
            angular_velocity: 2.0,
        },
        first: Hinge {
            angle: 0.2,
            angular_velocity: 0.0,
        },
        second: Hinge {
            angle: 1.6,
            angular_velocity: 0.0,
        },
    };
    bars.project(0.0, &mut state, &input)
        .expect("it can be put together");
    for _ in 0..40 {
        let motion = bars.acceleration(0.0, &state, &input);
        let rows = bars.regressor(0.0, &state, &motion, &input);
        let sum: SVector<f64, 3> =
            rows.crank * own.crank + rows.coupler * own.coupler + rows.rocker * own.rocker;
        let rates = [state.ground, state.first, state.second].map(|joint| joint.angular_velocity);
        let power = SMatrix::<f64, 1, 3>::from(rates.map(|rate| [rate])) * sum;
        let expected = 0.3 * rates[0] - 0.1 * rates[2].powi(2);
        close(power.as_slice(), &[expected], 1e-12);
        state = bars
            .integrate(&state)
            .input(input)
            .to(0.05)
            .expect("it moves");
    }
}
