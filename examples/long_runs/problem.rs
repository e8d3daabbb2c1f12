//! What is followed for long: a body, its starts, and what is known of its motion.
#![allow(clippy::float_cmp, reason = "times are powers of two")]

use nalgebra::{UnitQuaternion, Vector3};
use newton_euler::prelude::*;
use serde_json::Value;

use crate::bodies::{FreeBody, HeavyTop, LagrangeTop};
use crate::reference::{attitude, long_runs, number, vector};

/// The attitude, where it is known: of a start, by its number, at a time \[s\].
type Known<'p> = dyn Fn(usize, f64) -> Option<UnitQuaternion<f64>> + 'p;

/// A body and its starts, over which errors are averaged.
pub struct Problem<'p, B> {
    pub name: &'static str,
    pub body: &'p B,
    pub starts: Vec<Rotation>,
    /// Steps are so many times those of the methods.
    pub pace: f64,
    /// What of the angular momentum stays, world axes.
    kept: fn(Vector3<f64>) -> Vector3<f64>,
    known: Box<Known<'p>>,
}

/// What is watched: relative changes of energy and angular momentum, and by how much the attitude is off \[rad\].
pub const QUANTITIES: [&str; 3] = ["energy", "momentum", "attitude"];

/// A body without loads, with attitudes of the reference after 2ⁿ s.
pub fn free(body: &FreeBody) -> Problem<'_, FreeBody> {
    let table = long_runs();
    let rates = table["starts"].as_array().expect("a list").iter();
    let starts = rates.map(|rates| turning(vector(rates))).collect();
    let rows = table["rows"].as_array().expect("a list").clone();
    let known = move |start, time| {
        let is_then = |row: &&Value| number(&row["time"]) == time;
        rows.iter()
            .find(is_then)
            .map(|row| attitude(&row["attitudes"][start]))
    };
    Problem {
        name: "free body",
        body,
        starts,
        pace: 1.0,
        kept: |momentum| momentum,
        known: Box::new(known),
    }
}

/// A symmetric top, with attitudes in closed form.
pub fn lagrange(body: &LagrangeTop) -> Problem<'_, LagrangeTop> {
    let starts = tilted();
    let paths: Vec<_> = starts.iter().map(|start| body.path(start)).collect();
    Problem {
        name: "Lagrange's top",
        body,
        starts,
        pace: 0.5,
        kept: vertical,
        known: Box::new(move |start, time| Some(paths[start].at(time).attitude)),
    }
}

/// A top without symmetry, of which nothing else is known.
pub fn heavy(body: &HeavyTop) -> Problem<'_, HeavyTop> {
    Problem {
        name: "heavy top",
        body,
        starts: tilted(),
        pace: 0.5,
        kept: vertical,
        known: Box::new(|_, _| None),
    }
}

fn turning(angular_velocity: Vector3<f64>) -> Rotation {
    Rotation {
        angular_velocity,
        ..Rotation::default()
    }
}

/// A radian from the vertical.
fn tilted() -> Vec<Rotation> {
    let rates = [
        [0.5, 0.3, 5.0],
        [3.0, 0.5, -0.9],
        [-0.8, 1.7, 4.0],
        [0.2, -2.4, 3.0],
    ];
    let tilted = |rates: [f64; 3]| Rotation {
        attitude: UnitQuaternion::from_axis_angle(&Vector3::x_axis(), 1.0),
        angular_velocity: rates.into(),
    };
    rates.map(tilted).into()
}

fn vertical(momentum: Vector3<f64>) -> Vector3<f64> {
    Vector3::z() * momentum.z
}

impl<B> Problem<'_, B>
where
    B: Energy<State = Rotation, Scalar = f64, Input = ()> + Momentum<Angular = Vector3<f64>>,
{
    /// The errors of a state, of [`QUANTITIES`]; none of an attitude that is not known.
    pub fn errors(&self, start: usize, time: f64, state: &Rotation) -> [Option<f64>; 3] {
        let begin = &self.starts[start];
        let energy = |state: &Rotation| {
            self.body.kinetic_energy(state) + self.body.potential_energy(0.0, state, &())
        };
        let momentum = |state: &Rotation| self.body.angular_momentum_about_pole(0.0, state);
        let lost = (self.kept)(momentum(state) - momentum(begin));
        let turned = (self.known)(start, time).map(|known| angle(&state.attitude, &known));
        [
            Some((energy(state) / energy(begin) - 1.0).abs()),
            Some(lost.norm() / momentum(begin).norm()),
            turned,
        ]
    }
}

/// The angle between two attitudes \[rad\], of small ones too.
fn angle(one: &UnitQuaternion<f64>, other: &UnitQuaternion<f64>) -> f64 {
    let between = one.rotation_to(other);
    2.0 * between.imag().norm().atan2(between.w.abs())
}
