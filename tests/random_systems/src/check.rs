//! What the compiler says of a system, against the law.

use std::fmt::Write as _;

use fastrand::Rng;
use fuzz::symbolic::Id;

use crate::compiled::{Compiled, Given};
use crate::drawn::Drawn;
use crate::oracle::{Kind, Loads, Rates, Scene, motions, still};
use crate::space::{Vec3, ZERO, add, apply, cross, dot, scale, size, subtract};
use crate::wide::Wide;

/// Of 106 bits, relative to the terms: what is wrong is no rounding.
const EXACT: f64 = 1e-20;

/// The largest errors of doubles.
#[derive(Clone, Copy, Debug, Default)]
pub struct Errors {
    /// Of accelerations, relative to the largest.
    pub acceleration: f64,
    /// Per what a unit in the last place of the state does.
    pub conditioned: f64,
}

/// What fails, and by how much.
pub type Failure = String;

pub struct State {
    time: Wide,
    params: Vec<Wide>,
    inputs: Vec<Wide>,
    rates: Vec<Rates>,
    /// True of what is driven, any of the rest.
    accelerations: Vec<Vec<Wide>>,
    loads: Vec<[Vec3; 2]>,
}

impl State {
    pub fn new(drawn: &Drawn, rng: &mut Rng) -> Self {
        let mut number = |most: f64| Wide::from((rng.f64() * 2.0 - 1.0) * most);
        let time = number(2.0);
        let inputs: Vec<Wide> = drawn
            .declared
            .inputs
            .iter()
            .map(|(_, value)| (*value).into())
            .collect();
        let (mut rates, mut accelerations, mut loads) = (Vec::new(), Vec::new(), Vec::new());
        for link in &drawn.links {
            let mut list =
                |count: usize| -> Vec<Wide> { (0..count).map(|_| number(3.0)).collect() };
            let count = link.kind.freedoms();
            let (mut q, mut v, mut a) = (list(count), list(count), list(count));
            if matches!(link.kind, Kind::Spherical | Kind::Free) {
                q.push(number(1.0));
                let from = q.len() - 4;
                let square: Wide = q[from..].iter().map(|part| *part * *part).sum();
                let length = square.sqrt();
                for part in &mut q[from..] {
                    *part = *part / length;
                }
            }
            for (freedom, function) in link.driven.iter().flatten().enumerate() {
                [q[freedom], v[freedom], a[freedom]] = function(time, &inputs);
            }
            rates.push((q, v));
            accelerations.push(a);
            loads.push([0; 2].map(|_| [0; 3].map(|_| number(5.0))));
        }
        for (load, link) in loads.iter_mut().zip(&drawn.links) {
            if drawn.is_planar {
                (load[0][2], load[1][0], load[1][1]) = (Wide::ZERO, Wide::ZERO, Wide::ZERO);
            }
            // what is free has none
            if matches!(link.kind, Kind::Free | Kind::Plane) {
                *load = [ZERO; 2];
            }
        }
        let params = drawn
            .declared
            .params
            .iter()
            .map(|(_, value)| (*value).into());
        Self {
            time,
            params: params.collect(),
            inputs,
            rates,
            accelerations,
            loads,
        }
    }

    fn given(&self) -> Given<'_> {
        Given {
            time: self.time,
            params: &self.params,
            inputs: &self.inputs,
            rates: &self.rates,
            accelerations: &self.accelerations,
            loads: &self.loads,
        }
    }

    /// The state next to it.
    fn moved(&self, rng: &mut Rng) -> Self {
        let mut near = |list: &[Wide]| -> Vec<Wide> {
            let shift = |part: &Wide, sign: bool| {
                let unit = if sign { 1e-10 } else { -1e-10 };
                *part + *part * unit
            };
            list.iter().map(|part| shift(part, rng.bool())).collect()
        };
        Self {
            time: self.time,
            params: near(&self.params),
            inputs: self.inputs.clone(),
            rates: self.rates.iter().map(|(q, v)| (near(q), near(v))).collect(),
            accelerations: self.accelerations.clone(),
            loads: self.loads.clone(),
        }
    }
}

struct Checks<'a> {
    drawn: &'a Drawn,
    compiled: &'a Compiled,
    state: &'a State,
    scene: Scene<'a>,
    loads: Loads,
    failures: String,
}

/// Compares all answers in a state; none where a load has no direction.
pub fn check(
    drawn: &Drawn,
    compiled: &Compiled,
    state: &State,
    rng: &mut Rng,
) -> Option<Result<Errors, Failure>> {
    let scene = Scene::new(&drawn.links, state.time, &state.inputs, &state.rates);
    let loads = scene.loads(&drawn.acting);
    if scene.is_near.get() {
        return None;
    }
    let mut checks = Checks {
        drawn,
        compiled,
        state,
        scene,
        loads,
        failures: String::new(),
    };
    let found = checks.motion();
    checks.any_motion();
    checks.totals();
    checks.words();
    checks.jacobian();
    let errors = checks.doubles(&found, rng);
    Some(if checks.failures.is_empty() {
        Ok(errors)
    } else {
        Err(checks.failures)
    })
}

impl Checks<'_> {
    fn values(&self, roots: &[Id]) -> Vec<Wide> {
        self.compiled.values(roots, &self.state.given())
    }

    fn close(&mut self, what: &str, found: &[Wide], expected: &[Wide], size: f64) {
        let size = found
            .iter()
            .chain(expected)
            .fold(size, |size, one| size.max(one.high.abs()));
        let apart = found
            .iter()
            .zip(expected)
            .map(|(a, b)| (*a - *b).high.abs());
        // not a number is not close
        let largest = apart
            .clone()
            .fold(0.0, |largest: f64, apart| largest.max(apart) / size);
        if found.len() == expected.len() && apart.into_iter().all(|apart| apart <= EXACT * size) {
            return;
        }
        let list = |all: &[Wide]| all.iter().map(|one| one.high).collect::<Vec<_>>();
        let _ = writeln!(
            self.failures,
            "{what}: {:?}, expected {:?} of size {size:e}, apart by {largest:e} of it",
            list(found),
            list(expected)
        );
    }

    /// By link, open and driven ones.
    fn by_link(&self, open: &[Wide]) -> Vec<Vec<Wide>> {
        let mut all = self.state.accelerations.clone();
        let mut open = open.iter().copied();
        for (joint, ids) in self.compiled.accelerations.iter().enumerate() {
            let link = self.compiled.links[joint];
            if !self.compiled.system.joints[joint].is_driven() {
                all[link] = open.by_ref().take(ids.len()).collect();
            }
        }
        all
    }

    /// The accelerations are those of a true motion, and the loads of joints those of it.
    fn motion(&mut self) -> Vec<Wide> {
        let compiled = self.compiled;
        let open = compiled.accelerations.concat();
        let found = self.values(&open);
        let accelerations = self.by_link(&found);
        let (carried, _) = self.scene.carried(&self.loads, &accelerations);
        for (joint, link) in compiled.links.iter().enumerate() {
            let name = format!("j{link}");
            if compiled.system.joints[joint].is_driven() {
                let driving = self.values(&compiled.driving[joint]);
                self.close(
                    &format!("drive of {name}"),
                    &driving,
                    &carried.along[*link],
                    carried.size,
                );
            } else {
                let drives = self.loads.drives[*link].clone();
                self.close(
                    &format!("acceleration of {name}"),
                    &carried.along[*link],
                    &drives,
                    carried.size,
                );
            }
            let reaction = self.values(&compiled.reactions[joint].concat());
            let expected = carried.joints[*link].concat();
            self.close(
                &format!("reaction of {name}"),
                &reaction,
                &expected,
                carried.size,
            );
        }
        found
    }

    /// Inverse dynamics, mass matrix, and residuals, with any motion and any loads of joints.
    fn any_motion(&mut self) {
        let (compiled, state) = (self.compiled, self.state);
        let (carried, motions) = self.scene.carried(&self.loads, &state.accelerations);
        let mut needed = Vec::new();
        for link in 0..self.drawn.links.len() {
            let pairs = carried.along[link].iter().zip(&self.loads.drives[link]);
            needed.push(
                pairs
                    .map(|(along, drive)| *along - *drive)
                    .collect::<Vec<_>>(),
            );
        }
        for (joint, link) in compiled.links.iter().enumerate() {
            // nothing drives what is free
            let joint_of = &compiled.system.joints[joint];
            if joint_of.is_driven() || joint_of.kind.is_free() {
                continue;
            }
            let inverse = self.values(&compiled.inverse[joint]);
            self.close(
                &format!("inverse of j{link}"),
                &inverse,
                &needed[*link],
                carried.size,
            );
        }
        let count = compiled.inertias.rows.len();
        let rows = self.values(&compiled.inertias.rows.concat());
        let driving = self.values(&compiled.inertias.driving);
        let written = compiled
            .system
            .written
            .iter()
            .map(|joint| compiled.links[*joint]);
        let written: Vec<usize> = written.collect();
        let order = |by: &[Vec<Wide>]| -> Vec<Wide> {
            written.iter().flat_map(|link| by[*link].clone()).collect()
        };
        let (given, expected) = (order(&state.accelerations), order(&needed));
        let left: Vec<Wide> = (0..count)
            .map(|row| {
                let terms = rows[row * count..].iter().zip(&given);
                terms.map(|(m, a)| *m * *a).sum::<Wide>() - driving[row]
            })
            .collect();
        self.close("M q'' - f", &left, &expected, carried.size);
        let transposed: Vec<Wide> = (0..count * count)
            .map(|entry| rows[entry % count * count + entry / count])
            .collect();
        self.close("M transposed", &transposed, &rows, 0.0);
        for (body, link) in compiled.links.iter().enumerate() {
            let balance = &compiled.balances[body];
            let [force, moment] = self.loads.on[*link];
            let applied = self.values(&[balance.applied.force, balance.applied.moment].concat());
            self.close(
                &format!("applied on b{link}"),
                &applied,
                &[force, moment].concat(),
                carried.size,
            );
            let residual = self.values(&[balance.residual.force, balance.residual.moment].concat());
            let [taken, turning] = self.scene.taken(*link, &motions[*link]);
            let mut sums = [subtract(force, taken), subtract(moment, turning)];
            for (joint, other) in self.drawn.links.iter().enumerate() {
                let sign = match (joint == *link, other.carrier == Some(*link)) {
                    (true, _) => Wide::ONE,
                    (_, true) => -Wide::ONE,
                    _ => continue,
                };
                let pin = self.scene.point(Some(joint), other.pin);
                let arm = subtract(pin, motions[*link].position);
                let [force, moment] = state.loads[joint].map(|part| scale(part, sign));
                sums = [
                    add(sums[0], force),
                    add(sums[1], add(moment, cross(arm, force))),
                ];
            }
            self.close(
                &format!("residual of b{link}"),
                &residual,
                &sums.concat(),
                carried.size,
            );
        }
    }

    fn totals(&mut self) {
        let compiled = self.compiled;
        let (mut kinetic, mut mass, mut potential) = (Wide::ZERO, Wide::ZERO, Wide::ZERO);
        let gravity = self.drawn.gravity.unwrap_or(ZERO);
        let (mut first, mut linear, mut about) = (ZERO, ZERO, ZERO);
        for (body, link) in self.drawn.links.iter().enumerate() {
            let motion = &self.scene.motions[body];
            let spin = apply(&self.scene.tensor(body), motion.angular_velocity);
            let own = scale(motion.velocity, link.mass);
            kinetic =
                kinetic + (dot(own, motion.velocity) + dot(spin, motion.angular_velocity)) * 0.5;
            mass = mass + link.mass;
            first = add(first, scale(motion.position, link.mass));
            linear = add(linear, own);
            about = add(about, add(cross(motion.position, own), spin));
            potential = potential - dot(gravity, motion.position) * link.mass;
        }
        let center = subtract(about, cross(scale(first, Wide::ONE / mass), linear));
        let mut found = self.values(&[compiled.energy.kinetic, compiled.energy.potential]);
        if self.drawn.gravity.is_none() {
            found[1] = potential;
        }
        let scale = kinetic.high.abs() + size(first) * size(gravity);
        self.close("energy", &found, &[kinetic, potential], scale);
        let momentum = &compiled.momentum;
        let mut found =
            self.values(&[momentum.linear, momentum.angular, momentum.about_pole].concat());
        let mut expected = [linear, center, about].concat();
        if self.drawn.is_planar {
            // what the plane has
            let kept = |list: &[Wide]| vec![list[0], list[1], list[5], list[8]];
            (found, expected) = (kept(&found), kept(&expected));
        }
        let largest = size(about) + size(linear) * (1.0 + size(first) / mass.high);
        self.close("momentum", &found, &expected, largest);
    }

    /// A mass that is left out is said to go to what carries the body, or to what that is welded to.
    fn words(&mut self) {
        let links = &self.drawn.links;
        for (number, link) in links.iter().enumerate() {
            let body = format!("the mass of `b{number}` in its own");
            let mut lines = self.compiled.skipped.iter();
            let Some(line) = lines.find(|line| line.starts_with(&body)) else {
                continue;
            };
            let mut carrier = link.carrier;
            loop {
                let name = carrier.map_or("the ground".to_owned(), |one| format!("`b{one}`"));
                if line.ends_with(&format!(
                    "`j{number}` cannot tell it from a mass of {name} on its axis"
                )) {
                    break;
                }
                match carrier {
                    Some(one) if links[one].kind == Kind::Weld => carrier = links[one].carrier,
                    _ => {
                        let _ = writeln!(self.failures, "words: {line}");
                        break;
                    }
                }
            }
        }
    }

    /// How the velocity of a point changes with the rates.
    fn jacobian(&mut self) {
        let Some((body, at)) = self.drawn.asked else {
            return;
        };
        let Some(jacobian) = self.compiled.jacobians.first() else {
            return;
        };
        let columns: Vec<Id> = jacobian.iter().flat_map(|column| column.concat()).collect();
        let columns = self.values(&columns);
        let slow: Vec<Rates> = self
            .state
            .rates
            .iter()
            .map(|(q, v)| (q.clone(), vec![Wide::ZERO; v.len()]))
            .collect();
        let mut unit = still(&self.drawn.links);
        let mut expected = Vec::new();
        for joint in &self.compiled.system.written {
            let link = self.compiled.links[*joint];
            for freedom in 0..unit[link].len() {
                unit[link][freedom] = Wide::ONE;
                let motion = motions(&self.drawn.links, &slow, &unit)[body];
                unit[link][freedom] = Wide::ZERO;
                let arm = self.scene.turned(Some(body), at);
                let turning = motion.angular_acceleration;
                expected.extend(add(motion.acceleration, cross(turning, arm)));
                expected.extend(turning);
            }
        }
        self.close("jacobian", &columns, &expected, 1.0);
    }

    /// How far doubles are from what they round.
    fn doubles(&mut self, exact: &[Wide], rng: &mut Rng) -> Errors {
        let roots = self.compiled.accelerations.concat();
        let found = self.compiled.doubles(&roots, &self.state.given());
        let largest = exact
            .iter()
            .fold(1e-3, |size: f64, one| size.max(one.high.abs()));
        let mut errors = Errors::default();
        let mut near = vec![0.0_f64; exact.len()];
        for _ in 0..3 {
            let moved = self.state.moved(rng);
            let values = self.compiled.values(&roots, &moved.given());
            for (near, (a, b)) in near.iter_mut().zip(values.iter().zip(exact)) {
                *near = near.max((*a - *b).high.abs() * 1e10 * f64::EPSILON / 2.0);
            }
        }
        for ((found, exact), near) in found.iter().zip(exact).zip(near) {
            let apart = (Wide::from(*found) - *exact).high.abs();
            // not a number is the largest
            let relative = if apart.is_nan() {
                f64::INFINITY
            } else {
                apart / largest
            };
            errors.acceleration = errors.acceleration.max(relative);
            // what is zero is so to its terms
            let unit = near + exact.high.abs().max(1e-3 * largest) * f64::EPSILON;
            errors.conditioned =
                errors
                    .conditioned
                    .max(if apart == 0.0 { 0.0 } else { apart / unit });
        }
        errors
    }
}
