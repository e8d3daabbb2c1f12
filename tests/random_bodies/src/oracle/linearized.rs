//! The derivatives of the accelerations with respect to the coordinates of the state and the
//! parameters, by finite differences in 106 bits.

use crate::description::body::{Body, Motion};
use crate::given::Given;
use crate::wide::Wide;

use super::arithmetic::Values as _;
use super::constants::{Constants, exactly};
use super::differences::settled;
use super::following::following;
use super::law::Motions;
use super::number::Number;
use super::scene::{Instant, Scene};
use super::step::Step;

/// A derivative, and by how much it is in doubt.
pub struct Entry {
    pub row: usize,
    pub column: usize,
    pub value: Wide,
    pub doubt: f64,
}

/// The accelerations as a body lists them, and the rates of its own states.
fn accelerations(scene: &Scene<'_>) -> Vec<Number> {
    let body = scene.constants.body;
    let Motions { linear, angular } = following(scene);
    let parts =
        |vector: super::vector::Vector, count: usize| (0..count).map(move |i| vector.component(i));
    let mut list = Vec::new();
    let (along, about) = freedoms(&body.motion);
    list.extend(parts(linear, along));
    list.extend(parts(angular, about));
    list.extend(body.rates.iter().map(|rate| scene.scalar(rate)));
    list
}

/// How many coordinates are of places, and how many of turns.
fn freedoms(motion: &Motion) -> (usize, usize) {
    match motion {
        Motion::Spatial | Motion::Rod(_) => (3, 3),
        Motion::Rotation | Motion::FixedPoint(_) => (0, 3),
        Motion::Translation => (3, 0),
        Motion::Planar => (2, 1),
        Motion::PlanarTranslation => (2, 0),
        Motion::Pivot(_) | Motion::FixedAxis(..) => (0, 1),
    }
}

/// The step along a column.
fn step(motion: &Motion, column: usize, length: f64) -> Step {
    let (along, about) = freedoms(motion);
    let count = along + about;
    let length = Wide::from(length);
    let mut step = Step::default();
    let (is_rate, place) = (column >= count, column % count);
    let (lines, turns) = if is_rate {
        (&mut step.velocity, &mut step.turning)
    } else {
        (&mut step.position, &mut step.attitude)
    };
    match place.checked_sub(along) {
        None => lines[place] = length,
        Some(_) if about == 1 => turns[2] = length,
        Some(axis) => turns[axis] = length,
    }
    step
}

/// The rows of the accelerations and of the rates, by columns of the state, and behind them of the parameters; of a rod without
/// those of its axis, and nothing near switches.
pub fn derivatives(body: &Body, given: &Given) -> Option<Vec<Entry>> {
    let constants = Constants::now(body, given);
    let here = Scene::new(&constants, given);
    let rows = accelerations(&here).len();
    if here.is_near_switch() {
        return None;
    }
    let (along, about) = freedoms(&body.motion);
    let count = along + about;
    let instant = Instant::of(given);
    let mut entries = Vec::new();
    let params = exactly(&given.params);
    let states = 2 * count + body.rates.len();
    for column in 0..states + params.len() {
        let is_of_axis = matches!(body.motion, Motion::Rod(_)) && column % 6 >= 3 && column < 12;
        if is_of_axis {
            continue;
        }
        for row in 0..rows {
            let (value, doubt) = settled(
                0.1,
                |length| match column.checked_sub(2 * count) {
                    None => {
                        let moved = step(&body.motion, column, length).from(&body.motion, &instant);
                        accelerations(&Scene::at(&constants, given, &moved))[row]
                    }
                    Some(other) => {
                        let (mut moved, mut params) = (instant.clone(), params.clone());
                        let mut numbers = moved.own.iter_mut().chain(&mut params);
                        let number = numbers.nth(other).expect("a column");
                        *number = *number + Wide::from(length);
                        let constants = Constants::with_states(body, params, &moved.own);
                        accelerations(&Scene::at(&constants, given, &moved))[row]
                    }
                },
                1,
            );
            entries.push(Entry {
                row,
                column,
                value,
                doubt,
            });
        }
    }
    Some(entries)
}
