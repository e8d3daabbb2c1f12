//! H19: closed forms after a long time.

use dashu_ratio::RBig;
use nalgebra::{Quaternion, Vector3};
use newton_euler::exact::Path;
use newton_euler::prelude::*;
use newton_euler::top::SymmetricTop;

use crate::exact::{self, Real, ULP, decimal, rational, real, worse};
use crate::table::Record;

rigid_body!(Disc {
    motion: rotation,
    inertia: principal(1, 1, 0.5)[kg * m ^ 2],
    outputs: [flow],
});

rigid_body!(Handle {
    motion: rotation,
    inertia: principal(1, 2, 3)[kg * m ^ 2],
    outputs: [flow],
});

rigid_body!(Pendulum {
    motion: pivot(pin),
    mass: 1[kg],
    inertia: 0,
    points: [pin = (0, 1)[m]],
    fields: [weight = mass * world(0, -1[m / s ^ 2])],
    outputs: [flow],
});

const TIME: f64 = 1e9;

/// Of (33.4), (33.5): `q = exp(n M/I₁ t) exp(e₃ M₃ (1/I₃ - 1/I₁) t)`, from the attitude of identity.
fn exact_attitude(w: &Vector3<f64>) -> [Real; 4] {
    let momentum = [real(w.x), real(w.y), real(w.z) / real(2.0)];
    let square = momentum.iter().fold(real(0.0), |sum, m| sum + m * m);
    let magnitude = square.sqrt();
    let half_time = real(TIME) / real(2.0);
    let precessed = &magnitude * &half_time;
    let spun = &momentum[2] * &half_time; // 1/I₃ - 1/I₁ = 1
    let (s, c) = (precessed.sin(), precessed.cos());
    let [x, y, z] = momentum.map(|m| m / &magnitude * &s);
    let (sine, cosine) = (spun.sin(), spun.cos());
    [
        &c * &cosine - &z * &sine,
        &x * &cosine + &y * &sine,
        &y * &cosine - &x * &sine,
        &z * &cosine + &c * &sine,
    ]
}

/// The distance to q or -q, whichever is nearer.
fn distance(found: &Quaternion<f64>, exact: &[Real; 4]) -> f64 {
    let components = [found.w, found.i, found.j, found.k];
    let size = |sign: f64| {
        let errors = components
            .iter()
            .zip(exact)
            .map(|(x, e)| (real(sign * x) - e).to_f64().value().abs());
        errors.fold(0.0, worse)
    };
    size(1.0).min(size(-1.0))
}

/// Rates and phases in doubles.
fn straightforward(w: &Vector3<f64>) -> Quaternion<f64> {
    let momentum = Vector3::new(w.x, w.y, 0.5 * w.z);
    let rate = momentum.norm();
    let (sine, cosine) = (0.5 * rate * TIME).sin_cos();
    let precessed = Quaternion::from_parts(cosine, momentum / rate * sine);
    let (sine, cosine) = (0.5 * momentum.z * TIME).sin_cos();
    precessed * Quaternion::from_parts(cosine, Vector3::z() * sine)
}

pub fn long_times() -> Vec<Record> {
    let w = Vector3::new(0.3, -0.7, 1.1);
    let exact = exact_attitude(&w);
    let turned = w.norm() * TIME * ULP;
    let plain = distance(&straightforward(&w), &exact) / turned;
    let start = Rotation {
        angular_velocity: w,
        ..Rotation::default()
    };
    let written = Disc {}.flow(&start, TIME).attitude;
    let top = SymmetricTop::new(1.0, 0.5).expect("a body").free(&start);
    vec![
        Record::holds("symmetric, macro", plain)
            .ours(distance(written.quaternion(), &exact) / turned, 1.0),
        Record::holds("symmetric, runtime, `SymmetricTop`", plain).ours(
            distance(top.at(TIME).attitude.quaternion(), &exact) / turned,
            1.0,
        ),
        handle(),
        pendulum(),
    ]
}

/// The number of periods next to 1e9 s, the double next to their end, and by how much that is late.
fn periods(period: &RBig) -> (RBig, f64, f64) {
    let count = (rational(TIME) / period).round();
    let time = RBig::from(count.clone()) * period;
    let nearest = exact::nearest(&time);
    let late = exact::nearest(&(rational(nearest) - time));
    (RBig::from(count), nearest, late)
}

/// After a whole number of periods the rates are again what they were, but for what is left of the time.
fn handle() -> Record {
    let start = Rotation {
        angular_velocity: Vector3::new(0.01, 1.0, 0.01),
        ..Rotation::default()
    };
    // the period, by 40-digit arithmetic
    let (count, time, late) = periods(&decimal("39.105734197268720854"));
    let path = Handle {}.path(&start);
    let error = (path.at(time).angular_velocity - path.at(late).angular_velocity).amax();
    let turned = start.angular_velocity.norm() * time * ULP;
    Record::alone(format!("of three moments, after {count} periods, macro"))
        .ours(error / turned, 1.0)
}

/// A rate of 1 rad/s, from rest at 2.5 rad: the period is 4 K(sin 1.25) = 2π / agm(1, cos 1.25).
fn pendulum() -> Record {
    let start = Hinge {
        angle: 2.5,
        angular_velocity: 0.0,
    };
    let (mut a, mut b) = (real(1.0), real(1.25).cos());
    for _ in 0..10 {
        (a, b) = ((&a + &b) / real(2.0), (&a * &b).sqrt());
    }
    // 2π = 12 asin(1/2)
    let period = real(12.0) * real(0.5).asin() / a;
    let (count, time, late) = periods(&RBig::try_from(period).expect("a finite number"));
    let path = Pendulum {}.path(&start);
    let error = (path.at(time).angle - path.at(late).angle).abs();
    Record::alone(format!("pendulum, after {count} periods, macro")).ours(error / (time * ULP), 1.0)
}
