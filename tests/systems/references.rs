//! The systems of `tests/reference/systems`: accelerations, reactions, energies, motions.

use nalgebra::{Quaternion, UnitQuaternion, Vector3};
use newton_euler::{prelude::*, state::Coordinates};
use serde_json::Value;

use super::compare::{Listed, close};
use super::described::*;
use super::reference::{number, numbers};

/// Of one set of numbers to the next.
const TOLERANCE: f64 = 1e-13;

fn file(text: &str) -> Value {
    serde_json::from_str(text).unwrap()
}

fn list(value: &Value) -> Vec<f64> {
    value.as_array().unwrap().iter().map(number).collect()
}

/// Compares joint loads with those of the file, planar ones by the components they have.
fn reactions(data: &Value, found: &[Vec<f64>]) {
    let all = data["reactions"].as_array().unwrap();
    assert_eq!(all.len(), found.len());
    let pairs: Vec<[f64; 6]> = all
        .iter()
        .map(|pair| {
            let ([a, b, c], [d, e, f]) = (numbers(&pair["force"]), numbers(&pair["moment"]));
            [a, b, c, d, e, f]
        })
        .collect();
    let largest = pairs.concat().iter().fold(0.0, |a: f64, b| a.max(b.abs()));
    for (found, pair) in found.iter().zip(&pairs) {
        let expected = match found.len() {
            0 => continue,
            3 => vec![pair[0], pair[1], pair[5]],
            _ => pair.to_vec(),
        };
        close("reaction", found, &expected, largest, TOLERANCE);
    }
}

fn hinges<const N: usize>(q: &[f64], v: &[f64]) -> [Hinge; N] {
    let mut found = [Hinge::default(); N];
    for (k, hinge) in found.iter_mut().enumerate() {
        (hinge.angle, hinge.angular_velocity) = (q[k], v[k]);
    }
    found
}

/// Positions, then rates, of the end of a trajectory.
fn end(data: &Value) -> Vec<f64> {
    let last = &data["trajectory"];
    [list(&last["q"]), list(&last["v"])].concat()
}

fn energy<B: Energy<Scalar = f64>>(system: &B, state: &B::State, input: &B::Input) -> f64 {
    system.kinetic_energy(state) + system.potential_energy(0.0, state, input)
}

/// The state after the time of the trajectory.
macro_rules! moved {
    ($system:ident, $state:ident, $input:expr, $end:expr) => {{
        let run = $system.integrate(&$state).input($input).tolerance(1e-13);
        run.to(number($end)).unwrap()
    }};
}

#[test]
fn double_pendulum() {
    let data = file(include_str!("../reference/systems/double_pendulum.json"));
    let (q, v, system) = (
        list(&data["q"]),
        list(&data["v"]),
        DoublePendulum::default(),
    );
    let [shoulder, elbow] = hinges(&q, &v);
    let state = DoublePendulumState { shoulder, elbow };
    let found = system.acceleration(0.0, &state, &());
    close(
        "acceleration",
        &[found.shoulder, found.elbow],
        &list(&data["acceleration"]),
        0.0,
        TOLERANCE,
    );
    let loads = system.reactions(0.0, &state, &());
    reactions(&data, &[loads.shoulder.list(), loads.elbow.list()]);
    close(
        "energy",
        &[energy(&system, &state, &())],
        &[number(&data["energy"])],
        0.0,
        TOLERANCE,
    );
    let last = moved!(system, state, (), &data["trajectory"]["T"]);
    close(
        "motion",
        last.coordinates().as_ref(),
        &end(&data),
        0.0,
        1e-10,
    );
}

#[test]
fn cart_pole() {
    let data = file(include_str!("../reference/systems/cart_pole.json"));
    let (q, v, system) = (list(&data["q"]), list(&data["v"]), CartPole::default());
    let [_, pole] = hinges(&q, &v);
    let state = CartPoleState {
        track: Slide {
            position: q[0],
            velocity: v[0],
        },
        pole,
    };
    let input = CartPoleInput {
        push: number(&data["drives"][0]),
    };
    let found = system.acceleration(0.0, &state, &input);
    close(
        "acceleration",
        &[found.track, found.pole],
        &list(&data["acceleration"]),
        0.0,
        TOLERANCE,
    );
    let loads = system.reactions(0.0, &state, &input);
    reactions(&data, &[loads.track.list(), loads.pole.list()]);
    close(
        "energy",
        &[energy(&system, &state, &input)],
        &[number(&data["energy"])],
        0.0,
        TOLERANCE,
    );
    let last = moved!(system, state, input, &data["trajectory"]["T"]);
    close(
        "motion",
        last.coordinates().as_ref(),
        &end(&data),
        0.0,
        1e-10,
    );
}

#[test]
fn furuta() {
    let data = file(include_str!("../reference/systems/furuta.json"));
    let system = Furuta::default();
    let [yaw, swing] = hinges(&list(&data["q"]), &list(&data["v"]));
    let state = FurutaState { yaw, swing };
    let input = FurutaInput {
        torque: number(&data["drives"][0]),
    };
    let found = system.acceleration(0.0, &state, &input);
    close(
        "acceleration",
        &[found.yaw, found.swing],
        &list(&data["acceleration"]),
        0.0,
        TOLERANCE,
    );
    let loads = system.reactions(0.0, &state, &input);
    reactions(&data, &[loads.yaw.list(), loads.swing.list()]);
    close(
        "energy",
        &[energy(&system, &state, &input)],
        &[number(&data["energy"])],
        0.0,
        TOLERANCE,
    );
    let last = moved!(system, state, input, &data["trajectory"]["T"]);
    close(
        "motion",
        last.coordinates().as_ref(),
        &end(&data),
        0.0,
        1e-10,
    );
}

/// Of a quaternion x, y, z, w.
fn turning(q: &[f64], v: &[f64]) -> Rotation {
    Rotation {
        attitude: UnitQuaternion::from_quaternion(Quaternion::new(q[3], q[0], q[1], q[2])),
        angular_velocity: Vector3::new(v[0], v[1], v[2]),
    }
}

/// The sign of a quaternion is free.
fn attitudes(found: &UnitQuaternion<f64>, expected: &[f64]) {
    let sign = if found
        .coords
        .dot(&turning(expected, &[0.0; 3]).attitude.coords)
        < 0.0
    {
        -1.0
    } else {
        1.0
    };
    close(
        "attitude",
        &(found.coords * sign).iter().copied().collect::<Vec<_>>(),
        expected,
        0.0,
        1e-10,
    );
}

#[test]
fn ball_double() {
    let data = file(include_str!("../reference/systems/ball_double.json"));
    let (q, v, system) = (list(&data["q"]), list(&data["v"]), BallDouble::default());
    let state = BallDoubleState {
        first: turning(&q, &v),
        second: turning(&q[4..], &v[3..]),
    };
    let found = system.acceleration(0.0, &state, &());
    let found = [found.first.list(), found.second.list()].concat();
    close(
        "acceleration",
        &found,
        &list(&data["acceleration"]),
        0.0,
        TOLERANCE,
    );
    let loads = system.reactions(0.0, &state, &());
    reactions(&data, &[loads.first.list(), loads.second.list()]);
    close(
        "energy",
        &[energy(&system, &state, &())],
        &[number(&data["energy"])],
        0.0,
        TOLERANCE,
    );
    let last = moved!(system, state, (), &data["trajectory"]["T"]);
    let end = end(&data);
    attitudes(&last.first.attitude, &end[..4]);
    attitudes(&last.second.attitude, &end[4..8]);
    let rates = [
        last.first.angular_velocity.list(),
        last.second.angular_velocity.list(),
    ]
    .concat();
    close("motion", &rates, &end[8..], 0.0, 1e-10);
}

#[test]
fn satellite() {
    let data = file(include_str!("../reference/systems/satellite3w.json"));
    let (q, v, system) = (list(&data["q"]), list(&data["v"]), Satellite::default());
    let base = turning(&q[3..], &v[3..]);
    let [spin_x, spin_y, spin_z] = hinges(&q[7..], &v[6..]);
    let orbit = Spatial {
        attitude: base.attitude,
        angular_velocity: base.angular_velocity,
        ..Spatial::default()
    };
    let state = SatelliteState {
        orbit,
        spin_x,
        spin_y,
        spin_z,
    };
    let drives = list(&data["drives"]);
    let input = SatelliteInput {
        torque_x: drives[6],
        torque_y: drives[7],
        torque_z: drives[8],
    };
    let found = system.acceleration(0.0, &state, &input);
    // that of the file is along body axes, and the velocity is zero
    let linear = base.attitude.inverse() * found.orbit.linear;
    let spins = vec![found.spin_x, found.spin_y, found.spin_z];
    let found = [found.orbit.angular.list(), spins].concat();
    let expected = list(&data["acceleration"]);
    close("acceleration", &linear.list(), &expected[..3], 0.0, 1e-12);
    close("acceleration", &found, &expected[3..], 0.0, TOLERANCE);
    let loads = system.reactions(0.0, &state, &input);
    reactions(
        &data,
        &[
            vec![],
            loads.spin_x.list(),
            loads.spin_y.list(),
            loads.spin_z.list(),
        ],
    );
    close(
        "energy",
        &[energy(&system, &state, &input)],
        &[number(&data["energy"])],
        0.0,
        TOLERANCE,
    );
    let last = moved!(system, state, input, &data["trajectory"]["T"]);
    let end = end(&data);
    close(
        "position",
        &last.orbit.position.list(),
        &end[..3],
        0.0,
        1e-10,
    );
    attitudes(&last.orbit.attitude, &end[3..7]);
    let angles = [last.spin_x.angle, last.spin_y.angle, last.spin_z.angle];
    close("angles", &angles, &end[7..10], 0.0, 1e-10);
    let velocity = last.orbit.attitude.inverse() * last.orbit.velocity;
    close("velocity", &velocity.list(), &end[10..13], 0.0, 1e-10);
    close(
        "turning",
        &last.orbit.angular_velocity.list(),
        &end[13..16],
        0.0,
        1e-10,
    );
    let rates = [&last.spin_x, &last.spin_y, &last.spin_z].map(|spin| spin.angular_velocity);
    close("spins", &rates, &end[16..], 0.0, 1e-10);
}

#[test]
fn ur5() {
    let data = file(include_str!("../reference/systems/ur5.json"));
    let [pan, lift, elbow, wrist_1, wrist_2, wrist_3] =
        hinges(&list(&data["q"]), &list(&data["v"]));
    let state = Ur5State {
        pan,
        lift,
        elbow,
        wrist_1,
        wrist_2,
        wrist_3,
    };
    let drives: [f64; 6] = numbers(&data["drives"]);
    let input = Ur5Input {
        drives_1: drives[0],
        drives_2: drives[1],
        drives_3: drives[2],
        drives_4: drives[3],
        drives_5: drives[4],
        drives_6: drives[5],
    };
    let system = Ur5::default();
    let found = system.acceleration(0.0, &state, &input);
    let found = [
        found.pan,
        found.lift,
        found.elbow,
        found.wrist_1,
        found.wrist_2,
        found.wrist_3,
    ];
    close(
        "acceleration",
        &found,
        &list(&data["acceleration"]),
        0.0,
        TOLERANCE,
    );
    let loads = system.reactions(0.0, &state, &input);
    let loads = [
        loads.pan,
        loads.lift,
        loads.elbow,
        loads.wrist_1,
        loads.wrist_2,
        loads.wrist_3,
    ];
    reactions(&data, &loads.map(|load| load.list()));
    close(
        "energy",
        &[energy(&system, &state, &input)],
        &[number(&data["energy"])],
        0.0,
        TOLERANCE,
    );
}

#[test]
fn dual_spin() {
    let data = file(include_str!("../reference/systems/gyrostat_axial.json"));
    let start: [f64; 3] = numbers(&data["data"]["omega0"]);
    // the momentum of the rotor about its axis is 4.2 with its part that turns with the body
    let spinning = Spatial {
        angular_velocity: start.into(),
        ..Spatial::default()
    };
    let rotor = Hinge {
        angle: 0.0,
        angular_velocity: 4.2 / 0.6 - start[2],
    };
    let state = DualSpinState {
        orbit: spinning,
        spin: rotor,
    };
    let system = DualSpin::default();
    let last = moved!(system, state, (), &data["data"]["t"]);
    let expected: [f64; 3] = numbers(&data["omega_end"]);
    close(
        "turning",
        &last.orbit.angular_velocity.list(),
        &expected,
        0.0,
        1e-11,
    );
}
