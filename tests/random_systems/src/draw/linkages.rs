//! Linkages in the plane, with links of any lengths. They are drawn in a closed state, in which all
//! axes are along those of the world.

use fastrand::Rng;

use super::number::{Declared, Numbers, literal};
use super::{Drawing, Drawn, Extent, Masses};
use crate::law::closed::Loops;
use crate::law::kind::{Kind, Rates};
use crate::law::linear;
use crate::law::scene::{Link, Ring};
use crate::law::space::{NONE, Vec3, ZERO, identity};
use crate::wide::Wide;

/// A hinge between two bodies, or the ground and a body, at a point.
type Hinge = (Option<usize>, usize, usize);

pub struct Linkage {
    pub name: &'static str,
    /// The first one of a body carries it; carriers have smaller numbers.
    hinges: &'static [Hinge],
    /// A body that slides on the ground, and whether that closes the loop.
    slide: Option<(usize, bool)>,
    /// Points of which two links in line are made: dead points.
    lines: &'static [[usize; 3]],
}

const GROUND: Option<usize> = None;

pub const LINKAGES: [Linkage; 11] = [
    Linkage {
        name: "four-bar",
        hinges: &[
            (GROUND, 0, 0),
            (Some(0), 1, 1),
            (Some(1), 2, 2),
            (GROUND, 2, 3),
        ],
        slide: None,
        lines: &[[0, 1, 2], [1, 2, 3]],
    },
    Linkage {
        name: "five-bar",
        hinges: &[
            (GROUND, 0, 0),
            (Some(0), 1, 1),
            (Some(1), 2, 2),
            (Some(2), 3, 3),
            (GROUND, 3, 4),
        ],
        slide: None,
        lines: &[[0, 1, 2], [1, 2, 3]],
    },
    Linkage {
        name: "five-bar that carries a four-bar",
        hinges: &[
            (GROUND, 0, 0),
            (Some(0), 1, 1),
            (Some(1), 2, 2),
            (Some(2), 3, 3),
            (GROUND, 3, 4),
            (Some(1), 4, 5),
            (Some(4), 5, 6),
            (Some(2), 5, 7),
        ],
        slide: None,
        lines: &[[1, 2, 3], [5, 6, 7]],
    },
    Linkage {
        name: "slider-crank",
        hinges: &[(GROUND, 0, 0), (Some(0), 1, 1), (Some(1), 2, 2)],
        slide: Some((2, true)),
        lines: &[[0, 1, 2]],
    },
    Linkage {
        name: "slider-crank by its slide",
        hinges: &[(Some(0), 1, 1), (GROUND, 2, 0), (Some(1), 2, 2)],
        slide: Some((0, false)),
        lines: &[[0, 2, 1]],
    },
    Linkage {
        name: "Watt's, on a four-bar's coupler",
        hinges: &[
            (GROUND, 0, 0),
            (Some(0), 1, 1),
            (Some(1), 2, 2),
            (GROUND, 2, 3),
            (Some(1), 3, 4),
            (Some(2), 4, 5),
            (Some(3), 4, 6),
        ],
        slide: None,
        lines: &[[0, 1, 2], [1, 2, 3], [4, 6, 5]],
    },
    Linkage {
        name: "Watt's, on the ground",
        hinges: &[
            (GROUND, 0, 0),
            (Some(0), 1, 1),
            (Some(1), 2, 2),
            (GROUND, 2, 3),
            (Some(2), 3, 4),
            (Some(3), 4, 5),
            (GROUND, 4, 6),
        ],
        slide: None,
        lines: &[[0, 1, 2], [1, 2, 3], [4, 5, 6]],
    },
    Linkage {
        name: "Stephenson's third",
        hinges: &[
            (GROUND, 0, 0),
            (Some(0), 1, 1),
            (Some(1), 2, 2),
            (GROUND, 2, 3),
            (Some(1), 3, 4),
            (Some(3), 4, 5),
            (GROUND, 4, 6),
        ],
        slide: None,
        lines: &[[0, 1, 2], [1, 2, 3], [4, 5, 6]],
    },
    Linkage {
        name: "Stephenson's second",
        hinges: &[
            (GROUND, 0, 0),
            (Some(0), 1, 1),
            (Some(0), 2, 2),
            (Some(1), 3, 3),
            (Some(2), 3, 4),
            (Some(2), 4, 5),
            (GROUND, 4, 6),
        ],
        slide: None,
        lines: &[[1, 3, 4], [2, 5, 6]],
    },
    Linkage {
        name: "Stephenson's first",
        hinges: &[
            (GROUND, 0, 0),
            (GROUND, 1, 1),
            (Some(0), 2, 2),
            (Some(0), 3, 3),
            (Some(1), 2, 4),
            (Some(1), 4, 5),
            (Some(3), 4, 6),
        ],
        slide: None,
        lines: &[[2, 4, 1], [3, 6, 5]],
    },
    Linkage {
        name: "Andrews' squeezer",
        hinges: &[
            (GROUND, 0, 0),
            (Some(0), 1, 1),
            (GROUND, 2, 2),
            (GROUND, 3, 3),
            (Some(3), 4, 4),
            (GROUND, 5, 3),
            (Some(5), 6, 5),
            (Some(1), 2, 6),
            (Some(1), 4, 6),
            (Some(1), 6, 6),
        ],
        slide: None,
        lines: &[[0, 1, 6], [3, 4, 6], [3, 5, 6]],
    },
];

/// Loops are told apart from what hardly moves by their smallest pivot.
const MOVES: f64 = 0.02;

impl Linkage {
    /// With any links, or with the two of a line in line.
    pub fn drawn(&self, seed: u64, line: Option<usize>) -> Drawn {
        let line = line.map(|line| self.lines[line]);
        let mut rng = Rng::with_seed(seed);
        loop {
            let drawing = self.drawing(rng.fork(), line);
            if drawing.is_regular() {
                let mut drawing = drawing;
                drawing.all_loads();
                return drawing.finish();
            }
        }
    }

    pub fn lines(&self) -> usize {
        self.lines.len()
    }

    fn drawing(&self, rng: Rng, line: Option<[usize; 3]>) -> Drawing {
        let numbers = Numbers {
            rng,
            declared: Declared::default(),
            params: 0,
            locals: 0,
            states: 0,
        };
        let mut drawing = Drawing::new(numbers, true, Extent::ALL);
        let bodies = self.hinges.iter().map(|(_, carried, _)| carried + 1);
        let bodies = bodies.max().unwrap_or(0);
        let count = self.hinges.iter().map(|(_, _, point)| point + 1);
        let mut point = || [drawing.numbers.plain(1.0), drawing.numbers.plain(1.0), 0.0];
        let mut points: Vec<[f64; 3]> = (0..count.max().unwrap_or(0)).map(|_| point()).collect();
        if let Some([first, middle, last]) = line {
            points[middle] = [0, 1, 2].map(|axis| {
                let (from, to) = (points[first][axis], points[last][axis]);
                from + (to - from) * 0.375
            });
        }
        let centers: Vec<[f64; 3]> = (0..bodies).map(|_| point()).collect();
        for number in 0..bodies {
            drawing.firsts.push(number);
            drawing.body(Masses::Alike, number);
        }
        drawing.joints = vec![String::new(); bodies];
        let mut is_carried = vec![false; bodies];
        if let Some((body, false)) = self.slide {
            drawing.slide(body, centers[body], false);
            is_carried[body] = true;
        }
        for (number, (carrier, carried, point)) in self.hinges.iter().enumerate() {
            let mut end = |body: Option<usize>| {
                let from = body.map_or([0.0; 3], |body| centers[body]);
                let place = [0, 1, 2].map(|axis| points[*point][axis] - from[axis]);
                drawing.point(body, &format!("h{number}"), place)
            };
            let ((from, place), (to, pin)) = (end(*carrier), end(Some(*carried)));
            let kind = Kind::Revolute(identity()[2]);
            let word = format!("revolute({from}, {to})");
            let is_closing = std::mem::replace(&mut is_carried[*carried], true);
            drawing.hold((*carrier, *carried), [place, pin], (kind, word), is_closing);
        }
        if let Some((body, true)) = self.slide {
            drawing.slide(body, centers[body], true);
        }
        let still = |link: &Link| vec![Wide::ZERO; link.kind.freedoms()];
        let rates: Vec<Rates> = drawing
            .links
            .iter()
            .map(|link| (still(link), still(link)))
            .collect();
        drawing.start = Some((Wide::from(0.5), rates));
        drawing
    }
}

impl Drawing {
    /// A point of a body or the ground.
    fn point(&mut self, body: Option<usize>, name: &str, place: [f64; 3]) -> (String, Vec3) {
        let word = format!("{}, {}", literal(place[0]), literal(place[1]));
        let value = place.map(Wide::from);
        let Some(body) = body else {
            return (format!("world({word})"), value);
        };
        self.keys(body).points.push((name.to_owned(), value, word));
        (format!("{}.{name}", self.name(body)), value)
    }

    fn slide(&mut self, body: usize, center: [f64; 3], is_closing: bool) {
        let (from, place) = self.point(None, "", center);
        let (direction, d) = self.numbers.numeric(true);
        let word = format!(
            "prismatic({from}, {}.G, body({direction}))",
            self.name(body)
        );
        let held = (Kind::Prismatic(d), word);
        self.hold((None, body), [place, ZERO], held, is_closing);
    }

    /// Holds a body by a joint, which carries it, or closes a loop.
    fn hold(
        &mut self,
        (carrier, carried): (Option<usize>, usize),
        [place, pin]: [Vec3; 2],
        (kind, word): (Kind, String),
        is_closing: bool,
    ) {
        if is_closing {
            let number = self.links.len();
            self.rings.push(Ring {
                link: number,
                body: carried,
            });
            self.links.push(Link {
                mass: Wide::ZERO,
                inertia: NONE,
                carrier,
                place,
                pin,
                kind,
                turned: Vec::new(),
                driven: None,
                armature: Wide::ZERO,
            });
            self.joints.push(word);
            return;
        }
        let link = &mut self.links[carried];
        (link.carrier, link.place, link.pin, link.kind) = (carrier, place, pin, kind);
        self.joints[carried] = word;
    }

    /// Whether all that is held is held by itself.
    fn is_regular(&self) -> bool {
        let loops = Loops {
            links: &self.links,
            rings: &self.rings,
            is_planar: true,
        };
        let Some((_, rates)) = &self.start else {
            return false;
        };
        let rows = loops.slopes(rates);
        let (count, right) = (rows.len(), vec![Wide::ZERO; rows.len()]);
        let found = linear::solve(rows, right);
        found.rank == count && found.least > MOVES
    }
}
