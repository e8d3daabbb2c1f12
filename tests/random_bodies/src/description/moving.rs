//! Bodies whose motions are tried: those with a closed form, and those with smooth loads and loads
//! that change abruptly.

use super::body::{Body, Inertia, Key, Load, Motion, Point, Support, What};
use super::draw::{Draw, whole};
use super::expression::{Axes, Place, Scalar, Unary, Vector};

/// A body, and whether its motion has a closed form.
pub struct Moving {
    pub body: Body,
    pub has_flow: bool,
}

/// The same body for the same seed and index, in every build.
pub fn moving_body(seed: u64, index: usize) -> Moving {
    let mut draw = Draw::new(seed, index);
    draw.body.name = format!("Moving{index}");
    let has_flow = index.is_multiple_of(2);
    if has_flow {
        draw.flowing(index / 2 % 8);
    } else {
        draw.driven();
    }
    Moving {
        body: draw.body,
        has_flow,
    }
}

fn apply(function: Unary, x: Scalar) -> Scalar {
    Scalar::Unary(function, Box::new(x))
}

fn number(n: i64) -> Scalar {
    Scalar::literal(n, 0)
}

impl Draw {
    /// One of each kind of closed form.
    fn flowing(&mut self, kind: usize) {
        let support = |draw: &mut Self| {
            let order = draw.random.i32(-2..=0);
            let height = Scalar::Literal(draw.signed(order));
            draw.body.points.push(Point {
                axes: Axes::Body,
                coordinates: if draw.body.motion.is_planar() {
                    [height, Scalar::zero(), Scalar::zero()]
                } else {
                    [Scalar::zero(), Scalar::zero(), height]
                },
            });
            Support {
                point: 0,
                anchor: None,
            }
        };
        let mut is_symmetric = false;
        let mut has_weight = true;
        match kind {
            0 => self.body.motion = Motion::Spatial,
            1 => {
                self.body.motion = Motion::Rotation;
                has_weight = false;
            }
            2 => {
                self.body.motion = Motion::Planar;
                let held = support(self);
                self.body.motion = Motion::Pivot(held);
            }
            3 => {
                // Lagrange's top
                is_symmetric = true;
                let held = support(self);
                self.body.motion = Motion::FixedPoint(held);
            }
            4 => {
                // a constant moment along the axis of symmetry
                is_symmetric = true;
                has_weight = self.random.bool();
                self.body.motion = Motion::Spatial;
            }
            5 => {
                let held = support(self);
                let direction = self.pick(&[[1, 0, 0], [0, 1, 0], [1, 2, 2]]);
                self.body.motion = Motion::FixedAxis(held, Axes::Body, whole(direction));
            }
            6 => self.body.motion = Motion::Rod(whole([1, 0, 0])),
            _ => self.body.motion = Motion::Planar,
        }
        self.mass_and_inertia();
        if is_symmetric {
            let order = self.random.i32(-2..=0);
            let (across, along) = (self.positive(order), self.between(600, 1800));
            let across = Scalar::Literal(across);
            let along = Scalar::Literal(along) * across.clone();
            self.body.inertia = Some(Inertia::Principal([across.clone(), across, along]));
            let order = self.random.i32(-1..=1);
            self.body.mass = Some(Scalar::Literal(self.positive(order)));
        }
        // weight goes by the mass, which what is composed has by its parts
        if has_weight {
            let weight = self.weight();
            self.body.loads.push(weight);
        }
        let moment = Scalar::Literal(self.signed(-1));
        match kind {
            4 => {
                let along = Vector::Written(Axes::Body, [Scalar::zero(), Scalar::zero(), moment]);
                self.push(Key::Moments, What::Moment(along));
            }
            7 => self.push(Key::Moments, What::PlaneMoment(moment)),
            _ => {}
        }
    }

    fn push(&mut self, key: Key, what: What) {
        self.body.loads.push(Load { key, what });
        self.body.loads.sort_by_key(|load| load.key);
    }

    /// Under loads that are smooth, some of them as steep as a wall.
    fn driven(&mut self) {
        self.body.motion = self.pick(&[
            Motion::Translation,
            Motion::Translation,
            Motion::Spatial,
            Motion::Planar,
            Motion::Rotation,
            Motion::PlanarTranslation,
        ]);
        self.mass_and_inertia();
        if self.body.motion.moves() && self.random.bool() {
            let weight = self.weight();
            self.body.loads.push(weight);
        }
        for _ in 0..self.random.usize(1..=2) {
            self.drive();
        }
    }

    fn drive(&mut self) {
        let moves = self.body.motion.moves();
        let planar = self.body.motion.is_planar();
        let strength = Scalar::Literal(self.signed(0));
        if !moves {
            let factor = strength * self.smooth_gate();
            let along = self.direction();
            return self.push(Key::Moments, What::Moment(factor * along));
        }
        if planar && self.body.motion.turns() && self.chance(0.3) {
            let factor = strength * self.smooth_gate();
            return self.push(Key::Moments, What::PlaneMoment(factor));
        }
        let force = match self.random.u32(..4) {
            // drag, linear and quadratic: it takes energy away
            0 => {
                let order = self.random.i32(-2..=0);
                let drag = -Scalar::Literal(self.positive(order));
                let factor = if self.random.bool() {
                    drag
                } else {
                    drag * Scalar::Norm(Box::new(Vector::Velocity))
                };
                factor * Vector::Velocity
            }
            1 => {
                let order = self.random.i32(-1..=1);
                -Scalar::Literal(self.positive(order)) * Vector::Position
            }
            _ => {
                let factor = strength * self.smooth_gate();
                factor * self.direction()
            }
        };
        self.push(Key::Forces, What::Force(force, Place::Center));
    }

    /// Of bounded size, but for a wall.
    fn smooth_gate(&mut self) -> Scalar {
        self.is_slow = !self.body.motion.moves();
        let q = if self.is_slow {
            number(1) * Scalar::Time
        } else {
            self.quantity()
        };
        self.is_slow = false;
        let order = self.random.i32(-2..=1);
        let steep = order - self.random.i32(0..=2);
        let (c, s) = (self.signed(order), self.positive(steep));
        let x = q.clone() - Scalar::Literal(c);
        let scaled = Scalar::Quotient(Box::new(x.clone()), Box::new(Scalar::Literal(s)));
        match self.random.u32(..6) {
            // nothing but a shorter step would see a shorter pulse
            2 if steep < -1 => apply(Unary::Sin, q),
            0 | 1 => number(1) + apply(Unary::Tanh, scaled),
            2 => apply(Unary::Exp, -Scalar::Power(Box::new(scaled), 2)),
            3 => apply(Unary::Sin, q),
            4 => apply(Unary::Atan, scaled),
            _ => Scalar::Quotient(
                Box::new(number(1)),
                Box::new(number(1) + apply(Unary::Exp, scaled)),
            ),
        }
    }
}
