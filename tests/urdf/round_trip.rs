//! The text printed for a file, compiled again, gives the same system: with the same names in its
//! state, and the same accelerations bit for bit.

use newton_euler::prelude::*;
use serde::Serialize;
use serde::de::DeserializeOwned;
use serde_json::Value;

use crate::Random;
use crate::described::{Arm, ArmInput, Gripper, GripperParams, Quadruped, QuadrupedInput, Sensor};
use crate::printed::{
    ArmPrinted, ArmPrintedInput, GripperPrinted, GripperPrintedParams, QuadrupedPrinted,
    QuadrupedPrintedInput, SensorPrinted,
};

/// Other numbers in the place of all.
fn shaken(value: &mut Value, random: &mut Random) {
    match value {
        Value::Number(_) => *value = Value::from(random.number()),
        Value::Array(parts) => parts.iter_mut().for_each(|part| shaken(part, random)),
        Value::Object(fields) => {
            fields.values_mut().for_each(|part| shaken(part, random));
            fields.get_mut("attitude").map(normalize);
        }
        _ => {}
    }
}

fn normalize(attitude: &mut Value) {
    let parts: Vec<&mut Value> = match attitude {
        Value::Array(parts) => parts.iter_mut().collect(),
        Value::Object(parts) => parts.values_mut().collect(),
        _ => panic!("{attitude} is no attitude"),
    };
    assert_eq!(parts.len(), 4);
    let squares = parts.iter().filter_map(|part| part.as_f64());
    let size = squares.map(|part| part * part).sum::<f64>().sqrt();
    for part in parts {
        *part = Value::from(part.as_f64().unwrap_or(f64::NAN) / size);
    }
}

fn compare<A, B>((first, input): (&A, &A::Input), (second, same): (&B, &B::Input))
where
    A: RigidBody<Scalar = f64>,
    A::State: State<Acceleration: Serialize> + Default + Serialize + DeserializeOwned,
    B: RigidBody<Scalar = f64>,
    B::State: State<Acceleration: Serialize> + Serialize + DeserializeOwned,
{
    let mut random = Random(31);
    let mut value = serde_json::to_value(A::State::default()).unwrap();
    for _ in 0..100 {
        shaken(&mut value, &mut random);
        let state: A::State = serde_json::from_value(value.clone()).unwrap();
        let twin: B::State = serde_json::from_value(value.clone()).unwrap();
        assert_eq!(
            serde_json::to_value(&state).unwrap(),
            serde_json::to_value(&twin).unwrap()
        );
        let found = serde_json::to_value(first.acceleration(0.0, &state, input)).unwrap();
        let expected = serde_json::to_value(second.acceleration(0.0, &twin, same)).unwrap();
        assert_eq!(found, expected);
        assert!(!found.to_string().contains("null"), "{found}");
    }
}

#[test]
fn what_is_printed_moves_as_the_file() {
    compare(
        (&Arm::default(), &ArmInput { torque: 0.7 }),
        (&ArmPrinted::default(), &ArmPrintedInput { torque: 0.7 }),
    );
    compare(
        (&Gripper::new(GripperParams { tilt: 0.35 }).unwrap(), &()),
        (
            &GripperPrinted::new(GripperPrintedParams { tilt: 0.35 }).unwrap(),
            &(),
        ),
    );
    compare(
        (&Quadruped::default(), &QuadrupedInput { push: 3.0 }),
        (
            &QuadrupedPrinted::default(),
            &QuadrupedPrintedInput { push: 3.0 },
        ),
    );
    compare((&Sensor::default(), &()), (&SensorPrinted::default(), &()));
}
