//! All names of generated code. Not for users: no promise of stability.

pub use nalgebra::{SMatrix, UnitQuaternion, Vector2, Vector3};
#[cfg(not(rust_analyzer))]
pub use newton_euler_macros::{rigid_body, rigid_system};
#[cfg(rust_analyzer)]
pub use newton_euler_macros::{
    rigid_body_in_editors as rigid_body, rigid_system_in_editors as rigid_system,
};

pub use crate::bodies::body::{
    Balance, DrivenEnergy, DrivenMomentum, Energy, Flow, InvalidBody, Inverse, Jacobian,
    MassMatrix, Momentum, Reactions, Regressor, RigidBody, Singular,
};
pub use crate::bodies::columns::{Columns, Generic, Named, Names, Sink, Source, bare, show};
pub use crate::bodies::constrained::{Constrained, Inconsistent, Violation};
pub use crate::bodies::linearization::{
    ByParams, Coordinated, Linearization, Linearized, Place, Sensitivity, place, rates_of_places,
};
pub use crate::bodies::operations::{Operations, Stage};
pub use crate::bodies::structure::{Dependence, Structure, Structured, Symmetry};
pub use crate::exact::{
    Accelerated, AxialTorque, CounterSwing, Flight, FlyingPoint, FreeRotation, GreatCircle,
    Gyrostat, LagrangeTop, Parabola, Path, Pendulum,
};
pub use crate::integrate::{
    ClosedForm, Integrate, Projected, RungeKuttaPair, SeriesBelow, Switches, TaylorSeries,
};
pub use crate::mechanics::load::{Family, Load, PlanarLoad};
pub use crate::mechanics::wrench::{PlanarWrench, Wrench};
pub use crate::numbers::math;
pub use crate::numbers::scalar::Scalar;
pub use crate::state::{
    Coordinates, Cylinder, CylinderAcceleration, Hinge, List, Planar, PlanarAcceleration,
    PlanarTranslation, Rod, RodAcceleration, Rotation, Slide, Spatial, SpatialAcceleration, State,
    Still, Translation, Universal,
};
pub use crate::taylor::{Arithmetic, Axes, Products, Series, Taylor};

/// A user-defined state.
pub type Real = f64;

/// Numeric types over any scalar.
pub mod generic {
    /// A user-defined state.
    pub type Real<T> = T;

    pub use crate::mechanics::load::generic::*;
    pub use crate::mechanics::wrench::generic::*;
    pub use crate::state::generic::*;
}

/// A matrix, filled column by column.
#[must_use]
pub fn matrix<T, const ROWS: usize, const COLUMNS: usize>(
    columns: [[T; ROWS]; COLUMNS],
) -> SMatrix<T, ROWS, COLUMNS>
where
    T: nalgebra::Scalar,
{
    columns.into()
}

mod checks;
pub mod order;
mod path;
mod pivots;
mod record;
pub mod system;
mod tables;

pub use {crate::__record as record, crate::__system_state as system_state};
#[cfg(feature = "serde")]
pub use {crate::__written as written, serde};

/// Without serialization.
#[cfg(not(feature = "serde"))]
#[doc(hidden)]
#[macro_export]
macro_rules! __written {
    ($($all:tt)*) => {};
}
#[cfg(not(feature = "serde"))]
pub use crate::__written as written;

pub use crate::bodies::projection::{Kept, Row, Size, check, dependent, off, project};
pub use crate::mechanics::principal::PrincipalAxes;
pub use checks::{
    check_derived, check_finite, check_inertia, check_mass, check_planar_inertia, check_property,
    check_swinging_inertia, check_swinging_planar_inertia, lost_load, member,
};
pub use path::{
    axial_torque, gyrostat, lagrange_top, principal_axes, principal_rotation, rotation_about,
    rotation_along, symmetric_rotation,
};
pub use pivots::{determined, positive, reciprocal};
pub use tables::{constant, table};
