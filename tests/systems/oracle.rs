//! How bodies move and what acts on them, computed independently. Poses are carried through the
//! tree with their first and second time derivatives, so that velocity products follow from the
//! product rule.

use nalgebra::{Matrix3, Quaternion, UnitQuaternion, Vector3};

pub type Vec3 = Vector3<f64>;
pub type Mat3 = Matrix3<f64>;

/// How a joint moves, with its directions in the axes of both bodies at zero.
#[derive(Clone, Copy)]
pub enum Kind {
    Revolute(Vec3),
    Prismatic(Vec3),
    Cylindrical(Vec3),
    Screw(Vec3, f64),
    Universal(Vec3, Vec3),
    Spherical,
    Weld,
    Free,
    /// Along x and y, and about z.
    Plane,
    /// Along the first two, and about the third.
    Planar(Vec3, Vec3, Vec3),
    /// Along the first axes, so many.
    Shift(usize),
}

/// A body with the joint that carries it.
#[derive(Clone, Copy)]
pub struct Link {
    pub mass: f64,
    pub inertia: Mat3,
    /// A body before this one, or the ground.
    pub carrier: Option<usize>,
    /// P, from G of the carrier in its axes, or in world axes.
    pub place: Vec3,
    /// Q, from G in body axes.
    pub pin: Vec3,
    pub kind: Kind,
    /// An axis, and an angle about it.
    pub turned: (Vec3, f64),
}

/// Coordinates of a joint and their rates.
pub type Rates = (Vec<f64>, Vec<f64>);

/// A pose with its derivatives in time: of a frame in world axes.
#[derive(Clone, Copy)]
struct Pose {
    place: [Vec3; 3],
    turn: [Mat3; 3],
}

/// How a body moves, in world axes.
#[derive(Clone, Copy)]
pub struct Motion {
    pub position: Vec3,
    pub velocity: Vec3,
    pub acceleration: Vec3,
    pub attitude: Mat3,
    pub angular_velocity: Vec3,
    pub angular_acceleration: Vec3,
}

/// What acts from outside, and what drives the joints.
pub struct Loads {
    /// Force, and moment about G, of each body, world axes.
    pub on: Vec<[Vec3; 2]>,
    /// Of each joint, by its freedoms.
    pub drives: Vec<Vec<f64>>,
    pub motions: Vec<Motion>,
    pub rates: Vec<Rates>,
}

impl Kind {
    pub fn freedoms(self) -> usize {
        match self {
            Self::Weld => 0,
            Self::Revolute(_) | Self::Prismatic(_) | Self::Screw(..) => 1,
            Self::Cylindrical(_) | Self::Universal(..) => 2,
            Self::Shift(count) => count,
            Self::Spherical | Self::Plane | Self::Planar(..) => 3,
            Self::Free => 6,
        }
    }

    fn pose(self, (q, v): &Rates, a: &[f64]) -> Pose {
        let of = |k: usize| [q[k], v[k], a[k]];
        match self {
            Self::Weld => Pose::at(Vec3::zeros()),
            Self::Revolute(d) => Pose::turn(d, of(0)),
            Self::Prismatic(d) => Pose::slide(d, of(0)),
            Self::Cylindrical(d) => Pose::slide(d, of(0)).then(&Pose::turn(d, of(1))),
            Self::Screw(d, pitch) => Pose::slide(d * pitch, of(0)).then(&Pose::turn(d, of(0))),
            Self::Universal(d, e) => Pose::turn(d, of(0)).then(&Pose::turn(e, of(1))),
            Self::Spherical => Pose::ball(q, v, a),
            Self::Plane => {
                Self::Planar(Vec3::x(), Vec3::y(), Vec3::z()).pose(&(q.clone(), v.clone()), a)
            }
            Self::Planar(along, across, normal) => Pose::slide(along, of(0))
                .then(&Pose::slide(across, of(1)))
                .then(&Pose::turn(normal, of(2))),
            Self::Shift(count) => {
                let mut pose = Pose::at(Vec3::zeros());
                for axis in 0..count {
                    pose = pose.then(&Pose::slide(Vec3::ith(axis, 1.0), of(axis)));
                }
                pose
            }
            Self::Free => {
                let vector = |list: &[f64]| Vec3::new(list[0], list[1], list[2]);
                let mut pose = Pose::ball(&q[3..], &v[3..], &a[3..]);
                pose.place = [vector(q), vector(v), vector(a)];
                pose
            }
        }
    }
}

impl Pose {
    fn at(place: Vec3) -> Self {
        let (zero, none) = (Vec3::zeros(), Mat3::zeros());
        let turn = [Mat3::identity(), none, none];
        Self {
            place: [place, zero, zero],
            turn,
        }
    }

    fn slide(direction: Vec3, along: [f64; 3]) -> Self {
        let mut pose = Self::at(Vec3::zeros());
        pose.place = along.map(|part| direction * part);
        pose
    }

    fn turn(axis: Vec3, [angle, rate, second]: [f64; 3]) -> Self {
        let cross = axis.cross_matrix();
        let turn = UnitQuaternion::new(axis * angle).to_rotation_matrix();
        let turn = *turn.matrix();
        let derivatives = [
            turn,
            cross * turn * rate,
            (cross * second + cross * cross * (rate * rate)) * turn,
        ];
        let mut pose = Self::at(Vec3::zeros());
        pose.turn = derivatives;
        pose
    }

    /// Of a quaternion x, y, z, w, its angular velocity and acceleration in the axes it carries.
    fn ball(q: &[f64], v: &[f64], a: &[f64]) -> Self {
        let quaternion = Quaternion::new(q[3], q[0], q[1], q[2]);
        let turn = UnitQuaternion::new_unchecked(quaternion);
        let turn = *turn.to_rotation_matrix().matrix();
        let rate = Vec3::new(v[0], v[1], v[2]).cross_matrix();
        let second = Vec3::new(a[0], a[1], a[2]).cross_matrix();
        let mut pose = Self::at(Vec3::zeros());
        pose.turn = [turn, turn * rate, turn * (second + rate * rate)];
        pose
    }

    /// The product, with its derivatives.
    fn then(&self, next: &Self) -> Self {
        let [turn, rate, second] = self.turn;
        let ([p, dp, ddp], [t, dt, ddt]) = (next.place, next.turn);
        let place = [
            turn * p,
            rate * p + turn * dp,
            second * p + rate * dp * 2.0 + turn * ddp,
        ];
        Self {
            place: [0, 1, 2].map(|order| self.place[order] + place[order]),
            turn: [
                turn * t,
                rate * t + turn * dt,
                second * t + rate * dt * 2.0 + turn * ddt,
            ],
        }
    }

    fn motion(&self) -> Motion {
        let [turn, rate, second] = self.turn;
        let spin = rate * turn.transpose();
        Motion {
            position: self.place[0],
            velocity: self.place[1],
            acceleration: self.place[2],
            attitude: turn,
            angular_velocity: vector_of(&spin),
            angular_acceleration: vector_of(&(second * turn.transpose())),
        }
    }
}

/// Of the skew part.
fn vector_of(m: &Mat3) -> Vec3 {
    Vec3::new(m.m32 - m.m23, m.m13 - m.m31, m.m21 - m.m12) / 2.0
}

/// The motions of all bodies, with these accelerations joint by joint.
pub fn motions(links: &[Link], rates: &[Rates], accelerations: &[Vec<f64>]) -> Vec<Motion> {
    let mut poses: Vec<Pose> = Vec::new();
    for ((link, rates), a) in links.iter().zip(rates).zip(accelerations) {
        let carrier = link
            .carrier
            .map_or(Pose::at(Vec3::zeros()), |carrier| poses[carrier]);
        let pose = carrier
            .then(&Pose::at(link.place))
            .then(&Pose::turn(link.turned.0, [link.turned.1, 0.0, 0.0]))
            .then(&link.kind.pose(rates, a))
            .then(&Pose::at(-link.pin));
        poses.push(pose);
    }
    poses.iter().map(Pose::motion).collect()
}

impl Loads {
    /// A force in world axes, at a point in body axes.
    pub fn force(&mut self, body: usize, at: [f64; 3], force: Vec3) {
        let arm = self.motions[body].attitude * Vec3::from(at);
        self.on[body][0] += force;
        self.on[body][1] += arm.cross(&force);
    }

    pub fn moment(&mut self, body: usize, moment: Vec3) {
        self.on[body][1] += moment;
    }

    /// From body to world axes.
    pub fn turned(&self, body: usize, vector: [f64; 3]) -> Vec3 {
        self.motions[body].attitude * Vec3::from(vector)
    }

    pub fn point(&self, body: usize, at: [f64; 3]) -> Vec3 {
        self.motions[body].position + self.turned(body, at)
    }

    pub fn velocity(&self, body: usize, at: [f64; 3]) -> Vec3 {
        let motion = &self.motions[body];
        motion.velocity + motion.angular_velocity.cross(&self.turned(body, at))
    }

    /// Pulls two points of bodies together.
    pub fn tension(&mut self, tension: f64, (a, p): (usize, [f64; 3]), (b, q): (usize, [f64; 3])) {
        let line = (self.point(b, q) - self.point(a, p)).normalize();
        self.force(a, p, line * tension);
        self.force(b, q, line * -tension);
    }

    /// Pulls a point towards one of the ground.
    pub fn pull(&mut self, tension: f64, (a, p): (usize, [f64; 3]), ground: [f64; 3]) {
        let line = (Vec3::from(ground) - self.point(a, p)).normalize();
        self.force(a, p, line * tension);
    }
}
