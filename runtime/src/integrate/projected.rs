//! CF4 for bodies under constraints: each step ends on them.

use core::ops::Range;

use crate::constrained::{Constrained, Inconsistent};

use super::commutator_free::cf4_step;
use super::exact;

/// As [`cf4`](super::cf4), with [`Constrained::project`] before the first step and at the end of each: what the constraints
/// forbid does not grow, and the order is that of CF4.
///
/// # Errors
/// [`Inconsistent`] if a state is too far from its constraints: the first, or one after a step that is too long.
///
/// # Panics
/// In configurations in which the constraints do not determine their reactions.
pub fn cf4_projected<B: Constrained<Scalar = f64>>(
    body: &B,
    state: &B::State,
    input: &B::Input,
    times: Range<f64>,
    steps: usize,
) -> Result<B::State, Inconsistent> {
    let step = (times.end - times.start) / exact(steps);
    let mut state = state.clone();
    body.project(times.start, &mut state, input)?;
    for k in 0..steps {
        let time = times.start + exact(k) * step;
        state = cf4_step(body, time, &state, input, step);
        body.project(times.start + exact(k + 1) * step, &mut state, input)?;
    }
    Ok(state)
}
