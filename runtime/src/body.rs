//! What a rigid body answers: its acceleration, its balance, its reactions, its energy, its momenta, its motion.
//!
//! [`rigid_body!`](crate::rigid_body) implements these traits; by hand they are implemented just as well.
//!
//! The balance is D'Alembert's: loads of the four families and the inertial load sum to zero,
//!
//! ```text
//! (1.3)  Σ R_v + Σ F_s + Σ F_ext + Σ F_f + F_iG = 0
//! (1.4)  Σ (P - O) × (R_v, F_s, F_ext, F_f) + (G - O) × F_iG + Σ M_v + Σ M_s + Σ M_ext + Σ M_f + M_i = 0
//! ```
//!
//! with `F_iG = -m a_G`, and `M_i` of the completed (1.9): see [`gyroscopic`](crate::gyroscopic). The pole O is any point,
//! moving in any way: (1.4) is an identity between vectors at one instant and has no term in its velocity. Where the
//! source prints (1.4), the second sum has `R_s` for `F_s`: a misprint, no such symbol exists.

use core::fmt;

use crate::exact::Path;
use crate::inertia::InvalidInertia;
use crate::integrate::Switches;
use crate::state::State;

/// A rigid body whose motion is determined: given time, state and input, it has one acceleration.
///
/// ```
/// use newton_euler::prelude::*;
/// use nalgebra::Vector3;
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
    /// The coordinates and velocities that this motion has.
    type State: State<Scalar = Self::Scalar>;
    /// What is given anew at each evaluation, such as controls; the default is zero.
    type Input: Default;

    /// The acceleration: of G in world axes \[m/s²\], angular in body axes \[rad/s²\].
    fn acceleration(
        &self,
        time: Self::Scalar,
        state: &Self::State,
        input: &Self::Input,
    ) -> <Self::State as State>::Acceleration;

    /// Tells the times at which the equations change by a condition on time, such as the start and the end of a pulse: steps of
    /// [`integrate`](crate::integrate::Integrate::integrate) end there, and each is taken with the equations of its own side. None, unless it
    /// is said here; [`rigid_body!`](crate::rigid_body) finds the conditions of a description.
    ///
    /// ```
    /// use newton_euler::{integrate::Switches, prelude::*};
    /// use nalgebra::Vector2;
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
    ///     type Best = newton_euler::integrate::DormandPrince;
    /// }
    ///
    /// let end = Kicked { at: 50.0 }.integrate(&PlanarTranslation::default()).to(100.0)?;
    /// assert!((end.velocity.x - 5.0).abs() < 1e-12);
    /// # Ok::<(), newton_euler::integrate::IntegrationError<PlanarTranslation>>(())
    /// ```
    fn switches(&self, _input: &Self::Input, _times: &mut Switches) {}

    /// The name of a load that is infinite or not a number in this state, which is what the error of an integration says. None, unless it is said here:
    /// a body of [`rigid_body!`](crate::rigid_body) names those that it can tell.
    fn lost_load(
        &self,
        _time: Self::Scalar,
        _state: &Self::State,
        _input: &Self::Input,
    ) -> Option<&'static str> {
        None
    }

    /// The input some time \[s\] after it was given, if a part of it moves: a value with its rate and acceleration goes on with them. None, unless it
    /// is said here: inputs are held.
    fn input_after(&self, _input: &Self::Input, _duration: Self::Scalar) -> Option<Self::Input> {
        None
    }
}

/// The balances (1.3) and (1.4), open to inspection; wrenches in world axes.
pub trait Balance: RigidBody {
    /// [`Wrench`](crate::wrench::Wrench), [`PlanarWrench`](crate::wrench::PlanarWrench) or, for `motion: rotation`, the
    /// moment alone.
    type Wrench;
    /// The unknown reactions; `()` where there are none.
    type Reactions;
    /// An array of [`Load`](crate::load::Load) or [`PlanarLoad`](crate::load::PlanarLoad).
    type Loads;

    /// The resultant of the given loads (all but unknown reactions), its moment about G, world axes \[N, N m\].
    fn applied(&self, time: Self::Scalar, state: &Self::State, input: &Self::Input)
    -> Self::Wrench;

    /// The left sides of (1.3) and (1.4), about the pole, world axes \[N, N m\]: zero on a true motion.
    fn residual(
        &self,
        time: Self::Scalar,
        state: &Self::State,
        acceleration: &<Self::State as State>::Acceleration,
        reactions: &Self::Reactions,
        input: &Self::Input,
    ) -> Self::Wrench;

    /// Each given load by itself.
    fn loads(&self, time: Self::Scalar, state: &Self::State, input: &Self::Input) -> Self::Loads;
}

/// Kinetic and potential energy \[J\].
///
/// Their sum is conserved if the potential contains neither time nor input and no other load does work; in general
/// dE/dt is the derivative of the potential in time at fixed state, plus the power of the other loads.
pub trait Energy: RigidBody {
    /// `½ m v² + ½ ω·Jω`, of the degrees of freedom that the motion has.
    fn kinetic_energy(&self, state: &Self::State) -> Self::Scalar;

    /// The sum of potentials and of the potentials of uniform fields; zero for weight with G at the world origin.
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
pub trait Momentum: RigidBody {
    /// A vector in space or in the plane.
    type Linear;
    /// A vector, or in the plane a scalar.
    type Angular;

    /// `P = m v_G` \[kg m/s\].
    fn linear_momentum(&self, state: &Self::State) -> Self::Linear;

    /// Angular momentum about G \[kg m²/s\].
    fn angular_momentum(&self, state: &Self::State) -> Self::Angular;

    /// Angular momentum about the pole, `L_O = L_G + (G - O) × P` \[kg m²/s\].
    fn angular_momentum_about_pole(&self, time: Self::Scalar, state: &Self::State)
    -> Self::Angular;
}

/// The loads that constraints put on the body: the unknowns of (1.3) and (1.4).
///
/// With the motion known, the balances are linear in the unknown reactions R,
///
/// ```text
/// A R = b        A: the sum and the moments of unit reactions,   b = (m a_G, J ω̇ + ω × Jω) - given loads
/// ```
///
/// and `acceleration` has used up the equations in the free directions; the rest gives the reactions. Where A depends on
/// the configuration and may lose rank in it, [`Self::Reactions`] is a `Result` with [`Singular`] as its error.
///
/// ```
/// use newton_euler::prelude::*;
/// use nalgebra::Vector2;
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
///         let tension = self.mass * (9.80665 * cosine + self.length * state.angular_velocity.powi(2));
///         Vector2::new(-sine, cosine) * tension
///     }
/// }
///
/// let bob = Pendulum { mass: 2.0, length: 0.75 };
/// assert_eq!(bob.reactions(0.0, &Hinge::default(), &()).y, 2.0 * 9.80665);
/// ```
pub trait Reactions: RigidBody {
    /// One field for each load with unknowns, world axes \[N, N m\]; or a `Result` of that and [`Singular`].
    type Reactions;

    /// The reactions in the motion that [`RigidBody::acceleration`] gives. About which pole the balances are written does
    /// not matter.
    fn reactions(
        &self,
        time: Self::Scalar,
        state: &Self::State,
        input: &Self::Input,
    ) -> Self::Reactions;
}

/// Inverse dynamics, `outputs: [inverse]`: the drives that go with a given motion.
///
/// The force and moment balances, (1.3) and (1.4), with the acceleration given and the drives unknown. The motion is taken to
/// be one that the drives can make: a balance in which they have no part is not looked at, and where they are fewer than
/// the others, the acceleration that they leave over is least in the metric of the kinetic energy (Gauss's principle).
pub trait Inverse: RigidBody {
    /// One field for each drive with unknown components, in the axes in which it is written \[N, N m\]; or a `Result` of
    /// that and [`Singular`], where drives turn against each other.
    type Drives;

    /// The drives with which the body has this acceleration.
    fn inverse(
        &self,
        time: Self::Scalar,
        state: &Self::State,
        acceleration: &<Self::State as State>::Acceleration,
        input: &Self::Input,
    ) -> Self::Drives;
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
/// let thrown = Spatial { velocity: [0.0, 1.0, 7.0].into(), angular_velocity: [1.0, 15.0, 1.0].into(), ..Spatial::default() };
/// let brick = Brick::default();
/// let caught = brick.flow(&thrown, 1.4);
/// let (there, back) = (brick.path(&thrown), brick.path(&caught));
/// assert_eq!(there.at(1.4), caught);
/// assert!((back.at(-1.4).angular_velocity - thrown.angular_velocity).norm() < 1e-13);
/// ```
pub trait Flow: RigidBody {
    /// The motion from one state on.
    type Path: Path<State = Self::State>;

    /// The motion from a state on, set up once for any number of times.
    fn path(&self, state: &Self::State) -> Self::Path;

    /// The state after a duration \[s\], which may be negative.
    fn flow(&self, state: &Self::State, duration: f64) -> Self::State {
        self.path(state).at(duration)
    }
}

/// A configuration in which the balances do not determine what is asked.
///
/// Solving them divides by a quantity that depends on the configuration and vanishes in this one, such as the sine of the
/// angle between two guides: there its load is undetermined, or grows beyond bounds.
///
/// ```
/// use newton_euler::body::Singular;
///
/// let toggle = Singular { unknown: "knee.normal", value: 1e-17, scale: 0.8 };
/// assert_eq!(
///     toggle.to_string(),
///     "singular configuration: the divisor of `knee.normal` is 1e-17, nothing but rounding of terms of size 0.8",
/// );
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Singular {
    /// The unknown that a division would have given.
    pub unknown: &'static str,
    /// Its divisor.
    pub value: f64,
    /// The largest of the terms it was summed from.
    pub scale: f64,
}

impl Singular {
    /// A divisor not above this fraction of its largest term is singular: eight units in the last place, which a sum of a
    /// few rounded products may leave of zero. What is above has lost digits in proportion, but is determined.
    pub const TOLERANCE: f64 = 8.0 * f64::EPSILON;
}

impl fmt::Display for Singular {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self {
            unknown,
            value,
            scale,
        } = self;
        write!(
            f,
            "singular configuration: the divisor of `{unknown}` is {value:e}, nothing but rounding of terms of size {scale}"
        )
    }
}

impl core::error::Error for Singular {}

/// Why a body cannot be built from these parameters.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum InvalidBody {
    /// A parameter is infinite or not a number.
    NotFinite {
        /// Its name in the description.
        name: &'static str,
        /// What was given.
        value: f64,
    },
    /// The mass is not a positive finite number.
    Mass {
        /// What was given \[kg\].
        value: f64,
    },
    /// The moment of inertia `J_G` of a planar body or of a rod is not a positive finite number.
    PlanarInertia {
        /// What was given \[kg m²\].
        value: f64,
    },
    /// No body that can turn has this inertia tensor.
    Inertia(InvalidInertia),
}

impl fmt::Display for InvalidBody {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::NotFinite { name, value } => write!(f, "`{name}` must be finite, is {value}"),
            Self::Mass { value } => write!(f, "mass must be positive and finite, is {value} kg"),
            Self::PlanarInertia { value } => {
                write!(f, "inertia must be positive and finite, is {value} kg m²")
            }
            Self::Inertia(error) => write!(f, "impossible inertia: {error}"),
        }
    }
}

impl core::error::Error for InvalidBody {
    fn source(&self) -> Option<&(dyn core::error::Error + 'static)> {
        match self {
            Self::Inertia(error) => Some(error),
            _ => None,
        }
    }
}

impl From<InvalidInertia> for InvalidBody {
    fn from(error: InvalidInertia) -> Self {
        Self::Inertia(error)
    }
}
