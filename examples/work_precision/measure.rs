//! Time and error of methods, from coarse to fine.

use std::hint::black_box;
use std::time::{Duration, Instant};

use crate::clock::{quartiles, repeats, time};
use crate::distance::Distance;
use crate::method::{Method, Way};

/// A method on a problem: what each effort costs, and how good it is.
pub struct Curve {
    pub problem: String,
    pub method: String,
    pub points: Vec<Point>,
}

/// One effort.
#[derive(Clone, Copy)]
pub struct Point {
    /// Steps or tolerance.
    pub effort: f64,
    /// ns for a simulated second of one body.
    pub time: f64,
    pub error: f64,
}

/// How much time measuring takes.
#[derive(Clone, Copy)]
pub struct Care {
    /// Rounds of which the medians are taken.
    pub rounds: usize,
    /// No single time is taken over less \[s\].
    pub shortest: f64,
    /// What takes longer is left out.
    pub longest: Duration,
}

/// Errors above are no solutions.
const USELESS: f64 = 1.0;

/// An error that may be rounding, and after how many efforts without a better one it is.
const FLOOR: (f64, usize) = (1e-8, 4);

/// All methods on a problem of which the end is known: each effort once for its error, then all of them in turn for their times.
///
/// `seconds` are those of all bodies together.
pub fn measure<S: Distance>(
    care: Care,
    problem: &str,
    seconds: f64,
    end: &S,
    methods: &[Method<'_, S>],
) -> Vec<Curve> {
    let mut runs = Vec::new();
    for (place, method) in methods.iter().enumerate() {
        for (effort, error) in sweep(care, method, end) {
            let mut run = || {
                black_box(method.end(effort));
            };
            let repeats = repeats(care.shortest, &mut run);
            runs.push((place, effort, error, repeats));
        }
    }
    let mut times = vec![Vec::new(); runs.len()];
    for _ in 0..care.rounds {
        for ((place, effort, _, repeats), times) in runs.iter().zip(&mut times) {
            times.push(time(*repeats, &mut || {
                black_box(methods[*place].end(*effort));
            }));
        }
    }
    let mut curves: Vec<Curve> = methods
        .iter()
        .map(|method| Curve {
            problem: problem.into(),
            method: method.name.clone(),
            points: Vec::new(),
        })
        .collect();
    for ((place, effort, error, _), times) in runs.into_iter().zip(times) {
        curves[place].points.push(Point {
            effort,
            time: quartiles(times)[1] * 1e9 / seconds,
            error,
        });
    }
    curves
}

/// Efforts and errors, until errors fall no more or the time is up.
fn sweep<S: Distance>(care: Care, method: &Method<'_, S>, end: &S) -> Vec<(f64, f64)> {
    let (mut found, mut best, mut since) = (Vec::new(), f64::INFINITY, 0);
    for effort in method.efforts() {
        let error = method
            .end(effort)
            .map_or(f64::NAN, |arrived| arrived.distance(end));
        if error < USELESS {
            found.push((effort, error));
        }
        // of what is no number, too: such an effort is too small for the one kind and too great for the other
        since = if error < 0.7 * best { 0 } else { since + 1 };
        best = best.min(error);
        let is_floor = best < FLOOR.0 && since >= FLOOR.1;
        // a tolerance that is too loose may take the longest of all
        let may_shorten = matches!(method.way, Way::Adaptive(_)) && found.is_empty();
        // one run may have had to wait for another program
        let is_long = !may_shorten
            && (0..3).all(|_| {
                let start = Instant::now();
                black_box(method.end(effort));
                start.elapsed() > care.longest
            });
        if is_long || is_floor || matches!(method.way, Way::Closed(_)) {
            break;
        }
    }
    found
}

impl Curve {
    /// The least error.
    pub fn floor(&self) -> f64 {
        let errors = self.points.iter().map(|point| point.error);
        errors.fold(f64::INFINITY, f64::min)
    }

    /// The points that no other one betters in time and in error, from fast to good.
    pub fn best(&self) -> Vec<Point> {
        let mut points = self.points.clone();
        points.sort_by(|a, b| a.time.total_cmp(&b.time));
        let mut least = f64::INFINITY;
        points.retain(|point| {
            let is_better = point.error < least;
            least = least.min(point.error);
            is_better
        });
        points
    }

    /// The time that an error takes \[ns for a simulated second\], between the best points on straight lines in logarithms.
    pub fn time_to(&self, error: f64) -> Option<f64> {
        let best = self.best();
        let fine = best.iter().position(|point| point.error <= error)?;
        let b = best[fine];
        let Some(a) = fine.checked_sub(1).map(|coarse| best[coarse]) else {
            return Some(b.time);
        };
        let share = (error / a.error).ln() / (b.error / a.error).ln();
        Some(a.time * (b.time / a.time).powf(share))
    }
}
