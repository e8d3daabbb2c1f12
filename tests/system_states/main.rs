//! States of systems: structs with a field for each joint, moved with every method.
#![allow(clippy::float_cmp, reason = "what is exact is compared exactly")]

#[path = "../dual/mod.rs"]
mod dual;
mod lists;
mod motions;
mod scalars;
mod shown;
#[path = "../handwritten/mod.rs"]
mod systems;
mod written;

use nalgebra::{Unit, UnitQuaternion, Vector3};
use newton_euler::prelude::*;

use systems::{AssemblyState, DoublePendulumState};

/// Both arms lifted, the lower one turning.
fn lifted() -> DoublePendulumState<f64> {
    let hinge = |angle, angular_velocity| Hinge {
        angle,
        angular_velocity,
    };
    DoublePendulumState {
        shoulder: hinge(1.4, 0.0),
        elbow: hinge(-0.6, 2.5),
    }
}

/// Everything moves, and no two numbers are the same.
fn assembled() -> AssemblyState<f64> {
    let axis = Unit::new_normalize(Vector3::new(0.2, -0.5, 0.9));
    let attitude = |x, y, z| UnitQuaternion::from_scaled_axis(Vector3::new(x, y, z));
    AssemblyState {
        orbit: Spatial {
            position: [0.1, 0.2, -0.3].into(),
            attitude: attitude(0.4, -0.5, 0.6),
            velocity: [0.7, -0.8, 0.9].into(),
            angular_velocity: [1.0, -1.1, 1.2].into(),
        },
        wheel: Hinge {
            angle: 1.3,
            angular_velocity: -1.4,
        },
        ball: Rotation {
            attitude: attitude(-0.15, 0.25, 0.35),
            angular_velocity: [0.45, 0.55, -0.65].into(),
        },
        slide: Slide {
            position: 1.5,
            velocity: -1.6,
        },
        piston: Cylinder {
            position: 1.7,
            angle: 1.8,
            velocity: -1.9,
            angular_velocity: 2.0,
        },
        gimbal: Universal {
            angle_1: 2.1,
            angle_2: 2.2,
            angular_velocity_1: -2.3,
            angular_velocity_2: 2.4,
        },
        raft: Planar {
            position: [2.5, 2.6].into(),
            angle: 2.7,
            velocity: [-2.8, 2.9].into(),
            angular_velocity: 3.0,
        },
        load: Translation {
            position: [3.1, -3.2, 3.3].into(),
            velocity: [3.4, 3.5, -3.6].into(),
        },
        tray: PlanarTranslation {
            position: [3.7, 3.8].into(),
            velocity: [-3.9, 4.0].into(),
        },
        needle: Rod {
            position: [4.1, 4.2, 4.3].into(),
            velocity: [-4.4, 4.5, 4.6].into(),
            axis,
            axis_rate: axis.cross(&Vector3::new(4.7, 4.8, 4.9)),
        },
    }
}
