//! How joints move what they carry: poses, with their first and second time derivatives.

use super::space::{
    Mat3, NONE, Vec3, ZERO, add, apply, cross, crossing, dot, identity, product, scale, subtract,
    sum, times, transposed, unit,
};
use crate::wide::Wide;

#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Kind {
    Weld,
    Revolute(Vec3),
    Prismatic(Vec3),
    Cylindrical(Vec3),
    Screw(Vec3, Wide),
    Universal(Vec3, Vec3),
    Spherical,
    Free,
    /// Along x and y, and about z: what is free in the plane.
    Plane,
    /// Along the first two, and about the third.
    Planar(Vec3, Vec3, Vec3),
    /// Along the first axes, so many.
    Shift(usize),
    /// A rod of this length from P to Q, which is turned anyhow at both ends, in the plane or in space.
    Rod(Wide, bool),
}

/// Coordinates of a joint and their rates.
pub type Rates = (Vec<Wide>, Vec<Wide>);

/// A pose with its derivatives in time: of a frame in world axes.
#[derive(Clone, Copy)]
pub struct Pose {
    pub place: [Vec3; 3],
    pub turn: [Mat3; 3],
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

impl Kind {
    pub fn freedoms(self) -> usize {
        match self {
            Self::Weld => 0,
            Self::Revolute(_) | Self::Prismatic(_) | Self::Screw(..) => 1,
            Self::Cylindrical(_) | Self::Universal(..) | Self::Rod(_, true) => 2,
            Self::Shift(count) => count,
            Self::Spherical | Self::Plane | Self::Planar(..) => 3,
            Self::Rod(_, false) => 5,
            Self::Free => 6,
        }
    }

    /// Nothing holds what it carries.
    pub fn is_free(self) -> bool {
        matches!(self, Self::Free | Self::Plane)
    }

    /// The first coordinate of its quaternion, if it has one.
    pub fn quaternion(self) -> Option<usize> {
        match self {
            Self::Spherical => Some(0),
            Self::Free => Some(3),
            _ => None,
        }
    }

    /// The planar joint of a normal: its coordinates are measured along the two axes behind the one
    /// that is nearest to the normal, turned with that one by the shortest way.
    pub fn planar(normal: Vec3) -> Self {
        let larger =
            |a: usize, b: usize| normal[b].high.abs() > normal[a].high.abs() * (1.0 + 1e-12);
        let nearest = (1..3).fold(0, |best, axis| if larger(best, axis) { axis } else { best });
        let units = identity();
        let is_against = normal[nearest].high < 0.0;
        let sign = if is_against { -Wide::ONE } else { Wide::ONE };
        let axis = scale(units[nearest], sign);
        let first = units[(nearest + 1) % 3];
        let second = scale(units[(nearest + 2) % 3], sign);
        // about e x n, by the angle between e and n
        let about = cross(axis, normal);
        let (sine, cosine) = (dot(about, about).sqrt(), dot(axis, normal));
        if sine == Wide::ZERO {
            return Self::Planar(first, second, normal);
        }
        let turn = turning(unit(about), sine, cosine);
        Self::Planar(apply(&turn, first), apply(&turn, second), normal)
    }

    /// With other directions.
    pub fn with_directions(self, of: impl Fn(Vec3) -> Vec3) -> Self {
        match self {
            Self::Revolute(d) => Self::Revolute(of(d)),
            Self::Prismatic(d) => Self::Prismatic(of(d)),
            Self::Cylindrical(d) => Self::Cylindrical(of(d)),
            Self::Screw(d, pitch) => Self::Screw(of(d), pitch),
            Self::Universal(d, e) => Self::Universal(of(d), of(e)),
            other => other,
        }
    }

    pub fn pose(self, (q, v): &Rates, a: &[Wide]) -> Pose {
        let of = |k: usize| [q[k], v[k], a[k]];
        let [x, y, z] = identity();
        match self {
            Self::Weld => Pose::at(ZERO),
            Self::Revolute(d) => Pose::turn(d, of(0)),
            Self::Prismatic(d) => Pose::slide(d, of(0)),
            Self::Cylindrical(d) => Pose::slide(d, of(0)).then(&Pose::turn(d, of(1))),
            Self::Screw(d, pitch) => {
                Pose::slide(scale(d, pitch), of(0)).then(&Pose::turn(d, of(0)))
            }
            Self::Universal(d, e) => Pose::turn(d, of(0)).then(&Pose::turn(e, of(1))),
            Self::Spherical => Pose::ball(q, v, a),
            Self::Plane => Self::Planar(x, y, z).pose(&(q.clone(), v.clone()), a),
            Self::Planar(along, across, normal) => Pose::slide(along, of(0))
                .then(&Pose::slide(across, of(1)))
                .then(&Pose::turn(normal, of(2))),
            Self::Shift(count) => {
                let axes = [x, y, z].into_iter().enumerate().take(count);
                axes.fold(Pose::at(ZERO), |pose, (axis, unit)| {
                    pose.then(&Pose::slide(unit, of(axis)))
                })
            }
            Self::Rod(length, is_planar) => {
                let rod = Pose::at(scale(x, length));
                if is_planar {
                    return Pose::turn(z, of(0)).then(&rod).then(&Pose::turn(z, of(1)));
                }
                let turns = [(z, 2), (y, 3), (x, 4)].into_iter();
                let along = Pose::turn(z, of(0)).then(&Pose::turn(y, of(1)));
                turns.fold(along.then(&rod), |pose, (axis, part)| {
                    pose.then(&Pose::turn(axis, of(part)))
                })
            }
            Self::Free => {
                let mut pose = Pose::ball(&q[3..], &v[3..], &a[3..]);
                pose.place = [vector(q), vector(v), vector(a)];
                pose
            }
        }
    }

    /// The coordinates, moved along the rates: quaternions by the exponential.
    pub fn moved(self, q: &[Wide], by: &[Wide]) -> Vec<Wide> {
        let first = self.quaternion().unwrap_or(q.len());
        let mut moved: Vec<Wide> = q[..first].iter().zip(by).map(|(q, by)| *q + *by).collect();
        if let [x, y, z, w] = q[first..] {
            let about = vector(&by[first..]);
            let angle = dot(about, about).sqrt();
            let (sine, cosine) = (angle * 0.5).sin_cos();
            // sin(a / 2) / a, of a small angle 1/2
            let share = if angle == Wide::ZERO {
                Wide::from(0.5)
            } else {
                sine / angle
            };
            let (s, own) = (scale(about, share), [x, y, z]);
            let turned = add(add(scale(own, cosine), scale(s, w)), cross(own, s));
            let all = [turned[0], turned[1], turned[2], w * cosine - dot(own, s)];
            let square: Wide = all.iter().map(|part| *part * *part).sum();
            let length = square.sqrt();
            moved.extend(all.map(|part| part / length));
        }
        moved
    }
}

fn vector(list: &[Wide]) -> Vec3 {
    [list[0], list[1], list[2]]
}

/// About an axis, by an angle.
pub fn turn(axis: Vec3, angle: Wide) -> Mat3 {
    let (sine, cosine) = angle.sin_cos();
    turning(axis, sine, cosine)
}

/// About an axis, by an angle of this sine and cosine.
fn turning(axis: Vec3, sine: Wide, cosine: Wide) -> Mat3 {
    let k = crossing(axis);
    let twice = product(&k, &k);
    let bent = sum(&times(&k, sine), &times(&twice, Wide::ONE - cosine));
    sum(&identity(), &bent)
}

impl Pose {
    pub fn at(place: Vec3) -> Self {
        Self {
            place: [place, ZERO, ZERO],
            turn: [identity(), NONE, NONE],
        }
    }

    pub fn slide(direction: Vec3, along: [Wide; 3]) -> Self {
        let mut pose = Self::at(ZERO);
        pose.place = along.map(|part| scale(direction, part));
        pose
    }

    pub fn turn(axis: Vec3, [angle, rate, second]: [Wide; 3]) -> Self {
        let (sine, cosine) = angle.sin_cos();
        let k = crossing(axis);
        let twice = product(&k, &k);
        let turn = turning(axis, sine, cosine);
        let mut pose = Self::at(ZERO);
        pose.turn = [
            turn,
            times(&product(&k, &turn), rate),
            product(&sum(&times(&k, second), &times(&twice, rate * rate)), &turn),
        ];
        pose
    }

    /// Of a quaternion x, y, z, w, its angular velocity and acceleration in the axes it carries.
    fn ball(q: &[Wide], v: &[Wide], a: &[Wide]) -> Self {
        let k = crossing(vector(q));
        // of a unit quaternion
        let turn = sum(
            &times(&k, q[3] * 2.0),
            &times(&product(&k, &k), Wide::from(2.0)),
        );
        let turn = sum(&identity(), &turn);
        let (rate, second) = (crossing(vector(v)), crossing(vector(a)));
        let mut pose = Self::at(ZERO);
        pose.turn = [
            turn,
            product(&turn, &rate),
            product(&turn, &sum(&second, &product(&rate, &rate))),
        ];
        pose
    }

    /// The product, with its derivatives.
    pub fn then(&self, next: &Self) -> Self {
        let two = Wide::from(2.0);
        let [turn, rate, second] = &self.turn;
        let ([p, dp, ddp], [t, dt, ddt]) = (next.place, &next.turn);
        let place = [
            apply(turn, p),
            add(apply(rate, p), apply(turn, dp)),
            add(
                add(apply(second, p), scale(apply(rate, dp), two)),
                apply(turn, ddp),
            ),
        ];
        Self {
            place: [0, 1, 2].map(|order| add(self.place[order], place[order])),
            turn: [
                product(turn, t),
                sum(&product(rate, t), &product(turn, dt)),
                sum(
                    &sum(&product(second, t), &times(&product(rate, dt), two)),
                    &product(turn, ddt),
                ),
            ],
        }
    }

    pub fn motion(&self) -> Motion {
        let [turn, rate, second] = &self.turn;
        let back = transposed(turn);
        Motion {
            position: self.place[0],
            velocity: self.place[1],
            acceleration: self.place[2],
            attitude: *turn,
            angular_velocity: vector_of(&product(rate, &back)),
            angular_acceleration: vector_of(&product(second, &back)),
        }
    }
}

/// Of the skew part.
pub fn vector_of(m: &Mat3) -> Vec3 {
    [(2, 1), (0, 2), (1, 0)].map(|(i, j)| (m[i][j] - m[j][i]) * 0.5)
}

impl Motion {
    /// Velocity and acceleration of a point at an arm, world axes.
    pub fn swept(&self, arm: Vec3) -> [Vec3; 2] {
        let (w, turning) = (self.angular_velocity, self.angular_acceleration);
        let swept = cross(w, arm);
        let bent = add(cross(turning, arm), cross(w, swept));
        [add(self.velocity, swept), add(self.acceleration, bent)]
    }

    /// How fast a point at an arm and the axes move against another motion, of which it is at another
    /// arm; and how these rates change.
    pub fn against(&self, arm: Vec3, other: &Self, other_arm: Vec3) -> [[Vec3; 2]; 2] {
        let (own, others) = (self.swept(arm), other.swept(other_arm));
        let turning = subtract(self.angular_velocity, other.angular_velocity);
        let bent = subtract(self.angular_acceleration, other.angular_acceleration);
        [
            [subtract(own[0], others[0]), turning],
            [subtract(own[1], others[1]), bent],
        ]
    }
}
