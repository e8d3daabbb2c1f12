//! The law of each body by itself, (1.3) and (1.4), the loads of its joints unknown, in 106 bits.
//!
//! Poses are carried through the tree with their first and second derivatives in time, so that
//! velocity products follow from the product rule. Of given accelerations the loads of the joints
//! follow body by body from the tips; a motion is true if along each freedom they are what drives it.

use std::cell::Cell;

use crate::space::{
    Mat3, NONE, Vec3, ZERO, add, apply, cross, crossing, dot, identity, product, scale, size,
    subtract, sum, times, transposed,
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
    /// Along x and y, and about z.
    Plane,
}

/// A coordinate as a function of time and of inputs, with its rate and acceleration.
pub type Prescribed = Box<dyn Fn(Wide, &[Wide]) -> [Wide; 3]>;

/// A body with the joint that carries it.
pub struct Link {
    pub mass: Wide,
    pub inertia: Mat3,
    /// A body before this one, or the ground.
    pub carrier: Option<usize>,
    /// P, from G of the carrier in its axes, or in world axes.
    pub place: Vec3,
    /// Q, from G in body axes.
    pub pin: Vec3,
    pub kind: Kind,
    /// An axis, and an angle about it.
    pub turned: Option<(Vec3, Wide)>,
    pub driven: Option<Vec<Prescribed>>,
}

/// Coordinates of a joint and their rates.
pub type Rates = (Vec<Wide>, Vec<Wide>);

/// What acts.
pub type Acting = Box<dyn Fn(&Scene<'_>, &mut Loads)>;

/// Where the bodies are and how they move, in which no coordinate accelerates.
pub struct Scene<'a> {
    pub links: &'a [Link],
    pub time: Wide,
    pub inputs: &'a [Wide],
    pub rates: &'a [Rates],
    pub motions: Vec<Motion>,
    /// A load has no direction here.
    pub is_near: Cell<bool>,
}

#[derive(Clone, Default)]
pub struct Loads {
    /// Force, and moment about G, of each body, world axes.
    pub on: Vec<[Vec3; 2]>,
    /// Of each joint, by its freedoms.
    pub drives: Vec<Vec<Wide>>,
}

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

/// What the joints have to carry.
pub struct Carried {
    /// Force and moment on the carried body at Q, world axes.
    pub joints: Vec<[Vec3; 2]>,
    /// Along the freedoms of each joint.
    pub along: Vec<Vec<Wide>>,
    /// Of the terms.
    pub size: f64,
}

impl Kind {
    pub fn freedoms(self) -> usize {
        match self {
            Self::Weld => 0,
            Self::Revolute(_) | Self::Prismatic(_) | Self::Screw(..) => 1,
            Self::Cylindrical(_) | Self::Universal(..) => 2,
            Self::Spherical | Self::Plane => 3,
            Self::Free => 6,
        }
    }

    fn pose(self, (q, v): &Rates, a: &[Wide]) -> Pose {
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
            Self::Plane => Pose::slide(x, of(0))
                .then(&Pose::slide(y, of(1)))
                .then(&Pose::turn(z, of(2))),
            Self::Free => {
                let mut pose = Pose::ball(&q[3..], &v[3..], &a[3..]);
                pose.place = [vector(q), vector(v), vector(a)];
                pose
            }
        }
    }
}

fn vector(list: &[Wide]) -> Vec3 {
    [list[0], list[1], list[2]]
}

impl Pose {
    fn at(place: Vec3) -> Self {
        Self {
            place: [place, ZERO, ZERO],
            turn: [identity(), NONE, NONE],
        }
    }

    fn slide(direction: Vec3, along: [Wide; 3]) -> Self {
        let mut pose = Self::at(ZERO);
        pose.place = along.map(|part| scale(direction, part));
        pose
    }

    fn turn(axis: Vec3, [angle, rate, second]: [Wide; 3]) -> Self {
        let (sine, cosine) = angle.sin_cos();
        let k = crossing(axis);
        let twice = product(&k, &k);
        let turn = sum(
            &identity(),
            &sum(&times(&k, sine), &times(&twice, Wide::ONE - cosine)),
        );
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
    fn then(&self, next: &Self) -> Self {
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

    fn motion(&self) -> Motion {
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
fn vector_of(m: &Mat3) -> Vec3 {
    [(2, 1), (0, 2), (1, 0)].map(|(i, j)| (m[i][j] - m[j][i]) * 0.5)
}

/// The motions of all bodies, with these accelerations joint by joint.
pub fn motions(links: &[Link], rates: &[Rates], accelerations: &[Vec<Wide>]) -> Vec<Motion> {
    let mut poses: Vec<Pose> = Vec::new();
    for ((link, rates), a) in links.iter().zip(rates).zip(accelerations) {
        let carrier = link
            .carrier
            .map_or(Pose::at(ZERO), |carrier| poses[carrier]);
        let mut pose = carrier.then(&Pose::at(link.place));
        if let Some((axis, angle)) = link.turned {
            pose = pose.then(&Pose::turn(axis, [angle, Wide::ZERO, Wide::ZERO]));
        }
        let pose = pose
            .then(&link.kind.pose(rates, a))
            .then(&Pose::at(scale(link.pin, -Wide::ONE)));
        poses.push(pose);
    }
    poses.iter().map(Pose::motion).collect()
}

/// As many zeros as there are freedoms.
pub fn still(links: &[Link]) -> Vec<Vec<Wide>> {
    let counts = links.iter().map(|link| link.kind.freedoms());
    counts.map(|count| vec![Wide::ZERO; count]).collect()
}

impl<'a> Scene<'a> {
    pub fn new(links: &'a [Link], time: Wide, inputs: &'a [Wide], rates: &'a [Rates]) -> Self {
        let motions = motions(links, rates, &still(links));
        Self {
            links,
            time,
            inputs,
            rates,
            motions,
            is_near: Cell::new(false),
        }
    }

    /// From body to world axes; of the ground they are its own.
    pub fn turned(&self, body: Option<usize>, vector: Vec3) -> Vec3 {
        body.map_or(vector, |body| apply(&self.motions[body].attitude, vector))
    }

    pub fn point(&self, body: Option<usize>, at: Vec3) -> Vec3 {
        let arm = self.turned(body, at);
        body.map_or(arm, |body| add(self.motions[body].position, arm))
    }

    pub fn velocity(&self, body: usize, at: Vec3) -> Vec3 {
        let motion = &self.motions[body];
        let swept = cross(motion.angular_velocity, self.turned(Some(body), at));
        add(motion.velocity, swept)
    }

    pub fn loads(&self, acting: &[Acting]) -> Loads {
        let mut loads = Loads {
            on: vec![[ZERO; 2]; self.links.len()],
            drives: still(self.links),
        };
        for act in acting {
            act(self, &mut loads);
        }
        loads
    }

    /// What the joints carry with these accelerations, and how the bodies move.
    pub fn carried(&self, loads: &Loads, accelerations: &[Vec<Wide>]) -> (Carried, Vec<Motion>) {
        let motions = motions(self.links, self.rates, accelerations);
        let mut needed = vec![[ZERO; 2]; self.links.len()];
        let mut all = 0.0;
        for body in (0..self.links.len()).rev() {
            let [taken, turning] = self.taken(body, &motions[body]);
            let [force, moment] = loads.on[body];
            let about = add(needed[body][1], subtract(turning, moment));
            let whole = add(needed[body][0], subtract(taken, force));
            let arm = self.turned(Some(body), self.links[body].pin);
            let at_pin = subtract(about, cross(arm, whole));
            let reach = 1.0 + size(arm);
            all += (size(taken) + size(force)) * reach + size(turning) + size(moment);
            // what cancels in the cross product
            let rate = size(motions[body].angular_velocity);
            let largest = self.links[body].inertia.iter().map(|row| size(*row));
            all += rate * rate * largest.fold(0.0, f64::max);
            needed[body] = [whole, at_pin];
            if let Some(carrier) = self.links[body].carrier {
                let pin = self.point(Some(body), self.links[body].pin);
                let arm = subtract(pin, motions[carrier].position);
                let [sum_force, sum_moment] = needed[carrier];
                all *= 1.0 + size(arm);
                needed[carrier] = [
                    add(sum_force, whole),
                    add(sum_moment, add(at_pin, cross(arm, whole))),
                ];
            }
        }
        let along = self.along(&needed);
        let drives = loads.drives.iter().flatten();
        let size = drives.fold(all, |size, drive| size + drive.high.abs());
        let carried = Carried {
            joints: needed,
            along,
            size,
        };
        (carried, motions)
    }

    /// `m a_G`, and `J w' + w x J w`.
    pub fn taken(&self, body: usize, motion: &Motion) -> [Vec3; 2] {
        let tensor = self.tensor(body);
        let spin = apply(&tensor, motion.angular_velocity);
        let turning = apply(&tensor, motion.angular_acceleration);
        [
            scale(motion.acceleration, self.links[body].mass),
            add(turning, cross(motion.angular_velocity, spin)),
        ]
    }

    /// World axes.
    pub fn tensor(&self, body: usize) -> Mat3 {
        let attitude = &self.motions[body].attitude;
        let turned = product(attitude, &self.links[body].inertia);
        product(&turned, &transposed(attitude))
    }

    /// The power of joint loads along each freedom.
    fn along(&self, joints: &[[Vec3; 2]]) -> Vec<Vec<Wide>> {
        let slow = self.rates.iter();
        let slow = slow.map(|(q, v)| (q.clone(), vec![Wide::ZERO; v.len()]));
        let slow: Vec<Rates> = slow.collect();
        let mut unit = still(self.links);
        let mut along = still(self.links);
        for (joint, [force, moment]) in joints.iter().enumerate() {
            for freedom in 0..unit[joint].len() {
                unit[joint][freedom] = Wide::ONE;
                let motion = motions(self.links, &slow, &unit)[joint];
                unit[joint][freedom] = Wide::ZERO;
                let arm = self.turned(Some(joint), self.links[joint].pin);
                let turning = motion.angular_acceleration;
                let sliding = add(motion.acceleration, cross(turning, arm));
                along[joint][freedom] = dot(*force, sliding) + dot(*moment, turning);
            }
        }
        along
    }
}

impl Loads {
    /// A force in world axes, at a point in body axes.
    pub fn force(&mut self, scene: &Scene<'_>, body: usize, at: Vec3, force: Vec3) {
        let arm = scene.turned(Some(body), at);
        let [sum, about] = self.on[body];
        self.on[body] = [add(sum, force), add(about, cross(arm, force))];
    }

    pub fn moment(&mut self, body: usize, moment: Vec3) {
        self.on[body][1] = add(self.on[body][1], moment);
    }
}
