//! The rotation while the spin reverses, where λ is small.
//!
//! In the unit `√b` of rates, `R' = R (i g + k τ/2)` with `g = w/(2 √b)` and τ = u. The
//! coefficients of its Taylor series have a recurrence of three terms. R is one at τ = 0, and
//! series continue from there. `R(-τ) = k* R(τ) k`.

use nalgebra::Quaternion;

use super::sweep::{Place, Sweep};
use crate::mechanics::attitude;
use crate::numbers::math;
use crate::numbers::twofold::Twofold;

/// |τ| up to which series are used: beyond it `ε = b/λ²` is at most 1/81.
const REACH: f64 = 9.0;
/// The number of points from zero to there.
const NODES: usize = 10;

/// R at whole τ.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Reversal {
    /// √b
    unit: Twofold,
    /// g
    across: f64,
    nodes: [Quaternion<f64>; NODES],
}

impl Reversal {
    /// None if λ is never small.
    pub fn new(sweep: &Sweep) -> Option<Self> {
        let unit = sweep.rate.sqrt();
        let across = 0.5 * sweep.across.value() / unit.value();
        (2.0 * across < REACH).then(|| {
            let mut nodes = [Quaternion::identity(); NODES];
            let (mut node, mut along) = (Quaternion::identity(), 0.0);
            for next in &mut nodes[1..] {
                for _ in 0..2 {
                    node = advanced(&node, across, along, 0.5);
                    along += 0.5;
                }
                *next = node;
            }
            Self {
                unit,
                across,
                nodes,
            }
        })
    }

    /// The start and the end of the reversal.
    pub fn edges(&self) -> [Twofold; 2] {
        [-REACH, REACH].map(|edge| self.unit * Twofold::from(edge))
    }

    /// Whether a point is within its edges.
    pub fn holds(&self, place: &Place) -> bool {
        place.along.value().abs() < REACH * self.unit.value()
    }

    /// R at a point that is not beyond its edges.
    pub fn at(&self, place: &Place) -> Quaternion<f64> {
        let is_before = place.along.value() < 0.0;
        let along = if is_before { -place.along } else { place.along } / self.unit;
        let nearest = math::floor(along.value() + 0.5).clamp(0.0, REACH);
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "a small whole number"
        )]
        let node = &self.nodes[(nearest as usize).min(NODES - 1)];
        // τ in twice the precision: far from zero, R rotates by many radians per unit
        let rest = (along - Twofold::from(nearest)).value();
        let r = advanced(node, self.across, nearest, rest);
        if is_before {
            Quaternion::new(r.w, -r.i, -r.j, r.k)
        } else {
            r
        }
    }
}

/// From R at τ to R at `τ + x`. With `Rₙ xⁿ` its terms,
/// `(n + 1) Rₙ₊₁ = Rₙ (i g + k τ/2) + Rₙ₋₁ k/2`.
fn advanced(start: &Quaternion<f64>, across: f64, along: f64, x: f64) -> Quaternion<f64> {
    let (g, h, half) = (across * x, 0.5 * along * x, 0.5 * x * x);
    let (mut before, mut term, mut sum) = (Quaternion::default(), *start, *start);
    for n in 1..=40 {
        let share = 1.0 / f64::from(n);
        let next = turned(&term, &before, [g * share, h * share, half * share]);
        (before, term) = (term, next);
        sum += term;
        if term.coords.amax() + before.coords.amax() < 1e-18 {
            break;
        }
    }
    attitude::normalized(&sum).into_inner()
}

/// `q (i g + k h) + p k f`
fn turned(q: &Quaternion<f64>, p: &Quaternion<f64>, [g, h, f]: [f64; 3]) -> Quaternion<f64> {
    Quaternion::new(
        -q.i * g - (q.k * h + p.k * f),
        q.w * g + (q.j * h + p.j * f),
        q.k * g - (q.i * h + p.i * f),
        -q.j * g + (q.w * h + p.w * f),
    )
}
