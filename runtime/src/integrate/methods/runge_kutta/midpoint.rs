//! The implicit midpoint rule, for long runs with large steps.

use super::{RungeKutta, change, moved, number};
use crate::bodies::body::RigidBody;
use crate::integrate::steps::equations::Equations;
use crate::numbers::scalar::Scalar;
use crate::state::{Coordinates, group};

/// The implicit midpoint rule, of order 2: `k = f(t + h/2, y + h k/2)`, `y₁ = y + h k`, for games
/// and other long runs with large steps.
///
/// It conserves every quadratic invariant, to rounding and for steps of any length. So a free body
/// keeps its kinetic energy and the magnitude of its angular momentum, and attitudes stay unit
/// without correction. Heights are quadratic in a quaternion, so a body in uniform fields keeps its
/// energy, including a top on its tip. For other conservative loads the energy error is bounded:
/// the rule is symmetric in time, and neither gains nor loses energy.
///
/// k is found by repeated evaluation until it no longer changes, and once more, so that the
/// remaining error does not accumulate over long runs: six times for steps of a hundredth of a
/// turn. If the iteration does not converge, in steps of about a third of a turn and more, the
/// result is NaN, which ends an integration with
/// [`StepTooLong`](crate::integrate::IntegrationError::StepTooLong): such a step is meaningless.
/// (E. Hairer, Ch. Lubich, G. Wanner, Geometric Numerical Integration, 2nd edition,
/// 2006, IV.2, V.1 and VIII.6.)
///
/// ```
/// use newton_euler::integrate::{Fixed, Midpoint};
/// use newton_euler::prelude::*;
///
/// rigid_body!(Brick {
///     motion: rotation,
///     inertia: principal(1, 2, 3)[kg * m ^ 2],
///     outputs: [energy],
/// });
///
/// let (brick, thrown) = (
///     Brick::default(),
///     Rotation { angular_velocity: [0.1, 3.0, 0.1].into(), ..Rotation::default() },
/// );
/// let frames = Fixed { method: Midpoint, step: 1.0 / 60.0 };
/// let end = brick.integrate(&thrown).method(frames).to(600.0)?;
/// let energy = |state| brick.kinetic_energy(state);
/// assert!((energy(&end) / energy(&thrown) - 1.0).abs() < 1e-13);
/// # Ok::<(), newton_euler::integrate::IntegrationError<Rotation>>(())
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Midpoint;

/// The limit of evaluations.
const EVALUATIONS: usize = 60;

impl RungeKutta for Midpoint {
    const ORDER: usize = 2;
    const IS_IMPLICIT: bool = true;

    #[cfg_attr(not(unoptimized), inline(always))]
    fn increment<B: RigidBody<Scalar: Scalar, State: Coordinates>>(
        equations: &Equations<'_, B>,
        time: B::Scalar,
        coordinates: &<B::State as Coordinates>::Array,
        step: B::Scalar,
    ) -> <B::State as Coordinates>::Array {
        let middle = time + step.constant(0.5, 0.5) * step;
        let mut rates = equations.rates(time, coordinates);
        let (mut is_near, mut is_found) = (step.less(step), step.less(step));
        for _ in 0..EVALUATIONS {
            let stage = moved::<B::State, _>(coordinates, step, [(0.5, &rates)]);
            let next = equations.rates(middle, &stage);
            let is_same = agree::<B::State>(coordinates, &rates, &next, step);
            // a converged value stays, whatever a neighboring lane still does
            for (rate, next) in rates.as_mut().iter_mut().zip(next.as_ref()) {
                *rate = B::Scalar::select(is_found, *rate, *next);
            }
            // a remaining error of rounding could have the same sign in every step
            is_found = is_near;
            is_near = is_near | is_same;
            if B::Scalar::agreed(is_found) == Some(true) {
                break;
            }
        }
        let lost = number(step, f64::NAN);
        let mut sum = change::<B::State, _>(step, [(1.0, &rates)]);
        for value in sum.as_mut() {
            *value = B::Scalar::select(is_found, *value, lost);
        }
        sum
    }
}

/// Whether two rates give the same step, to rounding of the coordinates of a group.
#[cfg_attr(not(unoptimized), inline(always))]
fn agree<S: Coordinates>(
    coordinates: &S::Array,
    rates: &S::Array,
    next: &S::Array,
    step: S::Scalar,
) -> <S::Scalar as Scalar>::Truth {
    let rounding = number(step, 4.0 * S::Scalar::EPSILON);
    let mut truth = step.equal(step);
    let (mut coordinates, mut rates) = (coordinates.as_ref(), rates.as_ref());
    let mut next = next.as_ref();
    for count in S::GROUPS {
        let lists = [&mut coordinates, &mut rates, &mut next];
        let [coordinates, rates, next] = lists.map(|list| group(list, *count));
        let (mut size, mut difference) = (S::Scalar::default(), S::Scalar::default());
        for ((y, k), l) in coordinates.iter().zip(rates).zip(next) {
            size = size + y.abs() + (step * *l).abs();
            difference += (step * (*l - *k)).abs();
        }
        truth = truth & difference.less_or_equal(rounding * size);
    }
    truth
}
