//! Serialized ensembles: states as states, parameters and inputs as lists of numbers. All are
//! checked on reading.

use alloc::vec::Vec;
use core::fmt;

use serde::{Deserialize, Deserializer, Serialize, Serializer, de::Error};

use super::{Ensemble, Members};
use crate::bodies::columns::{Columns, Generic, Sink, Source};

#[derive(Serialize, Deserialize)]
#[serde(
    rename = "Ensemble",
    expecting = "an ensemble: `params`, `states` and `inputs`"
)]
struct Written<S> {
    /// The parameters of each member, or a single list if all are the same.
    params: Vec<Vec<f64>>,
    states: Vec<S>,
    inputs: Vec<Vec<f64>>,
}

impl<B: Generic<State: Serialize>> Serialize for Ensemble<B> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let written = Written {
            params: self
                .members
                .bodies
                .iter()
                .map(|body| to_list(&body.parameters()))
                .collect(),
            states: self.states.iter().collect(),
            inputs: self
                .members
                .inputs
                .iter()
                .map(|input| to_list(&input))
                .collect(),
        };
        written.serialize(serializer)
    }
}

impl<'de, B: Generic<State: Deserialize<'de>>> Deserialize<'de> for Ensemble<B> {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let Written {
            params,
            states,
            inputs,
        } = Written::<B::State>::deserialize(deserializer)?;
        if inputs.len() != states.len() || params.len() != states.len() && params.len() != 1 {
            return Err(D::Error::custom(format_args!(
                "an ensemble of {} states has as many inputs, and as many parameters or one for all, not {} and {}",
                states.len(),
                inputs.len(),
                params.len()
            )));
        }
        let body = |(index, list): (usize, &Vec<f64>)| {
            let body = B::build(from_list(list, "parameters").map_err(D::Error::custom)?);
            body.map_err(|error| D::Error::custom(super::InvalidMember { index, error }))
        };
        let input = |list: &Vec<f64>| from_list(list, "inputs").map_err(D::Error::custom);
        let members = Members {
            is_uniform: params.len() == 1,
            bodies: params
                .iter()
                .enumerate()
                .map(body)
                .collect::<Result<_, _>>()?,
            inputs: inputs.iter().map(input).collect::<Result<_, _>>()?,
        };
        Ok(Self::made(states.into_iter().collect(), members))
    }
}

/// A list of another length.
struct WrongLength {
    what: &'static str,
    expected: usize,
    found: usize,
}

impl fmt::Display for WrongLength {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self {
            what,
            expected,
            found,
        } = self;
        write!(f, "expected {expected} {what}, and there are {found}")
    }
}

fn to_list<C: Columns<f64>>(value: &C) -> Vec<f64> {
    let mut list = List(Vec::with_capacity(C::COUNT));
    value.write(&mut list);
    list.0
}

fn from_list<C: Columns<f64>>(list: &[f64], what: &'static str) -> Result<C, WrongLength> {
    if list.len() == C::COUNT {
        Ok(C::read(&mut Numbers(list.iter())))
    } else {
        Err(WrongLength {
            what,
            expected: C::COUNT,
            found: list.len(),
        })
    }
}

struct List(Vec<f64>);

impl Sink<f64> for List {
    fn put(&mut self, scalar: f64) {
        self.0.push(scalar);
    }
}

struct Numbers<'a>(core::slice::Iter<'a, f64>);

impl Source<f64> for Numbers<'_> {
    fn take(&mut self) -> f64 {
        *self.0.next().expect("the length was checked")
    }
}
