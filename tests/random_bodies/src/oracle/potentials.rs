//! Potentials whose forces are in any textbook.

use crate::description::body::Potential;
use crate::description::expression::{Axes, Place};
use crate::wide::Wide;

use super::arithmetic::Values;
use super::loads::{Acting, Wrench};
use super::number::Number;
use super::scene::Scene;
use super::vector::Vector;

impl Scene<'_> {
    pub fn potential(&self, potential: &Potential) -> Acting {
        let (wrench, energy) = self.derived(potential);
        Acting {
            wrench: wrench.derived(self),
            point: None,
            energy,
        }
    }

    fn derived(&self, potential: &Potential) -> (Wrench, Number) {
        let half = Number::known(Wide::from(0.5));
        match potential {
            Potential::Spring {
                stiffness,
                rest,
                from,
                to,
            } => {
                let stiffness = self.scalar(stiffness);
                let stretch = self.stretch(from, to);
                let (force, length) = match rest {
                    None => (stretch.scaled(stiffness), stretch.norm()),
                    Some(rest) => {
                        let longer = stretch.norm() - self.scalar(rest);
                        (stretch.normalized().scaled(stiffness * longer), longer)
                    }
                };
                let wrench = Wrench::of_force(self, force, from);
                (wrench, half * stiffness * length.squared())
            }
            Potential::Central { strength, from, to } => {
                let strength = self.scalar(strength);
                let stretch = self.stretch(from, to);
                let length = stretch.norm();
                // grows towards the center, so that it pushes away
                let force = -stretch.normalized().scaled(strength / length.squared());
                (Wrench::of_force(self, force, from), strength / length)
            }
            Potential::Well { strength, from, to } => {
                let (strength, stretch) = (self.scalar(strength), self.stretch(from, to));
                let length = stretch.norm();
                let (square, one) = (length.squared(), Number::ONE);
                let slope = (one - square) / (one + square).squared();
                let force = stretch.normalized().scaled(strength * slope);
                let energy = strength * (length / (one + square));
                (Wrench::of_force(self, force, from), energy)
            }
            Potential::Uniform { force, at } => {
                let force = self.written(Axes::World, force);
                (
                    Wrench::of_force(self, force, at),
                    -force.dot(self.position(at)),
                )
            }
            Potential::Dipole { moment, field } => {
                let moment = self.written(Axes::Body, moment);
                let field = self.written(Axes::World, field);
                (Wrench::couple(moment.cross(field)), -moment.dot(field))
            }
            Potential::Coil { stiffness } => {
                let stiffness = self.scalar(stiffness);
                let angle = self.angle;
                let moment = Vector::normal(-(stiffness * angle));
                (Wrench::couple(moment), half * stiffness * angle.squared())
            }
            Potential::Sum(energies) => {
                let each = energies.iter().map(|energy| self.derived(energy));
                each.fold((Wrench::ZERO, Number::ZERO), |(all, sum), (one, energy)| {
                    (all.and(one), sum + energy)
                })
            }
        }
    }

    fn stretch(&self, from: &Place, to: &Place) -> Vector {
        self.position(to) - self.position(from)
    }
}
