//! Loads that are solved for: as many as the support determines, and drives.

use super::body::{Key, Load, Motion, Point, Support, What};
use super::draw::Draw;
use super::expression::{Axes, Place, Scalar};

impl Draw {
    pub fn reactions(&mut self) {
        if self.chance(0.3) {
            return self.drives();
        }
        let axes = if self.is_rod() {
            Axes::World
        } else {
            self.pick(&[Axes::Body, Axes::World])
        };
        match self.body.motion.clone() {
            Motion::Translation | Motion::PlanarTranslation => {
                self.open_moment(Key::Reactions, axes, [None, None, None]);
            }
            Motion::Pivot(support) | Motion::FixedPoint(support) => {
                let place = Place::Named(support.point);
                self.open_force(Key::Reactions, axes, [None, None, None], place);
            }
            Motion::FixedAxis(support, _, direction) => self.bearings(&support, &direction),
            _ => {}
        }
    }

    /// All of one bearing, and of the other what is across the axis; or the moment of the one.
    fn bearings(&mut self, support: &Support, direction: &[Scalar; 3]) {
        let place = Place::Named(support.point);
        let [first, second] = [(); 2].map(|()| self.pick(&[Axes::Body, Axes::World]));
        let along: Vec<usize> = (0..3).filter(|i| !direction[*i].is_zero()).collect();
        let is_tilted = along.len() > 1;
        let given = match self.random.u32(..2) {
            0 => Scalar::zero(),
            _ => Scalar::Literal(self.signed(self.strength)),
        };
        // a component that has a part along the axis is given
        let mut parts = [None, None, None];
        parts[along[0]] = Some(given);
        if !is_tilted && self.chance(0.4) {
            self.open_force(Key::Reactions, first, [None, None, None], place);
            return self.open_moment(Key::Reactions, second, parts);
        }
        // of a tilted axis, components in the world turn about it
        let second = if is_tilted { Axes::Body } else { second };
        let distance = Scalar::Literal(self.length());
        let held = self.body.points[support.point].coordinates.clone();
        let other = [0, 1, 2].map(|i| {
            if direction[i].is_zero() {
                held[i].clone()
            } else {
                held[i].clone() + distance.clone() * direction[i].clone()
            }
        });
        self.body.points.push(Point {
            axes: Axes::Body,
            coordinates: other,
        });
        let far = Place::Named(self.body.points.len() - 1);
        self.open_force(Key::Reactions, first, [None, None, None], place);
        self.open_force(Key::Reactions, second, parts, far);
    }

    /// As many as the motion has degrees of freedom.
    fn drives(&mut self) {
        let axes = self.pick(&[Axes::Body, Axes::World]);
        let all = || [None, None, None];
        let joint = self.random.bool();
        let (forces, moments) = if joint {
            (Key::JointForces, Key::JointMoments)
        } else {
            (Key::Forces, Key::Moments)
        };
        match self.body.motion.clone() {
            Motion::Spatial | Motion::Planar => {
                let place = self.place(Axes::Body);
                self.open_force(forces, axes, all(), place);
                let other = self.pick(&[Axes::Body, Axes::World]);
                self.open_moment(moments, other, all());
            }
            Motion::Translation | Motion::PlanarTranslation => {
                self.open_force(forces, axes, all(), Place::Center);
            }
            Motion::Rotation | Motion::FixedPoint(_) | Motion::Pivot(_) => {
                self.open_moment(moments, axes, all());
            }
            Motion::FixedAxis(_, _, direction) => {
                let along: Vec<usize> = (0..3).filter(|i| !direction[*i].is_zero()).collect();
                if let [along] = along[..] {
                    let mut parts = [(); 3].map(|()| Some(Scalar::zero()));
                    parts[along] = None;
                    self.open_moment(moments, axes, parts);
                }
            }
            Motion::Rod(_) => {}
        }
    }

    fn open_force(&mut self, key: Key, axes: Axes, parts: [Option<Scalar>; 3], place: Place) {
        let what = What::OpenForce(axes, parts, place);
        self.body.loads.push(Load { key, what });
    }

    fn open_moment(&mut self, key: Key, axes: Axes, parts: [Option<Scalar>; 3]) {
        let what = What::OpenMoment(axes, parts);
        self.body.loads.push(Load { key, what });
    }
}
