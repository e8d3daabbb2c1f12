//! A vector `(w, 0, u)` whose third component is linear in time.

use crate::numbers::math;
use crate::numbers::twofold::Twofold;

/// `u = u₀ + b t`
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Sweep {
    /// w
    pub across: Twofold,
    /// w²
    square: Twofold,
    /// u₀
    pub start: Twofold,
    /// b, positive.
    pub rate: Twofold,
}

/// A point of a sweep.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Place {
    /// u
    pub along: Twofold,
    /// λ, the length of the vector.
    pub length: Twofold,
}

impl Place {
    /// 1 if u is positive, otherwise 0.
    pub fn side(&self) -> usize {
        usize::from(self.along.value() > 0.0)
    }
}

impl Sweep {
    pub fn new(across: Twofold, start: Twofold, rate: Twofold) -> Self {
        Self {
            across,
            square: across * across,
            start,
            rate,
        }
    }

    pub fn place(&self, along: Twofold) -> Place {
        Place {
            along,
            length: (along * along + self.square).sqrt(),
        }
    }

    /// The time from the start to a point.
    pub fn time(&self, place: &Place) -> Twofold {
        (place.along - self.start) / self.rate
    }

    /// `∫ λ dt` between two points, divided by the time between them, where y is the difference of
    /// `asinh(u/w)`,
    ///
    /// ```text
    /// ∫ λ dt = (u λ + w² asinh(u/w))/2b, between the two      tanh(y/2) = b t/(λ₀ + λ₁)
    /// ```
    ///
    /// in a form that does not cancel, even for small b.
    pub fn phase(&self, from: &Place, to: &Place, time: Twofold) -> Twofold {
        let lengths = from.length + to.length;
        let along = from.along + to.along;
        let step = (self.rate * time / lengths).value();
        let share = self.square * Twofold::from(4.0 * area_ratio(step));
        time.scaled(-2) * (lengths + (along * along + share) / lengths)
    }
}

/// `artanh(x)/x`; if x rounds to one, the value at the next smaller number.
fn area_ratio(x: f64) -> f64 {
    let below = 1.0 - f64::EPSILON;
    let x = math::min(x.abs(), below);
    if x == 0.0 { 1.0 } else { libm::atanh(x) / x }
}
