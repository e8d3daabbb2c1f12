//! States of all scales, and on both sides of every number in a description.

use fastrand::Rng;

use crate::description::body::Body;
use crate::given::Given;
use crate::layout::{Layout, is_rod};
use crate::oracle::scene::Instant;
use crate::oracle::vector::dot;
use crate::wide::Wide;

/// What numbers of a state are drawn from.
pub struct Source {
    pub random: Rng,
    /// The numbers of the description.
    numbers: Vec<f64>,
}

/// A state, exactly, and as doubles.
#[derive(Clone, Debug)]
pub struct Sample {
    pub given: Given,
    pub instant: Instant,
}

impl Sample {
    /// Makes the attitude a unit again; false if nothing is left of it.
    pub fn is_made_unit(&mut self, body: &Body) -> bool {
        let part = Layout::of(&body.motion).attitude;
        if part.len() < 3 {
            return true;
        }
        let square: Wide = self.instant.state[part.clone()]
            .iter()
            .map(|x| *x * *x)
            .sum();
        if square.high < 1e-30 {
            return false;
        }
        let length = square.sqrt();
        for x in &mut self.instant.state[part] {
            *x = *x / length;
        }
        if is_rod(body) {
            across(body, self);
        }
        true
    }

    /// The doubles nearest to the instant.
    pub fn rounded(mut self) -> Self {
        self.given.time = self.instant.time.high;
        self.given.state = self.instant.state.iter().map(|x| x.high).collect();
        self
    }
}

impl Source {
    pub fn new(random: Rng, description: &str) -> Self {
        let is_part = |c: char| c.is_ascii_alphanumeric() || c == '.' || c == '_';
        let words = description.split(|c: char| !is_part(c) && c != '-');
        let pieces = words.flat_map(|word| [word, word.trim_start_matches('-')]);
        let mut numbers: Vec<f64> = pieces
            .filter_map(|word| word.parse().ok())
            .filter(|number: &f64| number.is_finite() && *number != 0.0)
            .map(f64::abs)
            .collect();
        numbers.sort_by(f64::total_cmp);
        numbers.dedup();
        Self { random, numbers }
    }

    /// Of either sign: zero, of any size, near a number of the description, or of the order of one.
    pub fn number(&mut self) -> f64 {
        let sign = if self.random.bool() { 1.0 } else { -1.0 };
        sign * match self.random.u32(..16) {
            0 => 0.0,
            1..5 => 10.0_f64.powf(12.0 * self.random.f64() - 6.0),
            5..12 if !self.numbers.is_empty() => self.near(),
            _ => 3.0 * self.random.f64(),
        }
    }

    fn near(&mut self) -> f64 {
        let number = self.pick();
        let other = self.pick();
        let side = if self.random.bool() { 1.0 } else { -1.0 };
        match self.random.u32(..8) {
            0 | 1 => number * (1.0 + side * 1e-7),
            2 => number * (1.0 + side * 1e-3),
            3 => number * (1.0 + side * 0.3 * self.random.f64()),
            // as far from one as another is large
            4..6 => number + side * other * self.random.f64(),
            6 => 2.0 * number,
            _ => number / other,
        }
    }

    fn pick(&mut self) -> f64 {
        self.numbers[self.random.usize(..self.numbers.len())]
    }

    pub fn sample(&mut self, body: &Body, params: &[f64]) -> Sample {
        let layout = Layout::of(&body.motion);
        let mut sample = Sample {
            given: Given {
                params: params.to_vec(),
                state: vec![0.0; layout.len()],
                ..Given::default()
            },
            instant: Instant {
                time: Wide::ZERO,
                state: vec![Wide::ZERO; layout.len()],
                own: Vec::new(),
            },
        };
        self.time(&mut sample);
        self.inputs(body, &mut sample);
        self.fill(&mut sample, layout.position);
        self.fill(&mut sample, layout.velocity);
        self.fill(&mut sample, layout.turning);
        self.attitude(body, &mut sample);
        sample.rounded()
    }

    /// From zero on as often as not.
    pub fn time(&mut self, sample: &mut Sample) {
        let time = self.number();
        sample.instant.time = if self.random.u32(..8) > 0 {
            time.abs()
        } else {
            time
        }
        .into();
    }

    pub fn inputs(&mut self, body: &Body, sample: &mut Sample) {
        let count = body.input_offsets().1;
        sample.given.inputs = (0..count).map(|_| self.number()).collect();
    }

    pub fn fill(&mut self, sample: &mut Sample, part: std::ops::Range<usize>) {
        let is_at_rest = self.random.u32(..8) == 0;
        for place in part {
            sample.instant.state[place] = if is_at_rest { 0.0 } else { self.number() }.into();
        }
    }

    /// Unit to 106 bits; the rate of the axis of a rod perpendicular to it.
    pub fn attitude(&mut self, body: &Body, sample: &mut Sample) {
        let part = Layout::of(&body.motion).attitude;
        if part.len() == 1 {
            let angle = if self.random.bool() {
                self.number()
            } else {
                7.0 * (self.random.f64() - 0.5)
            };
            sample.instant.state[part.start] = angle.into();
            return;
        }
        let mut unit: Vec<Wide> = part.clone().map(|_| self.direction().into()).collect();
        if unit.iter().all(|x| x.high == 0.0) {
            unit.iter_mut()
                .last()
                .into_iter()
                .for_each(|last| *last = Wide::ONE);
        }
        let length = unit.iter().map(|x| *x * *x).sum::<Wide>().sqrt();
        for (place, x) in part.zip(unit) {
            sample.instant.state[place] = x / length;
        }
        if is_rod(body) {
            across(body, sample);
        }
    }

    fn direction(&mut self) -> f64 {
        match self.random.u32(..8) {
            0 => 0.0,
            1 => 10.0_f64.powf(-8.0 * self.random.f64()),
            _ => 2.0 * self.random.f64() - 1.0,
        }
    }

    /// Of any size, so that the mass and the inertia are what they can be.
    pub fn params(&mut self, body: &Body) -> Vec<f64> {
        let mut params = body.defaults();
        if self.random.u32(..3) > 0 {
            for param in &mut params {
                if self.random.u32(..3) > 0 {
                    *param = self.number();
                }
            }
        }
        params
    }
}

/// Takes what is along the axis of a rod off the rate of it.
pub fn across(body: &Body, sample: &mut Sample) {
    let Layout {
        attitude, turning, ..
    } = Layout::of(&body.motion);
    let state = &mut sample.instant.state;
    let three = |state: &[Wide], from: usize| [state[from], state[from + 1], state[from + 2]];
    let axis = three(state, attitude.start);
    for _ in 0..2 {
        let along = dot(axis, three(state, turning.start));
        for i in 0..3 {
            state[turning.start + i] = state[turning.start + i] - axis[i] * along;
        }
    }
}
