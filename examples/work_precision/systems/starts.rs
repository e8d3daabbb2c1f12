//! The states in the files of `tests/reference/systems`.

use nalgebra::{Quaternion, UnitQuaternion, Vector3};
use newton_euler::prelude::*;
use newton_euler::state::Coordinates;
use serde_json::Value;

use super::described::WheelsState;
use crate::reference::{number, numbers};

/// Positions, then rates, of a system of hinges.
pub fn swinging<S: Coordinates<Scalar = f64> + Default>(file: &Value) -> S {
    let lists = ["q", "v"].map(|key| file[key].as_array().expect("a list"));
    let numbers: Vec<f64> = lists.into_iter().flatten().map(number).collect();
    let mut list = S::default().coordinates();
    list.as_mut().copy_from_slice(&numbers);
    S::from_coordinates(&list)
}

/// A hub and its wheels; the file has its velocity in its own axes, and the scalar of its attitude last.
pub fn flying(file: &Value) -> WheelsState {
    let [px, py, pz, x, y, z, scalar, angles @ ..] = numbers::<10>(&file["q"]);
    let [u, v, w, p, q, r, rates @ ..] = numbers::<9>(&file["v"]);
    let attitude = UnitQuaternion::from_quaternion(Quaternion::new(scalar, x, y, z));
    let spin = |k: usize| Hinge {
        angle: angles[k],
        angular_velocity: rates[k],
    };
    WheelsState {
        orbit: Spatial {
            position: [px, py, pz].into(),
            attitude,
            velocity: attitude * Vector3::new(u, v, w),
            angular_velocity: [p, q, r].into(),
        },
        spin_x: spin(0),
        spin_y: spin(1),
        spin_z: spin(2),
    }
}
