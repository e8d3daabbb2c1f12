//! Loads that depend on accelerations: added mass, at G and at other points, isotropic or not.

use super::body::{Key, Load, What};
use super::draw::Draw;
use super::expression::{Axes, Place, Scalar, Vector};

impl Draw {
    /// One body out of four has them, and a rod has none.
    pub fn following(&mut self, index: usize) {
        let motion = &self.body.motion;
        let (moves, turns, planar) = (motion.moves(), motion.turns(), motion.is_planar());
        if index % 4 != 1 || self.is_rod() {
            return;
        }
        self.body.follows = true;
        if moves && (!turns || self.random.bool()) {
            let force = self.added_mass();
            self.body.loads.push(Load {
                key: Key::Forces,
                what: force,
            });
        } else {
            let size = Scalar::Literal(self.positive(self.strength));
            let moment = if planar {
                What::PlaneMoment(-(size * Scalar::AngularAcceleration))
            } else {
                What::Moment(-size * self.turned_or_not())
            };
            self.body.loads.push(Load {
                key: Key::Moments,
                what: moment,
            });
        }
        self.body.loads.sort_by_key(|load| load.key);
    }

    /// A fraction of the mass at a point, or another one along each axis of the body and across.
    fn added_mass(&mut self) -> What {
        let share = |draw: &mut Self| Scalar::Literal(draw.between(50, 900)) * Scalar::Mass;
        let turns = self.body.motion.turns();
        if turns && self.random.bool() {
            let place = self.place(Axes::Body);
            let follows = Vector::PointAcceleration(place.clone());
            return What::Force(-share(self) * follows, place);
        }
        if !turns || self.random.bool() {
            return What::Force(-share(self) * Vector::Acceleration, Place::Center);
        }
        let component = |i: usize| Scalar::Component(Box::new(Vector::Acceleration), Axes::Body, i);
        let axes = self.body.axes();
        let mut parts = [(); 3].map(|()| Scalar::zero());
        for (axis, part) in parts.iter_mut().enumerate().take(axes) {
            let across = Scalar::Literal(self.between(-40, 40)) * Scalar::Mass;
            *part = -(share(self) * component(axis)) + across * component((axis + 1) % axes);
        }
        What::Force(Vector::Written(Axes::Body, parts), Place::Center)
    }

    /// The angular acceleration, or what is across to a direction of it.
    fn turned_or_not(&mut self) -> Vector {
        let follows = Vector::AngularAcceleration;
        if self.random.bool() {
            return follows;
        }
        let axis = self.random.usize(..3);
        let component = |i: usize| Scalar::Component(Box::new(follows.clone()), Axes::Body, i);
        let mut parts = [(); 3].map(|()| Scalar::zero());
        parts[axis] = component(axis);
        Vector::Written(Axes::Body, parts)
    }
}
