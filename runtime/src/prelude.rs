//! What most programs need: `use newton_euler::prelude::*;`.

pub use crate::body::{
    Balance, Energy, Flow, InvalidBody, Inverse, Momentum, Reactions, RigidBody, Singular,
};
pub use crate::constrained::{Constrained, Inconsistent, Violation};
pub use crate::exact::Path as _;
pub use crate::inertia::InertiaTensor;
pub use crate::integrate::Integrate;
pub use crate::load::{Family, Load, PlanarLoad};
pub use crate::rigid_body;
pub use crate::state::{
    Hinge, Planar, PlanarAcceleration, PlanarTranslation, Rod, RodAcceleration, Rotation, Spatial,
    SpatialAcceleration, State, Translation,
};
pub use crate::taylor::Taylor;
pub use crate::wrench::{PlanarWrench, Wrench};
