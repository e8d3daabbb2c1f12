//! Times of two things, measured alternately.

use crate::clock::{quartiles, repeats, time};

/// The number of rounds, of which medians are taken.
const ROUNDS: usize = 101;

/// The shortest time over which anything is timed, in seconds.
const SHORTEST: f64 = 200e-6;

/// The times of two things, in ns per evaluation, and the ratio of the first to the second.
///
/// All are medians over the rounds. The ratio is taken within each round, in which the processor is
/// in the same condition for both.
#[derive(Clone, Copy)]
pub struct Paired {
    pub ours: f64,
    pub against: f64,
    /// The quartiles, the second of which is the median.
    pub ratio: [f64; 3],
}

/// Runs both alternately; each run makes a number of evaluations.
pub fn paired(evaluations: u32, mut ours: impl FnMut(), mut against: impl FnMut()) -> Paired {
    let repeats = [
        repeats(SHORTEST, &mut ours),
        repeats(SHORTEST, &mut against),
    ];
    let mut first = || time(repeats[0], &mut ours);
    let mut second = || time(repeats[1], &mut against);
    let rounds: Vec<[f64; 2]> = (0..ROUNDS)
        .map(|round| {
            if round % 2 == 0 {
                [first(), second()]
            } else {
                let second = second();
                [first(), second]
            }
        })
        .collect();
    let quartiles = |of: fn(&[f64; 2]) -> f64| quartiles(rounds.iter().map(of).collect());
    Paired {
        ours: quartiles(|[ours, _]| *ours)[1] * 1e9 / f64::from(evaluations),
        against: quartiles(|[_, against]| *against)[1] * 1e9 / f64::from(evaluations),
        ratio: quartiles(|[ours, against]| ours / against),
    }
}

/// The median time of one thing, in ns per evaluation.
pub fn alone(evaluations: u32, mut work: impl FnMut()) -> f64 {
    let repeats = repeats(SHORTEST, &mut work);
    let times = (0..ROUNDS).map(|_| time(repeats, &mut work)).collect();
    quartiles(times)[1] * 1e9 / f64::from(evaluations)
}
