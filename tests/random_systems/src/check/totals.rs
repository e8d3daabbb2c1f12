//! Energy, momentum, Jacobians, and the texts about them.

use std::fmt::Write as _;

use mounted::symbolic::Id;

use super::Checks;
use crate::law::kind::{Kind, Rates};
use crate::law::scene::{motions, still};
use crate::law::space::{ZERO, add, apply, cross, dot, scale, size, subtract};
use crate::wide::Wide;

impl Checks<'_> {
    pub fn totals(&mut self) {
        let compiled = self.compiled;
        let (mut kinetic, mut mass, mut potential) = (Wide::ZERO, Wide::ZERO, Wide::ZERO);
        let gravity = self.drawn.gravity.unwrap_or(ZERO);
        let (mut first, mut linear, mut about) = (ZERO, ZERO, ZERO);
        for (body, link) in self.drawn.links[..self.drawn.bodies()].iter().enumerate() {
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
        for (link, (_, v)) in self.drawn.links.iter().zip(&self.state.rates) {
            if let [v] = v[..] {
                kinetic = kinetic + link.armature * v * v * 0.5;
            }
        }
        let center = subtract(about, cross(scale(first, Wide::ONE / mass), linear));
        let energies = self.drawn.stored.iter().chain(&self.drawn.falling);
        for energy in energies {
            potential = potential + energy(&self.scene);
        }
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
    pub fn words(&mut self) {
        let links = &self.drawn.links;
        for (number, link) in links.iter().enumerate().take(self.drawn.bodies()) {
            let names = &self.drawn.names;
            let body = format!("the mass of `{}` in its own", names[number]);
            let mut lines = self.compiled.skipped.iter();
            let Some(line) = lines.find(|line| line.starts_with(&body)) else {
                continue;
            };
            let mut carrier = link.carrier;
            loop {
                let name =
                    carrier.map_or("the ground".to_owned(), |one| format!("`{}`", names[one]));
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
    pub fn jacobian(&mut self) {
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
}
