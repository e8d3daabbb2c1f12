//! Between which heights the axis of a top nods.
//!
//! With u = cos θ, a = k/A, p = C ω₃/A, b the vertical angular momentum over A, w the angular
//! velocity across the axis at time zero,
//!
//! ```text
//! u'² = (1 - u²)(w² - 2a (u - u(0))) - (b - p u)² = 2a (u - u₁)(u₂ - u)(u₃ - u)
//! -1 <= u₁ <= u <= u₂ <= 1 <= u₃
//! ```
//!
//! One of the three roots lies apart. It is found first, in twice the precision. The two others are
//! then the roots of a quadratic, of opposite signs because they lie on either side of u(0), or of
//! 1: neither cancels. So the distances of the roots from the poles, the start and each other all
//! keep their digits, at the edge of steady precession as near the separatrix; small ones next to a
//! pole by
//!
//! ```text
//! (b + p)² = 2a (1 + u₁)(1 + u₂)(1 + u₃)      (b - p)² = 2a (1 - u₁)(1 - u₂)(u₃ - 1)
//! ```

use core::f64::consts::FRAC_PI_3;

use crate::numbers::math;
use crate::numbers::twofold::Twofold;

/// The quantities that determine the motion, at time zero.
#[derive(Clone, Copy)]
pub(super) struct Start {
    /// a
    pub couple: Twofold,
    /// p
    pub spin: Twofold,
    /// 1 + u
    pub nadir: Twofold,
    /// 1 - u
    pub zenith: Twofold,
    /// `b - p u`: the vertical angular momentum over A, without the part of the spin
    pub vertical: Twofold,
    /// u'
    pub rise: Twofold,
    /// w²
    pub square: Twofold,
}

/// The roots, by their distances: to u₁, to u₂ and, times 2a, to u₃.
#[derive(Clone, Copy)]
pub(super) struct TurningPoints {
    /// From u(0).
    pub from_start: [f64; 3],
    /// From -1.
    pub from_nadir: [f64; 3],
    /// From 1.
    pub from_zenith: [f64; 3],
    /// `2a (u₃ - u₂)`
    pub gap: f64,
}

impl TurningPoints {
    /// The turning points of an axis that moves, or can move.
    pub fn new(start: &Start) -> Self {
        let cubic = start.cubic();
        let (root, is_highest) = isolated(&cubic);
        let (from_start, from_zenith, gap) = if is_highest {
            start.below(root)
        } else {
            start.above(positive(-root))
        };
        let high = start.nadir + from_start[1];
        let third = start.couple.scaled(1) * start.nadir + from_start[2];
        let about = start.vertical + start.spin * start.nadir; // b + p
        let from_nadir = [over(about * about, high * third), high, third];
        Self {
            from_start: from_start.map(Twofold::value),
            from_nadir: from_nadir.map(Twofold::value),
            from_zenith: from_zenith.map(Twofold::value),
            gap: gap.value(),
        }
    }
}

/// Distances from the start and from 1, and the gap.
type Found = ([Twofold; 3], [Twofold; 3], Twofold);

impl Start {
    /// The slope of u'² over u.
    fn slope(&self) -> Twofold {
        let height = self.nadir - Twofold::from(1.0);
        let turning = self.spin * self.vertical - height * self.square;
        (turning - self.couple * self.nadir * self.zenith).scaled(1)
    }

    /// `c₀, c₁, c₂` of `4a² u'² = X³ + c₂ X² + c₁ X + c₀`, `X = 2a (u - u(0))`.
    fn cubic(&self) -> [Twofold; 3] {
        let twice = self.couple.scaled(1);
        let height = self.nadir - Twofold::from(1.0);
        let rise = twice * self.rise;
        let bend = twice.scaled(1) * height - self.square - self.spin * self.spin;
        [rise * rise, twice * self.slope(), bend]
    }

    /// From the highest root, `2a (u₃ - u(0))`: x² + 2 B x - x₁ x₂ = 0.
    fn below(&self, third: Twofold) -> Found {
        let twice = self.couple.scaled(1);
        let product = over(self.rise * self.rise, third);
        let linear = -over(twice * product + self.slope(), third);
        let [high, low] = opposite_roots(linear.scaled(-1), product);
        let first = self.zenith + low;
        let about = self.vertical - self.spin * self.zenith; // b - p
        let square = about * about;
        let (second, last) = (
            positive(self.zenith - high),
            positive(third - twice * self.zenith),
        );
        // the larger by its difference, the smaller by their product
        let from_zenith = if (twice * second).value() >= last.value() {
            [first, second, over(square, first * second)]
        } else {
            [first, over(square, first * last), last]
        };
        ([low, high, third], from_zenith, third - twice * high)
    }

    /// From the lowest root, `2a (u(0) - u₁)`: Y² + 2 B Y - Y₂ Y₃ = 0 with `Y = 2a (1 - u)`.
    fn above(&self, low: Twofold) -> Found {
        let twice = self.couple.scaled(1);
        let low = over(low, twice);
        let first = self.zenith + low;
        let about = self.vertical - self.spin * self.zenith; // b - p
        let product = over(about * about, first);
        // of the upright body, less that it has at rest
        let energy = self.square - twice * self.zenith;
        let linear = over((energy - self.spin * about).scaled(1) - product, first);
        let [second, last] = opposite_roots(linear.scaled(-1), twice * product);
        let gap = second + last;
        let second = over(second, twice);
        let from_start = [
            low,
            positive(self.zenith - second),
            last + twice * self.zenith,
        ];
        (from_start, [first, second, last], gap)
    }
}

/// The sizes of the positive and the negative root of `x² + 2 h x - product`.
fn opposite_roots(half: Twofold, product: Twofold) -> [Twofold; 2] {
    let root = (half * half + product).sqrt();
    if half.value() < 0.0 {
        let positive = root - half;
        [positive, over(product, positive)]
    } else {
        let negative = root + half;
        [over(product, negative), negative]
    }
}

/// The one of the three real roots of a cubic that lies apart from the two others, and whether it
/// is the highest. The roots are not all zero, and lie on both sides of zero. By the cosine of a
/// third of an angle, then Newton's method.
fn isolated(cubic: &[Twofold; 3]) -> (Twofold, bool) {
    let [c0, c1, c2] = cubic.map(Twofold::value);
    let center = -c2 / 3.0;
    let square = f64::max(0.0, (c2 * c2 - 3.0 * c1) / 9.0);
    let radius = math::sqrt(square);
    let value = ((center + c2) * center + c1) * center + c0;
    let ratio = -0.5 * value / (square * radius);
    let cosine = if square > 0.0 {
        ratio.clamp(-1.0, 1.0)
    } else {
        1.0
    };
    let is_highest = cosine >= 0.0;
    let third = math::acos(cosine) / 3.0;
    let angle = if is_highest {
        third
    } else {
        third + 2.0 * FRAC_PI_3
    };
    let mut root = Twofold::from(center + 2.0 * radius * math::cos(angle));
    for _ in 0..2 {
        let [x, c0, c1, c2] = [root, cubic[0], cubic[1], cubic[2]];
        let value = ((x + c2) * x + c1) * x + c0;
        let slope = ((x.scaled(1) + x + c2.scaled(1)) * x + c1).value();
        if slope != 0.0 {
            root = root - value / Twofold::from(slope);
        }
    }
    (root, is_highest)
}

/// A quotient; zero where the divisor is.
fn over(dividend: Twofold, divisor: Twofold) -> Twofold {
    if divisor.value() == 0.0 {
        Twofold::default()
    } else {
        dividend / divisor
    }
}

/// Rounding below zero is zero.
fn positive(number: Twofold) -> Twofold {
    if number.value() < 0.0 {
        Twofold::default()
    } else {
        number
    }
}
