//! Tensors: made from entries, made from matrices, shifted, and read.

use fastrand::Rng;
use nalgebra::{Matrix3, Vector3};
use newton_euler::inertia::InertiaTensor;
use newton_euler::state::Rotation;

use super::numbers::{all, any, beside, sane, scale};
use super::written::{assert_round_trip, read_damaged};
use super::{Verdict, compare, exact};

pub fn tensors(rng: &mut Rng) {
    let e = entries(rng);
    let verdict = exact::tensor(&e);
    let [xx, yy, zz, xy, yz, zx] = e;
    let tensor = InertiaTensor::tensor(xx, yy, zz, xy, yz, zx);
    compare(&e, verdict, &tensor);
    let products = InertiaTensor::products(xx, yy, zz, -xy, -yz, -zx);
    assert_eq!(format!("{products:?}"), format!("{tensor:?}"));
    let symmetric = Matrix3::new(xx, xy, zx, xy, yy, yz, zx, yz, zz);
    // the mean of two large entries is beyond the doubles
    let is_large = e.iter().any(|entry| entry.abs() > f64::MAX / 2.0);
    let verdict = if is_large && verdict == Verdict::Possible {
        Verdict::Marginal
    } else {
        verdict
    };
    compare(&e, verdict, &InertiaTensor::from_matrix(&symmetric));
    asymmetric(&symmetric, rng);
    if let Ok(tensor) = tensor {
        check(&tensor);
        assert_round_trip(&tensor);
        read_damaged(&tensor, check, rng);
        let _ = (
            tensor.symmetry(),
            tensor.extent(),
            tensor.principal_axes(),
            tensor.inverse(),
        );
        let attitude = Rotation::default().attitude;
        let _ = tensor.rotated(&attitude).times(&Vector3::x());
        let [mass, x, y, z] = all(rng, any);
        for shifted in [
            tensor.shifted_from_center(mass, &Vector3::new(x, y, z)),
            tensor.shifted_to_center(mass, &Vector3::new(x, y, z)),
        ] {
            assert!(
                shifted.is_err() || mass.is_finite() && mass >= 0.0,
                "a mass of {mass}"
            );
            let _ = shifted.inspect(check);
        }
    }
}

/// One entry unlike its mirror image.
fn asymmetric(symmetric: &Matrix3<f64>, rng: &mut Rng) {
    let mut matrix = *symmetric;
    let other = any(rng);
    let (row, column) = [(1, 0), (2, 1), (0, 2)][rng.usize(..3)];
    matrix[(row, column)] = other;
    let difference = (other - matrix[(column, row)]).abs();
    let largest = matrix.diagonal().amax();
    let is_far = difference.is_nan() || difference > 64.0 * f64::EPSILON * largest;
    let result = InertiaTensor::from_matrix(&matrix);
    assert!(!is_far || result.is_err(), "not symmetric: {matrix}");
}

/// Whatever its origin, it is that of a body.
fn check(tensor: &InertiaTensor) {
    let ([xx, yy, zz], [xy, yz, zx]) = (tensor.moments(), tensor.off_diagonals());
    let entries = [xx, yy, zz, xy, yz, zx];
    assert!(
        exact::tensor(&entries) != Verdict::Impossible,
        "no body has {entries:?}"
    );
}

/// Anything; that of masses at points, which is possible but for rounding; one beside a flat body.
pub fn entries(rng: &mut Rng) -> [f64; 6] {
    let scale = scale(rng);
    match rng.u8(..4) {
        0 => all(rng, any),
        1 => all::<6>(rng, sane).map(|entry| entry * scale),
        2 => {
            let [a, b] = [rng.f64() * scale, rng.f64() * scale];
            let mut moments = [a, b, beside(a + b, rng)];
            rng.shuffle(&mut moments);
            let [xx, yy, zz] = moments;
            [xx, yy, zz, 0.0, 0.0, 0.0]
        }
        _ => {
            let mut entries = [0.0; 6];
            for _ in 0..rng.u8(1..5) {
                let [m, x, y, z]: [f64; 4] = all(rng, sane);
                let m = m.abs();
                let masses = [
                    y * y + z * z,
                    z * z + x * x,
                    x * x + y * y,
                    -x * y,
                    -y * z,
                    -z * x,
                ];
                for (entry, term) in entries.iter_mut().zip(masses) {
                    *entry += m * term;
                }
            }
            entries.map(|entry| entry * scale)
        }
    }
}
