//! What a description means at an instant, by the vector law.

use crate::description::body::Body;
use crate::given::Given;
use crate::layout::{is_hinged, is_rod};
use crate::oracle::Constants;
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
}

/// Nothing where a number is not finite, or a condition is not decided.
pub fn answer(constants: &Constants<'_>, given: &Given, instant: &Instant) -> Option<Answer> {
    let scene = Scene::at(constants, given, instant);
    let driving = driving(&scene);
    let motions = acceleration(&scene, &driving);
    let moment = moment(&scene, &motions);
    let answer = Answer {
        linear: motions.linear,
        angular: motions.angular,
        moment,
    };
    let vectors = [answer.linear, answer.angular, answer.moment];
    let is_known = vectors.iter().all(is_finite);
    (is_known && !scene.is_near_switch()).then_some(answer)
}

pub fn is_finite(vector: &Vector) -> bool {
    vector.size.is_finite() && vector.value.iter().all(|x| x.high.is_finite())
}

/// All that acts, but for unknown components.
fn driving(scene: &Scene<'_>) -> Wrench {
    let loads = scene.constants.body.loads.iter();
    let given = loads.filter_map(|load| acting(scene, load)).map(|load: Acting| load.wrench);
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

/// Whether two vectors differ by more than this part of the terms that they are sums of; the size of that.
pub fn differs(a: Vector, b: Vector, tolerance: f64) -> bool {
    let size = a.size.max(b.size);
    let pairs = a.value.iter().zip(&b.value);
    pairs.map(|(x, y)| (*x - *y).high.abs()).any(|difference| difference > tolerance * size)
}

pub fn shown(vector: Vector) -> String {
    let [x, y, z] = vector.value.map(|x| x.high);
    format!("({x:e}, {y:e}, {z:e}) of terms up to {:e}", vector.size)
}
