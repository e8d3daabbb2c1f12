//! What the compiler says about a system, compared with the law.

pub mod compiled;
mod doubles;
mod inverse;
mod linearized;
mod motion;
mod power;
mod regressed;
mod second;
pub mod state;
mod totals;

use std::fmt::Write as _;

use fastrand::Rng;
use mounted::symbolic::Id;

use crate::draw::Drawn;
use crate::law::scene::{Loads, Scene};
use crate::wide::Wide;

use compiled::Compiled;
use state::State;

/// Of 106 bits, relative to the terms: what is wrong is no rounding.
const EXACT: f64 = 1e-20;

/// The same of loops: their elimination loses up to fourteen digits beside light bodies.
const CLOSED: f64 = 1e-16;

/// The largest errors of doubles.
#[derive(Clone, Copy, Debug, Default)]
pub struct Errors {
    /// Of accelerations, relative to the largest.
    pub acceleration: f64,
    /// Per what a unit in the last place of the state does.
    pub conditioned: f64,
}

/// What fails, and by how much.
pub type Failure = String;

struct Checks<'a> {
    drawn: &'a Drawn,
    compiled: &'a Compiled,
    state: &'a State,
    scene: Scene<'a>,
    /// Those of potentials among them.
    loads: Loads,
    failures: String,
}

/// Compares all answers in a state; none where a load has no direction.
pub fn check(
    drawn: &Drawn,
    compiled: &Compiled,
    state: &State,
    rng: &mut Rng,
) -> Option<Result<Errors, Failure>> {
    let links = (&drawn.links[..], drawn.bodies());
    let scene = Scene::new(links, state.instant(drawn), &state.rates);
    let loads = scene.loads(drawn.acting.iter().chain(&drawn.pulling));
    if scene.is_near.get() {
        return None;
    }
    let mut checks = Checks {
        drawn,
        compiled,
        state,
        scene,
        loads,
        failures: String::new(),
    };
    let found = checks.motion();
    checks.any_motion();
    checks.regressed(rng);
    checks.totals();
    checks.words();
    checks.jacobian();
    checks.own_rates();
    checks.linearized();
    checks.sensitive();
    let errors = checks.doubles(&found, rng);
    Some(if checks.failures.is_empty() {
        Ok(errors)
    } else {
        Err(checks.failures)
    })
}

pub use inverse::round_trip;

impl Checks<'_> {
    /// Those of user-defined states.
    fn own_rates(&mut self) {
        let states = self.compiled.system.states.iter();
        let found: Vec<Id> = states.map(|state| state.rate).collect();
        let expected = self.drawn.rates.iter().map(|rate| rate(&self.scene));
        let expected: Vec<Wide> = expected.collect();
        let found = self.values(&found);
        self.close("rate of a state", &found, &expected, 1.0);
    }

    fn values(&self, roots: &[Id]) -> Vec<Wide> {
        self.compiled.values(roots, &self.state.given())
    }

    /// All loads, in a motion with these accelerations.
    fn loads_in(&self, accelerations: &[Vec<Wide>]) -> Loads {
        if !self.drawn.follows {
            return self.loads.clone();
        }
        self.scene.follow(accelerations);
        let acting = self.drawn.acting.iter().chain(&self.drawn.pulling);
        self.scene.loads(acting)
    }

    fn close(&mut self, what: &str, found: &[Wide], expected: &[Wide], size: f64) {
        let exact = if self.drawn.rings.is_empty() {
            EXACT
        } else {
            CLOSED
        };
        if let Some(failure) = apart(what, found, expected, (size, exact)) {
            self.failures += &failure;
        }
    }
}

/// What is to be said of numbers that are not the same.
fn apart(
    what: &str,
    found: &[Wide],
    expected: &[Wide],
    (size, exact): (f64, f64),
) -> Option<Failure> {
    let size = found
        .iter()
        .chain(expected)
        .fold(size, |size, one| size.max(one.high.abs()));
    let apart = found
        .iter()
        .zip(expected)
        .map(|(a, b)| (*a - *b).high.abs());
    // not a number is not close
    let largest = apart
        .clone()
        .fold(0.0, |largest: f64, apart| largest.max(apart) / size);
    if found.len() == expected.len() && apart.into_iter().all(|apart| apart <= exact * size) {
        return None;
    }
    let list = |all: &[Wide]| all.iter().map(|one| one.high).collect::<Vec<_>>();
    let mut text = String::new();
    let _ = writeln!(
        text,
        "{what}: {:?}, expected {:?} of size {size:e}, apart by {largest:e} of it",
        list(found),
        list(expected)
    );
    Some(text)
}
