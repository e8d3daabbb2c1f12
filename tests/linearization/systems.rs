//! Linearizations of systems, compared with dual numbers.

use crate::oracle::{Derived, by, derived, hold, unmoved};
use nalgebra::{UnitQuaternion, Vector3};
use newton_euler::prelude::*;

rigid_system!(Ur5::<T> {
    inputs: [
        drives_1[N * m],
        drives_2[N * m],
        drives_3[N * m],
        drives_4[N * m],
        drives_5[N * m],
        drives_6[N * m],
    ],
    bodies: [
        shoulder {
            mass: 3.7[kg],
            inertia: principal(0.010267495893, 0.010267495893, 0.00666)[kg * m ^ 2],
            points: [out = (0, 0.13585, 0)],
        },
        upper_arm {
            mass: 8.393[kg],
            inertia: principal(0.22689067591, 0.22689067591, 0.0151074)[kg * m ^ 2],
            points: [from = (0, 0, -0.28), out = (0, -0.1197, 0.145)],
        },
        forearm {
            mass: 2.275[kg],
            inertia: principal(0.049443313556, 0.049443313556, 0.004095)[kg * m ^ 2],
            points: [from = (0, 0, -0.25), out = (0, 0, 0.14225)],
        },
        first {
            mass: 1.219[kg],
            inertia: principal(0.111172755531, 0.111172755531, 0.21942)[kg * m ^ 2],
            points: [out = (0, 0.093, 0)],
        },
        second {
            mass: 1.219[kg],
            inertia: principal(0.111172755531, 0.111172755531, 0.21942)[kg * m ^ 2],
            points: [out = (0, 0, 0.09465)],
        },
        third {
            mass: 0.1879[kg],
            inertia: principal(0.0171364731454, 0.0171364731454, 0.033822)[kg * m ^ 2],
        },
    ],
    joints: [
        pan = revolute(world(0, 0, 0.089159)[m], shoulder.G, body(0, 0, 1)),
        lift = revolute(shoulder.out, upper_arm.from, body(0, 1, 0)).turned(body(0, 1, 0), 90[deg]),
        elbow = revolute(upper_arm.out, forearm.from, body(0, 1, 0)),
        wrist_1 = revolute(forearm.out, first.G, body(0, 1, 0)).turned(body(0, 1, 0), 90[deg]),
        wrist_2 = revolute(first.out, second.G, body(0, 0, 1)),
        wrist_3 = revolute(second.out, third.G, body(0, 1, 0)),
    ],
    fields: [weight = mass * world(0, 0, -9.81[m / s ^ 2])],
    drives: [
        a = drives_1.on(pan),
        b = drives_2.on(lift),
        c = drives_3.on(elbow),
        d = drives_4.on(wrist_1),
        e = drives_5.on(wrist_2),
        f = drives_6.on(wrist_3),
    ],
    outputs: [linearization],
});

rigid_system!(Orbiter::<T> {
    inputs: [torque[N * m], jet = world(_, _, _)[N]],
    bodies: [
        hub {
            mass: 120[kg],
            inertia: tensor {
                xx: 12,
                yy: 14,
                zz: 9,
                xy: 0.5,
                yz: -0.3,
                zx: 0.2
            }[kg * m ^ 2],
            points: [bearing = (0.3, 0.1, 0), nozzle = (-0.5, 0, 0.2)],
            forces: [thrust = jet.at(nozzle)],
        },
        mast {
            mass: 4[kg],
            inertia: principal(0.4, 0.02, 0.41)[kg * m ^ 2],
            points: [root = (0, -0.6, 0), tip = (0, 0.7, 0.1)],
            forces: [air = (-0.2[kg / s] * tip.velocity()).at(tip)],
        },
    ],
    joints: [
        orbit = free(hub),
        deploy = universal(hub.bearing, mast.root, body(1, 0, 0), body(0, 0, 1))
    ],
    drives: [
        motor = torque.on(deploy.angle_1),
        spring = (-3[N * m] * deploy.angle_2.sin()).on(deploy.angle_2)
    ],
    outputs: [linearization],
});

rigid_system!(Hanging::<T> {
    params: [reach = 0.3[m]],
    bodies: [
        upper {
            mass: 1.2[kg],
            inertia: principal(0.04, 0.045, 0.012)[kg * m ^ 2],
            points: [top = (0, 0, 0.3), end = (0.1, 0, -reach)]
        },
        lower {
            mass: 0.8[kg],
            inertia: principal(0.02, 0.022, 0.006)[kg * m ^ 2],
            points: [top = (0, 0, 0.25)]
        },
        slider {
            mass: 0.3[kg],
            inertia: principal(0.001, 0.001, 0.0006)[kg * m ^ 2]
        },
    ],
    joints: [
        first = spherical(world(0, 0, 0), upper.top),
        second = revolute(upper.end, lower.top, body(0, 1, 0)).driven(0.3 * (2[rad / s] * t).sin()),
        along = cylindrical(lower.G, slider.G, body(0, 0, 1)),
    ],
    fields: [weight = mass * world(0, 0, -9.81[m / s ^ 2])],
    drives: [spring = (-20[N / m] * along.position).on(along.position)],
    outputs: [linearization],
});

rigid_system!(FourBar::<T> {
    motion: planar,
    inputs: [torque[N * m]],
    bodies: [
        crank {
            mass: 0.4[kg],
            inertia: 4e-4[kg * m ^ 2],
            points: [o = (-0.04, 0), a = (0.06, 0)]
        },
        coupler {
            mass: 1.1[kg],
            inertia: 0.012[kg * m ^ 2],
            points: [a = (-0.16, 0), b = (0.19, 0)]
        },
        rocker {
            mass: 0.8[kg],
            inertia: 4.5e-3[kg * m ^ 2],
            points: [c = (-0.11, 0), b = (0.14, 0)]
        },
    ],
    joints: [
        o = revolute(world(0, 0), crank.o),
        a = revolute(crank.a, coupler.a),
        b = revolute(coupler.b, rocker.b),
        c = revolute(world(0.3, 0), rocker.c),
    ],
    drives: [motor = torque.on(o)],
    moments: [load = moment(-0.6[N * m * s] * rocker.angular_velocity).on(rocker)],
    outputs: [linearization],
});

#[test]
fn an_arm_with_six_axes() {
    let hinge = |angle, angular_velocity| Hinge {
        angle,
        angular_velocity,
    };
    let state = Ur5State {
        pan: hinge(0.3, 0.7),
        lift: hinge(-0.9, -1.1),
        elbow: hinge(1.3, 0.4),
        wrist_1: hinge(-0.2, 1.9),
        wrist_2: hinge(0.8, -0.6),
        wrist_3: hinge(2.1, 1.2),
    };
    let drives = [3.0, -20.0, 8.0, 1.0, -0.5, 0.2];
    let input = |j: usize| {
        let [drives_1, drives_2, drives_3, drives_4, drives_5, drives_6] =
            core::array::from_fn(|i| by(drives[i], i == j));
        Ur5Input {
            drives_1,
            drives_2,
            drives_3,
            drives_4,
            drives_5,
            drives_6,
        }
    };
    let [drives_1, drives_2, drives_3, drives_4, drives_5, drives_6] = drives;
    let own = Ur5Input {
        drives_1,
        drives_2,
        drives_3,
        drives_4,
        drives_5,
        drives_6,
    };
    let found = Ur5::<f64>::default().linearize(0.0, &state, &own);
    let body = Ur5::<Derived>::default();
    let at = unmoved(&state);
    hold::<_, _, Ur5State<Derived>, 12, 6>(
        &found,
        &state,
        1e-13,
        |state| body.acceleration(derived(0.0), state, &input(9)),
        |j| body.acceleration(derived(0.0), &at, &input(j)),
    );
    let operations = Ur5::<f64>::OPERATIONS.iter();
    let mut operations = operations.filter(|one| one.function == "linearize");
    let counted = operations.next().expect("it was asked for");
    let count = counted.mul + counted.add + counted.div;
    assert!(count <= 2018, "{counted:?}");
}

#[test]
fn a_free_base_with_a_mast() {
    let state = OrbiterState {
        orbit: Spatial {
            position: Vector3::new(0.4, -0.7, 1.1),
            attitude: UnitQuaternion::from_euler_angles(0.3, -0.9, 1.4),
            velocity: Vector3::new(1.3, 2.1, -0.6),
            angular_velocity: Vector3::new(0.5, -1.4, 0.8),
        },
        deploy: Universal {
            angle_1: 0.4,
            angle_2: -0.8,
            angular_velocity_1: 0.3,
            angular_velocity_2: 1.2,
        },
    };
    let jet = [3.0, -1.0, 0.5];
    let input = |j: usize| OrbiterInput {
        torque: by(0.7, j == 0),
        jet: Vector3::from_fn(|i, _| by(jet[i], i + 1 == j)),
    };
    let own = OrbiterInput {
        torque: 0.7,
        jet: jet.into(),
    };
    let found = Orbiter::<f64>::default().linearize(0.0, &state, &own);
    let body = Orbiter::<Derived>::default();
    let at = unmoved(&state);
    hold::<_, _, OrbiterState<Derived>, 16, 4>(
        &found,
        &state,
        1e-13,
        |state| body.acceleration(derived(0.0), state, &input(9)),
        |j| body.acceleration(derived(0.0), &at, &input(j)),
    );
}

#[test]
fn ball_joints_driven_joints_and_cylinders() {
    let state = HangingState {
        first: Rotation {
            attitude: UnitQuaternion::from_euler_angles(0.3, -0.9, 1.4),
            angular_velocity: Vector3::new(0.5, -1.4, 0.8),
        },
        along: Cylinder {
            position: 0.1,
            angle: 0.3,
            velocity: -0.4,
            angular_velocity: 2.0,
        },
    };
    let found = Hanging::<f64>::default().linearize(0.9, &state, &());
    let body = Hanging::<Derived>::default();
    hold::<_, _, HangingState<Derived>, 10, 0>(
        &found,
        &state,
        1e-13,
        |state| body.acceleration(derived(0.9), state, &()),
        |_| unreachable!("it has no input"),
    );
}

#[test]
fn a_loop() {
    let hinge = |angle, angular_velocity| Hinge {
        angle,
        angular_velocity,
    };
    let near = FourBarState {
        o: hinge(0.7, 12.0),
        a: hinge(0.513_679 - 0.7, -2.653_551_9 - 12.0),
        b: hinge(1.239_513_4 - 0.513_679, 1.339_603_5 + 2.653_551_9),
    };
    let body = FourBar::<f64>::default();
    let input = FourBarInput { torque: 0.4 };
    let mut state = near;
    body.project(0.0, &mut state, &input).expect("it closes");
    let found = body.linearize(0.0, &state, &input);
    let body = FourBar::<Derived>::default();
    let input = |j: usize| FourBarInput {
        torque: by(0.4, j == 0),
    };
    let at = unmoved(&state);
    hold::<_, _, FourBarState<Derived>, 6, 1>(
        &found,
        &state,
        1e-12,
        |state| body.acceleration(derived(0.0), state, &input(9)),
        |j| body.acceleration(derived(0.0), &at, &input(j)),
    );
}

// a driven joint before one that moves, and a potential of where what they carry is
rigid_system!(Sprung::<T> {
    inputs: [torque[N * m]],
    bodies: [
        a {
            mass: 1[kg],
            inertia: principal(0.1, 0.2, 0.25)[kg * m ^ 2],
            points: [p = (-0.2, 0, 0), q = (0.3, 0, 0.1)]
        },
        b {
            mass: 2[kg],
            inertia: principal(0.3, 0.2, 0.25)[kg * m ^ 2],
            points: [p = (0, -0.2, 0), q = (0.1, 0.3, 0)]
        },
        c {
            mass: 0.5[kg],
            inertia: principal(0.1, 0.05, 0.08)[kg * m ^ 2],
            points: [p = (0, 0.1, -0.2), q = (0.2, 0, 0.3)]
        },
    ],
    joints: [
        first = revolute(world(0, 0, 0), a.p, body(0, 0, 1)),
        swept = revolute(a.q, b.p, body(1, 0, 0)).driven(0.4[rad] * (2[rad / s] * t).sin()),
        last = revolute(b.q, c.p, body(0, 1, 0)),
    ],
    potentials: [trap = 30[N / m] * (c.q.position() - world(0.3, -0.4, 0.2)).norm_squared()],
    drives: [motor = torque.on(first)],
    outputs: [linearization],
});

#[test]
fn a_potential_behind_a_driven_joint() {
    let hinge = |angle, angular_velocity| Hinge {
        angle,
        angular_velocity,
    };
    let state = SprungState {
        first: hinge(0.4, 1.3),
        last: hinge(-0.7, -2.1),
    };
    let input = |j: usize| SprungInput {
        torque: by(0.7, j == 0),
    };
    let found = Sprung::<f64>::default().linearize(0.3, &state, &SprungInput { torque: 0.7 });
    let body = Sprung::<Derived>::default();
    let at = unmoved(&state);
    hold::<_, _, SprungState<Derived>, 4, 1>(
        &found,
        &state,
        1e-13,
        |state| body.acceleration(derived(0.3), state, &input(9)),
        |j| body.acceleration(derived(0.3), &at, &input(j)),
    );
}

// an input that turns what a potential is behind
rigid_system!(Steered::<T> {
    inputs: [torque[N * m], tilt[rad].moving],
    bodies: [
        a {
            mass: 1[kg],
            inertia: principal(0.1, 0.2, 0.25)[kg * m ^ 2],
            points: [p = (-0.2, 0, 0), q = (0.3, 0, 0.1)]
        },
        b {
            mass: 2[kg],
            inertia: principal(0.3, 0.2, 0.25)[kg * m ^ 2],
            points: [p = (0, -0.2, 0), q = (0.1, 0.3, 0)]
        },
    ],
    joints: [
        first = revolute(world(0, 0, 0), a.p, body(0, 0, 1)),
        swept = revolute(a.q, b.p, body(1, 0, 0)).driven(1.5 * tilt),
    ],
    potentials: [trap = 30[N / m] * (b.q.position() - world(0.3, -0.4, 0.2)).norm_squared()],
    drives: [motor = torque.on(first)],
    outputs: [linearization],
});

#[test]
fn an_input_that_drives_a_joint() {
    let state = SteeredState {
        first: Hinge {
            angle: 0.4,
            angular_velocity: 1.3,
        },
    };
    let input = |j: usize| SteeredInput {
        torque: by(0.7, j == 0),
        tilt: by(0.3, j == 1),
        tilt_rate: by(-0.8, j == 2),
        tilt_acceleration: by(1.1, j == 3),
    };
    let held = SteeredInput {
        torque: 0.7,
        tilt: 0.3,
        tilt_rate: -0.8,
        tilt_acceleration: 1.1,
    };
    let found = Steered::<f64>::default().linearize(0.0, &state, &held);
    let body = Steered::<Derived>::default();
    let at = unmoved(&state);
    hold::<_, _, SteeredState<Derived>, 2, 4>(
        &found,
        &state,
        1e-13,
        |state| body.acceleration(derived(0.0), state, &input(9)),
        |j| body.acceleration(derived(0.0), &at, &input(j)),
    );
}
