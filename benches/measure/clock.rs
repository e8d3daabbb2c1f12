//! Times of single runs, and what is made of many of them.

use std::time::Instant;

/// Seconds that one run takes, as the mean of some.
pub fn time(repeats: u32, run: &mut impl FnMut()) -> f64 {
    let start = Instant::now();
    for _ in 0..repeats {
        run();
    }
    start.elapsed().as_secs_f64() / f64::from(repeats)
}

/// How many runs take so many seconds that they can be timed.
pub fn repeats(seconds: f64, run: &mut impl FnMut()) -> u32 {
    let mut repeats = 1;
    while time(repeats, run) * f64::from(repeats) < seconds {
        repeats *= 2;
    }
    repeats
}

/// The quartiles of some values; the second is the median.
pub fn quartiles(mut values: Vec<f64>) -> [f64; 3] {
    values.sort_by(f64::total_cmp);
    [1, 2, 3].map(|quarter| values[(values.len() - 1) * quarter / 4])
}
