//! The quantities on which the accelerations of a body depend, known at compile time. Generic
//! integrators branch on them.
//!
//! An integrator for any [`RigidBody`] computes more than most bodies need.
//! [`Structured::STRUCTURE`] tells what a body does not need. It is a constant, so a branch on it
//! costs nothing:
//!
//! ```
//! use newton_euler::prelude::*;
//! use newton_euler::structure::{Structured, Symmetry};
//!
//! rigid_body!(Probe {
//!     motion: spatial,
//!     inputs: [thrust[N]],
//!     mass: 2[kg],
//!     inertia: principal(1.2, 1.2, 0.7)[kg * m ^ 2],
//!     forces: [engine = body(0, 0, thrust)],
//! });
//!
//! /// Whether position and velocity are sums over the sequence of attitudes.
//! fn is_quadrature<B: Structured>() -> bool {
//!     let [linear, angular] = [B::STRUCTURE.linear, B::STRUCTURE.angular];
//!     !(linear.position || linear.velocity || angular.position || angular.velocity)
//! }
//!
//! assert!(is_quadrature::<Probe>());
//! assert!(Probe::STRUCTURE.is_torque_free && Probe::STRUCTURE.keeps_spin);
//! assert_eq!(Probe::STRUCTURE.angular.body, Symmetry::About([0.0, 0.0, 1.0]));
//! assert_eq!(Probe::STRUCTURE.angular.world, Symmetry::Every);
//! ```
//!
//! # Savings
//!
//! Multiplications and additions of one evaluation before and after, for a body with an attitude
//! quaternion q:
//!
//! | change | condition on the structure | before, after |
//! |---|---|---|
//! | the attitude is not integrated | neither acceleration reads it, and it is not needed | 20, 0 |
//! | position and velocity are integrated last | neither acceleration reads them | 72, 36 in a whole Runge-Kutta step |
//! | `γ = Rᵀ e` replaces q | [`angular.world`](Dependence::world) about e | 34, 15 for the heavy symmetric top |
//! | axes that do not spin with the body | [`angular.body`](Dependence::body) about one axis, and [`keeps_spin`](Structure::keeps_spin) | 20, 12 products of series for the heavy symmetric top, and steps up to 2.4 times as long |
//! | a closed form | [`is_torque_free`](Structure::is_torque_free), [`linear`](Structure::linear) constant | no steps |
//!
//! Some changes of variables need no structure. Half the angular velocity as state,
//! `q' = q h`, saves three multiplications of 23 operations if there is an attitude. The
//! momentum as state, `L' = K - ω × L` with `ω = J⁻¹ L`, takes 27 operations instead of 40
//! if a tensor keeps its products of inertia. A scaled quaternion `s q`, with `s² = 2 T / m`,
//! rotates a constant force T along a body axis in 10 operations instead of 13. These changes suit
//! integrators that own the state from start to end.
//!
//! Of these, [`integrate::taylor`](crate::integrate::taylor) uses the axes that do not spin:
//! [`Axes`](crate::taylor::Axes). Quantities that are not read cost it no products anyway, and γ
//! saves none compared with q: its four products replace the four that rotate the weight.

use crate::bodies::body::RigidBody;

/// A body whose structure is known at compile time.
///
/// [`rigid_body!`](crate::rigid_body) implements it. An implementation by hand starts from
/// [`Structure::GENERAL`] and sets the known fields:
///
/// ```
/// use newton_euler::prelude::*;
/// use newton_euler::structure::{Dependence, Structure, Structured};
/// use newton_euler::nalgebra::Vector3;
///
/// struct Ball { drag: f64 }
///
/// impl RigidBody for Ball {
///     type Scalar = f64;
///     type State = Translation;
///     type Input = ();
///
///     fn acceleration(&self, _time: f64, state: &Translation, (): &()) -> Vector3<f64> {
///         state.velocity * -self.drag
///     }
/// }
///
/// impl Structured for Ball {
///     const STRUCTURE: Structure = Structure {
///         linear: Dependence { velocity: true, ..Dependence::NOTHING },
///         ..Structure::GENERAL
///     };
/// }
///
/// assert!(!Ball::STRUCTURE.linear.is_constant());
/// ```
pub trait Structured: RigidBody {
    /// The dependences of its accelerations; the same for all parameters.
    const STRUCTURE: Structure;
}

/// The structure of the accelerations of a body.
///
/// Every claim holds in all states, for all inputs and for all parameters; properties that are not
/// claimed may hold too. Nothing is claimed about the rates of user-defined states. An acceleration
/// that a motion lacks is zero: that of G under `rotation` and for a held point, the angular one
/// under `translation`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Structure {
    /// The dependence of the acceleration of G, world axes.
    pub linear: Dependence,
    /// The dependence of the angular acceleration, body axes; for a rod that of `u''`, world axes.
    pub angular: Dependence,
    /// The acceleration of G is zero. Then the path of G is `x + v t`.
    pub is_force_free: bool,
    /// No moment acts about G, or about the held point. Then the angular momentum about it
    /// is constant in space, and the motion has a closed form: elliptic functions, for a symmetric
    /// body [`precession`](crate::precession) (Landau and Lifshitz, *Mechanics*, §§ 33, 37; van Zon
    /// and Schofield, *J. Comput. Phys.* 225 (2007) 145).
    pub is_torque_free: bool,
    /// The angular velocity about the axis of [`angular.body`](Dependence::body), or about all
    /// axes, is constant. It is then no unknown, and in axes that do not spin with the body the
    /// gyroscopic term is linear in the other two components.
    pub keeps_spin: bool,
    /// The planes through the origin of the world in which a motion stays, for the normals x, y and
    /// z. If the body's axis lies along the world's, the position and the velocity of G are
    /// perpendicular to it and the angular velocity is along it, the accelerations are those of a
    /// planar motion. One angle then suffices, and no rounding leads out of the plane. Only for
    /// motions in space; for a rod, which has no rotating axes, the axis lies in the plane.
    pub planes: [bool; 3],
}

impl Structure {
    /// The structure of an unknown body.
    pub const GENERAL: Self = Self {
        linear: Dependence::ALL,
        angular: Dependence::ALL,
        is_force_free: false,
        is_torque_free: false,
        keeps_spin: false,
        planes: [false; 3],
    };
}

/// The quantities on which one acceleration depends.
///
/// A quantity that neither acceleration reads is not needed while the rest is integrated: it
/// follows by quadrature. An acceleration that reads nothing has a closed form.
#[allow(
    clippy::struct_excessive_bools,
    reason = "each quantity is read or not"
)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Dependence {
    /// It reads the time.
    pub time: bool,
    /// The position of G.
    pub position: bool,
    /// The velocity of G.
    pub velocity: bool,
    /// The attitude or the angle; for a rod its axis.
    pub attitude: bool,
    /// The angular velocity; for a rod the rate of its axis.
    pub angular_velocity: bool,
    /// The inputs.
    pub input: bool,
    /// User-defined states.
    pub states: bool,
    /// Directions e, world axes, about which the world may be rotated: if positions, velocities and
    /// attitude rotate about the line along e through the origin, with the same inputs and
    /// user-defined states, the acceleration rotates with them. Components in body axes do not
    /// change at all.
    ///
    /// With weight along -e alone, the angular acceleration reads only `γ = Rᵀ e` of the attitude,
    /// with `γ' = γ × ω`: three numbers instead of four, and the yaw follows by quadrature
    /// (Landau and Lifshitz, *Mechanics*, § 35).
    pub world: Symmetry,
    /// Directions e, body axes, about which the axes of the body may be rotated: the attitude is
    /// first rotated about e, and the components of angular velocity and angular acceleration are
    /// taken in the rotated axes. A linear acceleration, in world axes,
    /// does not change. None for a rod and a hinge, which have no such axes.
    ///
    /// The body may then be described in axes that do not spin with it about e, in which all
    /// quantities change more slowly: see [`Axes`](crate::taylor::Axes).
    pub body: Symmetry,
}

impl Dependence {
    /// Reads nothing and has every symmetry: the dependence of zero.
    pub const NOTHING: Self = Self {
        time: false,
        position: false,
        velocity: false,
        attitude: false,
        angular_velocity: false,
        input: false,
        states: false,
        world: Symmetry::Every,
        body: Symmetry::Every,
    };

    /// Reads everything and has no symmetry.
    pub const ALL: Self = Self {
        time: true,
        position: true,
        velocity: true,
        attitude: true,
        angular_velocity: true,
        input: true,
        states: true,
        world: Symmetry::None,
        body: Symmetry::None,
    };

    /// Whether nothing is read: the value is the same at all times, in all states and for all
    /// inputs.
    ///
    /// ```
    /// use newton_euler::structure::Dependence;
    ///
    /// assert!(Dependence::NOTHING.is_constant());
    /// assert!(!Dependence { time: true, ..Dependence::NOTHING }.is_constant());
    /// ```
    #[must_use]
    pub const fn is_constant(&self) -> bool {
        !(self.time
            || self.position
            || self.velocity
            || self.attitude
            || self.angular_velocity
            || self.input
            || self.states)
    }
}

/// Directions about which a rotation changes nothing. Two such directions imply all.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Symmetry {
    /// No direction.
    None,
    /// One direction, a unit vector; its first nonzero component is positive.
    About([f64; 3]),
    /// Every direction.
    Every,
}
