//! What cannot be asked of a body whose mass or inertia changes.

use crate::errors::Errors;
use crate::model::{Meaning, Outline, Workspace};
use crate::symbolic::Id;

/// Outputs that are of a state alone.
const OF_STATE: [&str; 2] = ["energy", "momentum"];

/// Reports outputs that know less than the masses and inertias of all bodies follow: of a state alone,
/// time; of the body alone, any change.
pub fn check_changing(work: &Workspace, known: &[Id], outline: &Outline, errors: &mut Errors) {
    let graph = &work.graph;
    let asked = |word: &&'static str| Some((*word, outline.place(word)?));
    if graph.depends_on(known, |id| work.meaning(id) == Some(Meaning::Time)) {
        for (word, place) in OF_STATE.iter().filter_map(asked) {
            let message = format!(
                "`{word}` is that of a state, and mass or inertia follow `t`: make it one of the `states`, \
                 `states: [clock[s]], rates: [clock = 1]`"
            );
            errors.push(place, message);
        }
    }
    if let Some((_, place)) = asked(&"regressor").filter(|_| !graph.are_early(known)) {
        let message = "the inertial parameters of a regressor are constant, and here mass or inertia change: leave \
                       out `regressor`";
        errors.push(place, message);
    }
}
