//! Further outputs: energy, momentum, balances, series, and switch times.

mod axes;
mod balance;
mod energy;
mod falls;
mod momentum;
mod partial;
mod regressor;
mod switches;
mod taylor;

pub use axes::Axes;
pub use balance::{Balance, LoadExpressions, Resultant, derive_balance};
pub use energy::{Energy, derive_energy, done_by_field};
pub use falls::falls;
pub use momentum::{Momentum, derive_momentum};
pub use partial::{Partial, list_partial, loads, parts};
pub use regressor::{Regressor, derive_regressor, inertial_parameters, told};
pub use switches::{Switch, derive_switches};
pub use taylor::{SeriesInput, Taylor, derive_taylor, polynomials, quaternion_rate};
