//! The simplest equivalent of a system of forces: nothing, a couple, a single force, or a screw.
//!
//! The pole can be moved to any point a of a line (34.7) so that the remaining moment is
//! parallel to the force,
//!
//! ```text
//! K = a × F + p F        a = F × K / F² + λ F        p = F·K / F²
//! ```
//!
//! with the *pitch* p \[m\]. If F is perpendicular to K, no moment remains: the system is a single
//! force on that line.

use nalgebra::{Unit, Vector2, Vector3};
#[cfg(feature = "serde")]
use serde::Serialize;

use super::{Line, PlanarWrench, Wrench};
use crate::numbers::scale;

/// The simplest system of loads with a given resultant and moment: one of four.
///
/// ```
/// use newton_euler::nalgebra::Vector3;
/// use newton_euler::wrench::{Reduction, Wrench};
///
/// let push = Wrench::from_force_at(Vector3::new(0.0, 0.0, 2.0), Vector3::new(3.0, 0.0, 7.0));
/// let Reduction::Force { line, .. } = push.reduce() else { panic!() };
/// assert_eq!(line.point, Vector3::new(3.0, 0.0, 0.0));
///
/// let driver = push + Wrench::from_moment(Vector3::new(0.0, 0.0, 1.0));
/// let Reduction::Screw { pitch, .. } = driver.reduce() else { panic!() };
/// assert_eq!(pitch, 0.5);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(Serialize))]
pub enum Reduction {
    /// F = 0 and K = 0: equilibrium.
    Zero,
    /// F = 0: a couple, the same about every pole.
    Couple {
        /// K \[N m\].
        moment: Vector3<f64>,
    },
    /// F·K = 0: a single force, anywhere on its line.
    Force {
        /// F \[N\].
        force: Vector3<f64>,
        /// Its line of action, along F.
        line: Line,
    },
    /// A force on a line and a couple along it.
    Screw {
        /// F \[N\].
        force: Vector3<f64>,
        /// The axis of the screw, along F.
        line: Line,
        /// F·K/F², positive for a right-handed screw: the couple is this times F \[m\].
        pitch: f64,
    },
}

/// The thresholds of zero in [`Wrench::reduce_within`].
///
/// Whether a force is negligible compared with a moment, or the reverse, depends on the length
/// scale, which a wrench does not contain: [`Tolerance::at_scale`] takes it as an argument.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Tolerance {
    /// A resultant up to this counts as zero \[N\].
    pub force: f64,
    /// A moment up to this counts as zero; along the force, where it does not depend on the pole
    /// \[N m\].
    pub moment: f64,
    /// F and K are perpendicular if |F·K| is at most this times |F||K|.
    pub perpendicular: f64,
}

impl Tolerance {
    /// Only exact zeros are zero, and F·K up to eight units in the last place of |F||K|.
    ///
    /// A moment computed as arm × force, with the arm perpendicular to the force, gives an F·K of
    /// up to three of these units: 2√2 roundings of half a unit in the cross product, three in the
    /// scalar product. A sum of two or three such moments of about the same size is within the
    /// tolerance, too.
    pub const EXACT: Self = Self {
        force: 0.0,
        moment: 0.0,
        perpendicular: 8.0 * f64::EPSILON,
    };

    /// For sums of loads of about this force \[N\] at about this distance \[m\] from the pole:
    /// anything below sixteen units in the last place of them is rounding.
    ///
    /// Each load contributes half a unit to the resultant and two to the moment, so this suffices
    /// for about eight loads.
    ///
    /// ```
    /// use newton_euler::nalgebra::Vector3;
    /// use newton_euler::wrench::{Reduction, Tolerance, Wrench};
    ///
    /// // 0.1 + 0.2 - 0.3 is not 0 in binary.
    /// let forces = [(0.1, 0.5), (0.2, 0.7), (-0.3, 0.9)];
    /// let sum: Wrench = forces
    ///     .map(|(f, x)| Wrench::from_force_at(Vector3::z() * f, Vector3::x() * x))
    ///     .into_iter()
    ///     .sum();
    /// assert!(matches!(sum.reduce(), Reduction::Force { .. })); // 5.6e-17 N, some 1.4e15 m away
    /// assert!(matches!(
    ///     sum.reduce_within(&Tolerance::at_scale(0.3, 1.0)),
    ///     Reduction::Couple { .. }
    /// ));
    /// ```
    #[must_use]
    pub const fn at_scale(force: f64, distance: f64) -> Self {
        let force_left = 16.0 * f64::EPSILON * force;
        Self {
            force: force_left,
            moment: force_left * distance,
            ..Self::EXACT
        }
    }
}

impl Wrench {
    /// The simplest equivalent, with [`Tolerance::EXACT`].
    ///
    /// The result is accurate at every size of force and moment: a wrench times a power of two
    /// gives the same line and pitch to the bit. A line or pitch beyond the largest double (1e-200
    /// N with 1e200 N m) gives a couple. The result of a non-finite wrench is not finite either.
    ///
    /// A moment has the rounding of the loads in its sum. That may be larger than the moment
    /// itself, and is not known here: a single force far along its line from the pole may come out
    /// as a screw of tiny pitch. Use [`Wrench::reduce_within`] in such cases.
    ///
    /// ```
    /// use newton_euler::nalgebra::Vector3;
    /// use newton_euler::wrench::{Reduction, Wrench};
    ///
    /// let [f, r] = [Vector3::new(0.0, 5.0, 0.0), Vector3::new(2.0, 0.0, 0.0)];
    /// let pair = Wrench::from_force_at(f, r) + Wrench::from_force_at(-f, -r);
    /// assert_eq!(pair.reduce(), Reduction::Couple { moment: Vector3::new(0.0, 0.0, 20.0) });
    /// assert_eq!((pair - pair).reduce(), Reduction::Zero);
    /// ```
    #[must_use]
    pub fn reduce(&self) -> Reduction {
        self.reduce_within(&Tolerance::EXACT)
    }

    /// The simplest equivalent, with values within a tolerance taken as zero.
    ///
    /// Values within tolerance are dropped: the force and the moment, for a couple or nothing; the
    /// moment along the force, for a single force.
    #[must_use]
    pub fn reduce_within(&self, tolerance: &Tolerance) -> Reduction {
        let Self { force, moment } = *self;
        // F and K divided by powers of two, of order one
        let [of_force, of_moment] = [force, moment].map(|v| scale::exponent(v.amax()));
        let [f, k] = [
            scale::scaled(&force, -of_force),
            scale::scaled(&moment, -of_moment),
        ];
        let square = f.norm_squared();
        let [f_norm, k_norm] = [f.norm(), k.norm()];

        if libm::scalbn(f_norm, of_force) <= tolerance.force {
            return if libm::scalbn(k_norm, of_moment) <= tolerance.moment {
                Reduction::Zero
            } else {
                Reduction::Couple { moment }
            };
        }

        let to_length = of_moment - of_force;
        let parallel = f.dot(&k);
        let line = Line {
            point: scale::scaled(&(f.cross(&k) / square), to_length),
            direction: Unit::new_unchecked(f / f_norm),
        };
        let pitch = libm::scalbn(parallel / square, to_length);
        if [line.point.x, line.point.y, line.point.z, pitch]
            .into_iter()
            .any(f64::is_infinite)
        {
            return Reduction::Couple { moment };
        }
        let perpendicular = parallel.abs() <= tolerance.perpendicular * f_norm * k_norm
            || libm::scalbn(parallel.abs() / f_norm, of_moment) <= tolerance.moment;
        if perpendicular || pitch == 0.0 {
            Reduction::Force { force, line }
        } else {
            Reduction::Screw { force, line, pitch }
        }
    }
}

impl Reduction {
    /// Force and moment about the pole of the original wrench: K = a × F + p F, without the parts
    /// dropped by a tolerance.
    ///
    /// ```
    /// use newton_euler::nalgebra::Vector3;
    /// use newton_euler::wrench::Wrench;
    ///
    /// let wrench =
    ///     Wrench { force: Vector3::new(0.0, 0.0, 2.0), moment: Vector3::new(4.0, 0.0, 1.0) };
    /// assert_eq!(wrench.reduce().wrench(), wrench);
    /// ```
    #[must_use]
    pub fn wrench(&self) -> Wrench {
        match *self {
            Self::Zero => Wrench::default(),
            Self::Couple { moment } => Wrench::from_moment(moment),
            Self::Force { force, line } => Wrench::from_force_at(force, line.point),
            Self::Screw { force, line, pitch } => {
                Wrench::from_force_at(force, line.point) + Wrench::from_moment(force * pitch)
            }
        }
    }
}

/// The simplest equivalent of a system of loads in the plane: there a force is always perpendicular
/// to a moment, so there is no screw.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(Serialize))]
pub enum PlanarReduction {
    /// F = 0 and K = 0: equilibrium.
    Zero,
    /// F = 0: a couple, the same about every pole.
    Couple {
        /// K, counterclockwise \[N m\].
        moment: f64,
    },
    /// A single force, anywhere on its line.
    Force {
        /// F \[N\], which has the direction of the line.
        force: Vector2<f64>,
        /// The point of the line nearest to the pole, from the pole \[m\]:
        /// `a = (F_y, -F_x) K / F²`.
        point: Vector2<f64>,
    },
}

impl PlanarWrench {
    /// The simplest equivalent, with [`Tolerance::EXACT`]; accurate at every size, like
    /// [`Wrench::reduce`].
    ///
    /// ```
    /// use newton_euler::nalgebra::Vector2;
    /// use newton_euler::wrench::{PlanarReduction, PlanarWrench};
    ///
    /// let push = PlanarWrench::from_force_at(Vector2::new(0.0, 2.0), Vector2::new(3.0, 5.0));
    /// let point = Vector2::new(3.0, 0.0);
    /// assert_eq!(push.reduce(), PlanarReduction::Force { force: push.force, point });
    /// ```
    #[must_use]
    pub fn reduce(&self) -> PlanarReduction {
        self.reduce_within(&Tolerance::EXACT)
    }

    /// The simplest equivalent, with a force within tolerance taken as zero, and likewise a moment
    /// without a force.
    #[must_use]
    pub fn reduce_within(&self, tolerance: &Tolerance) -> PlanarReduction {
        let Self { force, moment } = *self;
        let in_space = Wrench {
            force: Vector3::new(force.x, force.y, 0.0),
            moment: Vector3::new(0.0, 0.0, moment),
        };
        match in_space.reduce_within(tolerance) {
            Reduction::Zero => PlanarReduction::Zero,
            Reduction::Couple { .. } => PlanarReduction::Couple { moment },
            Reduction::Force { line, .. } | Reduction::Screw { line, .. } => {
                let point = line.point.xy();
                PlanarReduction::Force { force, point }
            }
        }
    }
}
