//! The values of parameters that have a default.

use std::collections::HashMap;

use crate::symbolic::Id;

/// The default values of parameters.
pub type Defaults = HashMap<Id, Id>;
