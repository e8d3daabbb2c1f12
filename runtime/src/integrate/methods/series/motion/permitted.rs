//! The step length that the last coefficients of a series permit.

use super::Along;
use crate::integrate::steps::size::{relative_size, root};
use crate::taylor::Taylor;

/// The fraction of the permitted step that is taken: roots are accurate to a few percent.
const SAFETY: f64 = 0.9;
/// A step that exceeds the previous one by more than this factor is checked twice.
pub(super) const GROWTH: f64 = 1.5;

impl<B: Taylor, const N: usize> Along<B, N> {
    /// The longest step whose last two terms are below `tolerance`.
    ///
    /// They may vanish, or nearly, although the series continues: cos t² has every fourth term. A
    /// step that grows is therefore also compared with earlier terms, which give the same radius.
    #[cfg_attr(not(unoptimized), inline(always))]
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

    /// The step at which the term of this order is as large as `tolerance`.
    #[cfg_attr(not(unoptimized), inline(always))]
    fn within_order(&self, order: usize, tolerance: f64) -> f64 {
        let size = self.relative(order);
        if size == 0.0 {
            f64::INFINITY
        } else {
            root(tolerance, size, order)
        }
    }

    /// A step, limited by the radius of convergence estimated from the upper half of the orders.
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

    /// The size of a coefficient relative to the state.
    #[cfg_attr(not(unoptimized), inline(always))]
    fn relative(&self, order: usize) -> f64 {
        let coefficients = self.expansions.series().coefficients();
        relative_size::<B::State>(&coefficients[order], &coefficients[0])
    }
}
