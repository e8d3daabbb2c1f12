//! Where a motion by Runge–Kutta steps is, and its last step.

use super::{RungeKutta, runge_kutta_step};

use crate::bodies::body::RigidBody;
use crate::bodies::switches::Stretch;
use crate::integrate::steps::point::Point;
use crate::integrate::steps::stretch::Within;
use crate::state::Coordinates;

/// The current point of a motion by Runge–Kutta steps, the start of the last step, and the stretch
/// of time that both are in.
pub(crate) struct Track<S: Coordinates<Scalar = f64>> {
    pub(crate) stretch: Stretch,
    pub(crate) now: Point<S>,
    /// The start of the last step.
    pub(crate) before: (f64, S::Array),
}

impl<S: Coordinates<Scalar = f64>> Track<S> {
    pub(in crate::integrate) fn new(time: f64, state: &S) -> Self {
        let now = Point::new(time, state);
        Self {
            stretch: Stretch::since(time),
            before: (time, now.coordinates),
            now,
        }
    }

    /// The state within the last step: the end of a shorter one from the same start.
    pub(in crate::integrate) fn within<P: RungeKutta, B>(
        &self,
        body: &B,
        time: f64,
        input: &B::Input,
    ) -> S
    where
        B: RigidBody<Scalar = f64, State = S>,
    {
        let (start, coordinates) = &self.before;
        let before = S::from_coordinates(coordinates);
        let within = Within::new(body, &self.stretch);
        runge_kutta_step::<P, _>(&within, *start, &before, input, time - start)
    }
}
