//! The free rotation of any body.

use nalgebra::{Matrix3, UnitVector3};

use crate::bodies::path::Path;
use crate::mechanics::inertia::InertiaTensor;
use crate::state::Rotation;

mod elliptic;
mod regular;

use elliptic::Circling;
use regular::Regular;

/// Rotation without a moment about G, or about a held point.
///
/// A body with three different moments rotates by Jacobi's elliptic functions and an integral of
/// the third kind. A body with two equal moments precesses steadily. About a principal axis, and
/// with three equal moments, the angular velocity is constant. Components that are zero stay
/// exactly zero, the sign of the quaternion is continuous in time, and moments and rates may have
/// any size. Beside a rate about the intermediate axis, rates that are less than about 1e-308 of it
/// count as zero.
///
/// The error of the end state is about that of one rounding of the inputs: a few 1e-16 per
/// radian turned, also near the separatrix, where a body spun about its intermediate axis flips.
///
/// ```
/// use newton_euler::exact::{FreeRotation, Path};
/// use newton_euler::prelude::*;
/// use newton_euler::nalgebra::Vector3;
///
/// // spun about the intermediate axis
/// let handle = InertiaTensor::principal(1.0, 2.0, 3.0)?;
/// let spun = Rotation { angular_velocity: Vector3::new(0.01, 1.0, 0.01), ..Rotation::default() };
/// let motion = FreeRotation::new(&handle, &spun);
/// let period = motion.period().unwrap();
/// assert!((period - 39.105_734_197_268_721).abs() < 1e-12);
/// assert!((motion.at(period / 2.0).angular_velocity.y + 1.0).abs() < 1e-13); // flipped
/// # Ok::<(), newton_euler::inertia::InvalidInertia>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FreeRotation(Case);

#[derive(Clone, Copy, Debug, PartialEq)]
#[expect(clippy::large_enum_variant, reason = "it is evaluated in place")]
enum Case {
    Regular(Regular),
    Circling(Circling),
}

impl FreeRotation {
    /// From the inertia about the point without a moment, in body axes, and the state
    /// at time zero.
    #[must_use]
    pub fn new(inertia: &InertiaTensor, state: &Rotation) -> Self {
        if inertia.off_diagonals().iter().all(|entry| *entry == 0.0) {
            return Self::principal(inertia.moments(), &Matrix3::identity(), state);
        }
        let principal = inertia.principal_axes();
        let axes = principal.axes.to_rotation_matrix().into_inner();
        Self::principal(principal.moments.into(), &axes, state)
    }

    /// From principal moments \[kg m²\] and unit vectors along their axes, in the columns of a
    /// matrix, right-handed, body axes.
    ///
    /// ```
    /// use newton_euler::exact::{FreeRotation, Path};
    /// use newton_euler::nalgebra::{Matrix3, Vector3};
    /// use newton_euler::prelude::*;
    ///
    /// let state =
    ///     Rotation { angular_velocity: Vector3::new(0.3, 0.0, 2.0), ..Rotation::default() };
    /// let motion = FreeRotation::principal([2.0, 2.0, 1.0], &Matrix3::identity(), &state);
    /// // ω₃ (1 - 1/2) = 1 rad/s
    /// assert!((motion.period().unwrap() - core::f64::consts::TAU).abs() < 1e-15);
    /// assert_eq!(motion.at(5.0).angular_velocity.z, 2.0);
    /// ```
    #[must_use]
    pub fn principal(moments: [f64; 3], axes: &Matrix3<f64>, state: &Rotation) -> Self {
        let ([i, j, k], [a, b, c]) = (moments, <[[f64; 3]; 3]>::from(*axes));
        let [x, y, z] = axes.tr_mul(&state.angular_velocity).into();
        // two moments and the rates about their axes; the third moment and its axis
        let pairs = [
            ([j, k], [y, z], i, a),
            ([k, i], [z, x], j, b),
            ([i, j], [x, y], k, c),
        ];
        #[expect(clippy::float_cmp, reason = "what is nearly equal is no special case")]
        let are_equal = |[one, other]: [f64; 2]| one == other;
        let is_steady = pairs
            .iter()
            .all(|(pair, rates, ..)| are_equal(*pair) || rates.contains(&0.0));
        if is_steady {
            return Self(Case::Regular(Regular::steady(state)));
        }
        for (pair, _, along, axis) in pairs {
            if are_equal(pair) {
                let both = [pair[0], along];
                return Self(Case::Regular(Regular::symmetric(both, axis.into(), state)));
            }
        }
        let circling = Circling::new(moments, axes, state);
        let steady = || Case::Regular(Regular::steady(state));
        Self(circling.map_or_else(steady, Case::Circling))
    }

    /// From the moment perpendicular to an axis of symmetry and the one about it \[kg m²\], and the
    /// axis, in the body.
    ///
    /// ```
    /// use newton_euler::exact::{FreeRotation, Path};
    /// use newton_euler::nalgebra::Vector3;
    /// use newton_euler::prelude::*;
    ///
    /// let state =
    ///     Rotation { angular_velocity: Vector3::new(2.0, 0.0, 0.3), ..Rotation::default() };
    /// let motion = FreeRotation::symmetric([2.0, 1.0], Vector3::x_axis(), &state);
    /// assert_eq!(motion.at(5.0).angular_velocity.x, 2.0);
    /// ```
    #[must_use]
    pub fn symmetric(moments: [f64; 2], axis: UnitVector3<f64>, state: &Rotation) -> Self {
        Self(Case::Regular(Regular::symmetric(
            moments,
            axis.into_inner(),
            state,
        )))
    }

    /// About a constant axis: a body with three equal moments, or any body about a
    /// principal axis.
    ///
    /// ```
    /// use newton_euler::exact::{FreeRotation, Path};
    /// use newton_euler::nalgebra::Vector3;
    /// use newton_euler::prelude::*;
    ///
    /// let state =
    ///     Rotation { angular_velocity: Vector3::new(0.0, 3.0, 4.0), ..Rotation::default() };
    /// let ball = FreeRotation::steady(&state);
    /// assert!((ball.at(0.2).attitude.angle() - 1.0).abs() < 1e-15);
    /// assert_eq!(ball.at(1e9).angular_velocity, Vector3::new(0.0, 3.0, 4.0));
    /// ```
    #[must_use]
    pub fn steady(state: &Rotation) -> Self {
        Self(Case::Regular(Regular::steady(state)))
    }

    /// The time after which the angular velocity in body axes repeats \[s\]. `None` if it is
    /// constant, or on the separatrix, where it never repeats.
    #[must_use]
    pub fn period(&self) -> Option<f64> {
        match &self.0 {
            Case::Regular(regular) => regular.period(),
            Case::Circling(circling) => circling.period(),
        }
    }
}

impl Path for FreeRotation {
    type State = Rotation;

    fn at(&self, time: f64) -> Rotation {
        match &self.0 {
            Case::Regular(regular) => regular.at(time),
            Case::Circling(circling) => circling.at(time),
        }
    }

    fn pace(&self, _time: f64) -> f64 {
        1.0 / self.at(0.0).angular_velocity.norm()
    }
}
