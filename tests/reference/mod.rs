//! Reads the numbers of the references.
#![allow(dead_code, reason = "each test reads its part")]

use nalgebra::{Quaternion, UnitQuaternion, Vector2, Vector3};
use serde_json::Value;

pub mod turning;

/// The statements of the theory, by name.
pub fn statement(name: &str) -> Value {
    file(include_str!("statements.json"))["statements"][name].take()
}

/// The section on the completed (1.9).
pub fn completed() -> Value {
    file(include_str!("statements.json"))["inertial_torque_1_9"].take()
}

/// A worked body, by name.
pub fn body(name: &str) -> Value {
    file(include_str!("bodies.json"))[name].take()
}

/// A trajectory, by name.
pub fn trajectory(name: &str) -> Value {
    file(include_str!("trajectories.json"))["problems"][name].take()
}

/// A flight, by name.
pub fn flight(name: &str) -> Value {
    file(include_str!("flights.json"))["problems"][name].take()
}

/// Attitudes of a free body after up to 2²⁴ s.
pub fn long_runs() -> Value {
    file(include_str!("long_runs.json"))
}

/// A problem that others have published, by name.
pub fn published(name: &str) -> Value {
    file(include_str!("published.json"))["problems"][name].take()
}

/// Andrews' squeezing mechanism.
pub fn squeezer() -> Value {
    file(include_str!("squeezer.json"))
}

/// A system of bodies, by name.
pub fn system(name: &str) -> Value {
    match name {
        "ball_double" => file(include_str!("systems/ball_double.json")),
        "cart_pole" => file(include_str!("systems/cart_pole.json")),
        "double_pendulum" => file(include_str!("systems/double_pendulum.json")),
        "furuta" => file(include_str!("systems/furuta.json")),
        "satellite3w" => file(include_str!("systems/satellite3w.json")),
        "ur5" => file(include_str!("systems/ur5.json")),
        "ur5_motion" => file(include_str!("systems/ur5_motion.json")),
        _ => panic!("no system {name}"),
    }
}

/// A number, written as one, as a decimal string or as a fraction.
pub fn number(value: &Value) -> f64 {
    match value {
        Value::Number(number) => number.as_f64().unwrap(),
        Value::String(text) => {
            let parts: Vec<f64> = text.split('/').map(|part| part.parse().unwrap()).collect();
            parts.into_iter().reduce(|a, b| a / b).unwrap()
        }
        _ => panic!("not a number: {value}"),
    }
}

/// The numbers of a list.
pub fn numbers<const N: usize>(value: &Value) -> [f64; N] {
    let list = value
        .as_array()
        .unwrap_or_else(|| panic!("not a list: {value}"));
    let numbers: Vec<f64> = list.iter().map(number).collect();
    numbers.try_into().unwrap()
}

pub fn planar(value: &Value) -> Vector2<f64> {
    numbers::<2>(value).into()
}

pub fn vector(value: &Value) -> Vector3<f64> {
    numbers::<3>(value).into()
}

/// A quaternion, scalar first.
pub fn attitude(value: &Value) -> UnitQuaternion<f64> {
    let [w, x, y, z] = numbers(value);
    UnitQuaternion::new_unchecked(Quaternion::new(w, x, y, z))
}

/// The distance of two attitudes, of which q and -q are one.
pub fn distance(a: &UnitQuaternion<f64>, b: &UnitQuaternion<f64>) -> f64 {
    let [a, b] = [a.coords, b.coords];
    (a - b).amax().min((a + b).amax())
}

fn file(text: &str) -> Value {
    serde_json::from_str(text).unwrap()
}
