//! The planar arm of two links: its rows in closed form, and the combinations of parameters that a
//! motion can reveal (W. Khalil, E. Dombre, "Modeling, Identification and Control of Robots",
//! chapter 9).

use nalgebra::{SMatrix, SVector};
use newton_euler::prelude::*;

use super::close;
use super::coordinates::Random;

macro_rules! arm {
    ($name:ident [$($fields:tt)*]) => {
        rigid_system!($name {
            motion: planar,
            bodies: [
                upper {
                    mass: 1.2[kg],
                    inertia: 0.04[kg * m ^ 2],
                    points: [pin = (-0.3, 0.02), end = (0.2, 0.02)],
                },
                lower { mass: 0.8[kg], inertia: 0.015[kg * m ^ 2], points: [pin = (-0.22, -0.03)] },
            ],
            joints: [shoulder = revolute(world(0, 0), upper.pin), elbow = revolute(upper.end, lower.pin)],
            fields: [$($fields)*],
            outputs: [regressor],
        });
    };
}
arm!(Upright[weight = mass * world(0, -9.81[m / s ^ 2])]);
arm!(Level []);

/// The distance between the pins.
const L: f64 = 0.5;
const G: f64 = 9.81;

#[test]
fn the_rows_are_those_of_the_textbook() {
    let mut random = Random(21);
    for _ in 0..100 {
        let mut number = || 3.0 * random.number();
        let (q, w, a) = (
            [number(), number()],
            [number(), number()],
            [number(), number()],
        );
        let state = UprightState {
            shoulder: Hinge {
                angle: q[0],
                angular_velocity: w[0],
            },
            elbow: Hinge {
                angle: q[1],
                angular_velocity: w[1],
            },
        };
        let given = UprightAcceleration {
            shoulder: a[0],
            elbow: a[1],
        };
        let rows = Upright::default().regressor(0.0, &state, &given, &());
        let (s1, c1) = q[0].sin_cos();
        let (s2, c2) = q[1].sin_cos();
        let (s12, c12) = (q[0] + q[1]).sin_cos();
        let both = a[0] + a[1];
        close(
            rows.upper.as_slice(),
            &[0.0, 0.0, G * c1, 0.0, -G * s1, 0.0, a[0], 0.0],
            1e-13,
        );
        let rate = w[1] * (2.0 * w[0] + w[1]);
        let x = [
            L * (2.0 * a[0] + a[1]) * c2 - L * rate * s2 + G * c12,
            L * (a[0] * c2 + w[0].powi(2) * s2) + G * c12,
        ];
        let y = [
            -L * (2.0 * a[0] + a[1]) * s2 - L * rate * c2 - G * s12,
            L * (w[0].powi(2) * c2 - a[0] * s2) - G * s12,
        ];
        let m = [L * L * a[0] + G * L * c1, 0.0];
        close(
            rows.lower.as_slice(),
            &[m[0], m[1], x[0], x[1], y[0], y[1], both, both],
            1e-13,
        );
    }
}

/// The squares of the rows of many random motions.
macro_rules! rows {
    ($name:ident $state:ident $acceleration:ident) => {{
        let mut random = Random(22);
        let mut all = SMatrix::<f64, 8, 8>::zeros();
        for _ in 0..40 {
            let mut joint = || Hinge {
                angle: 3.0 * random.number(),
                angular_velocity: random.number(),
            };
            let state = $state {
                shoulder: joint(),
                elbow: joint(),
            };
            let given = $acceleration {
                shoulder: random.number(),
                elbow: random.number(),
            };
            let rows = $name::default().regressor(0.0, &state, &given, &());
            let mut both = SMatrix::<f64, 2, 8>::zeros();
            both.columns_mut(0, 4).copy_from(&rows.upper);
            both.columns_mut(4, 4).copy_from(&rows.lower);
            all += both.transpose() * both;
        }
        all
    }};
}

#[test]
fn as_many_parameters_count_as_in_the_literature() {
    let upright = rows!(Upright UprightState UprightAcceleration);
    let rank = |squares: &SMatrix<f64, 8, 8>| squares.rank(1e-12 * squares.norm());
    assert_eq!(rank(&upright), 6);
    // lying in the plane, the first moment of the upper link tells nothing
    let level = rows!(Level LevelState LevelAcceleration);
    assert_eq!(rank(&level), 4);
    // the mass of the lower link counts as a point at its pin: with the first moment and the inertia
    // of the upper one less by m L and m L^2 nothing changes
    let unseen = SVector::from([0.0, -L, 0.0, -L * L, 1.0, 0.0, 0.0, 0.0]);
    assert!((upright * unseen).amax() < 1e-11);
    assert!((level * unseen).amax() < 1e-12);
}
