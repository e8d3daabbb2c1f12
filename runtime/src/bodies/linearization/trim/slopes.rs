//! Derivatives of constraints and conditions by finite differences.

/// Steps, as fractions of the plausible change: long ones for smooth functions, because rounding is
/// divided by them, short ones near places where functions are not smooth.
pub(super) const STEPS: [f64; 4] = [1e-2, 1e-3, 1e-4, 6e-6];

/// The rounding of motions along constraints, whose slopes over long steps are rounded by some units
/// over the step, as a fraction of A.
pub(super) const SLOPES: f64 = 64.0 * f64::EPSILON / STEPS[0];

/// The weights of the changes over one to four steps, in central differences of orders six and eight.
const WEIGHTS: [[f64; 4]; 2] = [
    [3.0 / 4.0, -3.0 / 20.0, 1.0 / 60.0, 0.0],
    [4.0 / 5.0, -1.0 / 5.0, 4.0 / 105.0, -1.0 / 280.0],
];

/// A derivative, and a bound of its error.
#[derive(Clone, Copy)]
pub(super) struct Slope {
    pub(super) value: f64,
    error: f64,
}

impl Slope {
    /// Nothing is known.
    pub(super) const UNKNOWN: Self = Self {
        value: 0.0,
        error: f64::INFINITY,
    };

    /// By the values after and before one to four steps of a length.
    fn of(values: [[f64; 2]; 4], step: f64) -> (Self, f64) {
        let [mut six, mut eight, mut size] = [0.0, 0.0, 0.0_f64];
        for (number, [after, before]) in values.into_iter().enumerate() {
            six += WEIGHTS[0][number] * (after - before);
            eight += WEIGHTS[1][number] * (after - before);
            size = size.max(after.abs()).max(before.abs());
        }
        let rounding = 4.0 * f64::EPSILON * size;
        let value = if eight.abs() > rounding { eight } else { 0.0 };
        let error = (eight - six).abs().max(rounding);
        let slope = Self {
            value: value / step,
            error: error / step,
        };
        (slope, rounding / step)
    }

    /// Improves the slope by those values, if they are better; returns whether nothing but rounding
    /// remains.
    pub(super) fn refine(&mut self, values: [[f64; 2]; 4], step: f64) -> bool {
        let (slope, rounding) = Self::of(values, step);
        if slope.error < self.error {
            *self = slope;
        }
        self.error <= rounding
    }
}
