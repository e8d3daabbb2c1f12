//! H16: tops that pass through the vertical.

use nalgebra::{Vector2, Vector3};
use newton_euler::exact::Path;
use newton_euler::integrate::{Classical4, Fixed};
use newton_euler::prelude::*;

use crate::exact::worse;
use crate::runge_kutta;
use crate::table::Record;

rigid_body!(Top {
    motion: fixed_point(tip),
    mass: 0.4[kg],
    inertia: principal(0.0021, 0.0021, 0.0009),
    points: [tip = (0, 0, -0.06)[m]],
    fields: [weight = mass * world(0, 0, -9.80665[m / s ^ 2])],
    outputs: [energy, flow, taylor],
});

/// About the tip.
const ACROSS: f64 = 0.0021 + 0.4 * 0.06 * 0.06;
const ALONG: f64 = 0.0009;
const TORQUE: f64 = 0.4 * 0.06 * 9.80665;

/// The energy of a top by Euler's angles, `θ'' = sin θ cos θ φ'² - J₃ ω₃/J₁ sin θ φ' + m g l/J₁ sin θ` with
/// `φ' = (p_φ - p_ψ cos θ)/(J₁ sin² θ)`, in steps of the classical Runge-Kutta method; its change relative to m g l.
fn by_angles(tilt: f64, tilting: f64, spin: f64, count: u32, h: f64) -> f64 {
    let momentum = ALONG * spin; // about both axes, as it has to be for a top that passes through the vertical
    let precession = |tilt: f64| (momentum - momentum * tilt.cos()) / (ACROSS * tilt.sin().powi(2));
    let rate = |state: &Vector2<f64>| {
        let [tilt, tilting] = (*state).into();
        let (sine, cosine, turning) = (tilt.sin(), tilt.cos(), precession(tilt));
        let turned = cosine * turning * turning - momentum / ACROSS * turning + TORQUE / ACROSS;
        Vector2::new(tilting, sine * turned)
    };
    let energy = |state: &Vector2<f64>| {
        let [tilt, tilting] = (*state).into();
        let across = tilting.powi(2) + (precession(tilt) * tilt.sin()).powi(2);
        0.5 * ACROSS * across + TORQUE * tilt.cos()
    };
    let start = Vector2::new(tilt, tilting);
    let (mut state, mut worst) = (start, 0.0);
    for _ in 0..count {
        state = runge_kutta::step(rate, state, h);
        worst = worse(worst, ((energy(&state) - energy(&start)) / TORQUE).abs());
    }
    worst
}

fn upright(spin: f64) -> Rotation {
    Rotation {
        angular_velocity: Vector3::new(3.0, 0.0, spin),
        ..Rotation::default()
    }
}

/// The largest changes of the energy over m g l, by all three ways to integrate, of a top that is upright after a second.
fn changes(start: &Rotation) -> [f64; 3] {
    let top = Top {};
    let energy =
        |state: &Rotation| top.kinetic_energy(state) + top.potential_energy(0.0, state, &());
    let all = energy(start);
    let change = |state: &Rotation| ((energy(state) - all) / TORQUE).abs();
    let method = Fixed {
        method: Classical4,
        step: 1e-4,
    };
    let path = top.path(start);
    let height = (path.at(1.0).attitude * Vector3::z()).z;
    assert!((height - 1.0).abs() < 1e-14, "it is upright");
    let largest = |changes: &mut dyn Iterator<Item = f64>| changes.fold(0.0, worse);
    [
        largest(
            &mut top
                .integrate(start)
                .tolerance(1e-15)
                .steps(10.0)
                .map(|step| change(&step.expect("a motion").state)),
        ),
        largest(
            &mut top
                .integrate(start)
                .method(method)
                .steps(2.0)
                .map(|step| change(&step.expect("a motion").state)),
        ),
        largest(&mut (0..=2000_u32).map(|k| change(&path.at(f64::from(k) * 0.005)))),
    ]
}

/// The same by Euler's angles, from upright and past it.
fn changes_by_angles(start: &Rotation, spin: f64) -> [f64; 2] {
    let axis = start.attitude * Vector3::z();
    let rate = (start.attitude * start.angular_velocity).cross(&axis);
    let tilt = axis.z.acos();
    [
        by_angles(0.0, 3.0, spin, 10, 1e-4),
        by_angles(tilt, -rate.z / tilt.sin(), spin, 20_000, 1e-4),
    ]
}

pub fn through_the_vertical() -> Vec<Record> {
    let mut records = Vec::new();
    for spin in [0.0, 20.0] {
        let start = Top {}.flow(&upright(spin), -1.0);
        let [series, fourth, closed] = changes(&start);
        let [from_upright, past] = changes_by_angles(&start, spin);
        let of = format!("spin {spin} rad/s");
        records.extend([
            Record::fails(
                format!("`TaylorSeries`, {of}, beside Euler's angles from upright"),
                from_upright,
                1.0,
            )
            .ours(series, 1e-12),
            Record::holds(
                format!("`Fixed<Classical4>`, {of}, beside Euler's angles past it"),
                past,
            )
            .ours(fourth, 1e-12),
            Record::alone(format!("closed form, {of}")).ours(closed, 1e-12),
        ]);
    }
    records
}
