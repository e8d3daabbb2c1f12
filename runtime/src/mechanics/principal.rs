//! Principal axes of inertia, by Jacobi's method.
//!
//! Each plane rotation of the method is a rotation about a coordinate axis, so the axes accumulate
//! as a product of unit quaternions: they are right-handed and orthogonal by construction, also for
//! repeated or nearly repeated moments.

use nalgebra::{Matrix3, Quaternion, UnitQuaternion, Vector3};

use crate::mechanics::attitude;
use crate::numbers::math;

/// The number of sweeps through the three planes. Convergence is quadratic and takes four to six.
const SWEEPS: usize = 12;

/// Principal moments and axes of an inertia tensor: J = R diag(moments) Rᵀ with R the rotation of
/// `axes`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PrincipalAxes {
    /// Principal moments, ascending \[kg m²\].
    pub moments: Vector3<f64>,
    /// Takes components along principal axes to components along the axes of the tensor; the
    /// identity if these are principal and in order. For equal moments the axes are arbitrary.
    pub axes: UnitQuaternion<f64>,
}

/// The principal axes of a symmetric matrix whose entries are of order one.
pub(crate) fn diagonalized(matrix: &Matrix3<f64>) -> PrincipalAxes {
    let mut j = *matrix;
    let mut axes = Quaternion::identity();
    for _ in 0..SWEEPS {
        let turns = [
            annihilated::<0, 1, 2>(&mut j),
            annihilated::<1, 2, 0>(&mut j),
            annihilated::<2, 0, 1>(&mut j),
        ];
        if turns == [None; 3] {
            break;
        }
        turns.iter().flatten().for_each(|turn| axes *= turn);
    }
    let mut moments = j.diagonal();
    ascending::<0, 1, 2>(&mut moments, &mut axes);
    ascending::<1, 2, 0>(&mut moments, &mut axes);
    ascending::<0, 1, 2>(&mut moments, &mut axes);
    PrincipalAxes {
        moments,
        axes: attitude::normalized(&axes),
    }
}

/// Rotates axes A and B about axis C, by at most π/4, so that the entry (A, B) vanishes; returns
/// the rotation, if one is needed.
fn annihilated<const A: usize, const B: usize, const C: usize>(
    j: &mut Matrix3<f64>,
) -> Option<Quaternion<f64>> {
    let product = j[(A, B)];
    // relative to the moments of this plane: what is left changes neither beyond rounding
    let negligible = f64::EPSILON * f64::EPSILON / 64.0 * (j[(A, A)] * j[(B, B)]).abs();
    let is_there = product * product > negligible;
    if !is_there {
        return None;
    }
    let cotangent = (j[(A, A)] - j[(B, B)]) / (2.0 * product); // of twice the angle
    let tangent = f64::copysign(1.0, cotangent) / (cotangent.abs() + math::hypot(1.0, cotangent));
    let cosine = 1.0 / math::sqrt(1.0 + tangent * tangent);
    let sine = tangent * cosine;
    let [ac, bc] = [j[(A, C)], j[(B, C)]];
    j[(A, A)] += tangent * product;
    j[(B, B)] -= tangent * product;
    let mut set = |row, column, value| {
        j[(row, column)] = value;
        j[(column, row)] = value;
    };
    set(A, B, 0.0);
    set(A, C, cosine * ac + sine * bc);
    set(B, C, cosine * bc - sine * ac);
    Some(turn_about::<C>(cosine, sine))
}

/// Exchanges axes A and B, by a rotation about axis C, if their moments are not in order.
fn ascending<const A: usize, const B: usize, const C: usize>(
    moments: &mut Vector3<f64>,
    axes: &mut Quaternion<f64>,
) {
    if moments[A] > moments[B] {
        moments.swap_rows(A, B);
        *axes *= turn_about::<C>(0.0, 1.0);
    }
}

/// The unit quaternion of the rotation about a coordinate axis with this cosine (not -1) and sine.
fn turn_about<const AXIS: usize>(cosine: f64, sine: f64) -> Quaternion<f64> {
    let norm = math::sqrt(2.0 * (1.0 + cosine));
    let mut vector = Vector3::zeros();
    vector[AXIS] = sine / norm;
    Quaternion::from_parts((1.0 + cosine) / norm, vector)
}
