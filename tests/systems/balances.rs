//! Another way to the same numbers: each body by itself, with the loads of its joints as unknowns.
//!
//! The unknowns are the accelerations of the coordinates and six components of load for each joint.
//! The equations are the balances of each body, and the power of the joint loads along the freedoms
//! of each joint, which is that of its drives.

use super::oracle::{Link, Loads, Mat3, Motion, Rates, Vec3, motions};

pub struct Solution {
    pub accelerations: Vec<Vec<f64>>,
    /// Force and moment on the carried body at Q, world axes.
    pub joints: Vec<[Vec3; 2]>,
    pub loads: Loads,
    /// At these accelerations.
    pub motions: Vec<Motion>,
}

/// One linear system: the balances of each body, six rows each, and a row for each freedom; the
/// columns are the accelerations, six components of load for each joint, and what is known.
struct Rows<'a> {
    links: &'a [Link],
    rates: &'a [Rates],
    /// Where the bodies are, and how they accelerate if no coordinate does.
    bias: Vec<Motion>,
    /// World axes.
    tensors: Vec<Mat3>,
    freedoms: usize,
    matrix: Vec<Vec<f64>>,
}

/// Accelerations and joint loads.
pub fn solve(
    links: &[Link],
    rates: &[Rates],
    gravity: Vec3,
    load: impl Fn(&mut Loads),
) -> Solution {
    let counts = links.iter().map(|link| link.kind.freedoms());
    let still: Vec<Vec<f64>> = counts.map(|count| vec![0.0; count]).collect();
    let bias = motions(links, rates, &still);
    let weights = links
        .iter()
        .map(|link| [gravity * link.mass, Vec3::zeros()]);
    let mut loads = Loads {
        on: weights.collect(),
        drives: still.clone(),
        motions: bias.clone(),
        rates: rates.to_vec(),
    };
    load(&mut loads);
    let mut rows = Rows::new(links, rates, bias);
    for body in 0..links.len() {
        rows.balance(body, loads.on[body]);
    }
    let mut column = 0;
    for (joint, drives) in loads.drives.iter().enumerate() {
        for (freedom, drive) in drives.iter().enumerate() {
            let mut unit = still.clone();
            unit[joint][freedom] = 1.0;
            rows.freedom(joint, column, &unit, *drive);
            column += 1;
        }
    }
    let found = eliminate(&rows.matrix);
    let (first, rest) = found.split_at(rows.freedoms);
    let mut first = first.iter().copied();
    let accelerations = still
        .iter()
        .map(|joint| first.by_ref().take(joint.len()).collect());
    let accelerations: Vec<Vec<f64>> = accelerations.collect();
    let pair = |load: &[f64]| [0, 3].map(|part| Vec3::from_row_slice(&load[part..part + 3]));
    Solution {
        joints: rest.chunks(6).map(pair).collect(),
        motions: motions(links, rates, &accelerations),
        accelerations,
        loads,
    }
}

impl<'a> Rows<'a> {
    fn new(links: &'a [Link], rates: &'a [Rates], bias: Vec<Motion>) -> Self {
        let freedoms = links.iter().map(|link| link.kind.freedoms()).sum();
        let size = freedoms + 6 * links.len();
        let tensors = links.iter().zip(&bias);
        let tensors = tensors
            .map(|(link, motion)| motion.attitude * link.inertia * motion.attitude.transpose());
        Self {
            tensors: tensors.collect(),
            matrix: vec![vec![0.0; size + 1]; size],
            links,
            rates,
            bias,
            freedoms,
        }
    }

    /// What is known of the balance of a body, and the loads of its joints.
    fn balance(&mut self, body: usize, [force, moment]: [Vec3; 2]) {
        let motion = self.bias[body];
        let tensor = self.tensors[body];
        let spin = motion
            .angular_velocity
            .cross(&(tensor * motion.angular_velocity));
        let inertial = tensor * motion.angular_acceleration + spin;
        let known = self.matrix.len();
        self.set(
            6 * body,
            known,
            &(force - motion.acceleration * self.links[body].mass),
        );
        self.set(6 * body + 3, known, &(moment - inertial));
        // the load of its own joint, and against it those of the joints it carries
        for (joint, link) in self.links.iter().enumerate() {
            let sign = match (joint == body, link.carrier == Some(body)) {
                (true, _) => 1.0,
                (_, true) => -1.0,
                _ => continue,
            };
            let pin = self.bias[joint].position + self.bias[joint].attitude * link.pin;
            let column = self.freedoms + 6 * joint;
            for axis in 0..3 {
                let force = Vec3::ith(axis, -sign);
                let moment = (pin - motion.position).cross(&force);
                self.set(6 * body, column + axis, &force);
                self.set(6 * body + 3, column + axis, &moment);
                self.set(6 * body + 3, column + 3 + axis, &force);
            }
        }
    }

    /// What the acceleration of a freedom does to all bodies, and what the joint load does along it.
    fn freedom(&mut self, joint: usize, column: usize, unit: &[Vec<f64>], drive: f64) {
        let slow = self
            .rates
            .iter()
            .map(|(q, v)| (q.clone(), vec![0.0; v.len()]));
        let along = motions(self.links, &slow.collect::<Vec<_>>(), unit);
        for (body, link) in self.links.iter().enumerate() {
            let turning = self.tensors[body] * along[body].angular_acceleration;
            self.set(6 * body, column, &(along[body].acceleration * link.mass));
            self.set(6 * body + 3, column, &turning);
        }
        let turning = along[joint].angular_acceleration;
        let pin = self.bias[joint].attitude * self.links[joint].pin;
        let sliding = along[joint].acceleration + turning.cross(&pin);
        let load = self.freedoms + 6 * joint;
        let row = &mut self.matrix[6 * self.links.len() + column];
        row[load..load + 3].copy_from_slice(sliding.as_slice());
        row[load + 3..load + 6].copy_from_slice(turning.as_slice());
        if let Some(known) = row.last_mut() {
            *known = drive;
        }
    }

    fn set(&mut self, row: usize, column: usize, vector: &Vec3) {
        for axis in 0..3 {
            self.matrix[row + axis][column] = vector[axis];
        }
    }
}

/// Elimination with the largest pivot of each column, and two refinements.
fn eliminate(rows: &[Vec<f64>]) -> Vec<f64> {
    let size = rows.len();
    let mut found = vec![0.0; size];
    for _ in 0..3 {
        let mut left = rows.to_vec();
        for row in &mut left {
            row[size] -= row.iter().zip(&found).map(|(a, x)| a * x).sum::<f64>();
        }
        let change = once(left);
        for (x, change) in found.iter_mut().zip(change) {
            *x += change;
        }
    }
    found
}

fn once(mut rows: Vec<Vec<f64>>) -> Vec<f64> {
    let size = rows.len();
    for column in 0..size {
        let largest =
            |a: &usize, b: &usize| rows[*a][column].abs().total_cmp(&rows[*b][column].abs());
        let pivot = (column..size).max_by(largest).unwrap();
        rows.swap(column, pivot);
        let (above, below) = rows.split_at_mut(column + 1);
        let pivot = &above[column];
        for row in below {
            let factor = row[column] / pivot[column];
            if factor != 0.0 {
                for k in column..=size {
                    row[k] -= factor * pivot[k];
                }
            }
        }
    }
    let mut found = vec![0.0; size];
    for row in (0..size).rev() {
        let rest: f64 = (row + 1..size).map(|k| rows[row][k] * found[k]).sum();
        found[row] = (rows[row][size] - rest) / rows[row][row];
    }
    found
}
