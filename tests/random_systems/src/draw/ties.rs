//! Massless links between two points. Each is as long as the distance of its points in the state in
//! which the loops are closed.

use super::Drawing;
use crate::law::kind::{Kind, Pose, Rates};
use crate::law::scene::{motions, still};
use crate::law::space::{
    Mat3, ZERO, add, apply, dot, identity, product, scale, subtract, transposed,
};
use crate::wide::Wide;

/// The turns about z, y and x, one after the other, that make this one.
fn angles(between: &Mat3) -> [f64; 3] {
    let entry = |i: usize, j: usize| between[i][j].high;
    [
        entry(1, 0).atan2(entry(0, 0)),
        -entry(2, 0).clamp(-1.0, 1.0).asin(),
        entry(2, 1).atan2(entry(2, 2)),
    ]
}

impl Drawing {
    /// Whether there is a link between two bodies, or the ground and a body.
    pub fn tie(&mut self, rates: &mut Vec<Rates>, ends: (Option<usize>, usize)) -> bool {
        let (carrier, carried) = ends;
        let number = self.links.len();
        let named = self.named();
        let (to, pin) = self.place(Some(carried), &format!("h{number}"), self.extent.pins);
        let (from, place) = self.place(carrier, &format!("d{number}"), true);
        let all = motions(&self.links, rates, &still(&self.links));
        let (origin, axes) = carrier.map_or((ZERO, identity()), |carrier| {
            (all[carrier].position, all[carrier].attitude)
        });
        let (back, body) = (transposed(&axes), &all[carried]);
        let from_origin = subtract(add(body.position, apply(&body.attitude, pin)), origin);
        let line = subtract(apply(&back, from_origin), place);
        let length = dot(line, line).sqrt();
        if length.high < 0.1 {
            self.forget(&named);
            return false;
        }
        let (word, length) = self.numbers.quantity(length.high, "m");
        let along = scale(line, Wide::ONE / length);
        let first = [
            along[1].high.atan2(along[0].high),
            -along[2].high.clamp(-1.0, 1.0).asin(),
        ];
        let [_, y, z] = identity();
        let zero = Wide::ZERO;
        let turned = |axis, angle: f64| Pose::turn(axis, [angle.into(), zero, zero]);
        let along = if self.is_planar {
            turned(z, first[0])
        } else {
            turned(z, first[0]).then(&turned(y, first[1]))
        };
        let rest = product(&back, &body.attitude);
        let rest = angles(&product(&transposed(&along.turn[0]), &rest));
        let q: Vec<Wide> = if self.is_planar {
            [first[0], rest[0]].map(Wide::from).to_vec()
        } else {
            first.iter().chain(&rest).map(|one| (*one).into()).collect()
        };
        let kind = Kind::Rod(length, self.is_planar);
        let word = format!("link({from}, {to}, {word})");
        self.close(
            rates,
            &named,
            ends,
            ([place, pin], kind, q, Vec::new(), word),
        )
    }

    /// Gives some of the joints an armature.
    pub fn armatures(&mut self) {
        for number in 0..self.firsts.len() {
            let size = self.numbers.positive(2.0);
            let is_drawn = self.numbers.one_of(5) && self.extent.armatures;
            let unit = match self.links[number].kind {
                Kind::Revolute(_) | Kind::Screw(..) => "kg * m ^ 2",
                Kind::Prismatic(_) => "kg",
                _ => continue,
            };
            if is_drawn {
                let (word, armature) = self.numbers.quantity(size, unit);
                self.joints[number].push_str(".armature(");
                self.joints[number].push_str(&word);
                self.joints[number].push(')');
                self.links[number].armature = armature;
            }
        }
    }
}
