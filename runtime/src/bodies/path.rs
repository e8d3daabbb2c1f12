//! Motions that are functions of time.

/// A motion in closed form: the state at any time.
///
/// ```
/// use newton_euler::exact::{Parabola, Path};
/// use newton_euler::prelude::*;
///
/// let stone = Parabola::<2> {
///     position: [0.0, 8.0].into(),
///     velocity: [1.0, 0.0].into(),
///     acceleration: [0.0, -4.0].into(),
/// };
/// let landed: PlanarTranslation = stone.at(2.0);
/// assert_eq!((landed.position.x, landed.position.y), (2.0, 0.0));
/// ```
pub trait Path {
    /// The kind of state.
    type State;

    /// The state at a time \[s\]; the path began at time zero, and negative times are before.
    fn at(&self, time: f64) -> Self::State;

    /// From a time on \[s\], or before it, a time in which the motion does not change its course
    /// more than a few times: about that of a radian; infinite where it never does.
    fn pace(&self, time: f64) -> f64;
}
