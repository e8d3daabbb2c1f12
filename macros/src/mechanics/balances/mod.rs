//! The balances (1.3) and (1.4): loads, inertia, and the resulting accelerations.

mod dyadic;
mod euler_equations;
mod kinetic;
mod loads;
mod moments;
mod newton_euler;
mod response;
pub mod rod;

pub use dyadic::{quadratic, transform};
pub use euler_equations::{EulerForm, is_diagonal};
pub use kinetic::twice_kinetic;
pub use loads::{
    about_pole, arm, check_moment_free, known_parts, moments_about, resultant, uniform_field,
};
pub use moments::inertia_about_center;
pub use newton_euler::{derive_accelerations, solve_balances};
pub use response::{free_moment, response};
pub use rod::{is_along_axis, not_vanishing, parts_along, turned_by};
