//! The values of parameters that have a default.

use std::collections::HashMap;

use crate::symbolic::Id;

/// The values that parameters have when nothing else is said.
pub type Defaults = HashMap<Id, Id>;
