//! The times of single runs, and statistics of many of them.

use std::time::Instant;

/// The seconds that one run takes, as the mean of several.
pub fn time(repeats: u32, run: &mut impl FnMut()) -> f64 {
    let start = Instant::now();
    for _ in 0..repeats {
        run();
    }
    start.elapsed().as_secs_f64() / f64::from(repeats)
}

/// The number of runs that take this many seconds, so that they can be timed.
pub fn repeats(seconds: f64, run: &mut impl FnMut()) -> u32 {
    let mut repeats = 1;
    while time(repeats, run) * f64::from(repeats) < seconds {
        repeats *= 2;
    }
    repeats
}

/// The quartiles of some values, the second of which is the median.
pub fn quartiles(mut values: Vec<f64>) -> [f64; 3] {
    values.sort_by(f64::total_cmp);
    [1, 2, 3].map(|quarter| values[(values.len() - 1) * quarter / 4])
}
