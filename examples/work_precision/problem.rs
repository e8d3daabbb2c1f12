//! What is to be solved: a body, its start, and where it is after some time, to more digits than a double has.

use nalgebra::{UnitQuaternion, Vector3};
use newton_euler::prelude::*;
use newton_euler::state::Coordinates;
use serde_json::Value;

use crate::reference::{attitude, flight, number, trajectory, vector};

/// A body on its way from a start to a known end.
pub struct Problem<B: RigidBody> {
    pub name: &'static str,
    pub body: B,
    pub start: B::State,
    /// \[s\]
    pub seconds: f64,
    pub end: B::State,
}

impl<B: RigidBody> Problem<B> {
    /// The same of another body.
    ///
    /// # Panics
    /// If it does not move alike.
    pub fn of<C>(&self, body: C) -> Problem<C>
    where
        B: RigidBody<Scalar = f64, Input = (), State: Coordinates<Scalar = f64>>,
        C: RigidBody<Scalar = f64, Input = (), State = B::State>,
    {
        let [ours, other] = [
            self.body.acceleration(0.0, &self.start, &()),
            body.acceleration(0.0, &self.start, &()),
        ];
        let [ours, other] = [ours, other].map(|acceleration| self.start.rates(&acceleration));
        for (one, other) in ours.as_ref().iter().zip(other.as_ref()) {
            let difference = (one - other).abs();
            assert!(
                difference <= 1e-11 * one.abs(),
                "{}: {one} is not {other}",
                self.name
            );
        }
        Problem {
            name: self.name,
            body,
            start: self.start.clone(),
            seconds: self.seconds,
            end: self.end.clone(),
        }
    }
}

fn rotation(attitude: UnitQuaternion<f64>, angular_velocity: Vector3<f64>) -> Rotation {
    Rotation {
        attitude,
        angular_velocity,
    }
}

/// A problem of `trajectories.json`, over the ten seconds of `at_T_10` where it has them.
pub fn turning<B: RigidBody<State = Rotation>>(name: &'static str, body: B) -> Problem<B> {
    let problem = trajectory(name);
    let (early, whole) = (&problem["at_T_10"], number(&problem["T"]));
    let (end, seconds) = if early.is_null() {
        (&problem, whole)
    } else {
        (early, 10.0)
    };
    Problem {
        name,
        body,
        start: rotation(attitude(&problem["q0"]), vector(&problem["w0"])),
        seconds,
        end: rotation(attitude(&end["q_ref"]), vector(&end["w_ref"])),
    }
}

/// The pendulum of `trajectories.json`, of one angle, from rest at 2.5 rad.
pub fn swinging<B: RigidBody<State = Hinge>>(name: &'static str, body: B) -> Problem<B> {
    let problem = trajectory("pendulum_planar");
    Problem {
        name,
        body,
        start: Hinge {
            angle: 2.5,
            angular_velocity: 0.0,
        },
        seconds: number(&problem["T"]),
        end: Hinge {
            angle: number(&problem["theta_T"]),
            angular_velocity: vector(&problem["w_ref"]).x,
        },
    }
}

/// A problem of `flights.json`.
pub fn flying<B: RigidBody<State = Spatial>>(name: &'static str, body: B) -> Problem<B> {
    let problem = flight(name);
    let state = |values: &Value| {
        let part = |places: std::ops::Range<usize>| {
            values.as_array().expect("a list")[places].to_vec().into()
        };
        Spatial {
            position: vector(&part(0..3)),
            attitude: attitude(&part(3..7)),
            velocity: vector(&part(7..10)),
            angular_velocity: vector(&part(10..13)),
        }
    };
    Problem {
        name,
        body,
        start: state(&problem["start"]),
        seconds: number(&problem["T"]),
        end: state(&problem["end"]),
    }
}
