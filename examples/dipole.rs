//! An electric dipole on a thin rod in a uniform field: it swings about the field like a pendulum,
//! and does not fall.
//!
//! Charges ±q are at the ends of the rod, which lies along body x; the field is along world x.
//! Without a net charge there is no force; the couple p × E is the same about every point. World z
//! is up; there is no weight.
//!
//! Asserts: the couple is p E sin θ; the period is 4 K(sin θ₀ / 2) √(J / p E), from elliptic
//! integrals; energy is conserved; a second pair of charges that cancels the dipole leaves nothing.

use std::f64::consts::PI;

use newton_euler::nalgebra::{UnitQuaternion, Vector3};
use newton_euler::{integrate, prelude::*};

rigid_body!(Dipole {
    doc: "Two opposite charges on a rod, in a uniform field.",
    motion: spatial,
    params: [charge = 2[uC], half = 5[cm], strength = 40[kV / m]],
    mass: 10[g],
    inertia: principal(2, 8, 8)[mg * m ^ 2],
    points: [front = (half, 0, 0), back = (-half, 0, 0)],
    fields: [electric = world(strength, 0, 0).on([charge.at(front), -charge.at(back)])],
    outputs: [energy, balance],
});

pub(crate) mod canceled {
    newton_euler::rigid_body!(Quadrupole {
        doc: "A second pair of charges, turned the other way: neither charge nor dipole is left.",
        motion: spatial,
        mass: 10[g],
        inertia: principal(2, 8, 8)[mg * m ^ 2],
        points: [
            front = (5, 0, 0)[cm],
            back = (-5, 0, 0)[cm],
            left = (5, 3, 0)[cm],
            right = (-5, 3, 0)[cm],
        ],
        fields: [electric = world(40, -3, 2)[kV / m].on([
            2[uC].at(front),
            -2[uC].at(back),
            -2[uC].at(left),
            2[uC].at(right),
        ]),],
    });
}

/// `4 K(k) √(J / p E)` with k = sin(θ₀ / 2), K by the arithmetic-geometric mean.
fn period(amplitude: f64, stiffness: f64) -> f64 {
    let (mut mean, mut other) = (1.0, (amplitude / 2.0).cos());
    for _ in 0..8 {
        (mean, other) = (f64::midpoint(mean, other), (mean * other).sqrt());
    }
    2.0 * PI / mean / stiffness.sqrt()
}

fn main() {
    println!("{}\n", Dipole::EQUATIONS);
    for line in Dipole::SKIPPED {
        println!("  skipped: {line}");
    }

    let dipole = Dipole::default();
    let amplitude = 2.0_f64;
    let start = Spatial {
        attitude: UnitQuaternion::from_axis_angle(&Vector3::z_axis(), amplitude),
        ..Spatial::default()
    };
    let (moment, inertia) = (2e-6 * 0.1 * 40e3, 8e-6);
    let wrench = dipole.applied(0.0, &start, &());
    println!("\nturned by {amplitude} rad from the field");
    println!(
        "  force {:.1e} N, couple {:.9e} N m",
        wrench.force.norm(),
        wrench.moment.z
    );
    println!(
        "  -p E sin θ =              {:.9e} N m",
        -moment * amplitude.sin()
    );

    // Released, it swings through the field and comes to rest on the other side: half a period.
    let expected = period(amplitude, moment / inertia);
    let (mut state, mut time, step) = (start, 0.0, expected / 20_000.0);
    let mut last = f64::NAN;
    println!("\nreleased: period {expected:.12} s by elliptic integrals");
    for _ in 0..45_000 {
        let next = integrate::cf4_step(&dipole, time, &state, &(), step);
        if state.angular_velocity.z > 0.0 && next.angular_velocity.z <= 0.0 && time > step {
            // at rest within this step: Newton's method
            let mut ahead = 0.5 * step;
            for _ in 0..4 {
                let there = integrate::cf4_step(&dipole, time, &state, &(), ahead);
                let rate = dipole.acceleration(time, &there, &()).angular.z;
                ahead -= there.angular_velocity.z / rate;
            }
            let turn = time + ahead;
            println!("  back after {turn:.12} s, {:.1e} off", {
                let before = if last.is_nan() { 0.0 } else { last };
                turn - before - expected
            });
            last = turn;
        }
        (state, time) = (next, time + step);
    }
    let energy =
        |state: &Spatial| dipole.kinetic_energy(state) + dipole.potential_energy(0.0, state, &());
    println!(
        "  energy {:.15} J, it was {:.15} J",
        energy(&state),
        energy(&start)
    );
    println!("  G has moved {:.1e} m", state.position.norm());

    println!("\nwith a second pair against the first:");
    for line in canceled::Quadrupole::EQUATIONS.lines() {
        println!("  {line}");
    }
}
