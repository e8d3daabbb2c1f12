//! The values of parameters that have a default.

use crate::symbolic::Id;
use std::collections::HashMap;

/// The values that parameters have when nothing else is said.
pub type Defaults = HashMap<Id, Id>;
