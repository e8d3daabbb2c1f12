//! A body whose motion is determined.

use crate::bodies::body::invalid::InvalidBody;
use crate::bodies::switches::Switches;
use crate::state::State;

/// A rigid body whose motion is determined: time, state and input give one acceleration.
///
/// ```
/// use newton_euler::prelude::*;
/// use newton_euler::nalgebra::Vector3;
///
/// /// A body that falls through still air.
/// struct Ball { mass: f64, drag: f64 }
///
/// impl RigidBody for Ball {
///     type Scalar = f64;
///     type State = Translation;
///     type Input = ();
///
///     fn acceleration(&self, _time: f64, state: &Translation, (): &()) -> Vector3<f64> {
///         Vector3::new(0.0, 0.0, -9.80665) - state.velocity * (self.drag / self.mass)
///     }
/// }
///
/// let ball = Ball { mass: 0.5, drag: 0.1 };
/// assert_eq!(ball.acceleration(0.0, &Translation::default(), &()).z, -9.80665);
/// ```
pub trait RigidBody {
    /// The number type.
    type Scalar;
    /// The coordinates and velocities of the motion.
    type State: State<Scalar = Self::Scalar>;
    /// The quantities given at each evaluation, such as controls; the default is zero.
    type Input: Default;

    /// Whether its mass or inertia change. If so, integration calls [`possible`](Self::possible) at
    /// the beginning and the end of each step.
    const CHANGES: bool = false;

    /// The acceleration: of G in world axes \[m/s²\], angular in body axes \[rad/s²\].
    fn acceleration(
        &self,
        time: Self::Scalar,
        state: &Self::State,
        input: &Self::Input,
    ) -> <Self::State as State>::Acceleration;

    /// Reports the times at which the equations change by a condition on time, such as the start
    /// and the end of a pulse. Steps of [`integrate`](crate::integrate::Integrate::integrate) end
    /// there, and each step uses the equations of its own side. By default there are none;
    /// [`rigid_body!`](crate::rigid_body) finds the conditions of a description.
    ///
    /// ```
    /// use newton_euler::{integrate::Switches, prelude::*};
    /// use newton_euler::nalgebra::Vector2;
    ///
    /// struct Kicked { at: f64 }
    ///
    /// impl RigidBody for Kicked {
    ///     type Scalar = f64;
    ///     type State = PlanarTranslation;
    ///     type Input = ();
    ///
    ///     fn acceleration(&self, time: f64, _: &PlanarTranslation, (): &()) -> Vector2<f64> {
    ///         let is_kicked = time >= self.at && time < self.at + 0.01;
    ///         Vector2::new(if is_kicked { 500.0 } else { 0.0 }, 0.0)
    ///     }
    ///
    ///     fn switches(&self, (): &(), times: &mut Switches) {
    ///         times.at(self.at);
    ///         times.at(self.at + 0.01);
    ///     }
    /// }
    ///
    /// impl Integrate for Kicked {
    ///     type Best = newton_euler::integrate::RungeKuttaPair;
    /// }
    ///
    /// let end = Kicked { at: 50.0 }.integrate(&PlanarTranslation::default()).to(100.0)?;
    /// assert!((end.velocity.x - 5.0).abs() < 1e-12);
    /// # Ok::<(), newton_euler::integrate::IntegrationError<PlanarTranslation>>(())
    /// ```
    fn switches(&self, _input: &Self::Input, _times: &mut Switches) {}

    /// The name of a load that is infinite or NaN in this state, for the error of an integration.
    /// `None` by default; a body of [`rigid_body!`](crate::rigid_body) names the loads that it can
    /// identify.
    fn lost_load(
        &self,
        _time: Self::Scalar,
        _state: &Self::State,
        _input: &Self::Input,
    ) -> Option<&'static str> {
        None
    }

    /// Whether a body can have the mass and the inertia of this state. By default it always can. An
    /// implementation that can fail also sets [`CHANGES`](Self::CHANGES).
    /// [`rigid_body!`](crate::rigid_body) and [`rigid_system!`](crate::rigid_system) implement it
    /// for changing bodies, and the error of an integration names the property that became
    /// impossible.
    ///
    /// # Errors
    /// [`InvalidBody`]: no body has this mass or inertia.
    fn possible(
        &self,
        _time: Self::Scalar,
        _state: &Self::State,
        _input: &Self::Input,
    ) -> Result<(), InvalidBody> {
        Ok(())
    }

    /// The input some time \[s\] after it was given, if a part of it moves: a value given with its
    /// rate and acceleration continues with them. `None` by default: inputs are held.
    fn input_after(&self, _input: &Self::Input, _duration: Self::Scalar) -> Option<Self::Input> {
        None
    }
}
