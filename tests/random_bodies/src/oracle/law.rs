//! The balances (1.3) and (1.4) of a body in a state.

use crate::description::body::Motion;
use crate::wide::Wide;

use super::constants::{Constants, multiplied};
use super::loads::Wrench;
use super::number::Number;
use super::scene::Scene;
use super::vector::{Vector, cross, dot};

/// Second derivatives of the coordinates: of G in world axes, and the angular one in body axes; of a hinge or in the plane
/// along the axis; of a rod that of its axis.
#[derive(Clone, Copy)]
pub struct Motions {
    pub linear: Vector,
    pub angular: Vector,
}

pub fn without(a: &Wrench, b: &Wrench) -> Wrench {
    Wrench {
        force: a.force - b.force,
        about_center: a.about_center - b.about_center,
        about_held: a.about_held - b.about_held,
    }
}

/// `ω × J ω`, body axes, of the tensor about the point that is held, and the size of its terms.
fn gyroscopic(scene: &Scene<'_>) -> Vector {
    let inertia = &scene.constants.inertia;
    let w = scene.in_body(scene.angular_velocity);
    Vector {
        value: cross(w.value, multiplied(&inertia.value, w.value)),
        size: w.size * inertia.size * w.size,
    }
}

pub fn acceleration(scene: &Scene<'_>, loads: &Wrench) -> Motions {
    let constants = scene.constants;
    let linear = || loads.force.over(constants.mass);
    match &constants.body.motion {
        Motion::Translation | Motion::PlanarTranslation => Motions {
            linear: linear(),
            angular: Vector::ZERO,
        },
        Motion::Spatial => Motions {
            linear: linear(),
            angular: euler(scene, loads.about_center),
        },
        Motion::Rotation => Motions {
            linear: Vector::ZERO,
            angular: euler(scene, loads.about_center),
        },
        Motion::Planar => Motions {
            linear: linear(),
            angular: Vector::scalar(loads.about_center.component(2) / constants.tensor[2][2]),
        },
        Motion::FixedPoint(_) => about_held(scene, euler(scene, loads.about_held)),
        Motion::Pivot(_) | Motion::FixedAxis(..) => {
            let axis = Vector {
                value: constants.direction,
                size: 1.0,
            };
            let moment = axis.dot(loads.about_held);
            let about_axis = dot(axis.value, multiplied(&constants.inertia.value, axis.value));
            let about_axis =
                Number::made(about_axis, constants.inertia.size, constants.inertia.known);
            about_held(scene, Vector::scalar(moment / about_axis))
        }
        Motion::Rod(_) => {
            let (axis, rate) = rod(scene);
            let turning = loads.about_center.cross(axis).over(constants.across());
            Motions {
                linear: linear(),
                angular: turning - axis.scaled(rate.dot(rate)),
            }
        }
    }
}

/// Euler's equations, `J⁻¹ (K - ω × J ω)`, body axes.
fn euler(scene: &Scene<'_>, moment: Vector) -> Vector {
    let inertia = &scene.constants.inertia;
    let right = scene.in_body(moment) - gyroscopic(scene);
    let value = multiplied(&inertia.inverse, right.value);
    let mut size = right.size;
    if !inertia.known {
        // an inverse made at run time is right to the condition of the tensor
        let length = Vector { value, size }.length().high;
        size = size.max(inertia.size * length);
    }
    Vector {
        value,
        size: inertia.inverse_size * size,
    }
}

fn rod(scene: &Scene<'_>) -> (Vector, Vector) {
    (scene.axis, scene.axis_rate)
}

/// The angular acceleration in world axes.
pub fn angular_in_world(scene: &Scene<'_>, angular: Vector) -> Vector {
    let constants = scene.constants;
    match constants.body.motion {
        Motion::Pivot(_) | Motion::FixedAxis(..) | Motion::Planar => {
            let axis = Vector {
                value: constants.direction,
                size: 1.0,
            };
            let along = Number::made(angular.value[0], angular.size, false);
            axis.scaled(along)
        }
        Motion::Rod(_) => rod(scene).0.cross(angular),
        _ => scene.turned(angular),
    }
}

/// With the acceleration of G about the point that is held.
fn about_held(scene: &Scene<'_>, angular: Vector) -> Motions {
    let arm = scene.fixed_in_body(scene.constants.held_to_center);
    let w = scene.angular_velocity;
    let linear = angular_in_world(scene, angular).cross(arm) + w.cross(w.cross(arm));
    Motions { linear, angular }
}

/// A motion that is given: exact numbers.
pub fn given_motion(scene: &Scene<'_>, numbers: &[f64]) -> Motions {
    let numbers: Vec<Number> = numbers.iter().map(|x| Number::given(*x)).collect();
    motion_of(scene, &numbers)
}

/// The motion with these coordinates.
pub fn motion_of(scene: &Scene<'_>, numbers: &[Number]) -> Motions {
    let three = |from: usize| Vector::new([numbers[from], numbers[from + 1], numbers[from + 2]]);
    let two = || Vector::new([numbers[0], numbers[1], Number::ZERO]);
    let zero = Vector::ZERO;
    let (linear, angular) = match scene.constants.body.motion {
        Motion::Spatial | Motion::Rod(_) => (three(0), three(3)),
        Motion::Translation => (three(0), zero),
        Motion::PlanarTranslation => (two(), zero),
        Motion::Planar => (two(), Vector::scalar(numbers[2])),
        Motion::Rotation => (zero, three(0)),
        Motion::FixedPoint(_) => return about_held(scene, three(0)),
        Motion::Pivot(_) | Motion::FixedAxis(..) => {
            return about_held(scene, Vector::scalar(numbers[0]));
        }
    };
    Motions { linear, angular }
}

/// `m a_G`, and the change of the angular momentum about G and about the point that is held, world axes.
pub fn inertial(scene: &Scene<'_>, motions: &Motions) -> Wrench {
    let constants = scene.constants;
    let force = motions.linear.scaled(constants.mass);
    let tensor = constants.tensor.map(|row| row.map(|entry| entry.value));
    let entries = constants.tensor.iter().flatten();
    let size = entries
        .map(|entry| entry.span().powi(2))
        .sum::<f64>()
        .sqrt();
    let angular = angular_in_world(scene, motions.angular);
    let w = scene.angular_velocity;
    let about_center = match constants.body.motion {
        Motion::Rod(_) => angular.scaled(constants.across()),
        Motion::Translation | Motion::PlanarTranslation => Vector::ZERO,
        Motion::Planar | Motion::Pivot(_) => angular.scaled(constants.tensor[2][2]),
        _ => {
            let [rate, spin] = [angular, w].map(|vector| {
                let inner = multiplied(&tensor, scene.in_body(vector).value);
                scene.turned(Vector {
                    value: inner,
                    size: size * vector.size,
                })
            });
            rate + w.cross(spin)
        }
    };
    let arm = scene.fixed_in_body(constants.held_to_center);
    Wrench {
        force,
        about_center,
        about_held: about_center + arm.cross(force),
    }
}

/// Angular momentum about G, world axes.
pub fn spin(scene: &Scene<'_>) -> Vector {
    let constants = scene.constants;
    let w = scene.angular_velocity;
    match constants.body.motion {
        Motion::Rod(_) => w.scaled(constants.across()),
        Motion::Planar | Motion::Pivot(_) => w.scaled(constants.tensor[2][2]),
        Motion::Translation | Motion::PlanarTranslation => Vector::ZERO,
        _ => {
            let tensor = constants.tensor.map(|row| row.map(|entry| entry.value));
            let entries = constants.tensor.iter().flatten();
            let size = entries
                .map(|entry| entry.span().powi(2))
                .sum::<f64>()
                .sqrt();
            let inner = multiplied(&tensor, scene.in_body(w).value);
            scene.turned(Vector {
                value: inner,
                size: size * w.size,
            })
        }
    }
}

pub fn kinetic_energy(scene: &Scene<'_>) -> Number {
    let half = Number::known(Wide::from(0.5));
    let v = scene.velocity;
    half * (scene.constants.mass * v.dot(v) + scene.angular_velocity.dot(spin(scene)))
}

/// The tensor of the balance of moments, body axes, and its size.
pub fn gyration(constants: &Constants<'_>) -> ([[Wide; 3]; 3], f64) {
    (constants.inertia.value, constants.inertia.size)
}
