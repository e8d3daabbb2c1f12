//! How long a step the last coefficients of its series permit.

use super::Motion;
use crate::integrate::steps::size::{relative_size, root};
use crate::taylor::Taylor;

/// How much of the permitted step is taken: roots are known to a few parts in a hundred.
const SAFETY: f64 = 0.9;
/// A step that is longer than the one before by more than this is looked at twice.
pub(super) const GROWTH: f64 = 1.5;

impl<B: Taylor, const N: usize> Motion<'_, B, N> {
    /// The longest step of which the last two terms are below `tolerance`.
    ///
    /// They may vanish, or nearly, where the series goes on: cos t² has every fourth term. A step
    /// that grows is therefore held against the terms before as well, which tell the same radius.
    #[inline(always)]
    pub(super) fn permitted(&self, tolerance: f64) -> f64 {
        let (last, before) = (
            self.within_order(N - 1, tolerance),
            self.within_order(N - 2, tolerance),
        );
        let step = SAFETY * if last <= before { last } else { before };
        if step > GROWTH * self.length {
            self.within_radius(step, tolerance)
        } else {
            step
        }
    }

    /// The step of which the term of this order is as large as `tolerance`.
    #[inline(always)]
    fn within_order(&self, order: usize, tolerance: f64) -> f64 {
        let size = self.relative(order);
        if size == 0.0 {
            f64::INFINITY
        } else {
            root(tolerance, size, order)
        }
    }

    /// A step, or what the radius of convergence leaves of it by the upper half of the orders.
    #[cold]
    fn within_radius(&self, step: f64, tolerance: f64) -> f64 {
        let share = SAFETY * root(tolerance, 1.0, N - 1);
        let radii = (N / 2..N - 2).filter_map(|order| {
            let size = self.relative(order);
            (size > 0.0 && order > 0).then(|| share / root(size, 1.0, order))
        });
        radii.fold(
            step,
            |step, radius| if radius < step { radius } else { step },
        )
    }

    /// The size of a coefficient beside the state.
    #[inline(always)]
    fn relative(&self, order: usize) -> f64 {
        let coefficients = self.expansions.series().coefficients();
        relative_size::<B::State>(&coefficients[order], &coefficients[0])
    }
}
