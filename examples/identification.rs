//! Mass properties from a log: a craft with known thrusters flies with an unknown load on board,
//! and an instrument P in its hull records its motion.
//!
//! The equations of motion are linear in mass, first moment and inertia about P (C. Atkeson, C. An,
//! J. Hollerbach, "Estimation of inertial parameters of manipulator loads and links", 1986). Each
//! line of the log is six rows, `regressor (m, m c, J) = (force, moment)`, and least squares find
//! the ten numbers.
//!
//! Asserts: mass, center of mass and inertia are those of the craft that flew, to eight digits;
//! with instrument noise, to a corresponding accuracy. A log without turns, and one with a hole, tell
//! nothing.

use nalgebra::{SMatrix, SVector, Vector3};
use newton_euler::prelude::*;

rigid_body!(Craft {
    doc: "What flies: points are counted from the true center of mass.",
    motion: spatial,
    inputs: [push = body(_, _, _)[N], turn = body(_, _, _)[N * m]],
    mass: 41.3[kg],
    inertia: tensor {
        xx: 2.6,
        yy: 3.4,
        zz: 4.1,
        xy: -0.21,
        yz: 0.08,
        zx: 0.33
    }[kg * m ^ 2],
    points: [p = (0.12, -0.05, 0.31)],
    fields: [weight = mass * world(0, 0, -1.62[m / s ^ 2])],
    forces: [thrusters = push.at(p)],
    moments: [couples = turn],
});

rigid_body!(Hull {
    doc: "What is known: a body whose origin is the instrument, of any mass.",
    motion: spatial,
    mass: 1[kg],
    inertia: principal(1, 1, 1)[kg * m ^ 2],
    fields: [weight = mass * world(0, 0, -1.62[m / s ^ 2])],
    outputs: [regressor],
});

/// From the center of mass to the instrument; the identification does not know it.
const P: Vector3<f64> = Vector3::new(0.12, -0.05, 0.31);
const LINES: u32 = 300;

/// Force and couple of the thrusters about the instrument, body axes.
fn thrust(time: f64) -> CraftInput {
    let wave = |size: f64, rate: f64| size * (rate * time).sin();
    CraftInput {
        push: [wave(60.0, 1.1), wave(50.0, 0.7), 70.0 + wave(40.0, 1.9)].into(),
        turn: [wave(3.0, 2.3), wave(4.0, 1.7), wave(5.0, 1.3)].into(),
    }
}

/// Attitude, rates and accelerations at the instrument, at its recording times.
fn log() -> Vec<(f64, Spatial, SpatialAcceleration)> {
    let (craft, mut state, mut lines) = (Craft::default(), Spatial::default(), Vec::new());
    for line in 0..LINES {
        let time = 0.1 * f64::from(line);
        let input = thrust(time);
        let motion = craft.acceleration(time, &state, &input);
        let (w, rate) = (state.angular_velocity, motion.angular);
        let swept = rate.cross(&P) + w.cross(&w.cross(&P));
        let linear = motion.linear + state.attitude * swept;
        lines.push((
            time,
            state,
            SpatialAcceleration {
                linear,
                angular: rate,
            },
        ));
        state = craft
            .integrate(&state)
            .input(input)
            .to(0.1)
            .expect("it flies");
    }
    lines
}

/// The least part of a column that the columns before it must leave, as the sine of an angle. Noise
/// in the log is amplified by its reciprocal.
const LEAST: f64 = 1e-4;

/// Least squares, sum of Y^T Y p = sum of Y^T f; `noise` gives the error of each acceleration by
/// its place in the log. `None` if the log does not tell all ten numbers.
fn identify(
    log: impl IntoIterator<Item = (f64, Spatial, SpatialAcceleration)>,
    noise: impl Fn(u32) -> f64,
) -> Option<SVector<f64, 10>> {
    let (mut squares, mut sides) = (SMatrix::<f64, 10, 10>::zeros(), SVector::zeros());
    let mut place = 0;
    for (time, state, mut motion) in log {
        for number in motion.linear.iter_mut().chain(motion.angular.iter_mut()) {
            *number += noise(place);
            place += 1;
        }
        let rows = Hull::default().regressor(time, &state, &motion, &());
        let given = thrust(time);
        let mut loads = SVector::<f64, 6>::zeros();
        loads.fixed_rows_mut::<3>(0).copy_from(&given.push);
        loads.fixed_rows_mut::<3>(3).copy_from(&given.turn);
        squares += rows.transpose() * rows;
        sides += rows.transpose() * loads;
    }
    // columns of length one, so that units do not matter
    let size = squares.diagonal().map(f64::sqrt);
    let factor = squares
        .component_div(&(size * size.transpose()))
        .cholesky()?;
    let left = factor.l().diagonal();
    let found = factor
        .solve(&sides.component_div(&size))
        .component_div(&size);
    (left.min() > LEAST && found.iter().all(|number| number.is_finite())).then_some(found)
}

/// The log, and its evaluation with and without noise.
pub fn main() {
    let (m, c) = (41.3, -P);
    // the inertia about the instrument, by the parallel axis theorem
    let about = [
        2.6 + m * (c.y * c.y + c.z * c.z),
        3.4 + m * (c.z * c.z + c.x * c.x),
        4.1 + m * (c.x * c.x + c.y * c.y),
        -0.21 - m * c.x * c.y,
        0.08 - m * c.y * c.z,
        0.33 - m * c.z * c.x,
    ];
    let h = m * c;
    let mut flown = SVector::<f64, 10>::zeros();
    flown.copy_from_slice(&[&[m], h.as_slice(), &about].concat());

    let found = identify(log(), |_| 0.0).expect("the log tells all ten numbers");
    // a hundredth of a unit, positive and negative by an irrational step
    let noise = |place| 0.02 * ((f64::from(place) * 0.618_033_988_749_895).fract() - 0.5);
    let noisy = identify(log(), noise).expect("the log tells all ten numbers");

    // at rest, and with one reading missing
    let still = log().into_iter().map(|(time, ..)| {
        let nothing = (Spatial::default(), SpatialAcceleration::default());
        (time, nothing.0, nothing.1)
    });
    assert!(identify(still, |_| 0.0).is_none());
    let hole = |place| if place == 77 { f64::NAN } else { 0.0 };
    assert!(identify(log(), hole).is_none());

    println!(
        "about the instrument   flown      found      with noise of 1 cm/s^2 and 0.01 rad/s^2"
    );
    for (number, name) in Hull::PARAMETERS.iter().enumerate() {
        println!(
            "{name:>10} {:>18.6} {:>10.6} {:>10.4}",
            flown[number], found[number], noisy[number]
        );
        assert!((found[number] - flown[number]).abs() < 1e-7, "{name}");
        assert!((noisy[number] - flown[number]).abs() < 0.02, "{name}");
    }
    let center = found.fixed_rows::<3>(1) / found[0];
    println!(
        "center of mass from the instrument: {:.6} {:.6} {:.6} m",
        center.x, center.y, center.z
    );
    assert!((center - c).norm() < 1e-8);
}
