//! The outputs of a system. A new output is a file, and a line in the list.

mod flow;
mod inverse;
mod jacobian;
mod mass_matrix;
mod reactions;

use crate::model::System;

use super::balance::Balance;
use super::constant::Constant;
use super::constrained::Constrained;
use super::energy::Energy;
use super::linearization::{Linearization, Sensitivity};
use super::momentum::Momentum;
use super::output::{Listed, Output};
use super::regressor::Regressor;
use super::taylor::Taylor;

impl Listed for System {
    fn outputs() -> Vec<Box<dyn Output<Self>>> {
        vec![
            Box::<Energy>::default(),
            Box::<Momentum>::default(),
            Box::<Balance>::default(),
            Box::<reactions::Reactions>::default(),
            Box::<inverse::Inverse>::default(),
            Box::<mass_matrix::MassMatrix>::default(),
            Box::<jacobian::Jacobian>::default(),
            Box::<flow::Flow>::default(),
            Box::<Taylor>::default(),
            Box::<Linearization>::default(),
            Box::<Sensitivity>::default(),
            Box::<Regressor>::default(),
            Box::<Constant>::default(),
            Box::<Constrained>::default(),
        ]
    }

    fn offered() -> Vec<Box<dyn Output<Self>>> {
        Self::outputs()
    }
}
