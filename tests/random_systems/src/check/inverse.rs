//! Inverse dynamics, mass matrices and balances.

use super::compiled::Compiled;
use super::state::State;
use super::{Checks, EXACT, Failure, apart};
use crate::draw::Drawn;
use crate::law::kind::{Kind, Motion};
use crate::law::scene::Loads;
use crate::law::space::{ZERO, add, cross, scale, subtract};
use crate::wide::Wide;

/// Numbers by joint of the compiler, as they are by link.
fn by_link(compiled: &Compiled, values: Vec<Wide>, count: usize) -> Vec<Vec<Wide>> {
    let mut all = vec![Vec::new(); count];
    let mut values = values.into_iter();
    for (link, ids) in compiled.links.iter().zip(&compiled.accelerations) {
        all[*link] = values.by_ref().take(ids.len()).collect();
    }
    all
}

/// Inverse dynamics of what the drives do is the drives, and what they do with those of inverse
/// dynamics is what was asked for. `opened` is the same system with open drives.
pub fn round_trip(
    drawn: &Drawn,
    compiled: &Compiled,
    opened: &Compiled,
    state: &mut State,
) -> Option<Failure> {
    let count = drawn.links.len();
    let forward = |state: &State| -> Vec<Vec<Wide>> {
        let open = compiled.accelerations.concat();
        by_link(compiled, compiled.values(&open, &state.given()), count)
    };
    let inverse = |state: &State| -> Vec<Wide> {
        let found = opened.values(&opened.inverse.concat(), &state.given());
        let found = by_link(opened, found, count);
        let open = drawn.open.iter();
        open.map(|(joint, freedom, _)| found[*joint][*freedom])
            .collect()
    };
    let size = |list: &[Vec<Wide>]| {
        let sum = list.concat().iter().map(|one| one.high.abs()).sum::<f64>();
        (1.0 + sum, 1e6 * EXACT)
    };
    let asked = state.accelerations.clone();
    let open = drawn.open.iter();
    let given: Vec<Wide> = open.map(|(_, _, input)| state.inputs[*input]).collect();
    state.accelerations = forward(state);
    let scale = size(&state.accelerations);
    let first = apart("inverse of forward", &inverse(state), &given, scale);
    state.accelerations.clone_from(&asked);
    for ((_, _, input), load) in drawn.open.iter().zip(inverse(state)) {
        state.inputs[*input] = load;
    }
    let found = forward(state);
    let second = apart(
        "forward of inverse",
        &found.concat(),
        &asked.concat(),
        size(&asked),
    );
    let failures = first.unwrap_or_default() + &second.unwrap_or_default();
    (!failures.is_empty()).then_some(failures)
}

impl Checks<'_> {
    /// Inverse dynamics, mass matrix, and residuals, with any motion and any loads of joints.
    pub fn any_motion(&mut self) {
        let (compiled, state) = (self.compiled, self.state);
        let loads = self.loads_in(&state.accelerations);
        let (carried, motions) = self.scene.carried(&loads, &state.accelerations);
        let mut needed = Vec::new();
        for link in 0..self.drawn.links.len() {
            let pairs = carried.along[link].iter().zip(&loads.drives[link]);
            needed.push(
                pairs
                    .map(|(along, drive)| *along - *drive)
                    .collect::<Vec<_>>(),
            );
        }
        for (joint, link) in compiled.links.iter().enumerate() {
            if compiled.inverse.is_empty() {
                break;
            }
            if compiled.system.joints[joint].is_driven() {
                continue;
            }
            let inverse = self.values(&compiled.inverse[joint]);
            self.close(
                &format!("inverse of j{link}"),
                &inverse,
                &needed[*link],
                carried.size,
            );
        }
        self.mass_matrix(&needed, carried.size);
        self.balances(&loads, &motions, carried.size);
    }

    /// `M q'' = f`
    fn mass_matrix(&mut self, needed: &[Vec<Wide>], size: f64) {
        let (compiled, state) = (self.compiled, self.state);
        // of loads that follow accelerations nothing is said
        let inertias = compiled.inertias.as_ref();
        let Some(inertias) = inertias.filter(|_| !self.drawn.follows) else {
            return;
        };
        let count = inertias.rows.len();
        let rows = self.values(&inertias.rows.concat());
        let driving = self.values(&inertias.driving);
        let written = compiled
            .system
            .written
            .iter()
            .map(|joint| compiled.links[*joint]);
        let written: Vec<usize> = written.collect();
        let order = |by: &[Vec<Wide>]| -> Vec<Wide> {
            written.iter().flat_map(|link| by[*link].clone()).collect()
        };
        let (given, expected) = (order(&state.accelerations), order(needed));
        let left: Vec<Wide> = (0..count)
            .map(|row| {
                let terms = rows[row * count..].iter().zip(&given);
                terms.map(|(m, a)| *m * *a).sum::<Wide>() - driving[row]
            })
            .collect();
        self.close("M q'' - f", &left, &expected, size);
        let transposed: Vec<Wide> = (0..count * count)
            .map(|entry| rows[entry % count * count + entry / count])
            .collect();
        self.close("M transposed", &transposed, &rows, 0.0);
    }

    /// Of each body, with any loads of joints.
    fn balances(&mut self, given: &Loads, motions: &[Motion], size: f64) {
        let (compiled, state) = (self.compiled, self.state);
        for (body, link) in compiled.links.iter().enumerate() {
            let balance = &compiled.balances[body];
            let [force, moment] = self.loads.on[*link];
            let applied = self.values(&[balance.applied.force, balance.applied.moment].concat());
            self.close(
                &format!("applied on b{link}"),
                &applied,
                &[force, moment].concat(),
                size,
            );
            let [force, moment] = given.on[*link];
            let residual = self.values(&[balance.residual.force, balance.residual.moment].concat());
            let [taken, turning] = self.scene.taken(*link, &motions[*link]);
            let mut sums = [subtract(force, taken), subtract(moment, turning)];
            for (joint, other) in self.drawn.links.iter().enumerate() {
                let ring = self.drawn.rings.iter().find(|ring| ring.link == joint);
                let carried = ring.map_or(joint, |ring| ring.body);
                let sign = match (carried == *link, other.carrier == Some(*link)) {
                    (true, _) => Wide::ONE,
                    (_, true) => -Wide::ONE,
                    _ => continue,
                };
                let pin = self.scene.point(Some(carried), other.pin);
                let arm = subtract(pin, motions[*link].position);
                let load = match other.kind {
                    Kind::Rod(..) => {
                        let tension = state.loads[joint][0][0];
                        [scale(self.scene.along_rod(joint), tension), ZERO]
                    }
                    _ => state.loads[joint],
                };
                let [force, moment] = load.map(|part| scale(part, sign));
                sums = [
                    add(sums[0], force),
                    add(sums[1], add(moment, cross(arm, force))),
                ];
            }
            self.close(
                &format!("residual of b{link}"),
                &residual,
                &sums.concat(),
                size,
            );
        }
    }
}
