//! The class of a tensor: its symmetry, and the number of dimensions in which the body extends.

use nalgebra::{UnitVector3, Vector3};

use super::matrix::{exponent, scaled};
use super::{InertiaTensor, invalid};
use crate::mechanics::principal::diagonalized;

/// The number of equal principal moments, on which free motion depends. Axes are in the axes of the
/// tensor, with the largest component positive.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Symmetry {
    /// All three: no gyroscopic moment in any motion. Cubes are included.
    Spherical,
    /// Two, perpendicular to this axis: the body precesses steadily if left alone. Square prisms
    /// are included.
    Symmetric {
        /// The axis of the other moment.
        axis: UnitVector3<f64>,
    },
    /// None.
    General,
}

/// The number of dimensions in which a body extends, from the number of its second moments
/// `½ tr(J) 1 - J = ∫ r rᵀ dm` that vanish. Axes are in the axes of the tensor, with the largest
/// component positive.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Extent {
    /// All mass in one point: J = 0.
    Point,
    /// All mass on a line: no moment of inertia about it.
    Rod {
        /// Along the rod.
        axis: UnitVector3<f64>,
    },
    /// All mass in a plane: the moment about its normal is the sum of the other two.
    Planar {
        /// The normal.
        normal: UnitVector3<f64>,
    },
    /// Extended in space.
    Solid,
}

impl InertiaTensor {
    /// The number of principal moments that are equal, to [`Self::SLACK`] (four times that if there
    /// are products) of the largest.
    ///
    /// A disc is both [`Symmetry::Symmetric`] and [`Extent::Planar`], so the two are separate
    /// methods.
    ///
    /// ```
    /// use newton_euler::inertia::{InertiaTensor, Symmetry};
    /// use newton_euler::nalgebra::Vector3;
    ///
    /// let rotor = InertiaTensor::principal(0.1, 0.3, 0.3)?;
    /// assert_eq!(rotor.symmetry(), Symmetry::Symmetric { axis: Vector3::x_axis() });
    /// assert_eq!(InertiaTensor::principal(0.1 + 0.2, 0.3, 0.3)?.symmetry(), Symmetry::Spherical);
    /// # Ok::<(), newton_euler::inertia::InvalidInertia>(())
    /// ```
    #[must_use]
    pub fn symmetry(&self) -> Symmetry {
        self.symmetry_within(invalid::slack(&self.matrix))
    }

    /// The number of principal moments that are equal, to this fraction of the largest.
    ///
    /// ```
    /// use newton_euler::inertia::{InertiaTensor, Symmetry};
    ///
    /// let nearly = InertiaTensor::principal(1.0, 1.001, 0.999)?;
    /// assert_eq!(nearly.symmetry_within(0.01), Symmetry::Spherical);
    /// assert_eq!(nearly.symmetry(), Symmetry::General);
    /// # Ok::<(), newton_euler::inertia::InvalidInertia>(())
    /// ```
    #[must_use]
    pub fn symmetry_within(&self, tolerance: f64) -> Symmetry {
        let principal = Principal::of(self);
        let [least, middle, largest] = principal.moments;
        let equal = |a: f64, b: f64| b - a <= tolerance * largest;
        if equal(least, largest) {
            return Symmetry::Spherical;
        }
        // if both pairs are equal, the closer one counts
        match [equal(least, middle), equal(middle, largest)] {
            [false, false] => Symmetry::General,
            [true, other] if !other || middle - least <= largest - middle => Symmetry::Symmetric {
                axis: principal.axes[2],
            },
            _ => Symmetry::Symmetric {
                axis: principal.axes[0],
            },
        }
    }

    /// The number of dimensions in which the body extends, with moments zero up to [`Self::SLACK`]
    /// (four times that if there are products) of the largest.
    ///
    /// ```
    /// use newton_euler::inertia::{Extent, InertiaTensor};
    /// use newton_euler::nalgebra::Vector3;
    ///
    /// assert_eq!(
    ///     InertiaTensor::principal(0.1, 0.2, 0.3)?.extent(),
    ///     Extent::Planar { normal: Vector3::z_axis() }
    /// );
    /// assert_eq!(
    ///     InertiaTensor::principal(0.2, 0.0, 0.2)?.extent(),
    ///     Extent::Rod { axis: Vector3::y_axis() }
    /// );
    /// # Ok::<(), newton_euler::inertia::InvalidInertia>(())
    /// ```
    #[must_use]
    pub fn extent(&self) -> Extent {
        self.extent_within(invalid::slack(&self.matrix))
    }

    /// The number of dimensions in which the body extends, with moments zero up to this fraction of
    /// the largest.
    ///
    /// ```
    /// use newton_euler::inertia::{Extent, InertiaTensor};
    ///
    /// let needle = InertiaTensor::principal(1e-7, 1.0, 1.0)?;
    /// assert_eq!(needle.extent(), Extent::Solid);
    /// assert!(matches!(needle.extent_within(1e-6), Extent::Rod { .. }));
    /// # Ok::<(), newton_euler::inertia::InvalidInertia>(())
    /// ```
    #[must_use]
    pub fn extent_within(&self, tolerance: f64) -> Extent {
        let principal = Principal::of(self);
        let [least, middle, largest] = principal.moments;
        if largest == 0.0 {
            Extent::Point
        } else if least <= tolerance * largest {
            Extent::Rod {
                axis: principal.axes[0],
            }
        } else if least - (largest - middle) <= tolerance * largest {
            Extent::Planar {
                normal: principal.axes[2],
            }
        } else {
            Extent::Solid
        }
    }
}

/// Principal moments of order one, ascending, and their axes.
struct Principal {
    moments: [f64; 3],
    axes: [UnitVector3<f64>; 3],
}

impl Principal {
    /// The coordinate axes themselves for a diagonal tensor.
    fn of(inertia: &InertiaTensor) -> Self {
        let j = scaled(&inertia.matrix, -exponent(&inertia.matrix));
        let [x, y, z] = [Vector3::x_axis(), Vector3::y_axis(), Vector3::z_axis()];
        if invalid::is_diagonal(&j) {
            let mut pairs = [(j.m11, x), (j.m22, y), (j.m33, z)];
            pairs.sort_unstable_by(|a, b| a.0.total_cmp(&b.0));
            return Self {
                moments: pairs.map(|pair| pair.0),
                axes: pairs.map(|pair| pair.1),
            };
        }
        let principal = diagonalized(&j);
        Self {
            moments: principal.moments.into(),
            axes: [x, y, z].map(|axis| {
                let axis = principal.axes * axis;
                if axis[axis.iamax()] < 0.0 {
                    -axis
                } else {
                    axis
                }
            }),
        }
    }
}
