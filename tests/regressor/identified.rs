//! What least squares find in a simulated log: the base parameters of an arm in space.

use nalgebra::{SMatrix, SVector, Vector3};
use newton_euler::prelude::*;

rigid_system!(Arm {
    inputs: [t1[N * m], t2[N * m], t3[N * m]],
    bodies: [
        base {
            mass: 4[kg],
            inertia: principal(0.05, 0.06, 0.03)[kg * m ^ 2],
            points: [top = (0, 0, 0.2)]
        },
        upper {
            mass: 2[kg],
            inertia: principal(0.01, 0.05, 0.05)[kg * m ^ 2],
            points: [pin = (-0.25, 0, 0), end = (0.25, 0.05, 0)],
        },
        tool {
            mass: 0.9[kg],
            inertia: tensor {
                xx: 0.01,
                yy: 0.02,
                zz: 0.015,
                xy: 0.002,
                yz: -0.001,
                zx: 0.003
            }[kg * m ^ 2],
            points: [pin = (-0.2, 0.03, -0.02)],
        },
    ],
    joints: [
        pan = revolute(world(0, 0, 0), base.G, body(0, 0, 1)),
        lift = revolute(base.top, upper.pin, body(0, 1, 0)),
        roll = revolute(upper.end, tool.pin, body(1, 0, 0)),
    ],
    fields: [weight = mass * world(0, 0, -9.81[m / s ^ 2])],
    drives: [m1 = t1.on(pan), m2 = t2.on(lift), m3 = t3.on(roll)],
    outputs: [regressor],
});

type Thirty = SVector<f64, 30>;

/// Runs the arm from rest, and gives its rows and torques.
fn log(shift: f64, count: u32) -> Vec<(SMatrix<f64, 3, 30>, Vector3<f64>)> {
    let arm = Arm::default();
    let mut state = ArmState::default();
    let lines = (0..count).map(|step| {
        let time = 0.05 * f64::from(step) + shift;
        let input = ArmInput {
            t1: 0.8 * (2.0 * time).sin(),
            t2: -9.0 + 3.0 * (1.3 * time).cos() - 2.0 * state.lift.angular_velocity,
            t3: 0.2 * (2.9 * time).sin(),
        };
        let motion = arm.acceleration(0.0, &state, &input);
        let found = arm.regressor(0.0, &state, &motion, &input);
        let mut rows = SMatrix::<f64, 3, 30>::zeros();
        for (body, matrix) in [found.base, found.upper, found.tool].iter().enumerate() {
            rows.columns_mut(10 * body, 10).copy_from(matrix);
        }
        state = arm
            .integrate(&state)
            .input(input)
            .to(0.05)
            .expect("it moves");
        (rows, Vector3::new(input.t1, input.t2, input.t3))
    });
    lines.collect()
}

#[test]
fn an_arm_is_known_as_far_as_its_motion_tells() {
    let (mut squares, mut sides) = (SMatrix::<f64, 30, 30>::zeros(), Thirty::zeros());
    for (rows, torques) in log(0.0, 400) {
        squares += rows.transpose() * rows;
        sides += rows.transpose() * torques;
    }
    let least = squares
        .svd(true, true)
        .solve(&sides, 1e-11 * squares.norm());
    let least = least.expect("there are singular vectors");
    // it tells of another motion what it takes
    for (rows, torques) in log(17.0, 100) {
        assert!((rows * least - torques).amax() < 1e-7);
    }
    // of the last link these tell each by itself, and of two moments of inertia the difference
    let own = Arm::default().inertial_parameters().tool;
    let found = least.rows(20, 10);
    for number in [2, 3, 4, 7, 8, 9] {
        let (found, own) = (found[number], own[number]);
        assert!(
            (found - own).abs() < 1e-7,
            "{}: {found}",
            Arm::PARAMETERS[number]
        );
    }
    assert!((found[5] - found[6] - (own[5] - own[6])).abs() < 1e-7);
}
