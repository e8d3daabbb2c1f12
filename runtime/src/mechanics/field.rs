//! Bodies in a uniform field: (34.7) to (34.9).
//!
//! A field that gives each charge e the force e E gives the body a resultant and a moment about the
//! origin of the charges' coordinates,
//!
//! ```text
//! F = E Σ e        K = p × E,   p = Σ e r                                  (34.8), (34.9)
//! and, if Σ e ≠ 0,   K = r₀ × F,   r₀ = Σ e r / Σ e
//! ```
//!
//! The moment is computed from p. A body without a net charge is therefore no special case: its
//! moment is a couple. Gravity is the case in which e is mass and E is the acceleration g. Then r₀
//! is the center of mass, and about it p = 0.

use nalgebra::Vector3;

use crate::mechanics::wrench::Wrench;
use crate::numbers::twofold::Twofold;

/// The charges of a body in a uniform field: their sum and their dipole moment.
///
/// Charges may be in any unit; fields are in newtons per that unit. Positions, field, force and
/// moment are in the same axes. If charges are given in body axes, rotate the field into them.
///
/// ```
/// use newton_euler::nalgebra::Vector3;
/// use newton_euler::field::Charges;
///
/// // Weight acts at the center of mass.
/// let masses = Charges::from_points([
///     (1.0, Vector3::new(7.0, 0.0, 0.0)),
///     (3.0, Vector3::new(9.0, 0.0, 0.0)),
/// ]);
/// assert_eq!(masses.center(), Some(Vector3::new(8.5, 0.0, 0.0)));
/// let weight = masses.wrench(&Vector3::new(0.0, 0.0, -10.0));
/// assert_eq!((weight.force.z, weight.moment.y), (-40.0, 340.0));
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Charges {
    net: f64,
    dipole: Vector3<f64>,
    center: Option<Vector3<f64>>,
}

impl Charges {
    /// The sums Σ e and Σ e r of charges e at positions r \[m\], finite numbers; zero for no
    /// charges.
    ///
    /// Sums are formed in twice the precision, so opposite charges and far origins cost no digits.
    /// A sum is correct to rounding unless it is 1e-16 times smaller than its largest term; then
    /// its absolute error is 1e-32 times that term.
    ///
    /// ```
    /// use newton_euler::nalgebra::Vector3;
    /// use newton_euler::field::Charges;
    ///
    /// let arm = Vector3::new(0.0, 0.0, 0.5);
    /// let needle = Charges::from_points([(2.0, arm), (-2.0, -arm)]);
    /// assert_eq!((needle.net(), needle.dipole().z), (0.0, 2.0));
    /// ```
    #[must_use]
    pub fn from_points<P: IntoIterator<Item = (f64, Vector3<f64>)>>(points: P) -> Self {
        let zero = Twofold::default();
        let (mut net, mut gross, mut dipole) = (zero, 0.0, [zero; 3]);
        for (charge, at) in points {
            net = net + charge.into();
            gross += charge.abs();
            for (sum, coordinate) in dipole.iter_mut().zip(at.iter()) {
                *sum = *sum + Twofold::product(charge, *coordinate);
            }
        }
        let center = (net.value().abs() > Self::NEUTRAL * gross)
            .then(|| dipole.map(|sum| (sum / net).value()).into());
        Self {
            net: net.value(),
            dipole: dipole.map(Twofold::value).into(),
            center,
        }
    }

    /// A sum of charges up to this fraction of the sum of their magnitudes may be nothing but
    /// rounding of the charges, which is up to half of this: 0.1, 0.2 and -0.3 sum to 2.8e-17.
    pub const NEUTRAL: f64 = f64::EPSILON;

    /// Σ e.
    #[must_use]
    pub const fn net(&self) -> f64 {
        self.net
    }

    /// p = Σ e r, about the origin of the positions \[m times the unit of charge\].
    #[must_use]
    pub const fn dipole(&self) -> Vector3<f64> {
        self.dipole
    }

    /// r₀ = Σ e r / Σ e (34.8), where the field's resultant acts \[m\]; the center of mass, if
    /// charges are masses.
    ///
    /// None if there is no net charge: if |Σ e| is at most [`Self::NEUTRAL`] times Σ |e|. For a
    /// nearly neutral body the point is far away, and has as few digits as the charges determine;
    /// force and moment do not depend on it.
    ///
    /// ```
    /// use newton_euler::nalgebra::Vector3;
    /// use newton_euler::field::Charges;
    ///
    /// let line = [(0.1, 1.0), (0.2, 2.0), (-0.3, 3.0)].map(|(e, x)| (e, Vector3::x() * x));
    /// assert_eq!(Charges::from_points(line).center(), None);
    /// ```
    #[must_use]
    pub const fn center(&self) -> Option<Vector3<f64>> {
        self.center
    }

    /// E Σ e \[N\].
    #[must_use]
    pub fn force(&self, field: &Vector3<f64>) -> Vector3<f64> {
        field * self.net
    }

    /// p × E, the moment about the origin of the positions \[N m\]; without a net charge, about
    /// every point.
    #[must_use]
    pub fn moment(&self, field: &Vector3<f64>) -> Vector3<f64> {
        self.dipole.cross(field)
    }

    /// Force and moment about the origin of the positions.
    #[must_use]
    pub fn wrench(&self, field: &Vector3<f64>) -> Wrench {
        Wrench {
            force: self.force(field),
            moment: self.moment(field),
        }
    }

    /// The energy `-(Σ e R + p)·E` of the body in the field \[J\], with the origin of the positions
    /// at R \[m\]; zero for a charge at R = 0.
    ///
    /// ```
    /// use newton_euler::nalgebra::Vector3;
    /// use newton_euler::field::Charges;
    ///
    /// let apple = Charges::from_points([(0.125, Vector3::zeros())]);
    /// let energy =
    ///     apple.potential_energy(&Vector3::new(0.0, 0.0, -10.0), &Vector3::new(0.0, 0.0, 3.0));
    /// assert_eq!(energy, 3.75);
    /// ```
    #[must_use]
    pub fn potential_energy(&self, field: &Vector3<f64>, position: &Vector3<f64>) -> f64 {
        -(position * self.net + self.dipole).dot(field)
    }
}
