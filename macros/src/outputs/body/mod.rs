//! The outputs of one body. A new output is a file, and a line in one of two lists.

mod flow;
mod inverse;
mod reactions;
mod structured;

use crate::model::Model;

use super::balance::Balance;
use super::constant::Constant;
use super::constrained::Constrained;
use super::energy::Energy;
use super::linearization::{Linearization, Sensitivity};
use super::momentum::Momentum;
use super::output::{Listed, Output};
use super::regressor::Regressor;
use super::taylor::Taylor;

/// Outputs that need a solution of equations, or a search.
fn solved() -> [Box<dyn Output<Model>>; 8] {
    [
        Box::<inverse::Inverse>::default(),
        Box::<flow::Flow>::default(),
        Box::<structured::Structured>::default(),
        Box::<Taylor>::default(),
        Box::<Linearization>::default(),
        Box::<Sensitivity>::default(),
        Box::<Regressor>::default(),
        Box::<Constant>::default(),
    ]
}

/// Outputs that are functions of the motion.
fn observed() -> [Box<dyn Output<Model>>; 5] {
    [
        Box::<Energy>::default(),
        Box::<Momentum>::default(),
        Box::<Balance>::default(),
        Box::<reactions::Reactions>::default(),
        Box::<Constrained>::default(),
    ]
}

impl Listed for Model {
    fn outputs() -> Vec<Box<dyn Output<Self>>> {
        solved().into_iter().chain(observed()).collect()
    }

    fn offered() -> Vec<Box<dyn Output<Self>>> {
        observed().into_iter().chain(solved()).collect()
    }
}
