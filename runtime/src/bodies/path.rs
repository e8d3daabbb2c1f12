//! Motions as functions of time.

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
pub trait Path: Send {
    /// The type of the state.
    type State;

    /// The state at a time \[s\]. The path begins at time zero and extends to negative times.
    fn at(&self, time: f64) -> Self::State;

    /// A time span near a time \[s\] in which the motion changes its course only a few times:
    /// about the time of one radian; infinite if it never does.
    fn pace(&self, time: f64) -> f64;
}
