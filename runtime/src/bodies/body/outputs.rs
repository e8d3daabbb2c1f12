//! The outputs of a body beyond its acceleration, one trait for each.

use super::rigid_body::RigidBody;
use crate::bodies::path::Path;
use crate::state::State;

/// The terms of the balances (1.3) and (1.4); wrenches in world axes.
#[diagnostic::on_unimplemented(
    message = "`{Self}` has no `balance`",
    label = "add `balance` to its `outputs`"
)]
pub trait Balance: RigidBody {
    /// [`Wrench`](crate::wrench::Wrench), [`PlanarWrench`](crate::wrench::PlanarWrench) or, for
    /// `motion: rotation`, the moment alone.
    type Wrench;
    /// The unknown reactions; `()` if there are none.
    type Reactions;
    /// An array of [`Load`](crate::load::Load) or [`PlanarLoad`](crate::load::PlanarLoad).
    type Loads;

    /// The resultant of the given loads (all but unknown reactions), its moment about G, world axes
    /// \[N, N m\].
    fn applied(&self, time: Self::Scalar, state: &Self::State, input: &Self::Input)
    -> Self::Wrench;

    /// The left sides of (1.3) and (1.4), about the pole, world axes \[N, N m\]: zero on an actual
    /// motion.
    fn residual(
        &self,
        time: Self::Scalar,
        state: &Self::State,
        acceleration: &<Self::State as State>::Acceleration,
        reactions: &Self::Reactions,
        input: &Self::Input,
    ) -> Self::Wrench;

    /// Each given load separately.
    fn loads(&self, time: Self::Scalar, state: &Self::State, input: &Self::Input) -> Self::Loads;
}

/// Kinetic and potential energy \[J\].
///
/// Their sum is conserved if the potential contains neither time nor input and no other load does
/// work. In general dE/dt is the partial time derivative of the potential, plus the power of the
/// other loads, plus the slopes of the potential along user-defined states times their rates.
#[diagnostic::on_unimplemented(
    message = "`{Self}` has no `energy`",
    label = "add `energy` to its `outputs`",
    note = "if it depends on time or an input, the trait is `DrivenEnergy`"
)]
pub trait Energy: RigidBody {
    /// `½ m v² + ½ ω·Jω`, over the degrees of freedom of the motion.
    fn kinetic_energy(&self, state: &Self::State) -> Self::Scalar;

    /// The sum of potentials, including those of uniform fields. The weight has potential zero with
    /// G at the world origin.
    fn potential_energy(
        &self,
        time: Self::Scalar,
        state: &Self::State,
        input: &Self::Input,
    ) -> Self::Scalar;
}

/// Momenta of the absolute velocities, world axes.
///
/// About a pole O moving with `v_O`, the angular momentum obeys `dL_O/dt = M_O - v_O × P`.
#[diagnostic::on_unimplemented(
    message = "`{Self}` has no `momentum`",
    label = "add `momentum` to its `outputs`",
    note = "if it depends on time or an input, the trait is `DrivenMomentum`"
)]
pub trait Momentum: RigidBody {
    /// A vector in space or in the plane.
    type Linear;
    /// A vector, or in the plane a scalar.
    type Angular;

    /// `P = m v_G`, world axes \[kg m/s\]; of a system, the sum over its bodies.
    fn linear_momentum(&self, state: &Self::State) -> Self::Linear;

    /// Angular momentum about G, world axes \[kg m²/s\]; of a system, about the center of mass of the
    /// system.
    fn angular_momentum(&self, state: &Self::State) -> Self::Angular;

    /// Angular momentum about the pole, `L_O = L_G + (G - O) × P`, world axes \[kg m²/s\].
    fn angular_momentum_about_pole(&self, time: Self::Scalar, state: &Self::State)
    -> Self::Angular;
}

/// The loads of constraints on the body: the unknowns of (1.3) and (1.4).
///
/// With the motion known, the balances are linear in the unknown reactions R,
///
/// ```text
/// A R = b        A: the sum and the moments of unit reactions,
///                b = (m a_G, J ω̇ + ω × Jω) - given loads
/// ```
///
/// and `acceleration` has used the equations in the free directions; the others give the reactions.
/// If A depends on the configuration and may lose rank, [`Self::Reactions`] is a `Result` with
/// [`Singular`](super::Singular) as its error.
///
/// ```
/// use newton_euler::prelude::*;
/// use newton_euler::nalgebra::Vector2;
///
/// /// A bob of mass m at l below a pin, angle from the vertical.
/// struct Pendulum { mass: f64, length: f64 }
///
/// impl RigidBody for Pendulum {
///     type Scalar = f64;
///     type State = Hinge;
///     type Input = ();
///
///     fn acceleration(&self, _time: f64, state: &Hinge, (): &()) -> f64 {
///         -9.80665 / self.length * state.angle.sin()
///     }
/// }
///
/// impl Reactions for Pendulum {
///     /// The force of the pin on the body \[N\].
///     type Reactions = Vector2<f64>;
///
///     fn reactions(&self, _time: f64, state: &Hinge, (): &()) -> Vector2<f64> {
///         let (sine, cosine) = state.angle.sin_cos();
///         let tension =
///             self.mass * (9.80665 * cosine + self.length * state.angular_velocity.powi(2));
///         Vector2::new(-sine, cosine) * tension
///     }
/// }
///
/// let bob = Pendulum { mass: 2.0, length: 0.75 };
/// assert_eq!(bob.reactions(0.0, &Hinge::default(), &()).y, 2.0 * 9.80665);
/// ```
#[diagnostic::on_unimplemented(
    message = "`{Self}` has no `reactions`",
    label = "add `reactions` to its `outputs`"
)]
pub trait Reactions: RigidBody {
    /// One field for each load with unknowns, world axes \[N, N m\]; or a `Result` of that and
    /// [`Singular`](super::Singular).
    type Reactions;

    /// The reactions in the motion given by [`RigidBody::acceleration`], forces and moments in world
    /// axes. They do not depend on the pole of the balances.
    fn reactions(
        &self,
        time: Self::Scalar,
        state: &Self::State,
        input: &Self::Input,
    ) -> Self::Reactions;
}

/// Inverse dynamics, `outputs: [inverse]`: the drives that produce a given motion.
///
/// The force and moment balances, (1.3) and (1.4), with the acceleration given and the drives
/// unknown. The motion is assumed to be one that the drives can produce. Balances in which no drive
/// appears are ignored. If there are fewer drives than other balances, the remaining acceleration
/// is least in the metric of the kinetic energy (Gauss's principle). Given loads act as well: if a
/// joint has both a given drive and an open one, the open drive is the required load minus the given
/// drive.
#[diagnostic::on_unimplemented(
    message = "`{Self}` has no `inverse`",
    label = "add `inverse` to its `outputs`"
)]
pub trait Inverse: RigidBody {
    /// One field for each drive with unknown components, in the axes in which it is written \[N, N
    /// m\]; or a `Result` of that and [`Singular`](super::Singular), if drives rotate relative to
    /// each other.
    type Drives;

    /// The drives that produce this acceleration.
    fn inverse(
        &self,
        time: Self::Scalar,
        state: &Self::State,
        acceleration: &<Self::State as State>::Acceleration,
        input: &Self::Input,
    ) -> Self::Drives;
}

/// The loads that a motion requires, per inertial parameter, `outputs: [regressor]`: the equations
/// of motion are linear in mass, first moment and inertia.
///
/// ```text
/// Y (m, m c, J) = the given loads, except the weights
/// ```
///
/// A motion requires these loads on a body, in its axes, about one of its points P,
///
/// ```text
/// f = m a + (w' x + w x w x) m c               a: acceleration of P less that of free fall
/// n = m c x a + J w' + w x J w                 c: from P to the center of mass, J: about P
/// ```
///
/// (C. Atkeson, C. An, J. Hollerbach, "Estimation of inertial parameters of manipulator loads and
/// links", 1986.) P is G, the origin of points, or the held point; the given accelerations are
/// those of the description's G. In systems P is the point at which the joint that carries the body
/// holds it, or G for a free body. [`Self::PARAMETERS`] names the columns. J stands for the entries
/// of its matrix, so `J_xy` is minus the integral of xy.
///
/// | motion | rows | columns |
/// |---|---|---|
/// | `spatial` | force, moment, body axes \[N, N m\] | m \[kg\], m c \[kg m\], J \[kg m²\]: ten |
/// | `fixed_point`, `fixed_axis` | moment, body axes; about the axis | ten: that of m is zero |
/// | `rotation` | moment, body axes | J: six |
/// | `planar`, `pivot` | force, body axes, and moment; moment | m, m c in x and y, `J_zz` |
/// | `translation`, `planar_translation` | force | m |
/// | `rod` | force, moment, world axes | m, m c along the axis, J perpendicular to it |
/// | systems | for each body: N or N m along each rate, in the order of the acceleration's [`Columns`](crate::columns::Columns) | ten, in the plane four |
///
/// A weight, such as the field `mass * world(0, 0, -9.81[m / s ^ 2])`, is part of the rows: free
/// fall needs no other load. The rows are compared with all other loads. In systems, the sum over all
/// bodies equals drives and loads along each rate, minus the part of armatures. With closed loops or
/// written constraints, the constraint loads are among the loads. They do no work, so multiply the
/// rows by rates that the system can have.
///
/// The mass and inertia of the description may be any numbers: the rows do not depend on them. So a
/// field is a weight only as far as the compiler proves that its force is proportional to the mass:
///
/// - It is among the `fields` of a body or of a system, acts at G, is fixed in axes that do
///   not rotate, and does not depend on position, attitude or velocity. It may depend on time,
///   inputs and `states`.
/// - Its force is `mass * g + r`, where g depends on no mass and no inertia, nor on a parameter that
///   they are computed from. Then `mass * g` is part of the rows, and r is a load. If the force is
///   not linear in the mass, all of it is a load.
/// - `mass` and, in systems, `arm.mass` are the mass. With `mass: m`, so is the parameter `m`. With
///   `mass: m1 + m2`, `m1 * a + m2 * a` is proportional to it, and `m1 * a` alone is a load. With
///   `mass: m1 + 1[kg]`, `m1 * a` is `mass * a + r`, where r is the force `-1[kg] * a`.
/// - A number in place of the word says nothing of the mass: with `mass: 2[kg]`, `2[kg] * world(..)`
///   and `world(0, -19.62[N])` are loads. So is a force on a charge, `q * world(0, 1)`, and every
///   field `.on([..])` charges.
///
/// ```
/// use newton_euler::prelude::*;
///
/// rigid_body!(Pendulum {
///     motion: pivot(hinge),
///     mass: 2[kg],
///     inertia: 0.1[kg * m ^ 2],
///     points: [hinge = (0, 0.5)],
///     inputs: [torque[N * m]],
///     moments: [motor = torque],
///     fields: [weight = mass * world(0, -9.81[m / s ^ 2])],
///     outputs: [regressor],
/// });
///
/// let pendulum = Pendulum::default();
/// let (state, input) = (Hinge { angle: 0.3, angular_velocity: 2.0 }, PendulumInput { torque: 1.5 });
/// let acceleration = pendulum.acceleration(0.0, &state, &input);
/// let rows = pendulum.regressor(0.0, &state, &acceleration, &input);
/// let parameters = pendulum.inertial_parameters();
/// assert_eq!(Pendulum::PARAMETERS, ["m", "m c_x", "m c_y", "J_zz"]);
/// assert_eq!(parameters.as_slice(), [2.0, 0.0, -1.0, 0.1 + 2.0 * 0.25]);
/// assert!(((rows * parameters).x - 1.5).abs() < 1e-14);
/// ```
#[diagnostic::on_unimplemented(
    message = "`{Self}` has no `regressor`",
    label = "add `regressor` to its `outputs`"
)]
pub trait Regressor: RigidBody {
    /// A matrix; for a system a field with a matrix for each body.
    type Regressor;
    /// A column; for a system a field with a column for each body.
    type Parameters;

    /// The names of the inertial parameters, in the order of the columns.
    const PARAMETERS: &'static [&'static str];

    /// The load per unit of each parameter, in the motion with this acceleration.
    fn regressor(
        &self,
        time: Self::Scalar,
        state: &Self::State,
        acceleration: &<Self::State as State>::Acceleration,
        input: &Self::Input,
    ) -> Self::Regressor;

    /// The parameters of the description, about the same points.
    fn inertial_parameters(&self) -> Self::Parameters;
}

/// Motion in closed form, `outputs: [flow]`: the state at any time, in one step.
///
/// ```
/// use newton_euler::exact::Path;
/// use newton_euler::prelude::*;
///
/// rigid_body!(Brick {
///     motion: spatial,
///     mass: 2[kg],
///     inertia: principal(0.01, 0.02, 0.026),
///     fields: [weight = mass * world(0, 0, -9.80665[m / s ^ 2])],
///     outputs: [flow],
/// });
///
/// let thrown = Spatial {
///     velocity: [0.0, 1.0, 7.0].into(),
///     angular_velocity: [1.0, 15.0, 1.0].into(),
///     ..Spatial::default()
/// };
/// let brick = Brick::default();
/// let caught = brick.flow(&thrown, 1.4);
/// let (there, back) = (brick.path(&thrown), brick.path(&caught));
/// assert_eq!(there.at(1.4), caught);
/// assert!((back.at(-1.4).angular_velocity - thrown.angular_velocity).norm() < 1e-13);
/// ```
#[diagnostic::on_unimplemented(
    message = "`{Self}` has no `flow`",
    label = "add `flow` to its `outputs`"
)]
pub trait Flow: RigidBody {
    /// The type of a motion from one state.
    type Path: Path<State = Self::State>;

    /// The motion from a state, set up once for any number of times.
    fn path(&self, state: &Self::State) -> Self::Path;

    /// The state after a duration \[s\], which may be negative.
    fn flow(&self, state: &Self::State, duration: f64) -> Self::State {
        self.path(state).at(duration)
    }
}
