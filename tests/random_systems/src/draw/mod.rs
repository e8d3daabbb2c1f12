//! A random system: its description, and what it means.

mod between;
mod bodies;
mod closings;
mod drives;
mod following;
mod joints;
mod led;
#[cfg(test)]
pub mod linkages;
mod loads;
pub mod number;
mod potentials;
mod sizes;
mod states;
mod ties;
mod written;

use fastrand::Rng;

use crate::law::kind::Rates;
use crate::law::scene::{Acting, Link, Ring, Stored};
use crate::law::space::{Vec3, ZERO};
use crate::wide::Wide;

use number::{Declared, Numbers};
use sizes::Size;

/// What is drawn of a system; less for a smaller one that fails alike.
#[allow(clippy::struct_excessive_bools, reason = "each leaves out one thing")]
#[derive(Clone, Copy, Debug)]
pub struct Extent {
    pub bodies: usize,
    /// The loads that are left out, by their numbers.
    pub without: u64,
    /// How many joints close loops at most.
    pub loops: usize,
    pub turned: bool,
    pub driven: bool,
    pub params: bool,
    pub pins: bool,
    pub places: bool,
    pub tensors: bool,
    pub copies: bool,
    pub locals: bool,
    pub armatures: bool,
    /// Loads that follow accelerations: of one system in four.
    pub following: bool,
    /// User-defined states, mass that changes with them, and tables: of one system in three.
    pub states: bool,
    /// Links without mass among what closes loops: asked for by `--links 1`.
    pub ties: bool,
    /// Asked for by `--linearized 1`.
    pub linearized: bool,
}

impl Extent {
    pub const ALL: Self = Self {
        bodies: 6,
        without: 0,
        loops: 2,
        turned: true,
        driven: true,
        params: true,
        pins: true,
        places: true,
        tensors: true,
        copies: true,
        locals: true,
        armatures: true,
        following: true,
        states: true,
        ties: false,
        linearized: false,
    };
}

pub struct Drawn {
    pub text: String,
    /// The same with open drives in the place of the inputs that drive the joints, if there are some.
    pub opened: Option<String>,
    /// Of the bodies.
    pub names: Vec<String>,
    pub is_planar: bool,
    /// Each carrier before what it carries; the numbers of body and joint are those of the link. Behind
    /// the bodies those without mass, which joints that close loops carry.
    pub links: Vec<Link>,
    pub rings: Vec<Ring>,
    /// A time, and coordinates with which all loops are as good as closed.
    pub start: Option<(Wide, Vec<Rates>)>,
    pub acting: Vec<Acting>,
    /// The loads of potentials, and their energies.
    pub pulling: Vec<Acting>,
    pub stored: Vec<Stored>,
    /// The energies of uniform fields of single bodies, which are loads like others.
    pub falling: Vec<Stored>,
    pub declared: Declared,
    /// Whether loads follow accelerations.
    pub follows: bool,
    /// Those of user-defined states.
    pub rates: Vec<Size>,
    /// The inputs that stand for open drives: of a joint, along its freedom, which input.
    pub open: Vec<(usize, usize, usize)>,
    /// The acceleration of the field that acts on all mass alike; none if there are fields that
    /// are uniform by chance, where a velocity or a position is prescribed.
    pub gravity: Option<Vec3>,
    /// Those of the fields of single bodies that are proportional to mass, each with its body.
    pub falls: Vec<(usize, Vec3)>,
    /// The point of a Jacobian: the body, and where on it.
    pub asked: Option<(usize, Vec3)>,
}

impl Drawn {
    pub fn bodies(&self) -> usize {
        self.links.len() - self.rings.len()
    }
}

/// How the masses go from the ground to the tips.
#[derive(Clone, Copy)]
pub enum Masses {
    Alike,
    Lighter,
    Heavier,
    Any,
}

pub struct Drawing {
    pub numbers: Numbers,
    pub is_planar: bool,
    /// In space, all moves in a plane.
    pub is_flat: bool,
    /// All drives are open.
    pub is_open: bool,
    pub extent: Extent,
    pub links: Vec<Link>,
    pub rings: Vec<Ring>,
    pub start: Option<(Wide, Vec<Rates>)>,
    pub acting: Vec<Acting>,
    pub pulling: Vec<Acting>,
    pub stored: Vec<Stored>,
    pub falling: Vec<Stored>,
    pub open: Vec<(usize, usize, usize)>,
    /// Of each state, as they are written and as they are.
    pub rates: Vec<(String, Size)>,
    pub gravity: Option<Vec3>,
    pub falls: Vec<(usize, Vec3)>,
    /// How many loads were drawn, and how many of them follow accelerations.
    pub loads: usize,
    pub following: usize,
    /// What is written of each body, and of those that are alike; by number, the first of them.
    pub bodies: Vec<Keys>,
    pub firsts: Vec<usize>,
    pub joints: Vec<String>,
    pub tops: [Vec<String>; 6],
}

/// What stands in the braces of a body.
#[derive(Default)]
pub struct Keys {
    /// Those that are alike, as they are written.
    pub copies: Vec<String>,
    pub mass: String,
    pub inertia: String,
    /// Names, where they are, and how that is written.
    pub points: Vec<(String, Vec3, String)>,
    pub locals: Vec<String>,
    pub fields: Vec<String>,
    pub potentials: Vec<String>,
    pub forces: Vec<String>,
    pub moments: Vec<String>,
}

pub const FORCES: usize = 0;
pub const MOMENTS: usize = 1;
pub const FIELDS: usize = 2;
pub const DRIVES: usize = 3;
pub const POTENTIALS: usize = 4;
pub const CABLES: usize = 5;

/// Draws the system of a number.
pub fn drawn(seed: u64, index: usize, extent: Extent) -> Drawn {
    let mut rng = Rng::with_seed(seed.wrapping_mul(0x9e37_79b9_7f4a_7c15) ^ index as u64);
    let is_planar = rng.usize(0..4) == 0;
    let count = rng.usize(1..=6).min(extent.bodies);
    let params = [0, 3, 12][rng.usize(0..3)];
    let masses = [Masses::Alike, Masses::Lighter, Masses::Heavier, Masses::Any][rng.usize(0..4)];
    let shape = rng.usize(0..3);
    // loops, or open drives
    let special = rng.usize(0..6);
    let loops = [1, 1, 2, 0, 0, 0][special].min(extent.loops);
    let mut parts = rng.fork();
    let is_flat = loops > 0 && !is_planar && rng.usize(0..4) == 0;
    let numbers = Numbers {
        rng,
        declared: Declared::default(),
        params: if extent.params { params } else { 0 },
        locals: if extent.locals { 24 } else { 0 },
        states: if extent.states && index % 3 == 2 {
            5
        } else {
            0
        },
    };
    let mut drawing = Drawing::new(numbers, is_planar, extent);
    (drawing.is_flat, drawing.is_open) = (is_flat, special == 3);
    drawing.extent.following &= index % 4 == 1;
    drawing.alike(count);
    for number in 0..count {
        // what is drawn of one body does not change what is drawn of the next
        drawing.numbers.rng = parts.fork();
        let carrier = match (number, shape) {
            (0, _) => None,
            (_, 0) => Some(number - 1),
            _ if drawing.numbers.one_of(5) => None,
            (_, 1) => Some(drawing.numbers.rng.usize(0..number)),
            _ => Some(0),
        };
        drawing.body(masses, number);
        drawing.joint(number, carrier);
    }
    drawing.numbers.rng = parts.fork();
    drawing.armatures();
    drawing.numbers.rng = parts.fork();
    drawing.closings(loops);
    drawing.numbers.rng = parts.fork();
    drawing.all_loads();
    drawing.numbers.rng = parts.fork();
    drawing.finish()
}

impl Drawing {
    /// Of nothing.
    fn new(numbers: Numbers, is_planar: bool, extent: Extent) -> Self {
        Self {
            is_flat: false,
            is_open: false,
            following: 0,
            numbers,
            is_planar,
            extent,
            links: Vec::new(),
            rings: Vec::new(),
            start: None,
            acting: Vec::new(),
            pulling: Vec::new(),
            stored: Vec::new(),
            falling: Vec::new(),
            open: Vec::new(),
            rates: Vec::new(),
            gravity: Some(ZERO),
            falls: Vec::new(),
            loads: 0,
            bodies: Vec::new(),
            firsts: Vec::new(),
            joints: Vec::new(),
            tops: Default::default(),
        }
    }

    /// Whether a load is kept; it has the next number.
    pub fn is_kept(&mut self) -> bool {
        let number = self.loads;
        self.loads += 1;
        number >= 64 || self.extent.without & (1 << number) == 0
    }

    /// The name of a body.
    pub fn name(&self, body: usize) -> String {
        let first = self.firsts[body];
        if self.alike_as(body).len() == 1 {
            format!("b{body}")
        } else {
            format!("g{first}_c{body}")
        }
    }

    /// The bodies that are written with this one.
    pub fn alike_as(&self, body: usize) -> Vec<usize> {
        let first = self.firsts[body];
        (0..self.firsts.len())
            .filter(|other| self.firsts[*other] == first)
            .collect()
    }

    /// What is written of a body.
    pub fn keys(&mut self, body: usize) -> &mut Keys {
        &mut self.bodies[self.firsts[body]]
    }
}
