//! F08 and F09: one body whose inertia is described in many forms, and one in axes that make it
//! diagonal.
#![allow(clippy::float_cmp, reason = "what is exact is compared exactly")]

use nalgebra::{Matrix3, Quaternion, UnitQuaternion, Vector3};
use newton_euler::prelude::*;
use proptest::prelude::*;

/// Mass points \[kg, m\] whose center of mass is the origin.
const POINTS: [(f64, [f64; 3]); 4] = [
    (0.5, [0.3, -0.2, 0.1]),
    (0.25, [-0.4, 0.2, 0.2]),
    (0.5, [0.1, 0.1, -0.3]),
    (0.25, [-0.4, 0.0, 0.2]),
];

/// The body of these points in many words.
mod words {
    newton_euler::rigid_body!(Tensor {
        motion: rotation,
        inputs: [k = body(_, _, _)],
        inertia: tensor {
            xx: 0.105,
            yy: 0.2,
            zz: 0.165,
            xy: 0.045,
            yz: 0.015,
            zx: 0.04
        },
        moments: [twist = k],
        outputs: [momentum, energy],
    });

    newton_euler::rigid_body!(Products {
        motion: rotation,
        inputs: [k = body(_, _, _)],
        inertia: products {
            xx: 0.105,
            yy: 0.2,
            zz: 0.165,
            xy: -0.045,
            yz: -0.015,
            zx: -0.04
        }[kg * m ^ 2],
        moments: [twist = k],
        outputs: [momentum, energy],
    });

    newton_euler::rigid_body!(Grams {
        motion: rotation,
        inputs: [k = body(_, _, _)],
        inertia: tensor {
            xx: 105,
            yy: 200,
            zz: 165,
            xy: 45,
            yz: 15,
            zx: 40
        }[g * m ^ 2],
        moments: [twist = k],
        outputs: [momentum, energy],
    });

    newton_euler::rigid_body!(About {
        motion: rotation,
        inputs: [k = body(_, _, _)],
        mass: 1.5[kg],
        points: [p = (0.2, -0.1, 0.4)],
        inertia: tensor {
            xx: 0.36,
            yy: 0.5,
            zz: 0.24,
            xy: 0.075,
            yz: 0.075,
            zx: -0.08
        }
        .about(p),
        moments: [twist = k],
        outputs: [momentum, energy],
    });

    newton_euler::rigid_body!(Parametric {
        motion: rotation,
        params: [
            m = 1.5,
            p = body(0.2, -0.1, 0.4),
            xx = 0.36,
            yy = 0.5,
            zz = 0.24,
            xy = -0.075,
            yz = -0.075,
            zx = 0.08,
        ],
        inputs: [k = body(_, _, _)],
        mass: m,
        inertia: products {
            xx: xx,
            yy: yy,
            zz: zz,
            xy: xy,
            yz: yz,
            zx: zx
        }
        .about(p),
        moments: [twist = k],
        outputs: [momentum, energy],
    });
}

/// A body by its principal moments, and in axes turned by the quaternion (0.1, 0.5, 0.5, 0.7).
mod axes {
    newton_euler::rigid_body!(Own {
        motion: rotation,
        inputs: [k = body(_, _, _)],
        inertia: principal(0.2, 0.3, 0.4),
        moments: [twist = k],
    });

    newton_euler::rigid_body!(Turned {
        motion: rotation,
        inputs: [k = body(_, _, _)],
        inertia: tensor {
            xx: 0.34096,
            yy: 0.29504,
            zz: 0.264,
            xy: 0.07872,
            yz: -0.0384,
            zx: 0.0288,
        },
        moments: [twist = k],
    });

    newton_euler::rigid_body!(Symmetric {
        motion: rotation,
        inputs: [k = body(_, _, _)],
        inertia: principal(0.2, 0.2, 0.4),
        moments: [twist = k],
    });

    newton_euler::rigid_body!(Spherical {
        motion: rotation,
        inputs: [k = body(_, _, _)],
        inertia: principal(0.3, 0.3, 0.3),
        moments: [twist = k],
    });
}

fn some_vector() -> impl Strategy<Value = Vector3<f64>> {
    prop::array::uniform3(-3.0..3.0).prop_map(Vector3::from)
}

fn some_attitude() -> impl Strategy<Value = UnitQuaternion<f64>> {
    some_vector().prop_map(UnitQuaternion::from_scaled_axis)
}

/// The angular acceleration of rigidly joined points under a moment: Σ m r × (ω̇ × r + ω × (ω × r)) = K.
fn from_points(w: &Vector3<f64>, k: &Vector3<f64>) -> Vector3<f64> {
    let points = POINTS.map(|(m, r)| (m, Vector3::from(r)));
    let moment = |alpha: &Vector3<f64>, w: &Vector3<f64>| -> Vector3<f64> {
        let sum = points
            .iter()
            .map(|(m, r)| r.cross(&(alpha.cross(r) + w.cross(&w.cross(r)))) * *m);
        sum.sum()
    };
    let still = Vector3::zeros();
    // The sum is linear in ω̇: its matrix, column by column.
    let columns = [Vector3::x(), Vector3::y(), Vector3::z()].map(|axis| moment(&axis, &still));
    Matrix3::from_columns(&columns).try_inverse().unwrap() * (k - moment(&still, w))
}

/// Angular momentum and twice the kinetic energy of the points, axes of the body.
fn momentum_of_points(w: &Vector3<f64>) -> (Vector3<f64>, f64) {
    let points = POINTS.map(|(m, r)| (m, Vector3::from(r)));
    let momentum = points.iter().map(|(m, r)| r.cross(&w.cross(r)) * *m).sum();
    let energy = points
        .iter()
        .map(|(m, r)| m * w.cross(r).norm_squared())
        .sum();
    (momentum, energy)
}

fn is(computed: &Vector3<f64>, expected: &Vector3<f64>, tolerance: f64) {
    let error = (computed - expected).amax();
    assert!(
        error <= tolerance,
        "{computed} is not {expected}: off by {error:e}"
    );
}

proptest! {
    #[test]
    fn f08_all_words_mean_the_sum_over_points(
        attitude in some_attitude(),
        w in some_vector(),
        k in some_vector(),
    ) {
        let state = Rotation { attitude, angular_velocity: w };
        let expected = from_points(&w, &k);
        let (momentum, energy) = momentum_of_points(&w);
        let accelerations = [
            words::Tensor {}.acceleration(0.0, &state, &words::TensorInput { k }),
            words::Products {}.acceleration(0.0, &state, &words::ProductsInput { k }),
            words::Grams {}.acceleration(0.0, &state, &words::GramsInput { k }),
            words::About {}.acceleration(0.0, &state, &words::AboutInput { k }),
            words::Parametric::default().acceleration(0.0, &state, &words::ParametricInput { k }),
        ];
        for computed in accelerations {
            // The smallest moment is 0.07: terms up to (3 + 27 · 0.2) / 0.07 = 120, condition 4, some thirty roundings.
            is(&computed, &expected, 120.0 * 1e-14);
        }
        let momenta = [
            words::Tensor {}.angular_momentum(&state),
            words::Products {}.angular_momentum(&state),
            words::Grams {}.angular_momentum(&state),
            words::About {}.angular_momentum(&state),
            words::Parametric::default().angular_momentum(&state),
        ];
        for computed in momenta {
            is(&computed, &(attitude * momentum), 1e-14); // terms below 1, some twenty roundings
        }
        let energies = [
            words::Tensor {}.kinetic_energy(&state),
            words::Products {}.kinetic_energy(&state),
            words::Grams {}.kinetic_energy(&state),
            words::About {}.kinetic_energy(&state),
            words::Parametric::default().kinetic_energy(&state),
        ];
        for computed in energies {
            prop_assert!((2.0 * computed - energy).abs() <= 1e-14 * 5.0); // terms to 27 · 0.2
        }
    }

    #[test]
    fn f09_axes_do_not_matter(w in some_vector(), k in some_vector()) {
        // Components in the body's own axes: u; in the described ones: R u.
        let turn = UnitQuaternion::new_unchecked(Quaternion::new(0.1, 0.5, 0.5, 0.7));
        let own = Rotation { angular_velocity: w, ..Rotation::default() };
        let own = axes::Own {}.acceleration(0.0, &own, &axes::OwnInput { k });
        let turned = Rotation { angular_velocity: turn * w, ..Rotation::default() };
        let turned = axes::Turned {}.acceleration(0.0, &turned, &axes::TurnedInput { k: turn * k });
        // Terms up to (3 + 27 · 0.2) / 0.2 = 42, condition 2, some thirty roundings; the quaternion is unit to 1 ulp.
        is(&turned, &(turn * own), 42.0 * 1e-14);
        // Euler's equations
        let euler = Vector3::new(
            (k.x + (0.3 - 0.4) * w.y * w.z) / 0.2,
            (k.y + (0.4 - 0.2) * w.z * w.x) / 0.3,
            (k.z + (0.2 - 0.3) * w.x * w.y) / 0.4,
        );
        is(&own, &euler, 42.0 * 1e-15);
    }

    #[test]
    fn f09_equal_moments(w in some_vector(), k in some_vector()) {
        let state = Rotation { angular_velocity: w, ..Rotation::default() };
        let symmetric = axes::Symmetric {}.acceleration(0.0, &state, &axes::SymmetricInput { k });
        let spherical = axes::Spherical {}.acceleration(0.0, &state, &axes::SphericalInput { k });
        let [j, none] = [Vector3::new(0.2, 0.2, 0.4), Vector3::zeros()];
        let euler = (k - w.cross(&j.component_mul(&w))).component_div(&j);
        // Terms up to (3 + 18 · 0.4) / 0.2 = 51, a dozen roundings.
        is(&symmetric, &euler, 51.0 * 2e-15);
        is(&spherical, &(k / 0.3), 10.0 * 4e-16); // 1 / 0.3 and the product are rounded once each
        // Nothing turns the axial rate, or a spherical body: exact zeros.
        let free = axes::Symmetric {}.acceleration(0.0, &state, &axes::SymmetricInput { k: none });
        prop_assert_eq!(free.z, 0.0);
        let free = axes::Spherical {}.acceleration(0.0, &state, &axes::SphericalInput { k: none });
        prop_assert_eq!(free, none);
    }
}

rigid_body!(TwiceTurned {
    motion: rotation,
    inputs: [torque = body(_, _, _)[N * m]],
    inertia: principal(1, 2, 2.5)[kg * m ^ 2]
        .turned(body(0, 0, 1), 90[deg])
        .turned(body(1, 0, 0), 90[deg]),
    moments: [drive = torque],
});

/// The second axis is not rotated by the first rotation: x and y are exchanged, then y and z.
#[test]
fn rotations_of_an_inertia_are_about_axes_of_the_body() {
    let input = TwiceTurnedInput {
        torque: [2.0, 2.5, 1.0].into(),
    };
    let found = TwiceTurned::default().acceleration(0.0, &Rotation::default(), &input);
    assert!((found - Vector3::repeat(1.0)).norm() < 1e-15);
}
