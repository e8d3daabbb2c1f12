//! The equations of a system, and its other outputs, from its tree of bodies.

mod balance;
mod closed;
mod consistency;
mod constraints;
mod equations;
mod flow;
mod independence;
mod jacobian;
mod loads;
mod matrix;
mod motion;
mod plane;
mod rates;
mod reduced;
mod regressor;
mod response;
mod series;
mod totals;

pub use balance::derive_system_balances;
pub use consistency::derive_system_consistency;
pub use constraints::check_followers;
pub use equations::{SystemEquations, derive_system, describe_system};
pub use flow::{Counter, Course, SystemFlow, derive_system_flow};
pub use jacobian::{Jacobian, derive_jacobians};
pub use loads::{
    derive_system_driving, derive_system_held, derive_system_inverse, derive_system_open,
    derive_system_reactions, derive_system_release,
};
pub use matrix::{Inertias, derive_inertias};
pub use motion::unit_motion;
pub use regressor::derive_system_regressors;
pub use response::Response;
pub use series::derive_system_taylor;
pub use totals::{derive_system_energy, derive_system_momentum};
