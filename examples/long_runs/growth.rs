//! How errors grow with the number of steps, and by which law.

use std::time::Instant;

use nalgebra::Vector3;
use newton_euler::prelude::*;

use crate::march::Way;
use crate::problem::Problem;

/// The errors of a method on a problem.
pub struct Growth {
    pub problem: &'static str,
    pub method: &'static str,
    /// \[s\]
    pub step: f64,
    /// ns for a step.
    pub cost: f64,
    /// After 1, 2, 4, ... steps.
    pub rows: Vec<Row>,
    /// The exponents that are expected.
    pub expected: [f64; 3],
}

/// Errors after a number of steps: root mean squares over the starts and, but of the attitude, over the second half of the steps.
#[derive(Clone, Copy)]
pub struct Row {
    pub steps: u64,
    pub errors: [Option<f64>; 3],
}

/// How often a doubling of steps is looked at.
const LOOKS: u64 = 16;

/// Follows a body from each of its starts, for 2ⁿ steps.
#[expect(clippy::cast_precision_loss, reason = "below 2⁵³")]
pub fn follow<'b, B>(problem: &Problem<'b, B>, way: &Way<'b, B>, doublings: u32) -> Growth
where
    B: Energy<State = Rotation, Scalar = f64, Input = ()> + Momentum<Angular = Vector3<f64>>,
{
    let step = way.step * problem.pace;
    let mut sums = vec![[Mean::default(); 3]; doublings as usize + 1];
    let clock = Instant::now();
    for (number, start) in problem.starts.iter().enumerate() {
        let mut march = way.begin(problem.body, start, step);
        let mut taken = 0;
        for (doubling, sums) in sums.iter_mut().enumerate() {
            let end = 1 << doubling;
            let stride = (end / 2 / LOOKS).max(1);
            while taken < end {
                let state = march(stride);
                taken += stride;
                let [energy, momentum, attitude] =
                    problem.errors(number, taken as f64 * step, &state);
                let attitude = attitude.filter(|_| taken == end);
                for (sum, error) in sums.iter_mut().zip([energy, momentum, attitude]) {
                    sum.add(error);
                }
            }
        }
    }
    let steps = (problem.starts.len() << doublings) as f64;
    let row = |(doubling, sums): (usize, [Mean; 3])| Row {
        steps: 1 << doubling,
        errors: sums.map(Mean::root),
    };
    Growth {
        problem: problem.name,
        method: way.name,
        step,
        cost: clock.elapsed().as_secs_f64() * 1e9 / steps,
        rows: sums.into_iter().enumerate().map(row).collect(),
        expected: way.expected,
    }
}

/// A mean of squares.
#[derive(Clone, Copy, Default)]
struct Mean {
    sum: f64,
    count: f64,
}

impl Mean {
    fn add(&mut self, value: Option<f64>) {
        if let Some(value) = value {
            self.sum += value * value;
            self.count += 1.0;
        }
    }

    fn root(self) -> Option<f64> {
        (self.count > 0.0).then(|| (self.sum / self.count).sqrt())
    }
}

/// Errors below may be those of looking at them.
const FLOOR: f64 = 4e-15;
/// Errors above no longer grow: an angle is not more than π.
const CEILING: f64 = 0.1;
/// A law is read off from so many doublings at the most, the last; what is bounded hides it before.
const LAST: usize = 8;
/// And so many at least.
const LEAST: usize = 4;

impl Growth {
    /// The exponent p of error = a nᵖ for one of [`QUANTITIES`](crate::problem::QUANTITIES), as far as it shows.
    pub fn exponent(&self, quantity: usize) -> Option<f64> {
        #[expect(clippy::cast_precision_loss, reason = "below 2⁵³")]
        let points = self.rows.iter().filter_map(|row| {
            let error = row.errors[quantity]?;
            let shows = (FLOOR..CEILING).contains(&error);
            shows.then(|| ((row.steps as f64).ln(), error.ln()))
        });
        let points: Vec<(f64, f64)> = points.collect();
        let last = points.len().saturating_sub(LAST);
        (points.len() >= LEAST).then(|| slope(&points[last..]))
    }
}

/// Of the line of least squares.
fn slope(points: &[(f64, f64)]) -> f64 {
    let count = points.iter().map(|_| 1.0).sum::<f64>();
    let mean = |of: fn(&(f64, f64)) -> f64| points.iter().map(of).sum::<f64>() / count;
    let (x, y) = (mean(|point| point.0), mean(|point| point.1));
    let across: f64 = points
        .iter()
        .map(|point| (point.0 - x) * (point.1 - y))
        .sum();
    let along: f64 = points.iter().map(|point| (point.0 - x).powi(2)).sum();
    across / along
}
