//! How far results in doubles are from the values that they round.

use fastrand::Rng;

use super::{Checks, Errors};
use crate::wide::Wide;

impl Checks<'_> {
    /// How far doubles are from what they round.
    pub fn doubles(&mut self, exact: &[Wide], rng: &mut Rng) -> Errors {
        // the compiler has no values for functions of Rust
        if self.drawn.declared.calls {
            return Errors::default();
        }
        let roots = self.compiled.accelerations.concat();
        let found = self.compiled.doubles(&roots, &self.state.given());
        let largest = exact
            .iter()
            .fold(1e-3, |size: f64, one| size.max(one.high.abs()));
        let mut errors = Errors::default();
        let mut near = vec![0.0_f64; exact.len()];
        for _ in 0..3 {
            let moved = self.state.moved(rng);
            let values = self.compiled.values(&roots, &moved.given());
            for (near, (a, b)) in near.iter_mut().zip(values.iter().zip(exact)) {
                *near = near.max((*a - *b).high.abs() * 1e10 * f64::EPSILON / 2.0);
            }
        }
        for ((found, exact), near) in found.iter().zip(exact).zip(near) {
            let apart = (Wide::from(*found) - *exact).high.abs();
            // not a number is the largest
            let relative = if apart.is_nan() {
                f64::INFINITY
            } else {
                apart / largest
            };
            errors.acceleration = errors.acceleration.max(relative);
            // what is zero is so to its terms
            let unit = near + exact.high.abs().max(1e-3 * largest) * f64::EPSILON;
            errors.conditioned =
                errors
                    .conditioned
                    .max(if apart == 0.0 { 0.0 } else { apart / unit });
        }
        errors
    }
}
