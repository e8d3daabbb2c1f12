//! Compares a described system with the oracle, in random states.

use nalgebra::{Matrix3, UnitQuaternion, Vector2, Vector3};
use newton_euler::prelude::*;

use super::balances::{Solution, solve};
use super::oracle::{Kind, Link, Loads, Motion, Rates};

/// When the loads are compared.
pub const TIME: f64 = 0.7;

/// Numbers that look random, the same in each run.
pub struct Random(u64);

impl Random {
    pub fn new(seed: u64) -> Self {
        Self(seed.wrapping_mul(0x9e37_79b9_7f4a_7c15) | 1)
    }

    /// Between -1 and 1.
    #[allow(clippy::cast_precision_loss, reason = "53 bits are kept")]
    pub fn number(&mut self) -> f64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        (self.0 >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
    }

    pub fn vector(&mut self) -> Vector3<f64> {
        [self.number(), self.number(), self.number()].into()
    }
}

/// The state of a joint.
pub trait Jointed: Sized {
    fn random(random: &mut Random) -> Self;
    fn rates(&self) -> Rates;
}

macro_rules! scalars {
    ($name:ident: [$($position:ident)*] [$($rate:ident)*]) => {
        impl Jointed for $name {
            fn random(random: &mut Random) -> Self {
                Self { $($position: 3.0 * random.number(),)* $($rate: 4.0 * random.number(),)* }
            }

            fn rates(&self) -> Rates {
                (vec![$(self.$position),*], vec![$(self.$rate),*])
            }
        }
    };
}
scalars!(Hinge: [angle] [angular_velocity]);
scalars!(Slide: [position] [velocity]);
scalars!(Cylinder: [position angle] [velocity angular_velocity]);
scalars!(Universal: [angle_1 angle_2] [angular_velocity_1 angular_velocity_2]);

impl Jointed for Rotation {
    fn random(random: &mut Random) -> Self {
        Self {
            attitude: UnitQuaternion::new(random.vector() * 2.0),
            angular_velocity: random.vector() * 3.0,
        }
    }

    fn rates(&self) -> Rates {
        let q = self.attitude.coords.iter().copied().collect();
        (q, self.angular_velocity.iter().copied().collect())
    }
}

impl Jointed for Spatial {
    fn random(random: &mut Random) -> Self {
        let turning = Rotation::random(random);
        Self {
            position: random.vector() * 3.0,
            attitude: turning.attitude,
            velocity: random.vector() * 3.0,
            angular_velocity: turning.angular_velocity,
        }
    }

    fn rates(&self) -> Rates {
        let q = self.position.iter().chain(self.attitude.coords.iter());
        let v = self.velocity.iter().chain(self.angular_velocity.iter());
        (q.copied().collect(), v.copied().collect())
    }
}

impl Jointed for Planar {
    fn random(random: &mut Random) -> Self {
        Self {
            position: random.vector().xy() * 3.0,
            angle: random.number() * 3.0,
            velocity: random.vector().xy() * 3.0,
            angular_velocity: random.number() * 3.0,
        }
    }

    fn rates(&self) -> Rates {
        let (p, v) = (self.position, self.velocity);
        (
            vec![p.x, p.y, self.angle],
            vec![v.x, v.y, self.angular_velocity],
        )
    }
}

macro_rules! shifts {
    ($($name:ident)*) => {
        $(impl Jointed for $name {
            fn random(random: &mut Random) -> Self {
                let mut state = Self::default();
                for place in state.position.iter_mut().chain(state.velocity.iter_mut()) {
                    *place = 3.0 * random.number();
                }
                state
            }

            fn rates(&self) -> Rates {
                let list = |vector: &[f64]| vector.to_vec();
                (list(self.position.as_slice()), list(self.velocity.as_slice()))
            }
        })*
    };
}
shifts!(Translation PlanarTranslation);

/// Accelerations, loads and momenta as lists.
pub trait Listed {
    fn list(&self) -> Vec<f64>;
}

macro_rules! listed {
    ($($name:ty: $value:ident => $list:expr;)*) => {
        $(impl Listed for $name {
            fn list(&self) -> Vec<f64> {
                let $value = self;
                $list
            }
        })*
    };
}
listed! {
    f64: a => vec![*a];
    Vector2<f64>: a => vec![a.x, a.y];
    Vector3<f64>: a => vec![a.x, a.y, a.z];
    CylinderAcceleration: a => vec![a.linear, a.angular];
    SpatialAcceleration: a => [a.linear.list(), a.angular.list()].concat();
    PlanarAcceleration: a => [a.linear.list(), a.angular.list()].concat();
    Wrench: a => [a.force.list(), a.moment.list()].concat();
    PlanarWrench: a => [a.force.list(), a.moment.list()].concat();
}

/// What a system says in a state.
pub struct Answer {
    pub rates: Vec<Rates>,
    pub accelerations: Vec<Vec<f64>>,
    /// In the order of the joints that have one.
    pub reactions: Vec<(usize, Vec<f64>)>,
    pub kinetic: f64,
    /// Linear, about G of the whole, about the origin.
    pub momentum: [Vec<f64>; 3],
}

/// Compares a system with the oracle in random states.
///
/// `agree!(System, |numbers| (system, input, links), gravity, moving [a b], held [0 a, 1 b], still [],
/// |loads, system, input| { .. })`: how it is made, the joints that move, in order, those that hold, with
/// their numbers, the numbers of welds, and what acts.
#[macro_export]
macro_rules! agree {
    ($system:ty, $make:expr, $gravity:expr,
        moving [$($moving:ident)*], held [$($number:literal $held:ident)*], still [$($still:literal)*],
        |$loads:ident, $system_:ident, $input:ident| $load:block) => {{
        use $crate::compare::{Answer, Jointed, Listed, Random};
        let mut numbers = Random::new(line!().into());
        for _ in 0..50 {
            let (system, input, links) = $make(&mut numbers);
            let mut state = <$system as RigidBody>::State::default();
            $(state.$moving = Jointed::random(&mut numbers);)*
            let found = system.acceleration($crate::compare::TIME, &state, &input);
            let mut rates = vec![$(state.$moving.rates()),*];
            let mut accelerations = vec![$(found.$moving.list()),*];
            let still: &[usize] = &[$($still),*];
            for place in still {
                rates.insert(*place, (vec![], vec![]));
                accelerations.insert(*place, vec![]);
            }
            let held = system.reactions($crate::compare::TIME, &state, &input);
            let answer = Answer {
                rates,
                accelerations,
                reactions: vec![$(($number, held.$held.list())),*],
                kinetic: system.kinetic_energy(&state),
                momentum: [
                    system.linear_momentum(&state).list(),
                    system.angular_momentum(&state).list(),
                    system.angular_momentum_about_pole($crate::compare::TIME, &state).list(),
                ],
            };
            let ($system_, $input) = (&system, &input);
            $crate::compare::check(&links, $gravity, &answer, |$loads| $load);
        }
    }};
}

/// Checks that two lists differ by so little, relative to the largest of them.
#[track_caller]
pub fn close(what: &str, found: &[f64], expected: &[f64], scale: f64, tolerance: f64) {
    assert_eq!(found.len(), expected.len(), "{what}");
    let size = expected.iter().fold(scale, |size, one| size.max(one.abs()));
    for (a, b) in found.iter().zip(expected) {
        let is_close = (a - b).abs() <= tolerance * size;
        assert!(is_close, "{what}: {found:?}, expected {expected:?}");
    }
}

/// Checks an answer against the oracle.
#[track_caller]
pub fn check(links: &[Link], gravity: [f64; 3], answer: &Answer, load: impl Fn(&mut Loads)) {
    const TOLERANCE: f64 = 1e-11;
    let solution = solve(links, &answer.rates, gravity.into(), load);
    let largest = solution
        .accelerations
        .concat()
        .iter()
        .fold(1.0, |a: f64, b| a.max(b.abs()));
    for (joint, (found, expected)) in answer
        .accelerations
        .iter()
        .zip(&solution.accelerations)
        .enumerate()
    {
        close(
            &format!("acceleration of joint {joint}"),
            found,
            expected,
            largest,
            TOLERANCE,
        );
    }
    let list = |[force, moment]: [Vector3<f64>; 2], count: usize| match count {
        3 => vec![force.x, force.y, moment.z],
        _ => [force.list(), moment.list()].concat(),
    };
    let heavy: f64 = links.iter().map(|link| link.mass).sum();
    let scale = solution
        .joints
        .iter()
        .flatten()
        .fold(heavy * largest, |a, b| a.max(b.amax()));
    for (joint, found) in &answer.reactions {
        let expected = list(solution.joints[*joint], found.len());
        close(
            &format!("load of joint {joint}"),
            found,
            &expected,
            scale,
            TOLERANCE,
        );
    }
    momenta(links, answer, &solution.motions);
    laws(links, &solution, &answer.reactions);
}

fn momenta(links: &[Link], answer: &Answer, motions: &[Motion]) {
    let (mut kinetic, mut mass) = (0.0, 0.0);
    let mut sums = [Vector3::zeros(); 3];
    let mut first = Vector3::zeros();
    for (link, motion) in links.iter().zip(motions) {
        let tensor = motion.attitude * link.inertia * motion.attitude.transpose();
        let spin = tensor * motion.angular_velocity;
        let linear = motion.velocity * link.mass;
        kinetic += motion.velocity.dot(&linear) / 2.0;
        kinetic += motion.angular_velocity.dot(&spin) / 2.0;
        mass += link.mass;
        first += motion.position * link.mass;
        sums[0] += linear;
        sums[2] += motion.position.cross(&linear) + spin;
    }
    sums[1] = sums[2] - (first / mass).cross(&sums[0]);
    close("kinetic energy", &[answer.kinetic], &[kinetic], 0.0, 1e-12);
    let scale = sums.iter().fold(1.0, |a: f64, b| a.max(b.amax()));
    for (order, (found, expected)) in answer.momentum.iter().zip(sums).enumerate() {
        let expected = match (order, found.len()) {
            (_, 3) => expected.list(),
            (0, _) => expected.xy().list(),
            _ => vec![expected.z],
        };
        close("momentum", found, &expected, scale, 1e-11);
    }
}

/// The loads on any set of bodies carry the motion of the whole set: what acts inside cancels.
fn laws(links: &[Link], solution: &Solution, reactions: &[(usize, Vec<f64>)]) {
    // of many bodies not all sets
    let stride = if links.len() > 6 { 97 } else { 1 };
    for set in (1_u32..(1 << links.len())).step_by(stride) {
        let is_in = |body: usize| set & (1 << body) != 0;
        let (mut force, mut size) = (Vector3::zeros(), 1.0_f64);
        for (body, link) in links.iter().enumerate().filter(|(body, _)| is_in(*body)) {
            let inertial = solution.motions[body].acceleration * link.mass;
            force += solution.loads.on[body][0] - inertial;
            size += inertial.amax();
        }
        for (joint, found) in reactions {
            let within = is_in(*joint);
            let carrier = links[*joint].carrier.is_some_and(is_in);
            let z = if found.len() == 3 { 0.0 } else { found[2] };
            let load = Vector3::new(found[0], found[1], z);
            size += load.amax();
            if within != carrier {
                force += if within { load } else { -load };
            }
        }
        assert!(force.amax() <= 1e-10 * size, "{force} of bodies {set:b}");
    }
}

/// Of principal moments.
pub fn principal(a: f64, b: f64, c: f64) -> Matrix3<f64> {
    Matrix3::from_diagonal(&Vector3::new(a, b, c))
}

/// A body with a joint; `turned` may be changed.
pub fn link(
    (mass, inertia): (f64, Matrix3<f64>),
    carrier: Option<usize>,
    place: [f64; 3],
    pin: [f64; 3],
    kind: Kind,
) -> Link {
    Link {
        mass,
        inertia,
        carrier,
        place: place.into(),
        pin: pin.into(),
        kind,
        turned: (Vector3::x(), 0.0),
    }
}

pub fn unit(x: f64, y: f64, z: f64) -> Vector3<f64> {
    Vector3::new(x, y, z).normalize()
}
