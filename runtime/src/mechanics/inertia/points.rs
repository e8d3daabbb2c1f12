//! Mass, center of mass and inertia of mass points.

use nalgebra::{Matrix3, Vector3};

use super::matrix::of_second_moments;
use super::{InertiaTensor, InvalidInertia, invalid};

/// The mass properties of a body, as the balances need them.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MassProperties {
    /// The mass \[kg\].
    pub mass: f64,
    /// The center of mass G, from the origin of the given coordinates \[m\].
    pub center: Vector3<f64>,
    /// The tensor about G.
    pub inertia: InertiaTensor,
}

impl InertiaTensor {
    /// Mass, center of mass and tensor about it, of mass points \[kg, m\] in body axes from any
    /// origin.
    ///
    /// Distances are taken first from the first point, then from the resulting center of mass, so a
    /// small body far from the origin keeps its digits.
    ///
    /// # Errors
    /// [`InvalidInertia::Mass`] if a mass is negative or not finite or all are zero,
    /// [`InvalidInertia::NotFinite`] if a coordinate is not.
    ///
    /// ```
    /// use newton_euler::inertia::InertiaTensor;
    /// use newton_euler::nalgebra::Vector3;
    ///
    /// let dumbbell = InertiaTensor::from_points([
    ///     (1.0, Vector3::new(7.0, 0.0, 0.0)),
    ///     (3.0, Vector3::new(9.0, 0.0, 0.0)),
    /// ])?;
    /// assert_eq!((dumbbell.mass, dumbbell.center.x), (4.0, 8.5));
    /// assert_eq!(dumbbell.inertia.moments(), [0.0, 3.0, 3.0]);
    /// # Ok::<(), newton_euler::inertia::InvalidInertia>(())
    /// ```
    pub fn from_points<P>(points: P) -> Result<MassProperties, InvalidInertia>
    where
        P: IntoIterator<Item = (f64, Vector3<f64>), IntoIter: Clone>,
    {
        let points = points.into_iter();
        let first = points.clone().next().map_or(Vector3::zeros(), |(_, at)| at);
        let (mut mass, mut moment) = (0.0, Vector3::zeros());
        for (m, at) in points.clone() {
            invalid::check_mass(m)?;
            mass += m;
            moment += (at - first) * m;
        }
        if !(mass > 0.0 && mass.is_finite()) {
            return Err(InvalidInertia::Mass { value: mass });
        }
        let center = moment / mass;
        let second: Matrix3<f64> = points
            .map(|(m, at)| {
                let arm = (at - first) - center;
                arm * arm.transpose() * m
            })
            .sum();
        let matrix = of_second_moments(&second);
        invalid::check(&matrix)?;
        Ok(MassProperties {
            mass,
            center: first + center,
            inertia: Self { matrix },
        })
    }
}
