//! The systems of `tests/reference/systems`, by Lagrange's equations. These use only the kinetic
//! energy of the trees in the files and its exact derivatives, and nothing of Newton's and Euler's
//! laws.

use newton_euler::{prelude::*, state::Coordinates};
use serde_json::Value;

use super::described::*;
use super::lagrange_systems::jet::Real;
use super::lagrange_systems::{Body, Load, Matrix, Part, State, Vector, missing};
use super::reference::{number, numbers, system};

impl Real for f64 {
    fn sin_cos(self) -> (Self, Self) {
        Self::sin_cos(self)
    }
}

fn list(value: &Value) -> Vec<f64> {
    value.as_array().unwrap().iter().map(number).collect()
}

fn minus(vector: Vector<f64>) -> Vector<f64> {
    vector.map(|part| -part)
}

fn matrix(value: &Value) -> Matrix<f64> {
    [0, 1, 2].map(|row| numbers(&value[row]))
}

/// Of a quaternion, the scalar last.
fn rows(q: &[f64]) -> Matrix<f64> {
    let [x, y, z, w] = [q[0], q[1], q[2], q[3]];
    [
        [
            1.0 - 2.0 * (y * y + z * z),
            2.0 * (x * y - w * z),
            2.0 * (x * z + w * y),
        ],
        [
            2.0 * (x * y + w * z),
            1.0 - 2.0 * (x * x + z * z),
            2.0 * (y * z - w * x),
        ],
        [
            2.0 * (x * z - w * y),
            2.0 * (y * z + w * x),
            1.0 - 2.0 * (x * x + y * y),
        ],
    ]
}

/// The bodies of a file, and a coordinate for each freedom.
fn tree(file: &Value) -> (Vec<Body<f64>>, Vec<f64>) {
    let joints = file["system"]["joints"].as_array().unwrap();
    let numbers_of = list(&file["q"]);
    let (mut rest, mut freedoms) = (&numbers_of[..], Vec::new());
    let mut take = |count: usize| {
        let (first, others) = rest.split_at(count);
        rest = others;
        first
    };
    let bodies = joints.iter().map(|joint| {
        let [x, y, z] = [0, 1, 2].map(|k| [0, 1, 2].map(|j| f64::from(u8::from(j == k))));
        let kind = joint["type"].as_str().unwrap();
        let axis = match &kind[1..] {
            "X" => x,
            "Y" => y,
            _ => z,
        };
        let ball = |q: &[f64]| Part::Ball(rows(q));
        let parts = match &kind[..1] {
            "R" => {
                freedoms.extend(take(1));
                vec![Part::Turn(axis)]
            }
            "P" => {
                freedoms.extend(take(1));
                vec![Part::Slide(axis)]
            }
            "S" => {
                freedoms.extend([0.0; 3]);
                vec![ball(take(4))]
            }
            _ => {
                freedoms.extend(take(3));
                freedoms.extend([0.0; 3]);
                vec![
                    Part::Slide(x),
                    Part::Slide(y),
                    Part::Slide(z),
                    ball(take(4)),
                ]
            }
        };
        let carrier = usize::try_from(joint["parent"].as_i64().unwrap()).ok();
        let place: Vector<f64> = numbers(&joint["p"]);
        let of = |k: usize| numbers::<3>(&joints[k]["inertia"]["c"]);
        let from = carrier.map_or([0.0; 3], of);
        Body {
            mass: number(&joint["inertia"]["m"]),
            inertia: matrix(&joint["inertia"]["Ic"]),
            carrier,
            place: [0, 1, 2].map(|k| place[k] - from[k]),
            pin: minus(numbers(&joint["inertia"]["c"])),
            turned: matrix(&joint["R"]),
            parts,
        }
    });
    let bodies = bodies.collect();
    (bodies, freedoms)
}

/// What the drives of the file do is all that Lagrange's equations of the generated accelerations lack.
fn check<B>(name: &str, body: &B, input: impl Fn(&[f64]) -> B::Input)
where
    B: RigidBody<Scalar = f64, State: Coordinates<Scalar = f64> + Default>,
{
    let file = system(name);
    let (v, drives) = (list(&file["v"]), list(&file["drives"]));
    let mut coordinates = B::State::default().coordinates();
    let numbers_of = [list(&file["q"]), v.clone()].concat();
    coordinates.as_mut().copy_from_slice(&numbers_of);
    let state = B::State::from_coordinates(&coordinates);
    let rates = state.rates(&body.acceleration(0.0, &state, &input(&drives)));
    let rates = rates.as_ref();

    let (bodies, q) = tree(&file);
    let gravity: Vector<f64> = numbers(&file["system"]["gravity"]);
    let weight = |body: &Body<f64>| -> Load<f64> { [gravity.map(|g| body.mass * g), [0.0; 3]] };
    let loads: Vec<Load<f64>> = bodies.iter().map(weight).collect();
    let a = &rates[rates.len() - v.len()..];
    let state = State { q: &q, v: &v, a };
    // what is differentiated is of the size of the energy: wheels spin fast
    let energy = number(&file["energy"]).abs();
    let missing = missing(&bodies, &state, &loads, f64::abs);
    let largest = missing
        .iter()
        .fold(energy, |most, (_, size)| most.max(*size));
    for (place, ((left, _), drive)) in missing.iter().zip(&drives).enumerate() {
        let off = (left - drive).abs();
        assert!(off < 1e-13 * largest, "{name}, {place}: {off} of {largest}");
    }
}

#[test]
fn of_the_reference_trees() {
    check("double_pendulum", &DoublePendulum::default(), |_| ());
    check("cart_pole", &CartPole::default(), |drives| CartPoleInput {
        push: drives[0],
    });
    check("furuta", &Furuta::default(), |drives| FurutaInput {
        torque: drives[0],
    });
    check("ball_double", &BallDouble::default(), |_| ());
    check("satellite3w", &Satellite::default(), |drives| {
        SatelliteInput {
            torque_x: drives[6],
            torque_y: drives[7],
            torque_z: drives[8],
        }
    });
    check("ur5", &Ur5::default(), |drives| Ur5Input {
        drives_1: drives[0],
        drives_2: drives[1],
        drives_3: drives[2],
        drives_4: drives[3],
        drives_5: drives[4],
        drives_6: drives[5],
    });
}
