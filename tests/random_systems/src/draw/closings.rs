//! Joints that close loops. They are drawn so that the loops are closed in a state that is drawn
//! first, up to the rounding of the numbers that are written.

use super::Drawing;
use super::number::literal;
use crate::law::closed::Loops;
use crate::law::kind::{Kind, Pose, Rates};
use crate::law::linear;
use crate::law::scene::{Instant, Link, Ring, motions, still};
use crate::law::space::{
    Mat3, NONE, Vec3, ZERO, add, apply, identity, product, scale, subtract, transposed, unit,
};
use crate::wide::Wide;

/// Loops are told apart from what hardly moves by their smallest pivot.
const MOVES: f64 = 0.05;

/// Its points, its kind with coordinates, how it is turned, and how it is written.
type Closing = ([Vec3; 2], Kind, Vec<Wide>, Vec<(Vec3, Wide)>, String);

impl Drawing {
    pub fn closings(&mut self, count: usize) {
        if count == 0 || self.links.iter().all(|link| link.driven.is_some()) {
            return;
        }
        let time = Wide::from(self.numbers.plain(2.0));
        let mut rates = Vec::new();
        for number in 0..self.links.len() {
            let (kind, mut v) = (self.links[number].kind, Vec::new());
            let mut q = self.coordinates(kind);
            v.resize(kind.freedoms(), Wide::ZERO);
            let (inputs, states) = self.numbers.declared.values();
            let instant = Instant {
                time,
                inputs: &inputs,
                states: &states,
            };
            let driven = self.links[number].driven.iter().flatten().enumerate();
            for (freedom, function) in driven {
                q[freedom] = function(&instant)[0];
            }
            rates.push((q, v));
        }
        for _ in 0..count {
            // not every joint between any bodies leaves them some way to move
            for _ in 0..8 {
                if self.closing(&mut rates) {
                    break;
                }
            }
        }
        if !self.rings.is_empty() {
            self.start = Some((time, rates));
        }
    }

    /// Of a joint, somewhere.
    fn coordinates(&mut self, kind: Kind) -> Vec<Wide> {
        let zeros = vec![Wide::ZERO; kind.freedoms() + usize::from(kind.quaternion().is_some())];
        let mut from = zeros;
        if let (Some(_), Some(last)) = (kind.quaternion(), from.last_mut()) {
            *last = Wide::ONE;
        }
        let by = (0..kind.freedoms()).map(|_| self.numbers.plain(1.5).into());
        kind.moved(&from, &by.collect::<Vec<Wide>>())
    }

    /// Whether there is one between two bodies.
    fn closing(&mut self, rates: &mut Vec<Rates>) -> bool {
        let count = self.firsts.len();
        let carried = self.numbers.rng.usize(0..count);
        let carrier = self.numbers.rng.usize(0..=count);
        let carrier = (carrier < count).then_some(carrier);
        if carrier == Some(carried) {
            return false;
        }
        if self.numbers.one_of(4) && self.extent.ties {
            return self.tie(rates, (carrier, carried));
        }
        let number = self.links.len();
        let named = self.named();
        let (to, pin) = self.place(Some(carried), &format!("h{number}"), self.extent.pins);
        let (word, directions, kind) = self.closing_kind();
        let q = self.coordinates(kind);
        let own = kind.pose(
            &(q.clone(), vec![Wide::ZERO; kind.freedoms()]),
            &vec![Wide::ZERO; kind.freedoms()],
        );
        let all = motions(&self.links, rates, &still(&self.links));
        let (origin, axes) = carrier.map_or((ZERO, identity()), |carrier| {
            (all[carrier].position, all[carrier].attitude)
        });
        let (back, body) = (transposed(&axes), &all[carried]);
        let between = product(&product(&back, &body.attitude), &transposed(&own.turn[0]));
        let (turns, turned) = self.turns(&between);
        let at_pin = add(body.position, apply(&body.attitude, pin));
        let place = apply(&back, subtract(at_pin, origin));
        let place = subtract(place, apply(&turning(&turned), own.place[0]));
        // as it is written
        let place = place.map(|part| {
            Wide::from(if part.high.abs() < 1e-25 {
                0.0
            } else {
                part.high
            })
        });
        let from = self.written_place(carrier, number, place);
        let word = format!("{word}({from}, {to}{directions}){turns}");
        self.close(
            rates,
            &named,
            (carrier, carried),
            ([place, pin], kind, q, turned, word),
        )
    }

    /// How many points of each body have names.
    pub fn named(&self) -> Vec<usize> {
        self.bodies.iter().map(|keys| keys.points.len()).collect()
    }

    /// Leaves out the points that were named since.
    pub fn forget(&mut self, named: &[usize]) {
        for (keys, count) in self.bodies.iter_mut().zip(named) {
            keys.points.truncate(*count);
        }
    }

    /// Adds what closes a loop, if the loops are closed by as much as they need.
    pub fn close(
        &mut self,
        rates: &mut Vec<Rates>,
        named: &[usize],
        (carrier, carried): (Option<usize>, usize),
        ([place, pin], kind, q, turned, word): Closing,
    ) -> bool {
        self.rings.push(Ring {
            link: self.links.len(),
            body: carried,
        });
        self.links.push(Link {
            mass: Wide::ZERO,
            inertia: NONE,
            carrier,
            place,
            pin,
            kind,
            turned,
            driven: None,
            armature: Wide::ZERO,
        });
        rates.push((q, vec![Wide::ZERO; kind.freedoms()]));
        if self.is_loop(rates) {
            self.joints.push(word);
            return true;
        }
        self.links.pop();
        self.rings.pop();
        rates.pop();
        self.forget(named);
        false
    }

    /// The word of a kind that may close a loop, and its directions.
    fn closing_kind(&mut self) -> (&'static str, String, Kind) {
        let (direction, d) = self.numbers.numeric(self.is_planar);
        let (second, e) = self.across(d);
        let z = identity()[2];
        let none = String::new();
        let along = |words: &str| format!(", body({words})");
        let which = self.numbers.rng.usize(0..12);
        if self.is_planar {
            return match which {
                0..=7 => ("revolute", none, Kind::Revolute(z)),
                8..=10 => ("prismatic", along(&direction), Kind::Prismatic(d)),
                _ => ("weld", none, Kind::Weld),
            };
        }
        if self.is_flat {
            let aslant = unit([2.0, -1.0, 0.0].map(Wide::from));
            return match which {
                0..=7 => ("revolute", along("0, 0, 1"), Kind::Revolute(z)),
                8..=9 => ("prismatic", along("2, -1, 0"), Kind::Prismatic(aslant)),
                10 => ("spherical", none, Kind::Spherical),
                _ => ("weld", none, Kind::Weld),
            };
        }
        match which {
            0..=1 => ("revolute", along(&direction), Kind::Revolute(d)),
            2 => ("prismatic", along(&direction), Kind::Prismatic(d)),
            3..=4 => ("cylindrical", along(&direction), Kind::Cylindrical(d)),
            5..=6 => (
                "universal",
                along(&direction) + &along(&second),
                Kind::Universal(d, e),
            ),
            7..=8 => ("spherical", none, Kind::Spherical),
            9..=10 => ("planar", along(&direction), Kind::planar(d)),
            _ => ("weld", none, Kind::Weld),
        }
    }

    /// Turns about axes that make this turn, as they are written and as they are.
    fn turns(&self, between: &Mat3) -> (String, Vec<(Vec3, Wide)>) {
        let [x, y, z] = identity();
        let entry = |i: usize, j: usize| between[i][j].high;
        let yaw = entry(1, 0).atan2(entry(0, 0));
        if self.is_planar {
            return (
                format!(".turned({}[rad])", literal(yaw)),
                vec![(z, yaw.into())],
            );
        }
        let pitch = -entry(2, 0).clamp(-1.0, 1.0).asin();
        let roll = entry(2, 1).atan2(entry(2, 2));
        let mut all = vec![("0, 0, 1", z, yaw)];
        if !self.is_flat {
            all.extend([("0, 1, 0", y, pitch), ("1, 0, 0", x, roll)]);
        }
        let words = all
            .iter()
            .map(|(axis, _, angle)| format!(".turned(body({axis}), {}[rad])", literal(*angle)));
        let turned = all.iter().map(|(_, axis, angle)| (*axis, (*angle).into()));
        (words.collect(), turned.collect())
    }

    /// A point of the carrier, or of the ground.
    fn written_place(&mut self, carrier: Option<usize>, number: usize, place: Vec3) -> String {
        let count = if self.is_planar { 2 } else { 3 };
        let parts = place[..count].iter().map(|part| {
            let zero = part.high == 0.0;
            if zero {
                "0".to_owned()
            } else {
                format!("{}[m]", literal(part.high))
            }
        });
        let word = parts.collect::<Vec<_>>().join(", ");
        let Some(carrier) = carrier else {
            return format!("world({word})");
        };
        let name = format!("d{number}");
        self.keys(carrier).points.push((name.clone(), place, word));
        format!("{}.{name}", self.name(carrier))
    }

    /// Whether what closes leaves the others independent. In a plane in space it holds more than it needs.
    fn is_loop(&self, rates: &[Rates]) -> bool {
        let loops = Loops {
            links: &self.links,
            rings: &self.rings,
            is_planar: self.is_planar || self.is_flat,
        };
        let rows = loops.slopes(rates);
        let count = rows.len();
        let found = linear::solve(rows, vec![Wide::ZERO; count]);
        found.rank == count && found.least > MOVES
    }
}

/// All turns, one after the other.
fn turning(turned: &[(Vec3, Wide)]) -> Mat3 {
    let zero = Wide::ZERO;
    let turns = turned.iter();
    let pose = turns.fold(Pose::at(ZERO), |pose, (axis, angle)| {
        pose.then(&Pose::turn(scale(*axis, Wide::ONE), [*angle, zero, zero]))
    });
    pose.turn[0]
}
