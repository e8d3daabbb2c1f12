//! How far a state is from the one that is right.

use nalgebra::SVector;
use newton_euler::prelude::*;

use crate::reference;

/// The error of a state: the largest of those of its parts; of attitudes, that of their quaternions, of which q and -q are one; of
/// all that is a vector, relative to its length.
pub trait Distance {
    fn distance(&self, right: &Self) -> f64;
}

pub fn relative<const N: usize>(vector: &SVector<f64, N>, right: &SVector<f64, N>) -> f64 {
    (vector - right).norm() / right.norm()
}

impl Distance for Rotation {
    fn distance(&self, right: &Self) -> f64 {
        reference::distance(&self.attitude, &right.attitude)
            .max(relative(&self.angular_velocity, &right.angular_velocity))
    }
}

impl Distance for Hinge {
    /// Half the angle is what a quaternion is off.
    fn distance(&self, right: &Self) -> f64 {
        let rate = (self.angular_velocity - right.angular_velocity) / right.angular_velocity;
        (0.5 * (self.angle - right.angle)).abs().max(rate.abs())
    }
}

impl Distance for Spatial {
    fn distance(&self, right: &Self) -> f64 {
        reference::distance(&self.attitude, &right.attitude)
            .max(relative(&self.position, &right.position))
            .max(relative(&self.velocity, &right.velocity))
            .max(relative(&self.angular_velocity, &right.angular_velocity))
    }
}

impl<S: Distance> Distance for Vec<S> {
    fn distance(&self, right: &Self) -> f64 {
        let pairs = self.iter().zip(right);
        pairs.fold(0.0, |worst, (state, right)| {
            worst.max(state.distance(right))
        })
    }
}
