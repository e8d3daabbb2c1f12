//! Random loads: common ones, and arbitrary expressions.

use super::body::{Key, Load, Motion, Potential, What};
use super::draw::Draw;
use super::expression::{Axes, Place, Scalar, Vector};

impl Draw {
    pub fn loads(&mut self) {
        self.reactions();
        for _ in 0..self.random.usize(1..=4) {
            let load = self.load();
            if self.chance(0.15) {
                let opposite = self.opposite(&load);
                self.body.loads.push(opposite);
            }
            self.body.loads.push(load);
        }
        if self.chance(0.5) {
            let weight = self.weight();
            self.body.loads.push(weight);
        }
        // as the language lists them
        self.body.loads.sort_by_key(|load| load.key);
    }

    pub fn weight(&mut self) -> Load {
        let down = self.down();
        let weight = Scalar::Mass * Vector::Written(Axes::World, down);
        Load {
            key: Key::Fields,
            what: What::Force(weight, Place::Center),
        }
    }

    pub fn load(&mut self) -> Load {
        // what does not turn has moments only where guides take them
        let takes_moments = self.body.motion.turns() || self.has_guide();
        let what = match self.random.u32(..10) {
            0..6 => {
                let place = if takes_moments {
                    self.point_of_action()
                } else {
                    Place::Center
                };
                let force = self.force(&place);
                What::Force(force, place)
            }
            6..8 if takes_moments => self.moment(),
            8 if takes_moments => {
                return Load {
                    key: Key::Fields,
                    what: self.charges(),
                };
            }
            _ => {
                return Load {
                    key: Key::Potentials,
                    what: What::Potential(self.potential(takes_moments)),
                };
            }
        };
        let is_force = matches!(what, What::Force(..));
        let key = match self.random.u32(..8) {
            0 if is_force => Key::JointForces,
            0 => Key::JointMoments,
            1 => Key::Fields,
            2 => Key::Reactions,
            _ if is_force => Key::Forces,
            _ => Key::Moments,
        };
        Load { key, what }
    }

    fn coefficient(&mut self) -> Scalar {
        let number = Scalar::Literal(self.signed(self.strength));
        match self.random.u32(..16) {
            0 => Scalar::zero(),
            1..5 => self
                .scalar_param()
                .map_or(number.clone(), |param| number * param),
            5..9 => self
                .scalar_input()
                .map_or(number.clone(), |input| number * input),
            _ => number,
        }
    }

    /// A load that takes back the force of this one, or its moment, or makes a couple of the two.
    pub fn opposite(&mut self, load: &Load) -> Load {
        let what = match load.what.clone() {
            What::Force(force, place) => {
                let place = match place {
                    Place::Named(_) if self.random.bool() => self.place(Axes::Body),
                    same => same,
                };
                What::Force(Vector::Negative(Box::new(force)), place)
            }
            What::Moment(moment) => What::Moment(Vector::Negative(Box::new(moment))),
            What::PlaneMoment(moment) => What::PlaneMoment(-moment),
            What::Charges(field, charges) => {
                let opposite = |(charge, place): (Scalar, Place)| (-charge, place);
                What::Charges(field, charges.into_iter().map(opposite).collect())
            }
            What::Potential(potential) => What::Potential(self.opposite_energy(potential)),
            known => known,
        };
        Load { what, ..*load }
    }

    /// Of a spring from the same point, or from another one, to the same hook or to another one.
    fn opposite_energy(&mut self, mut potential: Potential) -> Potential {
        match &mut potential {
            Potential::Spring {
                stiffness: k,
                from,
                to,
                ..
            }
            | Potential::Central {
                strength: k,
                from,
                to,
            }
            | Potential::Well {
                strength: k,
                from,
                to,
            } => {
                *k = -k.clone();
                if self.random.bool() {
                    *to = self.place(Axes::World);
                }
                if matches!(from, Place::Named(_)) && self.random.bool() {
                    *from = self.place(Axes::Body);
                }
            }
            Potential::Coil { stiffness } => *stiffness = -stiffness.clone(),
            Potential::Uniform { force: vector, .. } | Potential::Dipole { moment: vector, .. } => {
                *vector = vector.clone().map(|part| -part);
            }
            Potential::Sum(energies) => {
                let parts = core::mem::take(energies).into_iter();
                *energies = parts.map(|part| self.opposite_energy(part)).collect();
            }
        }
        potential
    }

    fn force(&mut self, place: &Place) -> Vector {
        let coefficient = self.coefficient();
        let moves = self.body.motion.moves();
        let at_point = |place: &Place| match place {
            Place::Shifted(place, _) => (**place).clone(),
            other => other.clone(),
        };
        match self.random.u32(..9) {
            0 => coefficient * self.written(),
            1 => self
                .vector_name()
                .unwrap_or_else(|| coefficient * self.written()),
            // drag, linear and quadratic
            2 if moves => coefficient * Vector::PointVelocity(at_point(place)),
            3 if moves => {
                let mut air = Vector::PointVelocity(at_point(place));
                if let Some(wind) = self.vector_name() {
                    air = air - wind;
                }
                coefficient * (Scalar::Norm(Box::new(air.clone())) * air)
            }
            // springs, without a rest length and with one
            4 if moves => coefficient * self.stretch(&at_point(place)),
            5 if moves => {
                let stretch = self.stretch(&at_point(place));
                let rest = Scalar::Literal(self.length());
                let longer = Scalar::Norm(Box::new(stretch.clone())) - rest;
                coefficient * (longer * Vector::Normalized(Box::new(stretch)))
            }
            // a lift, across the velocity
            6 if moves && !self.body.motion.is_planar() && self.body.motion.turns() => {
                let (w, v) = (Vector::AngularVelocity, Vector::Velocity);
                coefficient * Vector::Cross(Box::new(w), Box::new(v))
            }
            7 => coefficient * (self.scalar(2) * self.written()),
            _ => coefficient * self.vector(2),
        }
    }

    fn stretch(&mut self, from: &Place) -> Vector {
        let hook = self.place(Axes::World);
        Vector::PointPosition(hook) - Vector::PointPosition(from.clone())
    }

    fn moment(&mut self) -> What {
        let coefficient = self.coefficient();
        if self.body.motion.is_planar() {
            let moment = match self.random.u32(..3) {
                0 => coefficient,
                1 => coefficient * self.turning_rate(),
                _ => coefficient * self.scalar(2),
            };
            return What::PlaneMoment(moment);
        }
        if self.is_rod() {
            // across the axis
            let vector = self.vector(1);
            let across = Vector::Cross(Box::new(Vector::Axis), Box::new(vector));
            return What::Moment(coefficient * across);
        }
        What::Moment(match self.random.u32(..4) {
            0 => coefficient * self.written(),
            1 if self.body.motion.turns() => coefficient * Vector::AngularVelocity,
            2 => coefficient * (self.scalar(2) * self.written()),
            _ => coefficient * self.vector(2),
        })
    }

    /// In the plane; of what does not turn, a number.
    fn turning_rate(&mut self) -> Scalar {
        if self.body.motion.turns() {
            Scalar::AngularRate
        } else {
            Scalar::Literal(self.signed(0))
        }
    }

    fn charges(&mut self) -> What {
        let field = Vector::Written(Axes::World, self.components(0));
        let field = match self.random.u32(..3) {
            0 => self
                .scalar_input()
                .map_or(field.clone(), |input| input * field),
            1 => {
                Scalar::Unary(
                    super::expression::Unary::Sin,
                    Box::new(Scalar::Literal(self.signed(0)) * Scalar::Time),
                ) * field
            }
            _ => field,
        };
        let mut charges = Vec::new();
        for _ in 0..self.random.usize(1..=3) {
            let charge = self.coefficient();
            if self.chance(0.2) {
                charges.push((-charge.clone(), self.place(Axes::Body)));
            }
            charges.push((charge, self.place(Axes::Body)));
        }
        What::Charges(field, charges)
    }

    /// One, or several in one energy, some of which cancel.
    fn potential(&mut self, takes_moments: bool) -> Potential {
        let first = self.one_potential(takes_moments);
        if self.chance(0.6) {
            return first;
        }
        let second = if self.random.bool() {
            self.opposite_energy(first.clone())
        } else {
            self.one_potential(takes_moments)
        };
        let mut all = vec![first, second];
        if self.chance(0.3) {
            all.push(self.one_potential(takes_moments));
        }
        Potential::Sum(all)
    }

    fn one_potential(&mut self, takes_moments: bool) -> Potential {
        let stiffness = self.coefficient();
        let from = if takes_moments {
            self.place(Axes::Body)
        } else {
            Place::Center
        };
        let turns = self.body.motion.turns();
        if !self.body.motion.moves() {
            let order = self.strength + self.length;
            return Potential::Dipole {
                moment: self.components(order),
                field: self.components(0),
            };
        }
        if self.body.is_rich && self.random.bool() {
            let (strength, to) = (stiffness, self.place(Axes::World));
            return Potential::Well { strength, from, to };
        }
        match self.random.u32(..6) {
            0 => Potential::Spring {
                stiffness,
                rest: None,
                from,
                to: self.place(Axes::World),
            },
            1 => Potential::Spring {
                stiffness,
                rest: Some(Scalar::Literal(self.length())),
                from,
                to: self.place(Axes::World),
            },
            2 => Potential::Central {
                strength: stiffness,
                from,
                to: self.place(Axes::World),
            },
            3 if turns && self.body.motion.is_planar() => Potential::Coil { stiffness },
            4 if turns && !self.is_rod() => {
                let order = self.strength + self.length;
                Potential::Dipole {
                    moment: self.components(order),
                    field: self.components(0),
                }
            }
            _ => {
                let order = self.strength;
                Potential::Uniform {
                    force: self.components(order),
                    at: from,
                }
            }
        }
    }

    fn down(&mut self) -> [Scalar; 3] {
        let g = Scalar::literal(-980_665, -5);
        let zero = Scalar::zero;
        if self.body.motion.is_planar() {
            return [zero(), g, zero()];
        }
        self.pick(&[
            [zero(), zero(), g.clone()],
            [zero(), g.clone(), zero()],
            [g, zero(), zero()],
        ])
    }

    fn has_guide(&self) -> bool {
        let is_moment = |load: &Load| matches!(load.what, What::OpenMoment(..));
        !matches!(self.body.motion, Motion::Rotation) && self.body.loads.iter().any(is_moment)
    }
}
