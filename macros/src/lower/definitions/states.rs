//! User-defined states and their rates, which are integrated with the motion.

use proc_macro2::Ident;

use crate::errors::{every, hint, similar};
use crate::lower::expressions::{Lowering, Value};
use crate::model::{Declared, Dimension, Meaning, Own};
use crate::symbolic::{Id, Stage};
use crate::syntax::{Declaration, Definition, Description};

use super::outline::distinct;

/// The name of the field that holds the motion of a body, next to its user-defined states.
const MOTION: &str = "motion";

impl Lowering<'_> {
    /// A state: `fuel`, `speed[rad / s]`.
    pub fn state(
        &mut self,
        index: usize,
        written: &Declaration,
        declared: &mut Declared,
    ) -> Option<Value> {
        let name = &written.name;
        if name == MOTION && !self.is_whole {
            return self.report(
                name.span(),
                "the state has its motion in a field of this name: choose another name",
            );
        }
        if let Some(value) = &written.value {
            let place = value.as_ref()?.extent;
            return self.report(
                place,
                format!(
                    "a state is a scalar, which begins where the integration does: write `{name}[unit]`"
                ),
            );
        }
        self.declared_unit(written, declared)?;
        let symbol = self.work.symbol(Stage::State, Meaning::Own(index));
        Some(Value::Scalar(symbol, declared.dimension))
    }

    /// The states, each with its rate.
    pub fn states(&mut self, description: &Description, declared: &[Declared]) -> Option<Vec<Own>> {
        self.check_rates(description);
        let states = distinct(&description.states).zip(declared);
        every(states.map(|(state, declared)| {
            let name = state.name.to_string();
            let rate = self.rate(rate_in(description, &state.name)?, declared.dimension)?;
            match self.scope.peek(&name) {
                Some(Value::Scalar(symbol, _)) => Some(Own { name, symbol, rate }),
                _ => None,
            }
        }))
    }

    /// The name of the state with this symbol, and its rate as written.
    pub fn state_of<'d>(
        &mut self,
        description: &'d Description,
        symbol: Id,
    ) -> Option<(&'d Ident, &'d Definition)> {
        let is_it = |state: &&Declaration| {
            let value = self.scope.peek(&state.name.to_string());
            matches!(value, Some(Value::Scalar(id, _)) if id == symbol)
        };
        let state = distinct(&description.states).find(is_it)?;
        Some((&state.name, rate_in(description, &state.name)?))
    }

    /// The rate of the state with this symbol.
    pub fn rate_of(&mut self, description: &Description, symbol: Id) -> Option<Id> {
        let (name, rate) = self.state_of(description, symbol)?;
        match self.scope.peek(&name.to_string()) {
            Some(Value::Scalar(_, dimension)) => self.rate(rate, dimension),
            _ => None,
        }
    }

    /// The user-defined states that these values depend on.
    pub fn own_states(&self, values: &[Id]) -> Vec<Id> {
        let symbols = self.late_symbols(values).into_iter();
        let is_own = |id: &Id| matches!(self.work.meaning(*id), Some(Meaning::Own(_)));
        symbols.filter(is_own).collect()
    }

    /// Checks that each state has a rate, and that each rate belongs to a state.
    fn check_rates(&mut self, description: &Description) {
        let states: Vec<&Ident> = distinct(&description.states)
            .map(|state| &state.name)
            .collect();
        let words: Vec<String> = states.iter().map(ToString::to_string).collect();
        // states that a misspelt rate may belong to
        let mut misspelt = Vec::new();
        for rate in &description.rates {
            let (name, word) = (&rate.name, rate.name.to_string());
            if words.contains(&word) || self.scope.is_lost(&word) {
                continue;
            }
            let known = || words.iter().map(String::as_str);
            misspelt.extend(similar(&word, known()));
            let hint = hint(&word, known());
            let meant = if words.is_empty() {
                format!("a rate is that of a state, `states: [{name}]`")
            } else {
                format!("a rate is that of one of the `states`{hint}")
            };
            self.errors
                .push(name.span(), format!("there is no state `{name}`: {meant}"));
        }
        for (name, word) in states.into_iter().zip(&words) {
            let has_rate = description.rates.iter().any(|rate| rate.name == *name);
            if !has_rate && !self.scope.is_lost(word) && !misspelt.contains(&word.as_str()) {
                self.errors.push(
                    name.span(),
                    format!("`{name}` has no rate: write `rates: [{name} = ..]`"),
                );
            }
        }
    }

    /// The value of a rate, which must have the dimension of the state divided by time.
    fn rate(&mut self, written: &Definition, dimension: Dimension) -> Option<Id> {
        let (name, value) = (&written.name, written.value.as_ref()?);
        if let Some(place) = self.mentioned_reaction(value) {
            return self.report(
                place,
                "a rate follows from the state, inputs and time, and this is a load that is solved for: \
                 write what makes it",
            );
        }
        let Some(rate) = dimension.over(Dimension::TIME) else {
            return self.report(
                name.span(),
                format!("the unit of the rate of `{name}` has powers beyond measure"),
            );
        };
        let what = format!("the rate of `{name}`");
        let id = self.scalar(value, rate, &what)?;
        self.check_no_acceleration(value, &[id], &what)?;
        match self.named(Value::Scalar(id, rate), &format!("{name}_rate")) {
            Value::Scalar(id, _) => Some(id),
            _ => None,
        }
    }
}

/// The rate of a state, as written.
fn rate_in<'d>(description: &'d Description, state: &Ident) -> Option<&'d Definition> {
    description.rates.iter().find(|rate| rate.name == *state)
}
