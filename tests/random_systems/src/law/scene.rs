//! Where bodies are and how they move, what acts on them, and what their joints transmit.
//!
//! Poses are carried through the tree with their first and second time derivatives, so that
//! velocity products follow from the product rule. For given accelerations, the loads of the joints
//! follow body by body, starting at the tips. A motion is correct if, along each freedom, the load
//! is the drive there.

use std::cell::{Cell, RefCell};

use super::kind::{Kind, Motion, Pose, Rates};
use super::space::{
    Mat3, Vec3, ZERO, add, apply, cross, dot, product, scale, size, subtract, transposed,
};
use crate::wide::Wide;

/// What is known before the bodies move.
#[derive(Clone, Copy)]
pub struct Instant<'a> {
    pub time: Wide,
    pub inputs: &'a [Wide],
    /// User-defined ones.
    pub states: &'a [Wide],
}

/// A coordinate at an instant, with its rate and acceleration.
pub type Prescribed = Box<dyn Fn(&Instant<'_>) -> [Wide; 3]>;

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
    /// Axes, and angles about them, each in the axes that those before it have made.
    pub turned: Vec<(Vec3, Wide)>,
    pub driven: Option<Vec<Prescribed>>,
    /// The inertia along its only coordinate.
    pub armature: Wide,
}

/// What acts.
pub type Acting = Box<dyn Fn(&Scene<'_>, &mut Loads)>;

/// An energy.
pub type Stored = Box<dyn Fn(&Scene<'_>) -> Wide>;

/// A joint that closes a loop carries a link without mass, which is where the body is.
#[derive(Clone, Copy)]
pub struct Ring {
    pub link: usize,
    pub body: usize,
}

/// Where the bodies are and how they move, in which no coordinate accelerates.
pub struct Scene<'a> {
    pub links: &'a [Link],
    /// Links behind these have no mass, and are no bodies.
    pub bodies: usize,
    pub instant: Instant<'a>,
    pub rates: &'a [Rates],
    pub motions: Vec<Motion>,
    /// With the accelerations that loads follow.
    following: RefCell<Vec<Motion>>,
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

/// What the joints have to carry.
pub struct Carried {
    /// Force and moment on the carried body at Q, world axes.
    pub joints: Vec<[Vec3; 2]>,
    /// Along the freedoms of each joint.
    pub along: Vec<Vec<Wide>>,
    /// Of the terms.
    pub size: f64,
}

/// The motions of all bodies, with these accelerations joint by joint.
pub fn motions(links: &[Link], rates: &[Rates], accelerations: &[Vec<Wide>]) -> Vec<Motion> {
    let mut poses: Vec<Pose> = Vec::new();
    for ((link, rates), a) in links.iter().zip(rates).zip(accelerations) {
        let carrier = link
            .carrier
            .map_or(Pose::at(ZERO), |carrier| poses[carrier]);
        let mut pose = carrier.then(&Pose::at(link.place));
        for (axis, angle) in &link.turned {
            pose = pose.then(&Pose::turn(*axis, [*angle, Wide::ZERO, Wide::ZERO]));
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
    pub fn new(
        (links, bodies): (&'a [Link], usize),
        instant: Instant<'a>,
        rates: &'a [Rates],
    ) -> Self {
        let motions = motions(links, rates, &still(links));
        Self {
            links,
            bodies,
            instant,
            rates,
            following: RefCell::new(motions.clone()),
            motions,
            is_near: Cell::new(false),
        }
    }

    /// Loads follow these accelerations from now on.
    pub fn follow(&self, accelerations: &[Vec<Wide>]) {
        *self.following.borrow_mut() = motions(self.links, self.rates, accelerations);
    }

    /// The acceleration that loads follow: of a point of a body, and angular, world axes.
    pub fn followed(&self, body: usize, at: Vec3) -> [Vec3; 2] {
        let motion = &self.following.borrow()[body];
        let (arm, w) = (self.turned(Some(body), at), motion.angular_velocity);
        let turning = motion.angular_acceleration;
        let swept = add(cross(turning, arm), cross(w, cross(w, arm)));
        [add(motion.acceleration, swept), turning]
    }

    /// Of a link that a rod carries: the direction from Q to P, world axes.
    pub fn along_rod(&self, link: usize) -> Vec3 {
        let own = &self.links[link];
        let [p, q] = [(own.carrier, own.place), (Some(link), own.pin)];
        let line = subtract(self.point(p.0, p.1), self.point(q.0, q.1));
        scale(line, Wide::ONE / dot(line, line).sqrt())
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

    pub fn loads<'b>(&self, acting: impl Iterator<Item = &'b Acting>) -> Loads {
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
        let mut along = self.along(&needed);
        for ((link, along), a) in self.links.iter().zip(&mut along).zip(accelerations) {
            for (along, a) in along.iter_mut().zip(a) {
                let taken = link.armature * *a;
                *along = *along + taken;
                all += taken.high.abs();
            }
        }
        let drives = loads.drives.iter().flatten();
        let size = drives.fold(all, |size, drive| size + drive.high.abs());
        let carried = Carried {
            joints: needed,
            along,
            size,
        };
        (carried, motions)
    }

    /// The directions in which a joint slides before it turns, world axes.
    pub fn slides(&self, joint: usize) -> Vec<Vec3> {
        let link = &self.links[joint];
        let mut still = self.rates[joint].clone();
        still.1.fill(Wide::ZERO);
        let own = link.kind.pose(&still, &vec![Wide::ZERO; still.1.len()]);
        let before = product(&self.motions[joint].attitude, &transposed(&own.turn[0]));
        let directions = match link.kind {
            Kind::Planar(along, across, _) => vec![along, across],
            Kind::Shift(count) => super::space::identity()[..count].to_vec(),
            _ => Vec::new(),
        };
        directions.iter().map(|one| apply(&before, *one)).collect()
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
