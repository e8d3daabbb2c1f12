//! Systems from `MuJoCo` files, compared with the results of `MuJoCo` itself (`reference.py`).
#![allow(missing_docs)]

mod described;
mod printed;
mod projection;

use described::{
    Arm, ArmInput, Classes, ClassesInput, Coupled, CoupledInput, Linkage, Quadruped,
    QuadrupedInput, Swing,
};
use newton_euler::prelude::*;
use printed::{
    ArmPrinted, ArmPrintedInput, ClassesPrinted, ClassesPrintedInput, CoupledPrinted,
    CoupledPrintedInput, LinkagePrinted, QuadrupedPrinted, QuadrupedPrintedInput, SwingPrinted,
};
use serde::Serialize;
use serde::de::DeserializeOwned;
use serde_json::Value;

/// The numbers in a value, by their names.
fn numbers(value: &Value, path: &str, into: &mut Vec<(String, f64)>) {
    match value {
        Value::Number(number) => into.push((path.to_owned(), number.as_f64().unwrap())),
        Value::Array(parts) => {
            for (place, part) in parts.iter().enumerate() {
                numbers(part, &format!("{path}.{place}"), into);
            }
        }
        Value::Object(fields) => {
            for (name, part) in fields {
                numbers(part, &format!("{path}.{name}"), into);
            }
        }
        _ => panic!("{path} is {value}"),
    }
}

/// The motion of a body at the states of the reference, within some rounding of each.
fn compare<B>(name: &str, body: &B, input: impl Fn(&[f64]) -> B::Input) -> Vec<Value>
where
    B: RigidBody<Scalar = f64>,
    B::State: State<Acceleration: Serialize> + Serialize + DeserializeOwned,
{
    let text = std::fs::read_to_string("tests/mjcf/reference.json").unwrap();
    let whole: Value = serde_json::from_str(&text).unwrap();
    let rows = whole[name].as_array().unwrap();
    assert_eq!(rows.len(), 10);
    let mut all = Vec::new();
    for row in rows {
        let state: B::State = serde_json::from_value(row["state"].clone()).unwrap();
        let mut given = Vec::new();
        numbers(&row["input"], "", &mut given);
        let given: Vec<f64> = given.into_iter().map(|(_, value)| value).collect();
        let acceleration = body.acceleration(0.0, &state, &input(&given));
        let acceleration = serde_json::to_value(acceleration).unwrap();
        let (mut found, mut expected) = (Vec::new(), Vec::new());
        numbers(&acceleration, "", &mut found);
        numbers(&row["acceleration"], "", &mut expected);
        assert_eq!(found.len(), expected.len());
        let size = expected.iter().map(|(_, value)| value.abs());
        let size = size.fold(1.0, f64::max);
        for ((word, found), (same, expected)) in found.iter().zip(&expected) {
            assert_eq!(word, same);
            assert!(
                (found - expected).abs() < 1e-12 * size,
                "{name}{word}: {found} and {expected}, of {size}"
            );
        }
        all.push(acceleration);
    }
    all
}

/// An input, its fields in the order of the alphabet, from a list of numbers.
macro_rules! input {
    ($kind:ident { $($field:ident),* }, $given:expr) => {{
        let [$($field),*] = $given.try_into().unwrap();
        $kind { $($field),* }
    }};
}

#[test]
fn an_arm_of_all_kinds_of_geoms_and_turns() {
    // in the order of the alphabet
    let input = |given: &[f64]| (given[0], given[1]);
    let found = compare("arm", &Arm::default(), |given| {
        let (pan_motor, slip_motor) = input(given);
        ArmInput {
            pan_motor,
            slip_motor,
        }
    });
    let printed = compare("arm", &ArmPrinted::default(), |given| {
        let (pan_motor, slip_motor) = input(given);
        ArmPrintedInput {
            pan_motor,
            slip_motor,
        }
    });
    assert_eq!(found, printed);
}

#[test]
fn a_body_that_is_free_with_legs() {
    let found = compare("quadruped", &Quadruped::default(), |given| QuadrupedInput {
        motor_2: given[0],
        thigh_1_motor: given[1],
    });
    let printed = compare("quadruped", &QuadrupedPrinted::default(), |given| {
        QuadrupedPrintedInput {
            motor_2: given[0],
            thigh_1_motor: given[1],
        }
    });
    assert_eq!(found, printed);
}

#[test]
fn a_ball_joint_and_several_joints_of_one_body() {
    let found = compare("swing", &Swing::default(), |_| ());
    assert_eq!(found, compare("swing", &SwingPrinted::default(), |_| ()));
}

#[test]
fn a_loop_that_is_closed_and_a_body_that_is_welded() {
    let found = compare("linkage", &Linkage::default(), |_| ());
    assert_eq!(
        found,
        compare("linkage", &LinkagePrinted::default(), |_| ())
    );
}

#[test]
fn armatures_tendons_actuators_and_coordinates_that_follow_others() {
    macro_rules! given {
        ($kind:ident) => {
            |given: &[f64]| {
                input!(
                    $kind {
                        brake,
                        haul,
                        law,
                        pace,
                        pull,
                        push,
                        servo,
                        shift,
                        spindle,
                        squeeze,
                        still,
                        tighten,
                        turn,
                        whirl,
                        wind
                    },
                    given
                )
            }
        };
    }
    let found = compare("coupled", &Coupled::default(), given!(CoupledInput));
    let printed = CoupledPrinted::default();
    let same = compare("coupled", &printed, given!(CoupledPrintedInput));
    assert_eq!(found, same);
}

#[test]
fn classes_welds_with_poses_of_their_own_and_masses_of_some_groups() {
    macro_rules! given {
        ($kind:ident) => {
            |given: &[f64]| {
                input!(
                    $kind {
                        bare,
                        beside,
                        brake,
                        braked,
                        firm,
                        inner,
                        law,
                        loose,
                        nearest,
                        paced,
                        plain,
                        reset,
                        same,
                        servo,
                        slack,
                        strong,
                        tuned
                    },
                    given
                )
            }
        };
    }
    let found = compare("classes", &Classes::default(), given!(ClassesInput));
    let printed = ClassesPrinted::default();
    let same = compare("classes", &printed, given!(ClassesPrintedInput));
    assert_eq!(found, same);
}
