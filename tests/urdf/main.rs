//! Systems from URDF files, compared with the same systems by hand, and with another reader of the
//! files.
#![allow(missing_docs)]

mod described;
mod mimics;
mod oracle;
mod printed;
mod round_trip;

use std::collections::HashMap;

use described::{
    Arm, ArmByHand, ArmByHandInput, ArmByHandState, ArmInput, ArmState, Gripper, GripperByHand,
    GripperByHandParams, GripperByHandState, GripperParams, GripperState, Quadruped,
    QuadrupedInput, QuadrupedState, Sensor, SensorState,
};
use nalgebra::{Matrix3, UnitQuaternion, Vector3};
use newton_euler::prelude::*;
use oracle::{Moving, Robot};

const GRAVITY: Vector3<f64> = Vector3::new(0.0, 0.0, -9.81);

/// Numbers between -1 and 1 that look random, the same in each run.
struct Random(u64);

impl Random {
    #[allow(clippy::cast_precision_loss, reason = "53 bits are kept")]
    fn number(&mut self) -> f64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        (self.0 >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
    }

    fn vector(&mut self) -> Vector3<f64> {
        [self.number(), self.number(), self.number()].into()
    }

    fn hinge(&mut self) -> Hinge {
        Hinge {
            angle: 3.0 * self.number(),
            angular_velocity: 4.0 * self.number(),
        }
    }

    fn slide(&mut self) -> Slide {
        Slide {
            position: 0.3 * self.number(),
            velocity: 2.0 * self.number(),
        }
    }
}

fn close(found: &[f64], expected: &[f64]) {
    let size = expected
        .iter()
        .fold(0.0_f64, |size, one| size.max(one.abs()));
    for (found, expected) in found.iter().zip(expected) {
        assert!(
            (found - expected).abs() <= 1e-13 * size,
            "{found} and {expected}, of {size}"
        );
    }
}

fn no_loads(loads: &[(f64, f64)]) {
    assert!(!loads.is_empty());
    for (load, size) in loads {
        assert!(load.abs() <= 1e-13 * size, "{load} of {size}");
    }
}

fn of_hinge(state: Hinge, second: f64) -> [f64; 3] {
    [state.angle, state.angular_velocity, second]
}

fn of_slide(state: Slide, second: f64) -> [f64; 3] {
    [state.position, state.velocity, second]
}

#[test]
fn an_arm_moves_as_one_by_hand_and_as_the_laws_say() {
    let robot = Robot::read("tests/urdf/arm.urdf");
    let (arm, by_hand) = (Arm::default(), ArmByHand::default());
    let mut random = Random(17);
    for _ in 0..200 {
        let (shoulder, elbow, telescope, wrist) = (
            random.hinge(),
            random.hinge(),
            random.slide(),
            random.hinge(),
        );
        let state = ArmState {
            shoulder,
            elbow,
            telescope,
            wrist,
        };
        let same = ArmByHandState {
            shoulder,
            elbow,
            telescope,
            wrist,
        };
        let found = arm.acceleration(0.0, &state, &ArmInput { torque: 1.3 });
        let expected = by_hand.acceleration(0.0, &same, &ArmByHandInput { torque: 1.3 });
        close(
            &[found.shoulder, found.elbow, found.telescope, found.wrist],
            &[
                expected.shoulder,
                expected.elbow,
                expected.telescope,
                expected.wrist,
            ],
        );
        let rates = HashMap::from([
            ("shoulder", of_hinge(shoulder, found.shoulder)),
            ("elbow", of_hinge(elbow, found.elbow)),
            ("telescope", of_slide(telescope, found.telescope)),
            ("wrist", of_hinge(wrist, found.wrist)),
        ]);
        let mut loads = robot.loads(Moving::ground(), false, &rates, (GRAVITY, &[]));
        loads[1].0 -= 1.3;
        loads[1].1 += 1.3;
        no_loads(&loads);
        let energies = (arm.kinetic_energy(&state), by_hand.kinetic_energy(&same));
        close(&[energies.0], &[energies.1]);
    }
}

#[test]
fn joints_are_held_where_they_are_locked() {
    let gripper = Gripper::new(GripperParams { tilt: 0.35 }).unwrap();
    let by_hand = GripperByHand::new(GripperByHandParams { tilt: 0.35 }).unwrap();
    let robot = Robot::read("tests/urdf/gripper.urdf");
    let mut random = Random(23);
    for _ in 0..200 {
        let (carriage_joint, turn, finger_1) = (random.slide(), random.hinge(), random.slide());
        let state = GripperState {
            carriage_joint,
            turn,
            finger_1,
        };
        let same = GripperByHandState {
            carriage_joint,
            turn,
            finger_1,
        };
        let found = gripper.acceleration(0.0, &state, &());
        let expected = by_hand.acceleration(0.0, &same, &());
        close(
            &[found.carriage_joint, found.turn, found.finger_1],
            &[expected.carriage_joint, expected.turn, expected.finger_1],
        );
        let rates = HashMap::from([
            ("carriage", of_slide(carriage_joint, found.carriage_joint)),
            ("turn", of_hinge(turn, found.turn)),
            ("finger.1", of_slide(finger_1, found.finger_1)),
            ("finger.2", [0.015, 0.0, 0.0]),
            ("tool_tilt", [0.35, 0.0, 0.0]),
        ]);
        let mut loads = robot.loads(Moving::ground(), false, &rates, (GRAVITY, &[]));
        // those that are locked are loaded
        loads.truncate(3);
        no_loads(&loads);
    }
}

#[test]
fn a_quadruped_floats_and_carries_what_is_added() {
    let mut robot = Robot::read("tests/urdf/quadruped.urdf");
    let handle = Vector3::new(0.0, 0.0, 0.1);
    robot.add_ball("trunk", handle, 2.0, 0.1);
    let quadruped = Quadruped::default();
    let input = QuadrupedInput { push: 7.0 };
    let mut random = Random(29);
    for _ in 0..100 {
        let mut joints = || random.hinge();
        let state = QuadrupedState {
            front_left_hip: joints(),
            front_left_knee: joints(),
            front_right_hip: joints(),
            front_right_knee: joints(),
            hind_left_hip: joints(),
            hind_left_knee: joints(),
            hind_right_hip: joints(),
            hind_right_knee: joints(),
            root: Spatial {
                position: random.vector(),
                velocity: random.vector(),
                attitude: UnitQuaternion::from_scaled_axis(3.0 * random.vector()),
                angular_velocity: 2.0 * random.vector(),
            },
        };
        let found = quadruped.acceleration(0.0, &state, &input);
        let rates = HashMap::from([
            (
                "front_left_hip",
                of_hinge(state.front_left_hip, found.front_left_hip),
            ),
            (
                "front_left_knee",
                of_hinge(state.front_left_knee, found.front_left_knee),
            ),
            (
                "front_right_hip",
                of_hinge(state.front_right_hip, found.front_right_hip),
            ),
            (
                "front_right_knee",
                of_hinge(state.front_right_knee, found.front_right_knee),
            ),
            (
                "hind_left_hip",
                of_hinge(state.hind_left_hip, found.hind_left_hip),
            ),
            (
                "hind_left_knee",
                of_hinge(state.hind_left_knee, found.hind_left_knee),
            ),
            (
                "hind_right_hip",
                of_hinge(state.hind_right_hip, found.hind_right_hip),
            ),
            (
                "hind_right_knee",
                of_hinge(state.hind_right_knee, found.hind_right_knee),
            ),
        ]);
        // `base` is a frame: its G is its origin
        let axes = state.root.attitude.to_rotation_matrix();
        let base = Moving {
            axes,
            place: state.root.position,
            w: axes * state.root.angular_velocity,
            v: state.root.velocity,
            turning: axes * found.root.angular,
            a: found.root.linear,
        };
        let motions = robot.motions(base, &rates);
        let place = |name: &str| motions[robot.number(name)].place;
        let [start, end] = ["front_left_foot", "hind_right_foot"];
        let cord = 3.0 * (place(end) - place(start)).normalize();
        let on_trunk = place("trunk") + motions[robot.number("trunk")].axes * handle;
        let pushes = [
            (start.to_owned(), place(start), cord),
            (end.to_owned(), place(end), -cord),
            ("trunk".to_owned(), on_trunk, Vector3::new(7.0, 0.0, 0.0)),
        ];
        no_loads(&robot.loads(base, true, &rates, (GRAVITY, &pushes)));
    }
}

#[test]
fn links_get_mass_beside_the_file() {
    let mut robot = Robot::read("tests/urdf/sensor.urdf");
    let inertia = Matrix3::from_diagonal(&Vector3::new(1e-4, 2e-4, 1.5e-4));
    robot.give("camera", 0.2, inertia);
    robot.give(
        "plate",
        0.1,
        Matrix3::identity() * (0.4 * 0.1 * 0.03 * 0.03),
    );
    let (sensor, mut random) = (Sensor::default(), Random(31));
    for _ in 0..100 {
        let (rail, turn) = (random.slide(), random.hinge());
        let (pan, tilt) = (random.hinge(), random.hinge());
        let state = SensorState {
            rail,
            turn,
            pan,
            tilt,
        };
        let found = sensor.acceleration(0.0, &state, &());
        let rates = HashMap::from([
            ("rail", of_slide(rail, found.rail)),
            ("turn", of_hinge(turn, found.turn)),
            ("pan", of_hinge(pan, found.pan)),
            ("tilt", of_hinge(tilt, found.tilt)),
        ]);
        no_loads(&robot.loads(Moving::ground(), false, &rates, (GRAVITY, &[])));
    }
}

#[test]
fn a_file_says_what_is_made_of_it() {
    let skipped = Arm::SKIPPED.join("\n");
    for part in [
        "`<limit>` of 1 joint in",
        "`<dynamics>` of 1 joint in",
        "<visual>",
        "<transmission>",
    ] {
        assert!(skipped.contains(part), "{part}:\n{skipped}");
    }
}
