//! What a description means at an instant, according to the vector law.

use crate::description::body::Body;
use crate::given::Given;
use crate::layout::{is_hinged, is_rod};
use crate::oracle::Constants;
use crate::oracle::constrained::constrained;
use crate::oracle::law::{Motions, acceleration, inertial};
use crate::oracle::loads::{Acting, Wrench, acting};
use crate::oracle::scene::{Instant, Scene};
use crate::oracle::unknowns::open_loads;
use crate::oracle::vector::Vector;

/// The accelerations and the moment that makes them, where no rounding decides a condition.
#[derive(Clone, Copy)]
pub struct Answer {
    /// World axes.
    pub linear: Vector,
    /// Body axes; of a hinge the first component; of a rod that of its axis.
    pub angular: Vector,
    /// About G or about the point that is held, body axes; of a rod what turns its axis, of a hinge the angular acceleration.
    pub moment: Vector,
    /// Of the terms that the linear and the angular acceleration are sums of, whatever differences have added to the sizes of the vectors.
    pub sizes: [f64; 2],
}

/// Beyond it the last digits of constrained accelerations are not known.
const CONDITION: f64 = 1e4;
/// Of the terms that cancel before reactions see them. With the tolerance of constrained
/// accelerations it makes 1e-11, far above the rounding of doubles.
const CARRIED: f64 = 1e-5;
/// Of what is far below every double, double doubles lose their second part.
const LEAST: f64 = 1e-150;

/// Nothing where a number is not finite, or a condition is not decided.
pub fn answer(constants: &Constants<'_>, given: &Given, instant: &Instant) -> Option<Answer> {
    if !constants.body.constraints.is_empty() {
        return held(constants, given, instant);
    }
    let scene = Scene::at(constants, given, instant);
    let driving = driving(&scene);
    let motions = acceleration(&scene, &driving);
    known(&scene, &motions).filter(|_| !scene.is_near_switch())
}

fn known(scene: &Scene<'_>, motions: &Motions) -> Option<Answer> {
    let answer = Answer {
        linear: motions.linear,
        angular: motions.angular,
        moment: moment(scene, motions),
        sizes: [motions.linear.size, motions.angular.size],
    };
    let vectors = [answer.linear, answer.angular, answer.moment];
    let is_less = |x: f64| x != 0.0 && x.abs() < LEAST;
    let is_lost = |vector: &Vector| {
        is_less(vector.size) || vector.value.iter().any(|x| is_less(x.high)) && vector.size < LEAST
    };
    (vectors.iter().all(is_finite) && !vectors.iter().any(is_lost)).then_some(answer)
}

/// Under constraints: what differences may be off by is added to the sizes.
fn held(constants: &Constants<'_>, given: &Given, instant: &Instant) -> Option<Answer> {
    let solved = constrained(constants, given, instant)?;
    let sizes = [solved.motions.linear.size, solved.motions.angular.size];
    let are_known = solved
        .errors
        .iter()
        .zip(sizes)
        .all(|(error, size)| *error <= 1e-11 * size);
    if solved.is_near_switch || solved.condition > CONDITION || !are_known {
        return None;
    }
    let scene = Scene::at(constants, given, instant);
    let answer = known(&scene, &solved.motions)?;
    let speed = instant
        .state
        .iter()
        .fold(1.0, |most: f64, x| most.max(x.high.abs()));
    let widened = |vector: Vector, error: f64| Vector {
        size: 1e8 * vector.size + 100.0 * speed * speed + 1e23 * error,
        ..vector
    };
    let [linear, angular] = solved.errors;
    let sizes = std::array::from_fn(|i| answer.sizes[i].max(CARRIED * solved.carried[i]));
    Some(Answer {
        linear: widened(answer.linear, linear),
        angular: widened(answer.angular, angular),
        moment: widened(answer.moment, constants.inertia.size.max(1.0) * angular),
        sizes,
    })
}

/// Whether constraints and unknowns determine each other at an instant, beyond doubt.
pub fn is_determined(constants: &Constants<'_>, given: &Given, instant: &Instant) -> bool {
    let solved = constrained(constants, given, instant);
    solved.is_some_and(|solved| solved.condition < 1e3 && !solved.is_near_switch)
}

pub fn is_finite(vector: &Vector) -> bool {
    vector.size.is_finite() && vector.value.iter().all(|x| x.high.is_finite())
}

/// All that acts, but for unknown components.
fn driving(scene: &Scene<'_>) -> Wrench {
    let loads = scene.constants.body.loads.iter();
    let given = loads
        .filter_map(|load| acting(scene, load))
        .map(|load: Acting| load.wrench);
    let open = open_loads(scene, true).into_iter().map(|open| open.given);
    given.chain(open).fold(Wrench::ZERO, Wrench::and)
}

fn moment(scene: &Scene<'_>, motions: &Motions) -> Vector {
    let body: &Body = scene.constants.body;
    if is_rod(body) {
        let rate = scene.axis_rate;
        return motions.angular + scene.axis.scaled(rate.dot(rate));
    }
    if is_hinged(body) || body.motion.is_planar() {
        return motions.angular;
    }
    let change = inertial(scene, motions);
    scene.in_body(if body.motion.support().is_some() {
        change.about_held
    } else {
        change.about_center
    })
}

/// Whether two vectors differ by more than this part of the terms that they are sums of, where
/// these have 106 bits.
pub fn differs(a: Vector, b: Vector, tolerance: f64) -> bool {
    let size = a.size.max(b.size);
    if size < LEAST {
        return false;
    }
    let pairs = a.value.iter().zip(&b.value);
    pairs
        .map(|(x, y)| (*x - *y).high.abs())
        .any(|difference| difference > tolerance * size)
}

pub fn shown(vector: Vector) -> String {
    let [x, y, z] = vector.value.map(|x| x.high);
    format!("({x:e}, {y:e}, {z:e}) of terms up to {:e}", vector.size)
}
