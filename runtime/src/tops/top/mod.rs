//! Symmetric tops: the free one, and the heavy one that rotates about a point of its axis.
//!
//! The body's third axis is that of symmetry, so J = diag(I₁, I₁, I₃). Free, about the center of
//! mass, it precesses steadily about its angular momentum M, at the angle θ to it:
//!
//! ```text
//! (33.4)  Ω₃ = M₃/I₃ = (M/I₃) cos θ        (33.5)  Ω_pr = M/I₁,   Ω₁ = Ω_pr sin θ
//! ```
//!
//! Ω₃ and Ω₁ are components of the angular velocity along the body's axis and perpendicular to it.
//! Relative to the precessing frame the body spins at
//! `ψ̇ = Ω₃ - Ω_pr cos θ = M cos θ (1/I₃ - 1/I₁)`.

use nalgebra::{UnitQuaternion, Vector3};

use crate::mechanics::inertia::{InertiaTensor, InvalidInertia};
use crate::numbers::math;
use crate::numbers::scale;
use crate::numbers::twofold::Twofold;
use crate::state::Rotation;
use crate::tops::precession::Precession;

mod heavy;

pub use heavy::{HeavyTop, SteadyRates};

/// A body with two equal principal moments, symmetric about its third axis.
///
/// ```
/// use newton_euler::top::SymmetricTop;
///
/// let disc = SymmetricTop::new(0.25, 0.5)?;
/// let rates = disc.rates(0.1, 0.0); // thrown without a wobble
/// assert_eq!((rates.axial, rates.transverse), (0.2, 0.0));
/// assert!(SymmetricTop::new(0.25, 0.0).is_err()); // a rod has no spin
/// # Ok::<(), newton_euler::inertia::InvalidInertia>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SymmetricTop {
    transverse: f64,
    axial: f64,
}

/// Rates of the free symmetric top: (33.4), (33.5) \[rad/s\].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FreeRates {
    /// Ω₃, the component of the angular velocity along the axis of symmetry.
    pub axial: f64,
    /// Ω₁, the component perpendicular to it.
    pub transverse: f64,
    /// `Ω_pr`, the rate at which that axis rotates about the angular momentum. Not observable at θ
    /// = 0 and θ = π.
    pub precession: f64,
    /// ψ̇, the spin about that axis relative to the precessing frame; zero for a spherical body.
    pub spin: f64,
}

impl SymmetricTop {
    /// From the moments I₁ (transverse) and I₃ (axial), about the center of mass or about a fixed
    /// point of the axis \[kg m²\].
    ///
    /// # Errors
    /// No body has these moments, or one is zero: the rate of a rod about its axis is undefined.
    /// For a rod use the state [`Rod`](crate::state::Rod).
    pub fn new(transverse: f64, axial: f64) -> Result<Self, InvalidInertia> {
        InertiaTensor::principal(transverse, transverse, axial)?;
        if transverse > 0.0 && axial > 0.0 {
            Ok(Self { transverse, axial })
        } else {
            Err(InvalidInertia::Singular)
        }
    }

    /// I₁ \[kg m²\].
    #[must_use]
    pub const fn transverse(&self) -> f64 {
        self.transverse
    }

    /// I₃ \[kg m²\].
    #[must_use]
    pub const fn axial(&self) -> f64 {
        self.axial
    }

    /// The rates of free motion with an angular momentum of this magnitude \[kg m²/s\] at this
    /// angle to the axis of symmetry \[rad\].
    ///
    /// ```
    /// use newton_euler::top::SymmetricTop;
    ///
    /// let rates = SymmetricTop::new(0.0123, 0.0187)?.rates(0.456, 0.5);
    /// assert!((rates.precession - 37.073170731707317).abs() < 1e-14);
    /// assert!((rates.spin + 11.134893911659770).abs() < 1e-14);
    /// # Ok::<(), newton_euler::inertia::InvalidInertia>(())
    /// ```
    #[must_use]
    pub fn rates(&self, momentum: f64, tilt: f64) -> FreeRates {
        let (sine, cosine) = math::sin_cos(tilt);
        let axial = momentum * cosine / self.axial;
        FreeRates {
            axial,
            transverse: momentum * sine / self.transverse,
            precession: momentum / self.transverse,
            spin: self.spin(axial.into()).value(),
        }
    }

    /// The free motion from a state at time zero, about the center of mass.
    ///
    /// ```
    /// use newton_euler::{prelude::*, top::SymmetricTop};
    ///
    /// let plate = SymmetricTop::new(1.0, 2.0)?;
    /// let start = Rotation { angular_velocity: [0.1, 0.0, 3.0].into(), ..Rotation::default() };
    /// let wobble = plate.free(&start);
    /// assert!((wobble.rate() / wobble.axial_rate() - 2.0).abs() < 1e-3); // twice for each turn
    /// assert!((wobble.at(0.0).angular_velocity - start.angular_velocity).norm() < 1e-15);
    /// # Ok::<(), newton_euler::inertia::InvalidInertia>(())
    /// ```
    #[must_use]
    pub fn free(&self, start: &Rotation) -> Precession {
        let exponent = scale::exponent(start.angular_velocity.amax());
        let w = scale::scaled(&start.angular_velocity, -exponent);
        // ω and M/I₁ differ along the axis only
        let axial = Twofold::product(self.axial, w.z) / self.transverse.into();
        let along = Vector3::new(w.x, w.y, axial.value());
        let square = Twofold::product(w.x, w.x) + Twofold::product(w.y, w.y) + axial * axial;
        Precession::of(
            start.attitude,
            start.attitude * direction(&along),
            square.sqrt().scaled(exponent),
            self.spin(start.angular_velocity.z.into()),
        )
    }

    /// The free motion from an attitude at time zero, with this angular momentum about the center
    /// of mass, world axes \[kg m²/s\].
    ///
    /// ```
    /// use newton_euler::nalgebra::{UnitQuaternion, Vector3};
    /// use newton_euler::top::SymmetricTop;
    ///
    /// let tilted = UnitQuaternion::from_axis_angle(&Vector3::x_axis(), 0.5);
    /// let motion = SymmetricTop::new(0.0123, 0.0187)?
    ///     .free_with_momentum(tilted, &Vector3::new(0.0, 0.0, 0.456));
    /// assert!((motion.tilt() - 0.5).abs() < 1e-15);
    /// assert!((motion.axial_rate() - 21.399874236471121).abs() < 2e-14);
    /// # Ok::<(), newton_euler::inertia::InvalidInertia>(())
    /// ```
    #[must_use]
    pub fn free_with_momentum(
        &self,
        attitude: UnitQuaternion<f64>,
        momentum: &Vector3<f64>,
    ) -> Precession {
        let exponent = scale::exponent(momentum.amax());
        let m = scale::scaled(momentum, -exponent);
        let square = [m.x, m.y, m.z].map(|component| Twofold::product(component, component));
        let magnitude = (square[0] + square[1] + square[2]).sqrt();
        let axial = attitude.inverse_transform_vector(momentum).z;
        Precession::of(
            attitude,
            direction(&m),
            (magnitude / self.transverse.into()).scaled(exponent),
            self.spin(Twofold::from(axial) / self.axial.into()),
        )
    }

    /// `ψ̇ = Ω₃ (I₁ - I₃)/I₁`, which does not cancel for nearly spherical bodies.
    fn spin(&self, axial: Twofold) -> Twofold {
        axial * Twofold::sum(self.transverse, -self.axial) / self.transverse.into()
    }
}

/// The unit vector along a vector with components of order one; zero along zero.
fn direction(vector: &Vector3<f64>) -> Vector3<f64> {
    vector.try_normalize(0.0).unwrap_or_default()
}
