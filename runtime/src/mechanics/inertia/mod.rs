//! The inertia tensor of a possible body.
//!
//! Two conventions for off-diagonal entries are in use, and published numbers seldom say which one
//! they follow. A *product of inertia* here is `Jxy = +∫xy dm`; the *entry of the tensor* is its
//! negative. [`InertiaTensor::products`] takes the former, [`InertiaTensor::tensor`] the latter;
//! there is no default.
//!
//! A body with these moments exists iff J is symmetric and `½ tr(J) 1 - J = ∫ r rᵀ dm` is positive
//! semidefinite. Then in every frame no moment exceeds the sum of the other two, and `|Jxy|` is at
//! most half of `Jzz`. Equality holds for a plane body. It is allowed, up to rounding:
//! [`InertiaTensor::SLACK`].

use nalgebra::{Matrix3, UnitQuaternion, Vector3};

use crate::mechanics::principal::{PrincipalAxes, diagonalized};

mod invalid;
mod matrix;
#[cfg(feature = "stl")]
mod mesh;
mod points;
#[cfg(feature = "serde")]
mod serialized;
mod shape;

use matrix::{exponent, of_second_moments, scaled, symmetrized};

pub use invalid::InvalidInertia;
pub(crate) use invalid::{check_swinging, check_turning};
#[cfg(feature = "stl")]
pub use mesh::InvalidMesh;
pub use points::MassProperties;
pub use shape::{Extent, Symmetry};

/// The inertia tensor about a point of the body, in body axes \[kg m²\].
///
/// ```
/// use newton_euler::inertia::{InertiaTensor, InvalidInertia};
///
/// assert!(InertiaTensor::principal(1.0, 2.0, 3.0).is_ok()); // a plane body
/// assert_eq!(
///     InertiaTensor::principal(1.0, 1.0, 2.5),
///     Err(InvalidInertia::Triangle { axis: "z", moment: 2.5, others: 2.0 }),
/// );
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct InertiaTensor {
    matrix: Matrix3<f64>,
}

impl InertiaTensor {
    /// The largest relative rounding of a principal moment: four units in the last place of the
    /// largest one. It is four times as much if there are products, since entries in rotated axes
    /// carry more rounding.
    pub const SLACK: f64 = invalid::SLACK;

    /// Principal moments along the body axes.
    ///
    /// # Errors
    /// The violated condition, as for all constructors.
    ///
    /// ```
    /// use newton_euler::inertia::InertiaTensor;
    ///
    /// let quadrotor = InertiaTensor::principal(0.0123, 0.0123, 0.0224)?;
    /// # Ok::<(), newton_euler::inertia::InvalidInertia>(())
    /// ```
    pub fn principal(xx: f64, yy: f64, zz: f64) -> Result<Self, InvalidInertia> {
        Self::tensor(xx, yy, zz, 0.0, 0.0, 0.0)
    }

    /// The entries of the tensor: off the diagonal, xy is -∫xy dm.
    ///
    /// # Errors
    /// The violated condition.
    ///
    /// ```
    /// use newton_euler::inertia::InertiaTensor;
    ///
    /// let inertia = InertiaTensor::tensor(1.3, 1.7, 2.1, -0.12, -0.05, 0.07)?;
    /// assert_eq!(inertia, InertiaTensor::products(1.3, 1.7, 2.1, 0.12, 0.05, -0.07)?);
    /// # Ok::<(), newton_euler::inertia::InvalidInertia>(())
    /// ```
    pub fn tensor(
        xx: f64,
        yy: f64,
        zz: f64,
        xy: f64,
        yz: f64,
        zx: f64,
    ) -> Result<Self, InvalidInertia> {
        let matrix = Matrix3::new(xx, xy, zx, xy, yy, yz, zx, yz, zz);
        invalid::check(&matrix)?;
        Ok(Self { matrix })
    }

    /// Moments and positive products of inertia: xy is +∫xy dm, the convention of (1.9).
    ///
    /// # Errors
    /// The violated condition.
    ///
    /// ```
    /// use newton_euler::inertia::InertiaTensor;
    ///
    /// let inertia = InertiaTensor::products(1.3, 1.7, 2.1, 0.12, 0.05, -0.07)?;
    /// assert_eq!(inertia.matrix()[(0, 1)], -0.12);
    /// # Ok::<(), newton_euler::inertia::InvalidInertia>(())
    /// ```
    pub fn products(
        xx: f64,
        yy: f64,
        zz: f64,
        xy: f64,
        yz: f64,
        zx: f64,
    ) -> Result<Self, InvalidInertia> {
        Self::tensor(xx, yy, zz, -xy, -yz, -zx)
    }

    /// The entries xx, yy, zz, xy, yz, zx of a tensor that was already checked.
    pub(crate) fn checked([xx, yy, zz, xy, yz, zx]: [f64; 6]) -> Self {
        Self {
            matrix: Matrix3::new(xx, xy, zx, xy, yy, yz, zx, yz, zz),
        }
    }

    /// The matrix of the tensor. Opposite entries may differ by [`Self::SLACK`] of the largest
    /// moment; their mean is taken.
    ///
    /// # Errors
    /// The violated condition, symmetry among them.
    ///
    /// ```
    /// use newton_euler::inertia::InertiaTensor;
    /// use newton_euler::nalgebra::Matrix3;
    ///
    /// let ball = InertiaTensor::from_matrix(&(Matrix3::identity() * 0.4))?;
    /// assert_eq!(ball, InertiaTensor::principal(0.4, 0.4, 0.4)?);
    /// # Ok::<(), newton_euler::inertia::InvalidInertia>(())
    /// ```
    pub fn from_matrix(matrix: &Matrix3<f64>) -> Result<Self, InvalidInertia> {
        invalid::check_symmetry(matrix)?;
        let matrix = symmetrized(matrix);
        invalid::check(&matrix)?;
        Ok(Self { matrix })
    }

    /// The matrix of the tensor.
    #[inline]
    #[must_use]
    pub const fn matrix(&self) -> Matrix3<f64> {
        self.matrix
    }

    /// The moments xx, yy, zz.
    #[inline]
    #[must_use]
    pub fn moments(&self) -> [f64; 3] {
        self.matrix.diagonal().into()
    }

    /// The entries xy, yz, zx of the tensor, which are -∫xy dm and so on.
    #[inline]
    #[must_use]
    pub fn off_diagonals(&self) -> [f64; 3] {
        let j = &self.matrix;
        [j.m12, j.m23, j.m13]
    }

    /// The products of inertia xy, yz, zx, which are +∫xy dm and so on.
    #[inline]
    #[must_use]
    pub fn positive_products(&self) -> [f64; 3] {
        self.off_diagonals().map(|entry| -entry)
    }

    /// Jω: the angular momentum of an angular velocity \[kg m²/s\].
    #[inline]
    #[must_use]
    pub fn times(&self, vector: &Vector3<f64>) -> Vector3<f64> {
        self.matrix * vector
    }

    /// Moves the tensor from the center of mass to the point at `offset` from it (body axes, m), by
    /// the parallel-axis theorem: `J_P = J_G + m (d² 1 - d dᵀ)`, mass in kg.
    ///
    /// # Errors
    /// The mass is negative or not finite, or the offset is not finite.
    ///
    /// ```
    /// use newton_euler::inertia::InertiaTensor;
    /// use newton_euler::nalgebra::Vector3;
    ///
    /// let point = InertiaTensor::principal(0.0, 0.0, 0.0)?;
    /// let bob = point.shifted_from_center(2.0, &Vector3::new(0.0, 0.0, -3.0))?;
    /// assert_eq!(bob.moments(), [18.0, 18.0, 0.0]);
    /// # Ok::<(), newton_euler::inertia::InvalidInertia>(())
    /// ```
    pub fn shifted_from_center(
        &self,
        mass: f64,
        offset: &Vector3<f64>,
    ) -> Result<Self, InvalidInertia> {
        invalid::check_mass(mass)?;
        let matrix = self.matrix + of_second_moments(&(offset * offset.transpose() * mass));
        invalid::check(&matrix)?;
        Ok(Self { matrix })
    }

    /// Moves the tensor from a point to the center of mass at `offset` from it (body axes, m):
    /// `J_G = J_P - m (d² 1 - d dᵀ)`.
    ///
    /// This subtracts, so `J_G` loses the digits by which `m d²` exceeds it. If you have the
    /// choice, build about G.
    ///
    /// # Errors
    /// The mass is negative or not finite, or no body can have the difference as its tensor about
    /// G.
    ///
    /// ```
    /// use newton_euler::inertia::InertiaTensor;
    /// use newton_euler::nalgebra::Vector3;
    ///
    /// let hinge = InertiaTensor::principal(19.0, 19.0, 1.0)?;
    /// let center = Vector3::new(0.0, 0.0, -3.0);
    /// assert_eq!(
    ///     hinge.shifted_to_center(2.0, &center)?,
    ///     InertiaTensor::principal(1.0, 1.0, 1.0)?
    /// );
    /// assert!(hinge.shifted_to_center(3.0, &center).is_err());
    /// # Ok::<(), newton_euler::inertia::InvalidInertia>(())
    /// ```
    pub fn shifted_to_center(
        &self,
        mass: f64,
        offset: &Vector3<f64>,
    ) -> Result<Self, InvalidInertia> {
        invalid::check_mass(mass)?;
        let matrix = self.matrix - of_second_moments(&(offset * offset.transpose() * mass));
        invalid::check(&matrix)?;
        Ok(Self { matrix })
    }

    /// The tensor in other axes, `R J Rᵀ`, where the rotation takes components along the present
    /// axes to components along the others: an attitude gives the tensor in world axes.
    ///
    /// Only the part that depends on the axes is rotated, so spherical bodies stay exactly
    /// spherical.
    ///
    /// ```
    /// use newton_euler::inertia::InertiaTensor;
    /// use newton_euler::nalgebra::{UnitQuaternion, Vector3};
    ///
    /// let plank = InertiaTensor::principal(1.0, 2.0, 3.0)?;
    /// let quarter =
    ///     UnitQuaternion::from_axis_angle(&Vector3::z_axis(), core::f64::consts::FRAC_PI_2);
    /// assert!((plank.rotated(&quarter).moments()[0] - 2.0).abs() < 1e-15);
    /// # Ok::<(), newton_euler::inertia::InvalidInertia>(())
    /// ```
    #[must_use]
    pub fn rotated(&self, rotation: &UnitQuaternion<f64>) -> Self {
        let r = rotation.to_rotation_matrix().into_inner();
        let spherical = Matrix3::identity() * self.matrix.m33;
        let turned = r * (self.matrix - spherical) * r.transpose();
        Self {
            matrix: spherical + symmetrized(&turned),
        }
    }

    /// Principal moments and axes.
    ///
    /// ```
    /// use newton_euler::inertia::InertiaTensor;
    ///
    /// let square = InertiaTensor::tensor(2.0, 2.0, 3.0, -1.0, 0.0, 0.0)?.principal_axes();
    /// assert!((square.moments - newton_euler::nalgebra::Vector3::new(1.0, 3.0, 3.0)).norm() < 1e-15);
    /// # Ok::<(), newton_euler::inertia::InvalidInertia>(())
    /// ```
    #[must_use]
    pub fn principal_axes(&self) -> PrincipalAxes {
        let exponent = exponent(&self.matrix);
        let PrincipalAxes { moments, axes } = diagonalized(&scaled(&self.matrix, -exponent));
        PrincipalAxes {
            moments: moments.map(|moment| libm::scalbn(moment, exponent)),
            axes,
        }
    }

    /// The inverse \[1/(kg m²)\], at any scale of the moments.
    ///
    /// # Errors
    /// [`InvalidInertia::Singular`] if the moment of inertia about some axis is zero, to within
    /// [`Self::SLACK`]: a rod or a point.
    ///
    /// ```
    /// use newton_euler::inertia::InertiaTensor;
    ///
    /// assert_eq!(InertiaTensor::principal(2.0, 4.0, 4.0)?.inverse()?[(0, 0)], 0.5);
    /// assert!(InertiaTensor::principal(0.0, 1.0, 1.0)?.inverse().is_err());
    /// # Ok::<(), newton_euler::inertia::InvalidInertia>(())
    /// ```
    pub fn inverse(&self) -> Result<Matrix3<f64>, InvalidInertia> {
        let exponent = exponent(&self.matrix);
        let j = scaled(&self.matrix, -exponent);
        let moments = diagonalized(&j).moments;
        if moments.x <= invalid::slack(&j) * moments.z {
            return Err(InvalidInertia::Singular);
        }
        // J = L D Lᵀ, whose pivots D are positive unless rounding has taken the smallest moment
        let pivot = |left: f64| {
            let inverse = (left > 0.0).then(|| left.recip());
            inverse.ok_or(InvalidInertia::Singular)
        };
        let d1 = pivot(j.m11)?;
        let [l21, l31] = [j.m12 * d1, j.m13 * d1];
        let d2 = pivot(j.m22 - l21 * j.m12)?;
        let rest = j.m23 - l21 * j.m13;
        let l32 = rest * d2;
        let d3 = pivot(j.m33 - l31 * j.m13 - l32 * rest)?;
        // J⁻¹ = L⁻ᵀ D⁻¹ L⁻¹, the unit lower L⁻¹ having -l21, l, -l32 below its diagonal
        let l = l21 * l32 - l31;
        let [xy, yz, zx] = [-l21 * d2 - l * l32 * d3, -l32 * d3, l * d3];
        let inverse = Matrix3::new(
            d1 + l21 * l21 * d2 + l * l * d3,
            xy,
            zx,
            xy,
            d2 + l32 * l32 * d3,
            yz,
            zx,
            yz,
            d3,
        );
        Ok(scaled(&inverse, -exponent))
    }
}
