//! Attitudes over any [`Scalar`].

use nalgebra::{Quaternion, Unit, UnitQuaternion, Vector3, Vector4};

use crate::numbers::scalar::{Scalar, either};

/// The attitude with body axes along world axes.
#[must_use]
pub fn identity<T: Scalar>() -> UnitQuaternion<T> {
    let [zero, one] = [T::default(), T::default().constant(1.0, 1.0)];
    unit([zero, zero, zero, one])
}

/// Like [`attitude::exp`](super::exp).
#[cfg_attr(not(unoptimized), inline(always))]
#[must_use]
pub fn exp<T: Scalar>(rotation: &Vector3<T>) -> UnitQuaternion<T> {
    let [x, y, z] = [rotation.x, rotation.y, rotation.z];
    let square = x * x + y * y + z * z;
    // for small angles, series replace divisions by the angle; the first omitted term of each sum
    // is at most 2⁻⁵³
    let small = square.less(square.constant(1e-2, 1e-2));
    // cos(θ/2) and sin(θ/2)/θ
    let [cosine, ratio] = either(small, || series(square), || closed(square));
    unit([x * ratio, y * ratio, z * ratio, cosine])
}

#[cfg_attr(not(unoptimized), inline(always))]
fn series<T: Scalar>(square: T) -> [T; 2] {
    let c = |value: u16| square.constant(f64::from(value), f32::from(value));
    let [half, quarter] = [square.constant(0.5, 0.5), square.constant(0.25, 0.25)];
    let x = quarter * square;
    [
        c(1) - x * (half - x * (c(1) / c(24) - x * (c(1) / c(720) - x / c(40320)))),
        half - x * (c(1) / c(12) - x * (c(1) / c(240) - x / c(10080))),
    ]
}

#[cfg_attr(not(unoptimized), inline(always))]
fn closed<T: Scalar>(square: T) -> [T; 2] {
    let angle = square.sqrt();
    let (sine, cosine) = (square.constant(0.5, 0.5) * angle).sin_cos();
    [cosine, sine / angle]
}

/// Like [`attitude::normalized`](super::normalized).
#[cfg_attr(not(unoptimized), inline(always))]
#[must_use]
pub fn normalized<T: Scalar>(quaternion: &Quaternion<T>) -> UnitQuaternion<T> {
    let [x, y, z, w] = components(quaternion);
    let [half, three] = [w.constant(0.5, 0.5), w.constant(3.0, 3.0)];
    let factor = half * (three - (x * x + y * y + z * z + w * w));
    unit([x * factor, y * factor, z * factor, w * factor])
}

/// Like [`attitude::turned`](super::turned).
#[cfg_attr(not(unoptimized), inline(always))]
#[must_use]
pub fn turned<T: Scalar>(attitude: &UnitQuaternion<T>, rotation: &Vector3<T>) -> UnitQuaternion<T> {
    let turn = exp(rotation);
    let ([x, y, z, w], [a, b, c, d]) = (components(attitude.as_ref()), components(turn.as_ref()));
    normalized(&quaternion([
        w * a + x * d + y * c - z * b,
        w * b - x * c + y * d + z * a,
        w * c + x * b - y * a + z * d,
        w * d - x * a - y * b - z * c,
    ]))
}

#[cfg_attr(not(unoptimized), inline(always))]
fn components<T: Scalar>(quaternion: &Quaternion<T>) -> [T; 4] {
    quaternion.coords.into()
}

#[cfg_attr(not(unoptimized), inline(always))]
fn quaternion<T: Scalar>(components: [T; 4]) -> Quaternion<T> {
    Quaternion {
        coords: components.into(),
    }
}

#[cfg_attr(not(unoptimized), inline(always))]
fn unit<T: Scalar>(components: [T; 4]) -> UnitQuaternion<T> {
    Unit::new_unchecked(quaternion(components))
}

/// Like [`attitude::kinematics`](super::kinematics).
#[cfg_attr(not(unoptimized), inline(always))]
#[must_use]
pub fn kinematics<T: Scalar>(
    attitude: &UnitQuaternion<T>,
    angular_velocity: &Vector3<T>,
) -> Quaternion<T> {
    let (q, half) = (&attitude.coords, angular_velocity.x.constant(0.5, 0.5));
    let [x, y, z, w] = [q.x, q.y, q.z, q.w];
    let [a, b, c] = [
        angular_velocity.x * half,
        angular_velocity.y * half,
        angular_velocity.z * half,
    ];
    Quaternion {
        coords: Vector4::new(
            w * a + y * c - z * b,
            w * b + z * a - x * c,
            w * c + x * b - y * a,
            -(x * a + y * b + z * c),
        ),
    }
}
