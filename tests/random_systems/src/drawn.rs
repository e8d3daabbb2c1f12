//! A system at random: its description, and what it means.

use fastrand::Rng;

use crate::number::{Declared, Numbers};
use crate::oracle::{Acting, Kind, Link};
use crate::space::{Mat3, Vec3, ZERO, diagonal};
use crate::wide::Wide;

/// What is drawn of a system; less for a smaller one that fails alike.
#[allow(clippy::struct_excessive_bools, reason = "each leaves out one thing")]
#[derive(Clone, Copy, Debug)]
pub struct Extent {
    pub bodies: usize,
    /// The loads that are left out, by their numbers.
    pub without: u64,
    pub turned: bool,
    pub driven: bool,
    pub params: bool,
    pub pins: bool,
    pub places: bool,
    pub tensors: bool,
}

impl Extent {
    pub const ALL: Self = Self {
        bodies: 6,
        without: 0,
        turned: true,
        driven: true,
        params: true,
        pins: true,
        places: true,
        tensors: true,
    };
}

pub struct Drawn {
    pub text: String,
    pub is_planar: bool,
    /// Each carrier before what it carries; body `b2` and joint `j2` are those of link 2.
    pub links: Vec<Link>,
    pub acting: Vec<Acting>,
    pub declared: Declared,
    /// The acceleration of the field that acts on all mass alike; none if there are fields that
    /// are uniform by chance, where a velocity or a position is prescribed.
    pub gravity: Option<Vec3>,
    /// The point of a Jacobian: the body, and where on it.
    pub asked: Option<(usize, Vec3)>,
}

/// How the masses go from the ground to the tips.
#[derive(Clone, Copy)]
enum Masses {
    Alike,
    Lighter,
    Heavier,
    Any,
}

pub struct Drawing {
    pub numbers: Numbers,
    pub is_planar: bool,
    pub extent: Extent,
    pub links: Vec<Link>,
    pub acting: Vec<Acting>,
    pub gravity: Option<Vec3>,
    /// How many loads were drawn.
    pub loads: usize,
    /// The keys of each body.
    pub bodies: Vec<Keys>,
    pub joints: Vec<String>,
    pub tops: [Vec<String>; 4],
}

/// What stands in the braces of a body.
#[derive(Default)]
pub struct Keys {
    pub mass: String,
    pub inertia: String,
    /// Names, where they are, and how that is written.
    pub points: Vec<(String, Vec3, String)>,
    pub forces: Vec<String>,
    pub moments: Vec<String>,
}

pub const FORCES: usize = 0;
pub const MOMENTS: usize = 1;
pub const FIELDS: usize = 2;
pub const DRIVES: usize = 3;

/// Draws the system of a number.
pub fn drawn(seed: u64, index: usize, extent: Extent) -> Drawn {
    let mut rng = Rng::with_seed(seed.wrapping_mul(0x9e37_79b9_7f4a_7c15) ^ index as u64);
    let is_planar = rng.usize(0..4) == 0;
    let count = rng.usize(1..=6).min(extent.bodies);
    let params = if extent.params {
        [0, 3, 12][rng.usize(0..3)]
    } else {
        0
    };
    let masses = [Masses::Alike, Masses::Lighter, Masses::Heavier, Masses::Any][rng.usize(0..4)];
    let shape = rng.usize(0..3);
    let parts = rng.fork();
    let mut drawing = Drawing {
        numbers: Numbers {
            rng,
            declared: Declared::default(),
            params,
        },
        is_planar,
        extent,
        links: Vec::new(),
        acting: Vec::new(),
        gravity: Some(ZERO),
        loads: 0,
        bodies: Vec::new(),
        joints: Vec::new(),
        tops: Default::default(),
    };
    let mut parts = parts;
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
    drawing.all_loads();
    drawing.numbers.rng = parts.fork();
    drawing.finish()
}

impl Drawing {
    /// Whether a load is kept; it has the next number.
    pub fn is_kept(&mut self) -> bool {
        let number = self.loads;
        self.loads += 1;
        number >= 64 || self.extent.without & (1 << number) == 0
    }

    fn body(&mut self, masses: Masses, number: usize) {
        let steps = i32::try_from(number).unwrap_or(0);
        let power = match masses {
            Masses::Alike => 0,
            Masses::Lighter => -5 * steps,
            Masses::Heavier => steps,
            Masses::Any => self.numbers.rng.i32(-4..=4),
        };
        let numbers = &mut self.numbers;
        let mass = (0.5 + numbers.positive(2.0)) * 2.0_f64.powi(power);
        let mut keys = Keys::default();
        let (word, mass_value) = numbers.quantity(mass, "kg");
        keys.mass = word;
        // moments of the distribution along each axis, so that the inertia is possible
        let [a, b, c] = [0; 3].map(|_| mass * numbers.positive(0.25));
        let tensor = if self.is_planar {
            let (word, moment) = numbers.quantity(a, "kg * m ^ 2");
            keys.inertia = word;
            diagonal([Wide::ONE, Wide::ONE, moment])
        } else {
            let axes = match numbers.rng.usize(0..6) {
                0 => [a, a, a],
                1 => [a, b, b],
                2 => [b, a, b],
                3 => [b, b, a],
                _ => [a, b, c],
            };
            self.tensor(axes, &mut keys)
        };
        for point in ["r", "s"] {
            let (word, place) = self.numbers.components(0.5, "m", self.is_planar);
            keys.points.push((point.to_owned(), place, word));
        }
        self.links.push(Link {
            mass: mass_value,
            inertia: tensor,
            carrier: None,
            place: ZERO,
            pin: ZERO,
            kind: Kind::Weld,
            turned: None,
            driven: None,
        });
        self.bodies.push(keys);
    }

    /// Of second moments along the axes.
    fn tensor(&mut self, [a, b, c]: [f64; 3], keys: &mut Keys) -> Mat3 {
        let numbers = &mut self.numbers;
        let moments = [b + c, c + a, a + b];
        let unit = "kg * m ^ 2";
        if !self.extent.tensors || !numbers.one_of(3) {
            let mut words = Vec::new();
            let mut seen: Vec<(f64, String)> = Vec::new();
            for moment in moments {
                // what is equal is so by name, too
                let known = seen
                    .iter()
                    .find(|(value, _)| value.total_cmp(&moment).is_eq());
                let word = match known {
                    Some((_, word)) => word.clone(),
                    None => numbers.quantity(moment, unit).0,
                };
                seen.push((moment, word.clone()));
                words.push(word);
            }
            keys.inertia = format!("principal({})", words.join(", "));
            return diagonal(moments.map(Wide::from));
        }
        // products, small enough for any moments
        let least = a.min(b).min(c);
        let names = [("xy", 0, 1), ("zx", 0, 2), ("yz", 1, 2)];
        let mut matrix = diagonal(moments.map(Wide::from));
        let mut words: Vec<String> = ["xx", "yy", "zz"]
            .iter()
            .zip(moments)
            .map(|(name, moment)| format!("{name}: {}", numbers.quantity(moment, unit).0))
            .collect();
        for (name, i, j) in names {
            if numbers.one_of(3) {
                continue;
            }
            let entry = least * numbers.plain(0.4);
            words.push(format!("{name}: {}", numbers.quantity(entry, unit).0));
            matrix[i][j] = entry.into();
            matrix[j][i] = entry.into();
        }
        keys.inertia = format!("tensor {{ {} }}", words.join(", "));
        matrix
    }
}
