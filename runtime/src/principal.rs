//! Principal axes of inertia, by Jacobi's method.
//!
//! Each plane rotation of the method is a rotation about a coordinate axis, so the axes accumulate as a product of unit
//! quaternions: they are right-handed and orthogonal by construction, also for repeated or nearly repeated moments.

use nalgebra::{Matrix3, Quaternion, UnitQuaternion, Vector3};

use crate::attitude;
use crate::private::math;

/// The three pairs of axes and the axis that completes each, in cyclic order.
const PLANES: [[usize; 3]; 3] = [[0, 1, 2], [1, 2, 0], [2, 0, 1]];

/// Sweeps through the three planes. Convergence is quadratic and takes four to six.
const SWEEPS: usize = 12;

/// Principal moments and axes of an inertia tensor: J = R diag(moments) Rᵀ with R the rotation of `axes`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PrincipalAxes {
    /// Principal moments, ascending \[kg m²\].
    pub moments: Vector3<f64>,
    /// Takes components along principal axes to components along the axes of the tensor; the identity if these are
    /// principal and in order. Among equal moments the axes are a choice.
    pub axes: UnitQuaternion<f64>,
}

/// The principal axes of a symmetric matrix whose entries are of order one.
pub(crate) fn diagonalized(matrix: &Matrix3<f64>) -> PrincipalAxes {
    let mut j = *matrix;
    let mut axes = Quaternion::identity();
    for _ in 0..SWEEPS {
        let mut done = true;
        for [a, b, c] in PLANES {
            // Negligible relative to the moments of this plane: what is left moves neither beyond rounding.
            let negligible = f64::EPSILON * f64::EPSILON / 64.0 * (j[(a, a)] * j[(b, b)]).abs();
            if j[(a, b)] * j[(a, b)] > negligible {
                axes *= annihilated(&mut j, [a, b, c]);
                done = false;
            }
        }
        if done {
            break;
        }
    }
    let mut moments = j.diagonal();
    for [a, b, c] in [PLANES[0], PLANES[1], PLANES[0]] {
        if moments[a] > moments[b] {
            moments.swap_rows(a, b);
            axes *= turn_about(c, 0.0, 1.0);
        }
    }
    PrincipalAxes {
        moments,
        axes: attitude::normalized(&axes),
    }
}

/// Turns axes a and b about axis c, by at most π/4, so that the entry (a, b) vanishes; returns the turn.
fn annihilated(j: &mut Matrix3<f64>, [a, b, c]: [usize; 3]) -> Quaternion<f64> {
    let product = j[(a, b)];
    let cotangent = (j[(a, a)] - j[(b, b)]) / (2.0 * product); // of twice the angle
    let tangent = f64::copysign(1.0, cotangent) / (cotangent.abs() + math::hypot(1.0, cotangent));
    let cosine = 1.0 / math::sqrt(1.0 + tangent * tangent);
    let sine = tangent * cosine;
    let [ac, bc] = [j[(a, c)], j[(b, c)]];
    j[(a, a)] += tangent * product;
    j[(b, b)] -= tangent * product;
    let mut set = |row, column, value| {
        j[(row, column)] = value;
        j[(column, row)] = value;
    };
    set(a, b, 0.0);
    set(a, c, cosine * ac + sine * bc);
    set(b, c, cosine * bc - sine * ac);
    turn_about(c, cosine, sine)
}

/// The unit quaternion of the turn about a coordinate axis with this cosine (not -1) and sine.
fn turn_about(axis: usize, cosine: f64, sine: f64) -> Quaternion<f64> {
    let norm = math::sqrt(2.0 * (1.0 + cosine));
    let mut vector = Vector3::zeros();
    vector[axis] = sine / norm;
    Quaternion::from_parts((1.0 + cosine) / norm, vector)
}
