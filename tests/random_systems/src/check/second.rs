//! Lagrange's equations: a second derivation.

use std::fmt::Write as _;

use super::{Checks, EXACT};
use crate::lagrange::jet::Real;
use crate::lagrange::{self, Body, Part};
use crate::law::kind::{Kind, Pose};
use crate::law::scene::Link;
use crate::law::space::{ZERO, identity};
use crate::wide::Wide;

impl Real for Wide {
    fn sin_cos(self) -> (Self, Self) {
        self.sin_cos()
    }
}

/// A body as the derivation has it: numbers alone, and the quaternion that it is turned by.
fn body(link: &Link, q: &[Wide]) -> Body<Wide> {
    let turns = link.turned.iter();
    let turned = turns.fold(Pose::at(ZERO), |pose, (axis, angle)| {
        pose.then(&Pose::turn(*axis, [*angle, Wide::ZERO, Wide::ZERO]))
    });
    let [x, y, z] = identity();
    let parts = match link.kind {
        Kind::Weld => Vec::new(),
        Kind::Revolute(d) => vec![Part::Turn(d)],
        Kind::Prismatic(d) => vec![Part::Slide(d)],
        Kind::Cylindrical(d) => vec![Part::Slide(d), Part::Turn(d)],
        Kind::Screw(d, pitch) => vec![Part::Screw(d, pitch)],
        Kind::Universal(d, e) => vec![Part::Turn(d), Part::Turn(e)],
        Kind::Spherical => vec![Part::Ball(attitude(q))],
        Kind::Free => {
            let slides = [x, y, z].map(Part::Slide);
            slides
                .into_iter()
                .chain([Part::Ball(attitude(&q[3..]))])
                .collect()
        }
        Kind::Plane => vec![Part::Slide(x), Part::Slide(y), Part::Turn(z)],
        Kind::Planar(a, b, n) => vec![Part::Slide(a), Part::Slide(b), Part::Turn(n)],
        Kind::Shift(count) => [x, y, z][..count].iter().map(|d| Part::Slide(*d)).collect(),
        Kind::Rod(..) => unreachable!("a tree has no links without mass"),
    };
    Body {
        mass: link.mass,
        inertia: link.inertia,
        carrier: link.carrier,
        place: link.place,
        pin: link.pin,
        turned: turned.turn[0],
        parts,
    }
}

/// The matrix of a quaternion x, y, z, w, entry by entry.
fn attitude(q: &[Wide]) -> [[Wide; 3]; 3] {
    let [x, y, z, w] = [q[0], q[1], q[2], q[3]];
    let two = |a: Wide| a + a;
    [
        [
            Wide::ONE - two(y * y + z * z),
            two(x * y - w * z),
            two(x * z + w * y),
        ],
        [
            two(x * y + w * z),
            Wide::ONE - two(x * x + z * z),
            two(y * z - w * x),
        ],
        [
            two(x * z - w * y),
            two(y * z + w * x),
            Wide::ONE - two(x * x + y * y),
        ],
    ]
}

impl Checks<'_> {
    /// Of a tree, with accelerations by link.
    pub fn lagrange(&mut self, accelerations: &[Vec<Wide>]) {
        let links = &self.drawn.links;
        let bodies: Vec<Body<Wide>> = links
            .iter()
            .zip(&self.state.rates)
            .map(|(link, (q, _))| body(link, q))
            .collect();
        let (mut q, mut v) = (Vec::new(), Vec::new());
        for (link, (own, rates)) in links.iter().zip(&self.state.rates) {
            // the quaternion is in the body
            let kept = link.kind.quaternion().unwrap_or(own.len());
            q.extend(&own[..kept]);
            q.resize(v.len() + rates.len(), Wide::ZERO);
            v.extend(rates);
        }
        let state = lagrange::State {
            q: &q,
            v: &v,
            a: &accelerations.concat(),
        };
        let missing = lagrange::missing(&bodies, &state, &self.loads.on, |one| one.high.abs());
        let drives = self.loads.drives.concat();
        let driven = links
            .iter()
            .flat_map(|link| std::iter::repeat_n(link.driven.is_some(), link.kind.freedoms()));
        let armatures = links
            .iter()
            .flat_map(|link| std::iter::repeat_n(link.armature, link.kind.freedoms()));
        let taken = armatures.zip(state.a).map(|(armature, a)| armature * *a);
        let size = missing.iter().map(|(_, size)| size).sum::<f64>();
        let sides = missing.iter().zip(drives).zip(taken).zip(driven);
        for ((((missing, _), drive), taken), is_driven) in sides {
            let allowed = 10.0 * EXACT * (size + drive.high.abs() + taken.high.abs() + 1e-3);
            let left = (*missing + taken - drive).high;
            // not a number is not close
            let is_close = left.abs() <= allowed;
            if !is_driven && !is_close {
                let _ = writeln!(self.failures, "Lagrange: {left:e} is left of {size:e}");
            }
        }
    }
}
