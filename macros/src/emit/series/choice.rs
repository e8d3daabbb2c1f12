//! The choice between series and Runge–Kutta steps: whichever takes less time, by counts of
//! operations.

use crate::emit::items::Best;
use crate::symbolic::Cost;

/// The number of coefficients of a series at the default tolerance, and of stages of the
/// Runge–Kutta pair used at that tolerance.
const COEFFICIENTS: f64 = 17.0;
const STAGES: f64 = 16.0;
/// The operations of a stage other than those of the equations.
const STAGE: f64 = 28.0;
/// A sine or a similar function takes as long as this many operations.
const FUNCTION: f64 = 20.0;
/// The weights of a level of convolutions, which waits for the level before it, and of the
/// convolution of a root, which is computed separately.
const LEVEL: f64 = 20.0;
const ROOT: f64 = 40.0;

/// The exponents of the default tolerance, and of the coarsest one with a choice of its own.
const DEFAULT: u32 = 9;
const COARSEST: u32 = 2;
/// The decades of the tolerance that multiply the ratio of both times by e.
const DECADES: f64 = 12.0;
/// A predicted ratio is no more accurate than this.
const ACCURACY: f64 = 1.1;

/// What a step along a series computes.
pub struct Counts {
    /// The number of convolutions, including those that pad registers.
    pub width: usize,
    /// The number of levels of convolutions beyond the first.
    pub levels: usize,
    pub coordinates: usize,
    /// The operations of each order other than convolutions.
    pub each_order: Cost,
    /// The operations for the rates of the coordinates.
    pub rates: Cost,
}

impl Counts {
    /// The method that takes less time at each tolerance.
    ///
    /// The weights are fitted to the times of steps of 17 bodies and systems
    /// (`docs/performance.md`). They choose between methods with the same tolerance, so a bad
    /// choice costs only time.
    pub fn best(&self) -> Best {
        let ratio = self.ratio();
        if ratio > 1.0 {
            return Best::RungeKutta;
        }
        // toward coarse tolerances the steps along a series grow less than those of the pair
        let takes_series = |exponent: u32| {
            let decades = f64::from(DEFAULT - exponent);
            ratio * (decades / DECADES).exp() <= ACCURACY
        };
        let coarsest = (COARSEST..=DEFAULT).find(|exponent| takes_series(*exponent));
        match coarsest {
            Some(exponent) if exponent > COARSEST => Best::SeriesBelow(exponent),
            _ => Best::Series,
        }
    }

    /// The time of a step along a series divided by that of a step of Verner's pair, and by 1.4: at
    /// a tolerance of 1e-9, the steps of both cover about the same time in most nonlinear motions;
    /// in nearly linear ones, a step along the series covers more than twice as much.
    fn ratio(&self) -> f64 {
        let count = |number: usize| u32::try_from(number).map_or(f64::INFINITY, f64::from);
        // registers hold four numbers, and on average a sum has half the coefficients
        let convolutions = count(self.width) * COEFFICIENTS / 8.0;
        let coefficient = convolutions
            + 2.0 * count(self.coordinates)
            + LEVEL * count(self.levels)
            + weight(self.each_order) / 2.0
            + ROOT * f64::from(self.rates.sqrt);
        let series = COEFFICIENTS * coefficient;
        let pair = STAGES * (weight(self.rates) + STAGE);
        series / (1.4 * pair)
    }
}

fn weight(cost: Cost) -> f64 {
    f64::from(cost.total()) + (FUNCTION - 1.0) * f64::from(cost.trig)
}
