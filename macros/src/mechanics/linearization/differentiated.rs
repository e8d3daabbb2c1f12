//! The expressions that a linearization differentiates: accelerations, or the balances that
//! determine them.

use crate::mechanics::system::Response;
use crate::mechanics::variation::Direction;
use crate::model::{Group, Own, Workspace};
use crate::symbolic::{Components, Id};

/// Accelerations in the order of the state, and the expressions whose changes determine those of
/// the accelerations. In both, the rates of user-defined states come last.
pub struct Differentiated {
    pub accelerations: Vec<Id>,
    pub changing: Vec<Id>,
    /// For a tree: the balances are differentiated, and the change of the accelerations is solved
    /// for.
    response: Option<Response>,
}

impl Differentiated {
    /// Differentiates the accelerations themselves.
    pub fn directly(accelerations: Vec<Id>, states: &[Own]) -> Self {
        let accelerations = with_rates(accelerations, states);
        Self {
            changing: accelerations.clone(),
            accelerations,
            response: None,
        }
    }

    /// Differentiates the balances of a tree.
    pub fn by_balances(response: Response, states: &[Own]) -> Self {
        Self {
            accelerations: with_rates(response.accelerations.clone(), states),
            changing: with_rates(response.lacking.clone(), states),
            response: Some(response),
        }
    }

    /// The change of the accelerations, from that of the differentiated expressions.
    pub fn finish(&mut self, work: &mut Workspace, change: Vec<Id>) -> Vec<Id> {
        match &mut self.response {
            Some(response) => {
                let (change, rates) = change.split_at(response.lacking.len());
                [response.to(work, change).as_slice(), rates].concat()
            }
            None => change,
        }
    }
}

fn with_rates(all: Vec<Id>, states: &[Own]) -> Vec<Id> {
    let rates = states.iter().map(|state| state.rate);
    all.into_iter().chain(rates).collect()
}

/// The tangent space of the states of a body or a system.
pub trait Tangent {
    /// The direction in which one component of the tangent space changes by one.
    fn direction(&self, work: &mut Workspace, group: &Group, component: usize) -> Direction;

    /// The angular velocity with which the attitude of a joint changes. The joint is given by its
    /// index in the state.
    fn spin(&self, work: &Workspace, joint: usize) -> Components;
}
