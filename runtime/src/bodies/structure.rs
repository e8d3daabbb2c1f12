//! What the accelerations of a body depend on, known at compile time: what generic integrators
//! branch on.
//!
//! An integrator for any [`RigidBody`] computes more than most bodies need.
//! [`Structured::STRUCTURE`] says what a body does not need; since it is a constant, a branch on it
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
//! /// Whether position and velocity are sums of what the attitude passes through.
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
//! # What it pays for
//!
//! Multiplications and additions of one evaluation before and after, of a body with an attitude
//! quaternion q:
//!
//! | what is done otherwise | for which structures | before, after |
//! |---|---|---|
//! | the attitude is not integrated | neither acceleration reads it, and nobody asks for it | 20, 0 |
//! | position and velocity are integrated after all else | neither acceleration reads them | 72, 36 in a whole Runge-Kutta step |
//! | `γ = Rᵀ e` in the place of q | [`angular.world`](Dependence::world) about e | 34, 15 for the heavy symmetric top |
//! | axes that do not spin with the body | [`angular.body`](Dependence::body) about one axis, and [`keeps_spin`](Structure::keeps_spin) | 20, 12 products of series for the heavy symmetric top, and steps up to 2.4 times as long |
//! | a closed form | [`is_torque_free`](Structure::is_torque_free), [`linear`](Structure::linear) constant | no steps |
//!
//! Some changes of variables need nothing of the structure. Half the angular velocity as state,
//! `q' = q h`, saves three multiplications of 23 operations wherever there is an attitude. The
//! momentum as state, `L' = K - ω × L` with `ω = J⁻¹ L`, takes 27 operations in the place of 40
//! where a tensor keeps its products of inertia. A scaled quaternion `s q`, with `s² = 2 T / m`,
//! turns a constant force T along one axis of the body in 10 operations, not 13. They are for
//! integrators that own the state from one end to the other.
//!
//! Of these, [`integrate::taylor`](crate::integrate::taylor) takes the axes that do not spin:
//! [`Axes`](crate::taylor::Axes). What is not read costs it no products as it is, and γ none fewer
//! than q: its four replace the four that turn the weight.

use crate::bodies::body::RigidBody;

/// A body whose structure is known at compile time.
///
/// [`rigid_body!`](crate::rigid_body) implements it. By hand, what is known replaces what is not:
///
/// ```
/// use newton_euler::prelude::*;
/// use newton_euler::structure::{Dependence, Structure, Structured};
/// use nalgebra::Vector3;
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
    /// What its accelerations depend on; the same for all its parameters.
    const STRUCTURE: Structure;
}

/// The structure of the accelerations of a body.
///
/// All that it says holds in every state, for all inputs and for all parameters; what it does not
/// say may hold too. Of the rates of states of one's own it says nothing. A motion's missing acceleration is zero: that of G under `rotation` and where
/// a point is held, the angular one under `translation`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Structure {
    /// What the acceleration of G depends on, world axes.
    pub linear: Dependence,
    /// What the angular acceleration depends on, body axes; of a rod `u''`, world axes.
    pub angular: Dependence,
    /// The acceleration of G is zero. Then the path of G is `x + v t`.
    pub is_force_free: bool,
    /// No moment acts about G, or about the point that is held. Then the angular momentum about it
    /// is constant in space, and the motion has a closed form: elliptic functions, for a symmetric
    /// body [`precession`](crate::precession) (Landau and Lifshitz, *Mechanics*, §§ 33, 37; van Zon
    /// and Schofield, *J. Comput. Phys.* 225 (2007) 145).
    pub is_torque_free: bool,
    /// The angular velocity about the axis of [`angular.body`](Dependence::body), or about all, is
    /// constant. It is no unknown then, and in axes that do not spin with the body the gyroscopic
    /// term is linear in the other two.
    pub keeps_spin: bool,
    /// In which planes through the origin of the world a motion stays. For x, y and z: if the
    /// body's axis is along the world's, the position and the velocity of G perpendicular to it and
    /// the angular velocity along it, the accelerations are those of a motion in the plane. One
    /// angle is enough for it, and no rounding takes it out of the plane. Of motions in space; of a
    /// rod, which has no axes that turn, the axis lies in the plane.
    pub planes: [bool; 3],
}

impl Structure {
    /// Of a body of which nothing is known.
    pub const GENERAL: Self = Self {
        linear: Dependence::ALL,
        angular: Dependence::ALL,
        is_force_free: false,
        is_torque_free: false,
        keeps_spin: false,
        planes: [false; 3],
    };
}

/// What one acceleration depends on.
///
/// What neither acceleration reads need not be known while the rest is integrated: it follows by
/// quadrature, and what reads nothing has a closed form.
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
    /// The attitude or the angle; of a rod its axis.
    pub attitude: bool,
    /// The angular velocity; of a rod the rate of its axis.
    pub angular_velocity: bool,
    /// The inputs.
    pub input: bool,
    /// States of one's own.
    pub states: bool,
    /// Directions e, world axes, about which the world may be turned: positions, velocities and
    /// attitude are turned about the line along e through the origin, at the same inputs and
    /// the same states of one's own, and the acceleration turns with them. Components in body axes do not change at all.
    ///
    /// With weight along -e alone the angular acceleration reads of the attitude just `γ = Rᵀ e`,
    /// with `γ' = γ × ω`: three numbers in the place of four, and the yaw follows by quadrature
    /// (Landau and Lifshitz, *Mechanics*, § 35).
    pub world: Symmetry,
    /// Directions e, body axes, about which the axes of the body may be turned: the attitude is
    /// turned about e before all else, the components of the angular velocity are written in the
    /// turned axes, and so are those of the acceleration. A linear acceleration, in world axes,
    /// does not change. None of a rod and of a hinge, which have no such axes.
    ///
    /// The body may then be described in axes that do not spin with it about e, in which all
    /// changes more slowly: see [`Axes`](crate::taylor::Axes).
    pub body: Symmetry,
}

impl Dependence {
    /// Reads nothing and turns with everything: that of zero.
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

    /// Nothing is read: it is the same at all times, in all states and for all inputs.
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

/// Directions about which a turn changes nothing: if there are two of them, there are all.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Symmetry {
    /// About none.
    None,
    /// About one, a unit vector; the first of its components that is not zero is positive.
    About([f64; 3]),
    /// About every one.
    Every,
}
