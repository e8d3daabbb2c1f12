//! Outputs that a body with changing mass or inertia cannot have.

use crate::errors::Errors;
use crate::model::{Meaning, Outline, Workspace};
use crate::symbolic::Id;

use super::outline::REGRESSOR;

/// Outputs that are functions of the state alone, not of time.
const OF_STATE: [&str; 2] = ["energy", "momentum"];

/// Reports outputs that cannot follow the masses and inertias: functions of the state if these
/// depend on time, and the regressor if they change at all.
pub fn check_changing(work: &Workspace, known: &[Id], outline: &Outline, errors: &mut Errors) {
    let graph = &work.graph;
    let asked = |word: &&'static str| Some((*word, outline.place(word)?));
    if graph.depends_on(known, |id| work.meaning(id) == Some(Meaning::Time)) {
        for (word, place) in OF_STATE.iter().filter_map(asked) {
            let message = format!(
                "`{word}` is a function of the state, and mass or inertia depend on `t`: make it one of the `states`, \
                 `states: [clock[s]], rates: [clock = 1]`"
            );
            errors.push(place, message);
        }
    }
    if let Some((_, place)) = asked(&REGRESSOR).filter(|_| !graph.are_early(known)) {
        let message = "the inertial parameters of a regressor are constant, and here mass or inertia change: leave \
                       out `regressor`";
        errors.push(place, message);
    }
}
