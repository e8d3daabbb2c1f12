//! The gyroscopic moment ω × Jω and the moment of the inertial forces, the completed (1.9).
//!
//! In axes fixed in the body, with J constant and positive products of inertia (`Jxy = +∫xy dm`;
//! the entries of the tensor are their negatives), the moment of the inertial forces about the
//! center of mass is
//!
//! ```text
//! M_i = -(J ω̇ + ω × Jω) = -J ω̇ + G_sq (ω_x², ω_y², ω_z²) + G_prod (ω_y ω_z, ω_z ω_x, ω_x ω_y)
//!
//!         ⎡   0    Jyz  -Jyz ⎤             ⎡ Jyy-Jzz   -Jxy      Jxz   ⎤
//! G_sq =  ⎢ -Jxz    0    Jxz ⎥    G_prod = ⎢   Jxy    Jzz-Jxx   -Jyz   ⎥
//!         ⎣  Jxy  -Jxy    0  ⎦             ⎣  -Jxz      Jyz    Jxx-Jyy ⎦
//! ```
//!
//! # The erratum of (1.9)
//!
//! The chapter "Dynamics of a rigid body" that this library follows prints (1.9) **without its
//! third term**. The matrix on the squares is right in every entry and sign, and so is `-J ω̇`; the
//! matrix on the products is missing. The printed equation is exact only where those products
//! vanish, which for a general body means rotation about one coordinate axis: the unbalanced rotor,
//! from which it may have been written. Everything else comes out wrong:
//!
//! - In principal axes it says `M_i = -J ω̇`: no gyroscopic moment at all. A free body keeps its ω,
//!   its axis cones about ω instead of the angular momentum, and nothing flips about its
//!   intermediate axis (J = (1, 2, 3) with ω = (0.01, 1, 0.01) should, with a period of 39.1 s). A
//!   heavy symmetric top moves as if it were spherical: it precesses at J₃/J₁ times its rate.
//! - It is not an equation between tensors. For J = diag(1, 2, 3), ω = (1, 1, 0) it gives zero in
//!   these axes, and (0, 0, -1), the right value, in axes rotated by 45° about z.
//! - It does work. The full gyroscopic moment never does: `ω · (ω × Jω) = 0`.
//! - Angular momentum is not conserved in space.
//!
//! The error was found by computer algebra on two routes that had to agree: the derivative of the
//! tensor times ω, and the sum of `-m r × (ω̇ × r + ω × (ω × r))` over mass points with symbolic
//! coordinates. The coefficients of the squares were those printed; the coefficients of the
//! products were not zero. `tests/mechanics/erratum.rs` pins each statement to its numbers.
//!
//! A second discrepancy is one of convention. (1.5) writes the inertia matrix with entries +`Jxy`,
//! which as a tensor means `Jxy = -∫xy dm`; (1.9) needs `Jxy = +∫xy dm`: read with (1.5), all of
//! `G_sq` changes sign. Here a product of inertia is positive (+∫xy dm), an entry of the tensor is
//! its negative, and [`InertiaTensor`] requires a choice.

use nalgebra::{Matrix3, Vector3};

use crate::mechanics::inertia::InertiaTensor;

/// The matrix on the squares of (1.9), `G_sq` of the [module](self) \[kg m²\]: body axes, to be
/// multiplied with `(ω_x², ω_y², ω_z²)`.
///
/// ```
/// use newton_euler::{gyroscopic, prelude::*};
///
/// let unbalanced = InertiaTensor::products(1.3, 1.7, 2.1, 0.12, 0.05, -0.07)?;
/// assert_eq!(gyroscopic::squares(&unbalanced)[(0, 1)], 0.05); // Jyz
/// # Ok::<(), newton_euler::inertia::InvalidInertia>(())
/// ```
#[must_use]
pub fn squares(inertia: &InertiaTensor) -> Matrix3<f64> {
    let [xy, yz, zx] = inertia.positive_products();
    Matrix3::new(0.0, yz, -yz, -zx, 0.0, zx, xy, -xy, 0.0)
}

/// The matrix on the products, missing in the printed (1.9), `G_prod` of the [module](self) \[kg
/// m²\]: body axes, to be multiplied with `(ω_y ω_z, ω_z ω_x, ω_x ω_y)`.
///
/// ```
/// use newton_euler::nalgebra::Vector3;
/// use newton_euler::{gyroscopic, prelude::*};
///
/// // In principal axes this is all there is: Euler's equations.
/// let inertia = InertiaTensor::principal(1.0, 2.0, 3.0)?;
/// assert_eq!(gyroscopic::products(&inertia).diagonal(), Vector3::new(-1.0, 2.0, -1.0));
/// # Ok::<(), newton_euler::inertia::InvalidInertia>(())
/// ```
#[must_use]
pub fn products(inertia: &InertiaTensor) -> Matrix3<f64> {
    let [xx, yy, zz] = inertia.moments();
    let [xy, yz, zx] = inertia.positive_products();
    Matrix3::new(yy - zz, -xy, zx, xy, zz - xx, -yz, -zx, yz, xx - yy)
}

/// `G(ω) = [ω]× J` \[kg m²/s\], by which `ω × Jω = G(ω) ω`; ω in body axes \[rad/s\].
///
/// ```
/// use newton_euler::nalgebra::Vector3;
/// use newton_euler::{gyroscopic, prelude::*};
///
/// let inertia = InertiaTensor::principal(1.0, 2.0, 3.0)?;
/// let w = Vector3::new(1.0, 1.0, 1.0);
/// assert_eq!(gyroscopic::matrix(&inertia, &w) * w, Vector3::new(1.0, -2.0, 1.0));
/// # Ok::<(), newton_euler::inertia::InvalidInertia>(())
/// ```
#[must_use]
pub fn matrix(inertia: &InertiaTensor, angular_velocity: &Vector3<f64>) -> Matrix3<f64> {
    angular_velocity.cross_matrix() * inertia.matrix()
}

/// The derivative of `ω × Jω` with respect to ω at ω₀, `[ω₀]× J - [Jω₀]×` \[kg m²/s\]; ω₀ in body
/// axes \[rad/s\].
///
/// ```
/// use newton_euler::nalgebra::Vector3;
/// use newton_euler::{gyroscopic, prelude::*};
///
/// let inertia = InertiaTensor::principal(1.0, 2.0, 3.0)?;
/// let about_y = gyroscopic::linearization(&inertia, &Vector3::y());
/// // equal signs: the intermediate axis is unstable
/// assert_eq!((about_y[(0, 2)], about_y[(2, 0)]), (1.0, 1.0));
/// # Ok::<(), newton_euler::inertia::InvalidInertia>(())
/// ```
#[must_use]
pub fn linearization(inertia: &InertiaTensor, angular_velocity: &Vector3<f64>) -> Matrix3<f64> {
    matrix(inertia, angular_velocity) - inertia.times(angular_velocity).cross_matrix()
}

/// The gyroscopic moment `ω × Jω` \[N m\], in body axes, as ω is \[rad/s\]. It is a term of the
/// left side of `J ω̇ + ω × Jω = K`.
///
/// It is computed as `ω × (J - λ1)ω` with `λ = Jzz`, which is equal since `ω × ω = 0`. This takes
/// two operations fewer, and keeps all digits for nearly spherical bodies.
///
/// ```
/// use newton_euler::nalgebra::Vector3;
/// use newton_euler::{gyroscopic, prelude::*};
///
/// let inertia = InertiaTensor::principal(1.0, 2.0, 3.0)?;
/// let torque = gyroscopic::torque(&inertia, &Vector3::new(1.0, 1.0, 1.0));
/// assert_eq!(torque, Vector3::new(1.0, -2.0, 1.0));
/// # Ok::<(), newton_euler::inertia::InvalidInertia>(())
/// ```
#[inline]
#[must_use]
pub fn torque(inertia: &InertiaTensor, angular_velocity: &Vector3<f64>) -> Vector3<f64> {
    let w = angular_velocity;
    let [xx, yy, zz] = inertia.moments();
    let [xy, yz, zx] = inertia.positive_products();
    let deviatoric = Vector3::new(
        (xx - zz) * w.x - xy * w.y - zx * w.z,
        (yy - zz) * w.y - xy * w.x - yz * w.z,
        -zx * w.x - yz * w.y,
    );
    w.cross(&deviatoric)
}

/// The moment of the inertial forces about G, `M_i = -(J ω̇ + ω × Jω)`, the completed (1.9) \[N
/// m\]; body axes throughout.
///
/// ```
/// use newton_euler::nalgebra::Vector3;
/// use newton_euler::{gyroscopic, prelude::*};
///
/// let inertia = InertiaTensor::products(1.3, 1.7, 2.1, 0.12, 0.05, -0.07)?;
/// let [w, dw] = [Vector3::new(1.5, -0.8, 2.2), Vector3::new(0.2, -0.3, 0.7)];
/// let moment = gyroscopic::inertial_moment(&inertia, &w, &dw);
/// assert!((moment - Vector3::new(-0.163, 2.8765, -0.784)).norm() < 1e-15);
/// # Ok::<(), newton_euler::inertia::InvalidInertia>(())
/// ```
#[inline]
#[must_use]
pub fn inertial_moment(
    inertia: &InertiaTensor,
    angular_velocity: &Vector3<f64>,
    angular_acceleration: &Vector3<f64>,
) -> Vector3<f64> {
    -(inertia.times(angular_acceleration) + torque(inertia, angular_velocity))
}
