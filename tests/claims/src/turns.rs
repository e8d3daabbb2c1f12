//! Rotations of the world, or of the axes of a body, to 106 bits.

use crate::description::body::Body;
use crate::layout::{Layout, is_rod};
use crate::oracle::scene::Instant;
use crate::oracle::vector::{Vector, cross, dot};
use crate::wide::Wide;

/// About a unit vector, by an angle.
#[derive(Clone, Copy)]
pub struct Turn {
    axis: [Wide; 3],
    /// Of half the angle.
    half: (Wide, Wide),
    angle: Wide,
}

impl Turn {
    pub fn new(axis: [f64; 3], angle: f64) -> Self {
        Self::exactly(axis.map(Wide::from), angle)
    }

    pub fn exactly(axis: [Wide; 3], angle: f64) -> Self {
        let length = dot(axis, axis).sqrt();
        let angle = Wide::from(angle);
        Self {
            axis: axis.map(|x| x / length),
            half: (angle * 0.5).sin_cos(),
            angle,
        }
    }

    /// `v + 2 q x (w v + q x v)`
    fn of(&self, v: [Wide; 3]) -> [Wide; 3] {
        let (sine, cosine) = self.half;
        let q = self.axis.map(|x| x * sine);
        let swept = cross(q, v);
        let inner = [0, 1, 2].map(|i| swept[i] + v[i] * cosine);
        let outer = cross(q, inner);
        [0, 1, 2].map(|i| v[i] + outer[i] * 2.0)
    }

    pub fn vector(&self, vector: Vector) -> Vector {
        Vector {
            value: self.of(vector.value),
            ..vector
        }
    }

    /// Three coordinates of a state.
    pub fn part(&self, state: &mut [Wide], from: usize) {
        self.turn(state, from, 3);
    }

    fn turn(&self, state: &mut [Wide], from: usize, count: usize) {
        let part = |i: usize| {
            if i < count {
                state[from + i]
            } else {
                Wide::ZERO
            }
        };
        let turned = self.of([part(0), part(1), part(2)]);
        state[from..from + count].copy_from_slice(&turned[..count]);
    }

    fn quaternion(&self, sign: f64) -> [Wide; 4] {
        let (sine, cosine) = self.half;
        let [x, y, z] = self.axis.map(|part| part * sine * sign);
        [x, y, z, cosine]
    }

    pub fn world(&self, body: &Body, instant: &mut Instant) {
        let layout = Layout::of(&body.motion);
        let state = &mut instant.state;
        for part in [layout.position, layout.velocity] {
            self.turn(state, part.start, part.len());
        }
        let attitude = layout.attitude;
        match attitude.len() {
            1 => state[attitude.start] = state[attitude.start] + self.signed_angle(),
            3 => {
                self.turn(state, attitude.start, 3);
                self.turn(state, layout.turning.start, 3);
            }
            4 => {
                let q = std::array::from_fn(|i| state[attitude.start + i]);
                state[attitude].copy_from_slice(&multiplied(self.quaternion(1.0), q));
            }
            _ => {}
        }
    }

    pub fn body(&self, body: &Body, instant: &mut Instant) {
        let layout = Layout::of(&body.motion);
        let state = &mut instant.state;
        let attitude = layout.attitude;
        match attitude.len() {
            1 => state[attitude.start] = state[attitude.start] - self.signed_angle(),
            4 => {
                let q = std::array::from_fn(|i| state[attitude.start + i]);
                state[attitude].copy_from_slice(&multiplied(q, self.quaternion(-1.0)));
                self.turn(state, layout.turning.start, 3);
            }
            _ => {}
        }
    }

    /// About z, as angles are counted.
    fn signed_angle(&self) -> Wide {
        if self.axis[2].high < 0.0 {
            -self.angle
        } else {
            self.angle
        }
    }
}

/// The accelerations that go with it.
pub fn turned(
    body: &Body,
    turn: Turn,
    is_world: bool,
    [linear, angular]: [Vector; 2],
) -> [Vector; 2] {
    if is_world {
        let angular = if is_rod(body) {
            turn.vector(angular)
        } else {
            angular
        };
        [turn.vector(linear), angular]
    } else {
        let is_scalar = body.motion.is_planar();
        [
            linear,
            if is_scalar {
                angular
            } else {
                turn.vector(angular)
            },
        ]
    }
}

/// Of quaternions with their scalar last.
fn multiplied([ax, ay, az, aw]: [Wide; 4], [bx, by, bz, bw]: [Wide; 4]) -> [Wide; 4] {
    [
        aw * bx + ax * bw + ay * bz - az * by,
        aw * by - ax * bz + ay * bw + az * bx,
        aw * bz + ax * by - ay * bx + az * bw,
        aw * bw - ax * bx - ay * by - az * bz,
    ]
}
