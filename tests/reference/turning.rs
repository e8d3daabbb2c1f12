//! Bodies that rotate in space, from a start to a known end: how far a result is from this end, and
//! how far errors of the inputs may move it.

use nalgebra::{Quaternion, UnitQuaternion, Vector3};
use newton_euler::state::Rotation;
use serde_json::Value;

use super::{attitude, distance, file, number, numbers, vector};

/// A start and its end, of a body with N numbers of inertia.
pub struct Turning<const N: usize> {
    pub name: String,
    pub moments: [f64; N],
    /// What turns it, if anything does: a torque, a couple.
    pub drive: f64,
    /// The axis of symmetry in the body, and the direction of the couple in the world.
    pub axes: [Vector3<f64>; 2],
    pub start: Rotation,
    pub time: f64,
    pub end: Rotation,
}

/// A body without a moment.
pub fn free() -> Vec<Turning<3>> {
    read(include_str!("free_rotation.json"), None)
}

/// A top under a couple.
pub fn tops() -> Vec<Turning<2>> {
    read(include_str!("heavy_top.json"), Some("couple"))
}

/// A body under a torque along its axis.
pub fn axial_torques() -> Vec<Turning<2>> {
    read(include_str!("axial_torque.json"), Some("torque"))
}

fn read<const N: usize>(text: &str, drive: Option<&str>) -> Vec<Turning<N>> {
    let list = file(text);
    let read = |case: &Value| Turning {
        name: case.to_string(),
        moments: numbers(&case["moments"]),
        drive: drive.map_or(0.0, |name| number(&case[name])),
        axes: ["axis", "up"].map(|name| case.get(name).map_or(Vector3::z(), vector)),
        start: Rotation {
            attitude: attitude(&case["attitude"]),
            angular_velocity: vector(&case["angular_velocity"]),
        },
        time: number(&case["time"]),
        end: Rotation {
            attitude: attitude(&case["end_attitude"]),
            angular_velocity: vector(&case["end_angular_velocity"]),
        },
    };
    list.as_array().unwrap().iter().map(read).collect()
}

/// The larger of the errors of attitude and relative angular velocity.
pub fn error(state: &Rotation, expected: &Rotation) -> f64 {
    let rates = (state.angular_velocity - expected.angular_velocity).amax();
    let size = expected.angular_velocity.norm();
    distance(&state.attitude, &expected.attitude).max(if size > 0.0 { rates / size } else { rates })
}

impl<const N: usize> Turning<N> {
    /// By how much the end moves if one input moves by one unit in its last place.
    pub fn effect_of_one_ulp(&self, end: impl Fn([f64; N], f64, &Rotation) -> Rotation) -> f64 {
        let base = end(self.moments, self.drive, &self.start);
        let step = 1e-9;
        let mut worst: f64 = 0.0;
        let mut moved = |moments, drive, start| {
            worst = worst.max(error(&end(moments, drive, &start), &base));
        };
        for factor in [1.0 + step, 1.0 - step] {
            for k in 0..N {
                let mut moments = self.moments;
                moments[k] *= factor;
                moved(moments, self.drive, self.start);
            }
            moved(self.moments, self.drive * factor, self.start);
            for k in 0..3 {
                let mut start = self.start;
                start.angular_velocity[k] *= factor;
                moved(self.moments, self.drive, start);
            }
            for k in 0..4 {
                let mut coords = self.start.attitude.coords;
                coords[k] *= factor;
                let attitude = UnitQuaternion::new_normalize(Quaternion::from(coords));
                let start = Rotation {
                    attitude,
                    ..self.start
                };
                moved(self.moments, self.drive, start);
            }
        }
        worst / step * f64::EPSILON
    }
}
