//! Alternatives that one might use, timed next to generated code: see README.md.

#[allow(dead_code)]
#[path = "../../acceleration/bodies.rs"]
mod bodies;
#[allow(dead_code)]
#[path = "../../acceleration/by_hand.rs"]
mod by_hand;
#[path = "../../measure/clock.rs"]
mod clock;
mod differential_equations;
#[allow(dead_code)]
#[path = "../../acceleration/pair.rs"]
mod pair;
#[allow(dead_code)]
#[path = "../../acceleration/paired.rs"]
mod paired;
mod rapier;
#[allow(dead_code)]
#[path = "../../acceleration/table.rs"]
mod table;
mod wrenfold;

use nalgebra::{UnitQuaternion, Vector3};
use newton_euler::prelude::*;

use table::Table;

fn main() {
    let mut table = Table::default();
    wrenfold::measure(&mut table);
    differential_equations::measure(&mut table);
    rapier::measure(&mut table);
    println!("\n{table}");
}

/// A state that depends on x.
fn state(x: f64) -> Spatial {
    Spatial {
        attitude: UnitQuaternion::from_euler_angles(x, 2.0 * x, 3.0 * x),
        angular_velocity: Vector3::new(x.sin(), x.cos(), (2.0 * x).sin()),
        ..Spatial::default()
    }
}

/// The distance of two states: the largest difference in m, m/s, rad and rad/s.
fn distance(one: &Spatial, other: &Spatial) -> f64 {
    (one.position - other.position)
        .norm()
        .max((one.velocity - other.velocity).norm())
        .max(one.attitude.angle_to(&other.attitude))
        .max((one.angular_velocity - other.angular_velocity).norm())
}
