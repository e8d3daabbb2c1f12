//! A small step from an instant: how much each coordinate changes.

use crate::description::body::Motion;
use crate::wide::Wide;

use super::scene::Instant;

/// A step along the motion.
#[derive(Clone, Copy, Default)]
pub struct Step {
    pub time: Wide,
    pub position: [Wide; 3],
    /// Body axes; in the plane about its normal, in the third place; of a rod of its axis.
    pub attitude: [Wide; 3],
    pub velocity: [Wide; 3],
    pub turning: [Wide; 3],
}

impl Step {
    /// What comes of it.
    pub fn from(&self, motion: &Motion, instant: &Instant) -> Instant {
        let mut instant = instant.clone();
        instant.time = instant.time + self.time;
        let state = &mut instant.state;
        let mut add = |from: usize, parts: &[Wide]| {
            for (i, part) in parts.iter().enumerate() {
                state[from + i] = state[from + i] + *part;
            }
        };
        match motion {
            Motion::Translation => {
                add(0, &self.position);
                add(3, &self.velocity);
            }
            Motion::PlanarTranslation => {
                add(0, &self.position[..2]);
                add(2, &self.velocity[..2]);
            }
            Motion::Planar => {
                add(0, &self.position[..2]);
                add(2, &self.attitude[2..]);
                add(3, &self.velocity[..2]);
                add(5, &self.turning[2..]);
            }
            Motion::Rod(_) => {
                add(0, &self.position);
                add(3, &self.attitude);
                add(6, &self.velocity);
                add(9, &self.turning);
            }
            Motion::Spatial => {
                add(0, &self.position);
                add(7, &self.velocity);
                add(10, &self.turning);
                turn(&mut state[3..7], self.attitude);
            }
            Motion::Pivot(_) | Motion::FixedAxis(..) => {
                add(0, &self.attitude[2..]);
                add(1, &self.turning[2..]);
            }
            Motion::Rotation | Motion::FixedPoint(_) => {
                add(4, &self.turning);
                turn(&mut state[..4], self.attitude);
            }
        }
        instant
    }
}

/// `q exp(s / 2)` of a short vector s in body axes, the scalar of q last.
fn turn(q: &mut [Wide], s: [Wide; 3]) {
    let length = s.iter().map(|x| *x * *x).sum::<Wide>().sqrt();
    if length == Wide::ZERO {
        return;
    }
    let (sine, cosine) = (length * 0.5).sin_cos();
    let share = sine / length;
    let [x, y, z] = s.map(|part| part * share);
    let [a, b, c, w] = [q[0], q[1], q[2], q[3]];
    q[0] = w * x + a * cosine + b * z - c * y;
    q[1] = w * y - a * z + b * cosine + c * x;
    q[2] = w * z + a * y - b * x + c * cosine;
    q[3] = w * cosine - a * x - b * y - c * z;
}
