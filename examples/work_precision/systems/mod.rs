//! Systems, as problems, each with its methods.

mod by_hand;
mod described;
mod recursion;

use nalgebra::{Quaternion, UnitQuaternion, Vector3};
use newton_euler::prelude::*;
use newton_euler::state::Coordinates;
use serde_json::Value;

use crate::distance::Distance;
use crate::measure::{Care, Curve, measure};
use crate::method::Method;
use crate::peers::plain::Plain;
use crate::peers::runge_kutta::Renormalised;
use crate::problem::Problem;
use crate::reference::{self, number};
use crate::{ours, peers};
use described::*;

/// All of them, measured.
pub fn all(care: Care) -> Vec<Curve> {
    let pendulum = reference::system("double_pendulum");
    let pendulum = Problem {
        name: "double_pendulum",
        body: DoublePendulum::default(),
        start: links(&pendulum),
        seconds: number(&pendulum["trajectory"]["T"]),
        end: links(&pendulum["trajectory"]),
    };
    let satellite = reference::system("satellite3w");
    let satellite = Problem {
        name: "satellite, three wheels",
        body: Gyrostat::default(),
        start: spun(&satellite),
        seconds: number(&satellite["trajectory"]["T"]),
        end: spun(&satellite["trajectory"]),
    };
    let moved = reference::arm();
    let arm = Problem {
        name: "UR5",
        body: Ur5::default(),
        start: bent(&reference::system("ur5")),
        seconds: number(&moved["T"]),
        end: bent(&moved),
    };
    let curves = [
        measured(care, &pendulum, ours::smooth(&pendulum), by_hand::Links),
        measured(
            care,
            &satellite,
            ours::smooth(&satellite),
            by_hand::Wheels::new(),
        ),
        // the series of an arm take minutes to compile
        measured(care, &arm, ours::any(&arm), recursion::Arm::new()),
    ];
    curves.into_iter().flatten().collect()
}

fn measured<'p, B, C>(
    care: Care,
    problem: &'p Problem<B>,
    mut methods: Vec<Method<'p, B::State>>,
    by_hand: C,
) -> Vec<Curve>
where
    B: RigidBody<Scalar = f64, Input = ()>,
    B::State: Distance + Renormalised + Coordinates<Scalar = f64, Array: Plain>,
    C: RigidBody<Scalar = f64, State = B::State, Input = ()>,
{
    let by_hand = problem.of(by_hand);
    let peers = peers::general(problem, &by_hand);
    // those of the peers do not outlive what they are of
    let methods: Vec<Method<'_, B::State>> = methods.drain(..).chain(peers).collect();
    measure(care, problem.name, problem.seconds, &problem.end, &methods)
}

/// The numbers of a file from a place on: positions `q`, rates `v`.
fn listed(data: &Value, name: &str, place: usize) -> Vec<f64> {
    let list = data[name].as_array().expect("a list");
    list[place..].iter().map(number).collect()
}

/// The k-th of the hinges that begin at these places.
fn hinge(data: &Value, [q, v]: [usize; 2], k: usize) -> Hinge {
    Hinge {
        angle: listed(data, "q", q)[k],
        angular_velocity: listed(data, "v", v)[k],
    }
}

fn links(data: &Value) -> DoublePendulumState {
    DoublePendulumState {
        shoulder: hinge(data, [0, 0], 0),
        elbow: hinge(data, [0, 0], 1),
    }
}

fn bent(data: &Value) -> Ur5State {
    let joint = |k| hinge(data, [0, 0], k);
    Ur5State {
        pan: joint(0),
        lift: joint(1),
        elbow: joint(2),
        wrist_1: joint(3),
        wrist_2: joint(4),
        wrist_3: joint(5),
    }
}

/// The velocity of the file is along body axes.
fn spun(data: &Value) -> GyrostatState {
    let (q, v) = (listed(data, "q", 0), listed(data, "v", 0));
    let attitude = UnitQuaternion::new_normalize(Quaternion::new(q[6], q[3], q[4], q[5]));
    let wheel = |k| hinge(data, [7, 6], k);
    GyrostatState {
        orbit: Spatial {
            position: Vector3::from_column_slice(&q[..3]),
            attitude,
            velocity: attitude * Vector3::from_column_slice(&v[..3]),
            angular_velocity: Vector3::from_column_slice(&v[3..6]),
        },
        spin_x: wheel(0),
        spin_y: wheel(1),
        spin_z: wheel(2),
    }
}

/// What a state of several joints has from them.
macro_rules! joints {
    ($($state:ident: $($joint:ident)*;)*) => {$(
        impl Distance for $state {
            fn distance(&self, right: &Self) -> f64 {
                0_f64$(.max(self.$joint.distance(&right.$joint)))*
            }
        }

        impl Renormalised for $state {
            #[inline(always)]
            fn renormalised(self) -> Self {
                Self { $($joint: self.$joint.renormalised()),* }
            }
        }
    )*};
}

joints! {
    DoublePendulumState: shoulder elbow;
    GyrostatState: orbit spin_x spin_y spin_z;
    Ur5State: pan lift elbow wrist_1 wrist_2 wrist_3;
}
