//! Every kind of motion: along its series, the coordinates change at the rate given by the
//! velocities, and the velocities by the acceleration that the body has there.

use nalgebra::{Quaternion, Unit, UnitQuaternion, Vector3};
use newton_euler::attitude;
use newton_euler::prelude::*;

use crate::scenes;

/// The rates of the coordinates of a state, in the order of `Coordinates`, from the definitions of the states.
pub trait Moving: State {
    fn rates(&self, acceleration: &Self::Acceleration) -> Vec<f64>;
}

fn chain<const N: usize>(parts: [&[f64]; N]) -> Vec<f64> {
    parts.concat()
}

fn turning(q: &UnitQuaternion<f64>, w: &Vector3<f64>) -> [f64; 4] {
    attitude::kinematics(q, w).coords.into()
}

impl Moving for Spatial {
    fn rates(&self, acceleration: &SpatialAcceleration) -> Vec<f64> {
        let q = turning(&self.attitude, &self.angular_velocity);
        let SpatialAcceleration { linear, angular } = acceleration;
        chain([
            self.velocity.as_slice(),
            &q,
            linear.as_slice(),
            angular.as_slice(),
        ])
    }
}

impl Moving for Rotation {
    fn rates(&self, acceleration: &Vector3<f64>) -> Vec<f64> {
        let q = turning(&self.attitude, &self.angular_velocity);
        chain([&q, acceleration.as_slice()])
    }
}

impl Moving for Translation {
    fn rates(&self, acceleration: &Vector3<f64>) -> Vec<f64> {
        chain([self.velocity.as_slice(), acceleration.as_slice()])
    }
}

impl Moving for Planar {
    fn rates(&self, acceleration: &PlanarAcceleration) -> Vec<f64> {
        let (v, a) = (self.velocity.as_slice(), acceleration.linear.as_slice());
        chain([v, &[self.angular_velocity], a, &[acceleration.angular]])
    }
}

impl Moving for PlanarTranslation {
    fn rates(&self, acceleration: &nalgebra::Vector2<f64>) -> Vec<f64> {
        chain([self.velocity.as_slice(), acceleration.as_slice()])
    }
}

impl Moving for Hinge {
    fn rates(&self, acceleration: &f64) -> Vec<f64> {
        vec![self.angular_velocity, *acceleration]
    }
}

impl Moving for Rod {
    fn rates(&self, acceleration: &RodAcceleration) -> Vec<f64> {
        let RodAcceleration { linear, axis } = acceleration;
        let (v, u) = (self.velocity.as_slice(), self.axis_rate.as_slice());
        chain([v, u, linear.as_slice(), axis.as_slice()])
    }
}

pub fn check<B>(name: &str, body: &B, state: &B::State, input: &B::Input)
where
    B: Taylor<State: Moving>,
{
    let (time, series) = (0.4, body.series::<20>(0.4, state, input));
    for after in [-0.02, 0.0, 0.01, 0.02] {
        let there = series.after(after);
        let acceleration = body.acceleration(time + after, &there, input);
        let expected = there.rates(&acceleration);
        for (coordinate, expected) in expected.iter().enumerate() {
            let rows = series.coefficients().iter().enumerate().skip(1).rev();
            let found = rows.fold(0.0, |sum, (n, row)| {
                sum * after + n as f64 * row.as_ref()[coordinate]
            });
            assert!(
                (found - expected).abs() < 1e-12 * (1.0 + expected.abs()),
                "{name}, coordinate {coordinate}, {after} s later: {found} for {expected}"
            );
        }
    }
}

pub fn tilted() -> UnitQuaternion<f64> {
    UnitQuaternion::new_normalize(Quaternion::new(0.7, -0.2, 0.4, 0.5))
}

#[test]
fn in_space() {
    let (position, velocity) = ([0.3, -0.2, 0.5].into(), [1.0, -0.4, 0.6].into());
    let (attitude, angular_velocity) = (tilted(), [1.1, -0.7, 0.9].into());
    let (push, wind) = ([2.0, -1.0, 3.0].into(), [-1.5, 0.5, 1.0].into());
    let state = Spatial {
        position,
        attitude,
        velocity,
        angular_velocity,
    };
    check(
        "spatial",
        &scenes::Spatial::default(),
        &state,
        &scenes::SpatialInput { push, wind },
    );
    let state = Rotation {
        attitude,
        angular_velocity,
    };
    check(
        "fixed_point",
        &scenes::FixedPoint::default(),
        &state,
        &scenes::FixedPointInput { push, wind },
    );
    check(
        "rotation",
        &scenes::Rotation::default(),
        &state,
        &scenes::RotationInput { push, wind },
    );
    let state = Hinge {
        angle: 0.6,
        angular_velocity: -1.2,
    };
    check(
        "fixed_axis",
        &scenes::FixedAxis::default(),
        &state,
        &scenes::FixedAxisInput { push, wind },
    );
    let state = Translation { position, velocity };
    check(
        "translation",
        &scenes::Translation::default(),
        &state,
        &scenes::TranslationInput { push, wind },
    );
    let axis = Unit::new_normalize(Vector3::new(0.3, -0.5, 0.8));
    let axis_rate = axis.cross(&Vector3::new(0.9, 0.4, -0.7));
    let state = Rod {
        position,
        velocity,
        axis,
        axis_rate,
    };
    check(
        "rod",
        &scenes::Rod::default(),
        &state,
        &scenes::RodInput { push, wind },
    );
}

#[test]
fn in_the_plane() {
    let (position, velocity) = ([0.3, -0.2].into(), [1.0, -0.4].into());
    let (push, wind) = ([2.0, -1.0].into(), [-1.5, 0.5].into());
    let state = Planar {
        position,
        angle: 0.6,
        velocity,
        angular_velocity: -1.2,
    };
    check(
        "planar",
        &scenes::Planar::default(),
        &state,
        &scenes::PlanarInput { push, wind },
    );
    let state = Hinge {
        angle: 0.6,
        angular_velocity: -1.2,
    };
    check(
        "pivot",
        &scenes::Pivot::default(),
        &state,
        &scenes::PivotInput { push, wind },
    );
    let state = PlanarTranslation { position, velocity };
    let body = scenes::PlanarTranslation::default();
    check(
        "planar_translation",
        &body,
        &state,
        &scenes::PlanarTranslationInput { push, wind },
    );
}

/// A generic body has the series of the same body of doubles.
#[test]
fn generic() {
    let state = Hinge {
        angle: 0.6,
        angular_velocity: -1.2,
    };
    let (generic, plain) = (
        scenes::AnyPendulum::<f64>::default(),
        scenes::Pendulum::default(),
    );
    let [generic, plain] = [
        generic.series::<12>(0.0, &state, &()),
        plain.series::<12>(0.0, &state, &()),
    ];
    assert_eq!(generic.coefficients(), plain.coefficients());
}

/// A polynomial motion has a series that ends, and one step is exact.
#[test]
fn a_thrown_stone() {
    let stone = scenes::Stone::default();
    let thrown = Translation {
        position: [1.0, 2.0, 3.0].into(),
        velocity: [4.0, 5.0, 6.0].into(),
    };
    let series = stone.series::<9>(0.0, &thrown, &());
    let rows = series.coefficients();
    assert_eq!(rows[1], [4.0, 5.0, 6.0, 0.0, 0.0, -10.0]);
    assert_eq!(rows[2], [0.0, 0.0, -5.0, 0.0, 0.0, 0.0]);
    assert!(rows[3..].iter().all(|row| *row == [0.0; 6]));
    let later = newton_euler::integrate::taylor(&stone, &thrown, &(), 0.0..8.0, 1e-3).unwrap();
    assert_eq!(later.position, nalgebra::Vector3::new(33.0, 42.0, -269.0));
}
