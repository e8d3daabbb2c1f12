//! The names that most programs need: `use newton_euler::prelude::*;`.

#[doc(no_inline)]
pub use crate::body::{
    Balance, DrivenEnergy, DrivenMomentum, Energy, Flow, InvalidBody, Inverse, Jacobian,
    MassMatrix, Momentum, Reactions, Regressor, RigidBody, Singular,
};
#[doc(no_inline)]
pub use crate::constrained::{Constrained, Inconsistent, Violation};
pub use crate::exact::Path as _;
#[doc(no_inline)]
pub use crate::inertia::InertiaTensor;
pub use crate::integrate::Integrate;
#[doc(no_inline)]
pub use crate::integrate::Sample;
#[doc(no_inline)]
pub use crate::linearization::{ByParams, Linearization, Linearized, Sensitivity, Trim};
#[doc(no_inline)]
pub use crate::load::{Family, Load, PlanarLoad};
pub use crate::state::{
    Cylinder, CylinderAcceleration, Hinge, Planar, PlanarAcceleration, PlanarTranslation, Rod,
    RodAcceleration, Rotation, Slide, Spatial, SpatialAcceleration, State, Still, Translation,
    Universal,
};
pub use crate::taylor::Taylor;
#[doc(no_inline)]
pub use crate::wrench::{PlanarWrench, Wrench};
pub use crate::{rigid_body, rigid_system};
