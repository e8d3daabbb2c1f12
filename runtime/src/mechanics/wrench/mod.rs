//! Wrenches: the resultant force of a system of loads together with its moment about a pole.
//!
//! A wrench does not store its pole, and only wrenches about the same pole may be added. The moment
//! about another pole is (34.5) `K = K' + a × F`, where the pole of K' lies at a from the
//! pole of K. [`Reduction`] gives the simplest equivalent of a wrench (nothing, a couple, a single
//! force, a screw).

use core::iter::Sum;
use core::ops::{Add, AddAssign, Neg, Sub};

use nalgebra::{Vector2, Vector3};

pub mod generic;
mod line;
mod reduction;

pub use line::Line;
pub use reduction::{PlanarReduction, Reduction, Tolerance};

/// Force and moment about a pole, both in one set of axes: world axes in all outputs of bodies and
/// systems.
///
/// ```
/// use newton_euler::nalgebra::Vector3;
/// use newton_euler::wrench::Wrench;
///
/// let [x, z] = [Vector3::x(), Vector3::z()];
/// // A couple: two forces without a resultant, whose moment is the same about every pole.
/// let couple: Wrench = [Wrench::from_force_at(z, x), Wrench::from_force_at(-z, -x)]
///     .into_iter()
///     .sum();
/// assert_eq!(couple, Wrench::from_moment(Vector3::new(0.0, -2.0, 0.0)));
/// assert_eq!(couple.moved(&Vector3::zeros(), &Vector3::new(7.0, 8.0, 9.0)), couple);
/// ```
pub type Wrench = generic::Wrench<f64>;

impl Wrench {
    /// A force \[N\] acting at `arm` \[m\] from the pole: its moment is arm × force.
    ///
    /// ```
    /// use newton_euler::nalgebra::Vector3;
    /// use newton_euler::wrench::Wrench;
    ///
    /// let push = Wrench::from_force_at(Vector3::new(0.0, 10.0, 0.0), Vector3::new(0.5, 0.0, 0.0));
    /// assert_eq!(push.moment, Vector3::new(0.0, 0.0, 5.0));
    /// ```
    #[inline]
    #[must_use]
    pub fn from_force_at(force: Vector3<f64>, arm: Vector3<f64>) -> Self {
        Self {
            force,
            moment: arm.cross(&force),
        }
    }

    /// A couple \[N m\].
    ///
    /// ```
    /// use newton_euler::nalgebra::Vector3;
    /// use newton_euler::wrench::Wrench;
    ///
    /// assert_eq!(Wrench::from_moment(Vector3::x()).force, Vector3::zeros());
    /// ```
    #[inline]
    #[must_use]
    pub fn from_moment(moment: Vector3<f64>) -> Self {
        Self {
            force: Vector3::zeros(),
            moment,
        }
    }

    /// The same system of loads about another pole (34.5): `K_to = K_from + (from - to) × F`.
    ///
    /// ```
    /// use newton_euler::nalgebra::Vector3;
    /// use newton_euler::wrench::Wrench;
    ///
    /// let weight = Wrench::from_force_at(Vector3::new(0.0, 0.0, -9.0), Vector3::zeros());
    /// let center = Vector3::new(2.0, 0.0, 1.0);
    /// assert_eq!(weight.moved(&center, &Vector3::zeros()).moment, Vector3::new(0.0, 18.0, 0.0));
    /// ```
    #[inline]
    #[must_use]
    pub fn moved(&self, from: &Vector3<f64>, to: &Vector3<f64>) -> Self {
        Self {
            force: self.force,
            moment: self.moment + (from - to).cross(&self.force),
        }
    }

    /// The power `F·v + K·ω` \[W\] on a rigid body, with v the velocity of its point at the pole
    /// \[m/s\] and ω its angular velocity \[rad/s\], all in the axes of the wrench. It does not
    /// depend on the pole.
    #[inline]
    #[must_use]
    pub fn power(&self, velocity: &Vector3<f64>, angular_velocity: &Vector3<f64>) -> f64 {
        self.force.dot(velocity) + self.moment.dot(angular_velocity)
    }
}

/// Force and moment in the plane, the moment positive counterclockwise.
///
/// ```
/// use newton_euler::nalgebra::Vector2;
/// use newton_euler::wrench::PlanarWrench;
///
/// let push = PlanarWrench::from_force_at(Vector2::new(0.0, 10.0), Vector2::new(0.5, 0.0));
/// assert_eq!((push + PlanarWrench::from_moment(-5.0)).moment, 0.0);
/// ```
pub type PlanarWrench = generic::PlanarWrench<f64>;

impl PlanarWrench {
    /// A force \[N\] acting at `arm` \[m\] from the pole: its moment is arm × force.
    ///
    /// ```
    /// use newton_euler::nalgebra::Vector2;
    /// use newton_euler::wrench::PlanarWrench;
    ///
    /// assert_eq!(PlanarWrench::from_force_at(Vector2::y(), Vector2::x()).moment, 1.0);
    /// ```
    #[inline]
    #[must_use]
    pub fn from_force_at(force: Vector2<f64>, arm: Vector2<f64>) -> Self {
        Self {
            force,
            moment: arm.perp(&force),
        }
    }

    /// A couple \[N m\].
    ///
    /// ```
    /// use newton_euler::wrench::PlanarWrench;
    ///
    /// assert_eq!(PlanarWrench::from_moment(2.0).force.norm(), 0.0);
    /// ```
    #[inline]
    #[must_use]
    pub fn from_moment(moment: f64) -> Self {
        Self {
            force: Vector2::zeros(),
            moment,
        }
    }

    /// The same system of loads about another pole (34.5): `K_to = K_from + (from - to) × F`.
    ///
    /// ```
    /// use newton_euler::nalgebra::Vector2;
    /// use newton_euler::wrench::PlanarWrench;
    ///
    /// let weight = PlanarWrench::from_force_at(Vector2::new(0.0, -9.0), Vector2::zeros());
    /// assert_eq!(weight.moved(&Vector2::new(2.0, 1.0), &Vector2::zeros()).moment, -18.0);
    /// ```
    #[inline]
    #[must_use]
    pub fn moved(&self, from: &Vector2<f64>, to: &Vector2<f64>) -> Self {
        Self {
            force: self.force,
            moment: self.moment + (from - to).perp(&self.force),
        }
    }

    /// The power `F·v + K ω` \[W\] on a rigid body, with v the velocity of its point at the pole
    /// \[m/s\] and ω its angular velocity \[rad/s\]. It does not depend on the pole.
    #[inline]
    #[must_use]
    pub fn power(&self, velocity: &Vector2<f64>, angular_velocity: f64) -> f64 {
        self.force.dot(velocity) + self.moment * angular_velocity
    }
}

/// Sums of wrenches about one pole.
macro_rules! sums {
    ($wrench:ident) => {
        impl Add for $wrench {
            type Output = Self;

            #[inline]
            fn add(self, other: Self) -> Self {
                Self {
                    force: self.force + other.force,
                    moment: self.moment + other.moment,
                }
            }
        }

        impl Sub for $wrench {
            type Output = Self;

            #[inline]
            fn sub(self, other: Self) -> Self {
                Self {
                    force: self.force - other.force,
                    moment: self.moment - other.moment,
                }
            }
        }

        impl Neg for $wrench {
            type Output = Self;

            #[inline]
            fn neg(self) -> Self {
                Self {
                    force: -self.force,
                    moment: -self.moment,
                }
            }
        }

        impl AddAssign for $wrench {
            #[inline]
            fn add_assign(&mut self, other: Self) {
                *self = *self + other;
            }
        }

        impl Sum for $wrench {
            fn sum<I: Iterator<Item = Self>>(wrenches: I) -> Self {
                wrenches.fold(Self::default(), Add::add)
            }
        }
    };
}

sums!(Wrench);
sums!(PlanarWrench);
