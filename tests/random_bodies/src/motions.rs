//! Bodies moved with every method that they have, and a comparison of their final states.

use std::fmt;

use fastrand::Rng;
use newton_euler::integrate::{IntegrationError, Sample};
use newton_euler::state::Coordinates;

use crate::description::body::{Body, Motion};
use crate::description::moving::moving_body;
use crate::description::written::described;
use crate::given::Given;
use crate::states::of_run;

/// What is written at build time.
pub type March = fn(&Given, f64, &mut Ends);

/// The end by each method, or what ended the motion.
#[derive(Debug, Default)]
pub struct Ends {
    pub list: Vec<(&'static str, Result<Vec<f64>, String>)>,
}

/// Of a motion that is not stiff, or goes on for ever.
const STEPS: usize = 20_000;

impl Ends {
    /// The last of these steps.
    pub fn tell<S: Coordinates<Scalar = f64>>(
        &mut self,
        method: &'static str,
        steps: impl Iterator<Item = Result<Sample<S>, IntegrationError<S>>>,
    ) {
        let mut end = Err("no step".to_owned());
        for (number, step) in steps.enumerate() {
            end = match step {
                _ if number > STEPS => Err("too many steps".to_owned()),
                Ok(sample) => Ok(sample.state.coordinates().as_ref().to_vec()),
                Err(error) => Err(error.to_string()),
            };
            if end.is_err() {
                break;
            }
        }
        self.list.push((method, end));
    }
}

#[derive(Debug, Default)]
pub struct Motions {
    pub count: usize,
    /// Where DOP853 does not come to the end, or not to the same one with another tolerance.
    pub undecided: usize,
    /// The largest difference, in parts of the largest coordinate of its group and one.
    pub largest: f64,
    pub failures: Vec<String>,
    /// Motions that DOP853 takes to their end and another method does not.
    pub unfinished: Vec<String>,
}

/// Differences of ends that are allowed: far above the errors of steps, far below what a load does.
const ALLOWED: f64 = 1e-6;

impl Motions {
    /// Moves a body from so many states.
    pub fn ask(&mut self, seed: u64, index: usize, march: March, states: usize) {
        let moving = moving_body(seed, index);
        for state in 0..states {
            let mut random = of_run(seed ^ 0x6d, index, state);
            let (given, end) = start(&mut random, &moving.body);
            let mut ends = Ends::default();
            march(&given, end, &mut ends);
            self.count += 1;
            self.compare(&ends, || {
                format!(
                    "{}\n  body {index}, state {state}: {given:?} for {end:e}",
                    described(&moving.body, &[])
                )
            });
        }
    }

    fn compare(&mut self, ends: &Ends, place: impl Fn() -> String) {
        let [(_, known), (_, coarser), others @ ..] = ends.list.as_slice() else {
            unreachable!("two of each")
        };
        let (Ok(known), Ok(coarser)) = (known, coarser) else {
            self.undecided += 1;
            return;
        };
        let doubt = apart(known, coarser);
        if doubt > ALLOWED {
            self.undecided += 1;
            return;
        }
        for (method, end) in others {
            let place = || format!("{method}: {end:?}\n  for {known:?}\n{}", place());
            let Ok(end) = end else {
                self.unfinished.push(place());
                continue;
            };
            let difference = apart(known, end);
            if difference.is_finite() {
                self.largest = self.largest.max(difference);
            }
            // what is no number is no end, either
            if difference.is_nan() || difference > ALLOWED + 100.0 * doubt {
                self.failures.push(place());
            }
        }
    }
}

/// The largest difference; quaternions are the same with the other sign.
fn apart(a: &[f64], b: &[f64]) -> f64 {
    let size = a.iter().fold(1.0, |most: f64, x| most.max(x.abs()));
    let by = |signs: &dyn Fn(usize) -> f64| {
        let pairs = a.iter().zip(b).enumerate();
        pairs
            .map(|(i, (x, y))| (x - signs(i) * y).abs())
            .fold(0.0, f64::max)
            / size
    };
    let attitude = match a.len() {
        13 => 3..7,
        7 => 0..4,
        _ => 0..0,
    };
    by(&|_| 1.0).min(by(&|i| if attitude.contains(&i) { -1.0 } else { 1.0 }))
}

/// A state, at rest one time out of four, and how long it is to move.
fn start(random: &mut Rng, body: &Body) -> (Given, f64) {
    let mut given = Given {
        params: body.defaults(),
        ..Given::default()
    };
    let is_at_rest = random.u32(..4) == 0;
    let mut number = |size: f64| size * (2.0 * random.f64() - 1.0);
    let mut quaternion = [(); 4].map(|()| number(1.0));
    let length = quaternion.iter().map(|x| x * x).sum::<f64>().sqrt();
    quaternion = quaternion.map(|x| x / length);
    let list = &mut given.state;
    let position = |list: &mut Vec<f64>, count: usize, number: &mut dyn FnMut(f64) -> f64| {
        list.extend((0..count).map(|_| number(3.0)));
    };
    let rates = |list: &mut Vec<f64>, count: usize, number: &mut dyn FnMut(f64) -> f64| {
        list.extend((0..count).map(|_| if is_at_rest { 0.0 } else { number(3.0) }));
    };
    match body.motion {
        Motion::Spatial => {
            position(list, 3, &mut number);
            list.extend(quaternion);
            rates(list, 6, &mut number);
        }
        Motion::Rotation | Motion::FixedPoint(_) => {
            list.extend(quaternion);
            rates(list, 3, &mut number);
        }
        Motion::Translation | Motion::Planar => {
            position(list, 3, &mut number);
            rates(list, 3, &mut number);
        }
        Motion::PlanarTranslation => {
            position(list, 2, &mut number);
            rates(list, 2, &mut number);
        }
        Motion::Pivot(_) | Motion::FixedAxis(..) => {
            position(list, 1, &mut number);
            rates(list, 1, &mut number);
        }
        Motion::Rod(_) => {
            position(list, 3, &mut number);
            list.extend([1.0, 0.0, 0.0]);
            rates(list, 3, &mut number);
            list.push(0.0);
            rates(list, 2, &mut number);
        }
    }
    given.inputs = (0..body.input_offsets().1).map(|_| number(3.0)).collect();
    (given, 10.0_f64.powf(2.0 * random.f64() - 1.0))
}

impl fmt::Display for Motions {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for failure in self.failures.iter().chain(&self.unfinished) {
            writeln!(f, "{failure}\n")?;
        }
        let Self {
            count,
            undecided,
            largest,
            failures,
            unfinished,
        } = self;
        writeln!(
            f,
            "{count} motions; {undecided} that DOP853 does not decide; {} ends that differ, the others by up to {largest:.1e}; {} that another method does not reach",
            failures.len(),
            unfinished.len()
        )
    }
}
