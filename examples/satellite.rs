//! A satellite held upright by the gravity gradient: libration in the plane of a circular orbit,
//! with the orbit and the attitude computed together.
//!
//! The potential of the Earth on a small body, to second order in its size, is -μ m / r - (μ / 2
//! r³) (tr J - 3 n · J n), with n the unit vector from the Earth, in body axes. Its force and its
//! moment 3 μ/r³ n × J n are derived. World axes are inertial; body z, with the smallest moment,
//! points away from the Earth, and body y, with the largest, is normal to the orbit.
//!
//! Asserts: the moment, against 40-digit arithmetic; twice the libration angle follows a pendulum,
//! so with J = (A, B, C) the period is that of the orbit over √(3 (A - C) / B), times 2 K(sin θ₀) /
//! π; energy and angular momentum about the Earth are conserved.

use std::f64::consts::PI;

use newton_euler::nalgebra::{UnitQuaternion, Vector3};
use newton_euler::{integrate, prelude::*};

rigid_body!(Satellite {
    doc: "A satellite in the field of a distant mass, to the second order of its size.",
    motion: spatial,
    params: [mu = 3.986004418e14[m ^ 3 / s ^ 2]],
    mass: 500[kg],
    inertia: principal(120, 150, 90)[kg * m ^ 2],
    locals: [
        distance = position.norm(),
        n = position.in_body(),
        along = n.dot(body(120 * n.x, 150 * n.y, 90 * n.z)[kg * m ^ 2]),
        trace = 360[kg * m ^ 2],
    ],
    potentials: [gravity =
        -mu * mass / distance - mu / 2 * (trace / distance.powi(3) - 3 * along / distance.powi(5)),],
    outputs: [energy, momentum, balance],
    pole: world(0, 0, 0),
});

const MU: f64 = 3.986_004_418e14;
const RADIUS: f64 = 7e6;

const AMPLITUDE: f64 = 0.2;

/// The angle from the vertical to body z, in the plane of the orbit.
fn libration(state: &Spatial) -> f64 {
    let up = state.attitude.inverse() * state.position;
    (-up.x).atan2(up.z)
}

/// `2 K(sin θ₀) / π`, by the arithmetic-geometric mean.
fn lengthening(amplitude: f64) -> f64 {
    let (mut mean, mut other) = (1.0, amplitude.cos());
    for _ in 0..8 {
        (mean, other) = (f64::midpoint(mean, other), (mean * other).sqrt());
    }
    1.0 / mean
}

fn main() {
    println!("{}\n", Satellite::EQUATIONS);
    let satellite = Satellite::default();

    let state = Spatial {
        position: Vector3::new(2.0, 1.0, 2.0) * (RADIUS / 3.0),
        ..Spatial::default()
    };
    let moment = satellite.applied(0.0, &state, &()).moment;
    println!("moment at 7000 km in the direction (2, 1, 2) / 3");
    println!(
        "  {:.15e} {:.15e} {:.15e} N m",
        moment.x, moment.y, moment.z
    );
    println!("  -4.648401653644315e-5 4.648401653644315e-5 2.324200826822157e-5 in 40 digits");

    // A circular orbit in the plane of z and x; at rest in the rotating frame, off the vertical.
    let rate = (MU / RADIUS.powi(3)).sqrt();
    let orbit = 2.0 * PI / rate;
    let expected = orbit / f64::sqrt(3.0 * (120.0 - 90.0) / 150.0) * lengthening(AMPLITUDE);
    let start = Spatial {
        position: Vector3::z() * RADIUS,
        attitude: UnitQuaternion::from_axis_angle(&Vector3::y_axis(), AMPLITUDE),
        velocity: Vector3::x() * (rate * RADIUS),
        angular_velocity: Vector3::y() * rate,
    };
    println!("\norbit {orbit:.3} s, libration of {AMPLITUDE} rad {expected:.6} s");
    let (mut state, mut time, step) = (start, 0.0, 1.0);
    let mut last = f64::NAN;
    while time < 4.0 * orbit {
        let next = integrate::cf4_step(&satellite, time, &state, &(), step);
        let (before, after) = (libration(&state), libration(&next));
        if before > 0.0 && after <= 0.0 {
            let crossing = time + step * before / (before - after);
            let since = if last.is_nan() {
                String::new()
            } else {
                format!(", {:.6} s later", crossing - last)
            };
            println!("  through the vertical at {crossing:.3} s{since}");
            last = crossing;
        }
        (state, time) = (next, time + step);
    }

    let energy = |state: &Spatial| {
        satellite.kinetic_energy(state) + satellite.potential_energy(0.0, state, &())
    };
    let about_earth = |state: &Spatial| satellite.angular_momentum_about_pole(0.0, state);
    let relative = (about_earth(&state) - about_earth(&start)).norm() / about_earth(&start).norm();
    println!("after four orbits, relative change");
    println!(
        "  energy           {:.1e}",
        energy(&state) / energy(&start) - 1.0
    );
    println!("  angular momentum {relative:.1e}");
    println!("\noperations");
    for operations in Satellite::OPERATIONS {
        println!("  {operations}");
    }
}
