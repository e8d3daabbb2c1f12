//! Linearizations of trees with loads that depend on accelerations, compared with dual numbers.

use crate::oracle::{Derived, by, derived, hold, unmoved};
use crate::sensitivity::{self, Numbers, numbers};
use nalgebra::{UnitQuaternion, Vector3};
use newton_euler::columns::Columns;
use newton_euler::prelude::*;

rigid_system!(Swimmer::<T> {
    motion: planar,
    inputs: [torque[N * m]],
    bodies: [
        head {
            mass: 2[kg],
            inertia: 0.1[kg * m ^ 2],
            points: [tail = (-0.3, 0)],
            forces: [added = -body(
                0.1[kg] * acceleration.in_body().x,
                3[kg] * acceleration.in_body().y
            )],
        },
        fin {
            mass: 0.3[kg],
            inertia: 0.01[kg * m ^ 2],
            points: [root = (0.15, 0)],
            forces: [wake = 0.2[kg] * head.acceleration],
        },
    ],
    joints: [swims = free(head), joint = revolute(head.tail, fin.root)],
    drives: [motor = torque.on(joint)],
    outputs: [linearization, taylor],
});

#[test]
fn loads_that_follow_accelerations() {
    let state = SwimmerState {
        swims: Planar {
            position: [0.2, 0.1].into(),
            angle: 0.4,
            velocity: [1.0, -0.3].into(),
            angular_velocity: 0.7,
        },
        joint: Hinge {
            angle: 0.5,
            angular_velocity: -1.1,
        },
    };
    let input = |j: usize| SwimmerInput {
        torque: by(0.3, j == 0),
    };
    let found = Swimmer::<f64>::default().linearize(0.0, &state, &SwimmerInput { torque: 0.3 });
    let body = Swimmer::<Derived>::default();
    let at = unmoved(&state);
    hold::<_, _, SwimmerState<Derived>, 8, 1>(
        &found,
        &state,
        1e-13,
        |state| body.acceleration(derived(0.0), state, &input(9)),
        |j| body.acceleration(derived(0.0), &at, &input(j)),
    );
    // series and steps of Runge and Kutta go the same way
    let body = Swimmer::<f64>::default();
    let held = SwimmerInput { torque: 0.3 };
    let by_series = body.integrate(&state).input(held).to(0.5).unwrap();
    let method = newton_euler::integrate::DormandPrince { tolerance: 1e-12 };
    let by_steps = body
        .integrate(&state)
        .input(held)
        .method(method)
        .to(0.5)
        .unwrap();
    assert!((by_series.joint.angle - by_steps.joint.angle).abs() < 1e-10);
    assert!((by_series.swims.position - by_steps.swims.position).amax() < 1e-10);
}

// an arm on a free base: water moves with its tip, and rotors turn with its motors
rigid_system!(Diver::<T> {
    params: [water = 0.8[kg], rotor = 0.03[kg * m ^ 2]],
    inputs: [torque[N * m]],
    bodies: [
        hull {
            mass: 12[kg],
            inertia: tensor {
                xx: 1.2,
                yy: 1.4,
                zz: 0.9,
                xy: 0.05,
                yz: -0.03,
                zx: 0.02
            }[kg * m ^ 2],
            points: [bearing = (0.3, 0.1, 0)],
            forces: [added = -body(
                2[kg] * acceleration.in_body().x,
                6[kg] * acceleration.in_body().y,
                7[kg] * acceleration.in_body().z
            )],
            moments: [turned = -0.2[kg * m ^ 2] * angular_acceleration],
        },
        arm {
            mass: 2[kg],
            inertia: principal(0.04, 0.02, 0.041)[kg * m ^ 2],
            points: [root = (0, -0.3, 0), end = (0, 0.3, 0)],
        },
        hand {
            mass: 1[kg],
            inertia: principal(0.01, 0.02, 0.02)[kg * m ^ 2],
            points: [root = (-0.2, 0, 0), tip = (0.1, 0, 0.05)],
            forces: [taken = (-water * tip.acceleration()).at(tip)],
        },
    ],
    joints: [
        dives = free(hull),
        shoulder = universal(hull.bearing, arm.root, body(1, 0, 0), body(0, 0, 1)),
        elbow = revolute(arm.end, hand.root, body(0, 1, 2)),
    ],
    fields: [weight = mass * world(0, 0, -9.81[m / s ^ 2])],
    drives: [
        motor = (torque - rotor * elbow.angular_acceleration).on(elbow),
        spring = (-3[N * m] * shoulder.angle_2.sin()).on(shoulder.angle_2),
    ],
    outputs: [linearization, sensitivity],
});

fn diving() -> DiverState<f64> {
    DiverState {
        dives: Spatial {
            position: Vector3::new(0.4, -0.7, 1.1),
            attitude: UnitQuaternion::from_euler_angles(0.3, -0.9, 1.4),
            velocity: Vector3::new(1.3, 2.1, -0.6),
            angular_velocity: Vector3::new(0.5, -1.4, 0.8),
        },
        shoulder: Universal {
            angle_1: 0.4,
            angle_2: -0.8,
            angular_velocity_1: 0.3,
            angular_velocity_2: 1.2,
        },
        elbow: Hinge {
            angle: 1.1,
            angular_velocity: -2.3,
        },
    }
}

#[test]
fn water_around_an_arm_on_a_free_base() {
    let state = diving();
    let input = |j: usize| DiverInput {
        torque: by(0.7, j == 0),
    };
    let own = DiverInput { torque: 0.7 };
    let found = Diver::<f64>::default().linearize(0.0, &state, &own);
    let body = Diver::<Derived>::default();
    let at = unmoved(&state);
    hold::<_, _, DiverState<Derived>, 18, 1>(
        &found,
        &state,
        1e-12,
        |state| body.acceleration(derived(0.0), state, &input(9)),
        |j| body.acceleration(derived(0.0), &at, &input(j)),
    );
    // the balances are differentiated, with one elimination for all columns: to differentiate the
    // accelerations took 46 437 operations
    let of = |name| {
        let counted = Diver::<f64>::OPERATIONS.iter();
        let mut counted = counted.filter(|one| one.function == name);
        let counted = counted.next().expect("it was asked for");
        (counted.mul + counted.add, counted.div + counted.sqrt)
    };
    let (linearize, acceleration) = (of("linearize"), of("acceleration"));
    assert!(linearize.0 <= 13_916, "{linearize:?}");
    assert_eq!(linearize.1, acceleration.1);
}

#[test]
fn by_the_mass_of_the_water_and_the_rotor() {
    let (body, state) = (Diver::<f64>::default(), diving());
    let found = body.sensitivity(0.0, &state, &DiverInput { torque: 0.7 });
    let columns = [
        [
            found.dives_linear_by_water.as_slice(),
            found.dives_angular_by_water.as_slice(),
            found.shoulder_angular_by_water.as_slice(),
            &[found.elbow_angular_by_water],
        ]
        .concat(),
        [
            found.dives_linear_by_rotor.as_slice(),
            found.dives_angular_by_rotor.as_slice(),
            found.shoulder_angular_by_rotor.as_slice(),
            &[found.elbow_angular_by_rotor],
        ]
        .concat(),
    ];
    let accelerations = |params: Vec<Derived>, state: &_| {
        let params = Columns::read(&mut Numbers(params, 0));
        let body = Diver::<Derived>::new(params).expect("a possible body");
        let torque = derived(0.7);
        numbers(&body.acceleration(derived(0.0), state, &DiverInput { torque }))
    };
    sensitivity::hold(&body, &state, accelerations, &columns, 1e-12);
}
