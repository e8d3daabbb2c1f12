//! Random constraints, each with the unknown that keeps it: floors, prescribed speeds, pins, with
//! branches and with gates.

use super::body::{Constraint, Key, Load, Motion, Param, What};
use super::draw::Draw;
use super::expression::{Axes, Condition, Place, Scalar, Unary, Vector};

impl Draw {
    /// One to three constraints along different axes, and friction that follows one of them.
    pub fn constraints(&mut self) {
        self.is_slow = true;
        let mut axes: Vec<usize> = (0..self.body.axes()).collect();
        self.random.shuffle(&mut axes);
        let count = self.random.usize(1..=axes.len());
        let first_reaction = self.body.loads.len();
        if self.body.motion.is_planar() && self.body.motion.turns() && self.chance(0.1) {
            self.spin();
        }
        if self.chance(0.12) {
            self.pendulum();
        } else {
            for axis in axes.iter().take(count) {
                self.along_axis(*axis);
            }
        }
        if self.chance(0.5) {
            self.friction(first_reaction, &axes);
        }
        self.is_slow = false;
        if self.random.bool() {
            self.random.shuffle(&mut self.body.constraints);
        }
    }

    fn open(&mut self, what: What) {
        self.body.loads.push(Load {
            key: Key::Reactions,
            what,
        });
    }

    /// A number that is one thing here and another beyond: of the time, or of a coordinate.
    fn level(&mut self, other: Option<usize>) -> Scalar {
        let number = Scalar::Literal(self.signed(0));
        match self.random.u32(..4) {
            0 => number,
            1 => Scalar::literal(0, 0),
            _ => {
                let q = self.slow_quantity(other);
                let gate = if self.random.bool() {
                    self.branch(q)
                } else {
                    self.gate_of(q)
                };
                number * gate
            }
        }
    }

    fn slow_quantity(&mut self, other: Option<usize>) -> Scalar {
        let number = Scalar::Literal(self.signed(0));
        let params = self
            .body
            .params
            .iter()
            .any(|param| matches!(param, Param::Scalar(_)));
        match (self.random.u32(..6), other) {
            (0 | 1, _) => number * Scalar::Time,
            (2, _) if params => number * self.scalar_param().expect("there is one"),
            (_, Some(axis)) => {
                number * Scalar::Component(Box::new(Vector::Position), Axes::World, axis)
            }
            _ => number * Scalar::Time,
        }
    }

    /// `if q > c { k (q - c) } else { 0 }`, or with a jump.
    fn branch(&mut self, q: Scalar) -> Scalar {
        let c = Scalar::Literal(self.signed(1));
        let number = Scalar::Literal(self.signed(0));
        let beyond = Condition::Less(c.clone(), q.clone());
        let there = match self.random.u32(..3) {
            0 => number,
            1 => number * (q - c),
            _ => number * Scalar::Power(Box::new(q - c), 2),
        };
        let here = if self.chance(0.7) {
            Scalar::zero()
        } else {
            Scalar::Literal(self.signed(0))
        };
        Scalar::If(Box::new(beyond), Box::new(there), Box::new(here))
    }

    fn along_axis(&mut self, axis: usize) {
        let others: Vec<usize> = (0..self.body.axes()).filter(|i| *i != axis).collect();
        let other = self.pick(&others);
        let place = if self.body.motion.turns() && self.random.bool() {
            self.place(Axes::Body)
        } else {
            Place::Center
        };
        let position = match &place {
            Place::Center => Vector::Position,
            other => Vector::PointPosition(other.clone()),
        };
        let velocity = match &place {
            Place::Center => Vector::Velocity,
            other => Vector::PointVelocity(other.clone()),
        };
        let of =
            |vector: Vector, axis: usize| Scalar::Component(Box::new(vector), Axes::World, axis);
        let (value, is_of_rates) = match self.random.u32(..4) {
            0 | 1 => (of(position, axis) - self.level(Some(other)), false),
            2 => (of(velocity, axis) - self.level(Some(other)), true),
            _ => {
                let slope = self.level(None);
                (
                    of(velocity.clone(), axis) - slope * of(velocity, other),
                    true,
                )
            }
        };
        self.body
            .constraints
            .push(Constraint::Scalar(value, is_of_rates));
        let mut parts = [(); 3].map(|()| Some(Scalar::zero()));
        parts[axis] = None;
        let what = if self.chance(0.2) {
            let unit = [0, 1, 2].map(|i| Scalar::literal(i64::from(i == axis), 0));
            What::OpenAlong(Vector::Written(Axes::World, unit), place)
        } else {
            What::OpenForce(Axes::World, parts, place)
        };
        self.open(what);
    }

    /// An angular velocity that is given.
    fn spin(&mut self) {
        let value = Scalar::AngularRate - self.level(None);
        self.body.constraints.push(Constraint::Scalar(value, true));
        let parts = [Some(Scalar::zero()), Some(Scalar::zero()), None];
        self.open(What::OpenMoment(Axes::World, parts));
    }

    /// On a string, or at a joint.
    fn pendulum(&mut self) {
        let anchor = self.place(Axes::World);
        let stretch = Vector::Position - Vector::PointPosition(anchor.clone());
        if self.body.motion.turns() && self.random.bool() && !self.is_rod() {
            let pin = self.place(Axes::Body);
            let held = Vector::PointPosition(pin.clone()) - Vector::PointPosition(anchor);
            self.body.constraints.push(Constraint::Vector(held, false));
            self.open(What::OpenForce(Axes::World, [None, None, None], pin));
            return;
        }
        let length = Scalar::Literal(self.length());
        let longer = Scalar::Norm(Box::new(stretch.clone())) - length;
        self.body
            .constraints
            .push(Constraint::Scalar(longer, false));
        let direction = Vector::Normalized(Box::new(stretch));
        self.open(What::OpenAlong(direction, Place::Center));
    }

    /// Along an axis that is free or not, with a coefficient that may depend on a branch.
    fn friction(&mut self, first: usize, axes: &[usize]) {
        let open = self.body.loads[first..]
            .iter()
            .position(|load| matches!(load.what, What::OpenForce(..)));
        let Some(open) = open.map(|place| first + place) else {
            return;
        };
        let What::OpenForce(_, parts, place) = self.body.loads[open].what.clone() else {
            return;
        };
        let normal = parts.iter().position(Option::is_none).unwrap_or(0);
        let along = self.pick(axes);
        let mu = match self.random.u32(..3) {
            0 => Scalar::Literal(self.signed(-1)),
            1 => {
                let q = Scalar::literal(1, 0)
                    * Scalar::Component(Box::new(Vector::Velocity), Axes::World, along);
                if self.random.bool() {
                    Scalar::Unary(Unary::Signum, Box::new(q)) * Scalar::Literal(self.signed(-1))
                } else {
                    self.branch(q)
                }
            }
            _ => {
                let q = self.slow_quantity(Some(along));
                Scalar::Literal(self.signed(-1)) * self.gate_of(q)
            }
        };
        let force = mu * Scalar::Reaction(open, normal);
        let mut components = [(); 3].map(|()| Scalar::zero());
        components[along] = force;
        let place = if self.random.bool() {
            place
        } else {
            Place::Center
        };
        let what = What::Force(Vector::Written(Axes::World, components), place);
        self.open(what);
    }

    /// Whether a motion may be under constraints.
    pub fn takes_constraints(&self) -> bool {
        matches!(
            self.body.motion,
            Motion::Spatial
                | Motion::Planar
                | Motion::Translation
                | Motion::PlanarTranslation
                | Motion::Rod(_)
        )
    }
}
