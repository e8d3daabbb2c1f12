//! The loads on the craft, written by hand.

use nalgebra::{Matrix3, Vector3};
use newton_euler::load::Family::{External, Field, Joint, Reaction};
use newton_euler::prelude::*;
use proptest::prelude::*;

use super::craft;
use crate::oracle::{Sum, spatial, vectors};

#[derive(Clone, Debug)]
pub struct Given {
    pub state: Spatial,
    pub push: Vector3<f64>,
    pub pull: Vector3<f64>,
    pub wind: Vector3<f64>,
    pub turn: Vector3<f64>,
    pub twist: Vector3<f64>,
    pub throttle: f64,
}

pub fn given() -> impl Strategy<Value = Given> {
    let v = || vectors(8.0);
    (spatial(), v(), v(), v(), v(), v(), 0.0..1.0).prop_map(
        |(state, push, pull, wind, turn, twist, throttle)| Given {
            state,
            push,
            pull,
            wind,
            turn,
            twist,
            throttle,
        },
    )
}

impl Given {
    pub fn baked(&self) -> craft::BakedInput {
        let Self {
            push,
            pull,
            wind,
            turn,
            twist,
            throttle,
            ..
        } = *self;
        craft::BakedInput {
            push,
            pull,
            wind,
            turn,
            twist,
            throttle,
        }
    }

    pub fn parametric(&self) -> craft::ParametricInput {
        let Self {
            push,
            pull,
            wind,
            turn,
            twist,
            throttle,
            ..
        } = *self;
        craft::ParametricInput {
            push,
            pull,
            wind,
            turn,
            twist,
            throttle,
        }
    }
}

pub const MASS: f64 = 2.5;

pub fn inertia() -> Matrix3<f64> {
    Matrix3::new(1.3, -0.12, 0.07, -0.12, 1.7, -0.05, 0.07, -0.05, 2.1)
}

/// A load in world axes: force, its size, where it acts from G, couple, its size.
pub struct Acting {
    pub name: &'static str,
    pub family: Family,
    pub force: (Vector3<f64>, f64),
    pub arm: (Vector3<f64>, f64),
    pub couple: (Vector3<f64>, f64),
}

/// All loads, in the order of the families.
pub fn loads(given: &Given) -> Vec<Acting> {
    let Spatial {
        position: g,
        attitude: q,
        velocity: v,
        angular_velocity: w,
    } = given.state;
    let [tip, tail, hook] =
        [[0.4, -0.2, 0.1], [-0.6, 0.1, -0.2], [0.3, 0.0, 0.5]].map(Vector3::from);
    let [mast, wall] = [[2.0, -1.0, 3.0], [-1.0, 0.5, 1.0]].map(Vector3::from);
    let none = (Vector3::zeros(), 0.0);
    let on_body = |r: Vector3<f64>| (q * r, r.norm());
    let in_space = |p: Vector3<f64>| (p - g, p.norm() + g.norm());
    let force = |name, family, (force, size), arm| Acting {
        name,
        family,
        force: (force, size),
        arm,
        couple: none,
    };
    let couple = |name, family, vector: Vector3<f64>, size| Acting {
        name,
        family,
        force: none,
        arm: none,
        couple: (vector, size),
    };
    let plain = |f: Vector3<f64>| (f, f.norm());
    let turned = |f: Vector3<f64>| (q * f, f.norm());

    let air = v + q * w.cross(&tail) - given.wind;
    let airspeed = v.norm() + w.norm() * tail.norm() + given.wind.norm();
    let stretch = mast - (g + q * hook);
    let stretch_size = mast.norm() + g.norm() + hook.norm();
    let gain = if given.throttle < 0.5 && g.z <= 4.0 {
        2.0 * given.throttle
    } else {
        1.0 + given.throttle * given.throttle
    };
    let [dipole, field] = [Vector3::new(1.0, 2.0, 3.0), Vector3::new(0.1, 0.2, 0.3)];
    vec![
        force("held", Reaction, plain(given.pull), in_space(wall)),
        couple("clamped", Reaction, q * given.turn * 0.5, given.turn.norm()),
        force("linked", Joint, turned(2.0 * given.push), in_space(wall)),
        couple("hinged", Joint, q * Vector3::new(0.25, 0.0, -0.5), 1.0),
        force("pushed", External, turned(given.push), on_body(tip)),
        force("pulled", External, plain(given.pull), on_body(tail)),
        force(
            "drag",
            External,
            (air * -0.8 * air.norm(), 0.8 * airspeed.powi(2)),
            on_body(tail),
        ),
        force(
            "spring",
            External,
            (stretch * 12.5, 12.5 * stretch_size),
            on_body(hook),
        ),
        force(
            "jet",
            External,
            turned(Vector3::new(0.0, 3.0, 4.0) * gain),
            on_body(tip),
        ),
        couple("turned", External, q * given.turn, given.turn.norm()),
        couple("twisted", External, given.twist, given.twist.norm()),
        couple("damped", External, q * w * -0.3, w.norm()),
        force(
            "weight",
            Field,
            plain(Vector3::new(0.0, 0.0, -MASS * 9.80665)),
            on_body(Vector3::zeros()),
        ),
        force(
            "lifted",
            Field,
            plain(Vector3::new(0.5, 0.0, 2.0)),
            on_body(hook),
        ),
        couple(
            "magnet",
            Field,
            (q * dipole).cross(&field),
            dipole.norm() * field.norm(),
        ),
    ]
}

pub fn resultant(loads: &[Acting]) -> Sum<3> {
    loads
        .iter()
        .fold(Sum::new(), |sum, load| sum.and(load.force.0, load.force.1))
}

/// Moment about G, world axes.
pub fn moment(loads: &[Acting]) -> Sum<3> {
    loads.iter().fold(Sum::new(), |sum, load| {
        sum.and(load.arm.0.cross(&load.force.0), load.arm.1 * load.force.1)
            .and(load.couple.0, load.couple.1)
    })
}

/// `-(J ω̇ + ω × J ω)` about G, world axes.
pub fn inertial(state: &Spatial, angular: &Vector3<f64>, sum: Sum<3>) -> Sum<3> {
    let (q, w, j) = (state.attitude, state.angular_velocity, inertia());
    sum.and(-(q * (j * angular)), j.norm() * angular.norm())
        .and(-(q * w.cross(&(j * w))), j.norm() * w.norm_squared())
}
