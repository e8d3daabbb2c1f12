//! The loads of a motion per inertial parameter, from the balances of a body about one of its
//! points: `f = m a + w' x h + w x (w x h)`, `n = h x a + J w' + w x J w`.

use crate::description::body::{Key, Motion, What};
use crate::description::expression::{Scalar, Vector as Written};
use crate::output::Output;
use crate::wide::Wide;

use super::law::{Motions, angular_in_world};
use super::loads::is_uniform;
use super::number::Number;
use super::scene::Scene;
use super::vector::Vector;

/// Force and moment by a unit of each parameter, and the parameters themselves.
pub struct Regressed {
    pub columns: Vec<[Vector; 2]>,
    pub parameters: Vec<Number>,
}

/// The rows that a motion has: of force, of moment.
pub fn outputs(motion: &Motion) -> &'static [Output] {
    const BOTH: [Output; 2] = [Output::RegressorForce, Output::RegressorMoment];
    match motion {
        Motion::Spatial | Motion::Rod(_) | Motion::Planar => &BOTH,
        Motion::Translation | Motion::PlanarTranslation => &BOTH[..1],
        _ => &BOTH[1..],
    }
}

/// The rows of a motion with these accelerations.
pub fn regressed(scene: &Scene<'_>, motions: &Motions) -> Regressed {
    let constants = scene.constants;
    let motion = &constants.body.motion;
    let held = motion.support().is_some();
    let linear = if held { Vector::ZERO } else { motions.linear } - fall(scene);
    let angular = angular_in_world(scene, motions.angular);
    if let Motion::Rod(_) = motion {
        let (axis, zero) = (scene.axis, Vector::ZERO);
        return Regressed {
            columns: vec![
                [linear, zero],
                [motions.angular, axis.cross(linear)],
                [zero, angular],
            ],
            parameters: vec![constants.mass, Number::ZERO, constants.across()],
        };
    }
    let in_body = |vector: Vector| scene.in_body(vector);
    let [a, turning, w] = [linear, angular, scene.angular_velocity].map(in_body);
    let zero = Vector::ZERO;
    let mut columns = vec![[a, zero]];
    for axis in 0..3 {
        let h = unit(axis);
        let f = turning.cross(h) + w.cross(w.cross(h));
        columns.push([f, h.cross(a)]);
    }
    for (i, j) in ENTRIES {
        let taken = |v: Vector| {
            let along = unit(i).scaled(v.component(j));
            if i == j {
                along
            } else {
                along + unit(j).scaled(v.component(i))
            }
        };
        columns.push([zero, taken(turning) + w.cross(taken(w))]);
    }
    let inertia = &constants.inertia;
    let entry =
        |(i, j): (usize, usize)| Number::made(inertia.value[i][j], inertia.size, inertia.known);
    let first = constants.held_to_center.map(|part| constants.mass * part);
    let parameters = [constants.mass].into_iter().chain(first);
    let parameters: Vec<Number> = parameters.chain(ENTRIES.map(entry)).collect();
    let told = told(motion);
    Regressed {
        columns: told.iter().map(|i| rows(scene, columns[*i])).collect(),
        parameters: told.iter().map(|i| parameters[*i]).collect(),
    }
}

/// The entries of a tensor in the order of the parameters.
const ENTRIES: [(usize, usize); 6] = [(0, 0), (1, 1), (2, 2), (0, 1), (1, 2), (2, 0)];

fn told(motion: &Motion) -> &'static [usize] {
    match motion {
        Motion::Translation | Motion::PlanarTranslation => &[0],
        Motion::Rotation => &[4, 5, 6, 7, 8, 9],
        Motion::Planar | Motion::Pivot(_) => &[0, 1, 2, 6],
        _ => &[0, 1, 2, 3, 4, 5, 6, 7, 8, 9],
    }
}

/// As a body gives them: of a hinge what is along its axis, in the plane what is normal to it.
fn rows(scene: &Scene<'_>, [force, moment]: [Vector; 2]) -> [Vector; 2] {
    let along = match scene.constants.body.motion {
        Motion::Pivot(_) | Motion::FixedAxis(..) | Motion::Planar => Vector {
            value: scene.constants.direction,
            size: 1.0,
        },
        _ => return [force, moment],
    };
    [force, Vector::scalar(along.dot(moment))]
}

fn unit(axis: usize) -> Vector {
    let mut value = [Wide::ZERO; 3];
    value[axis] = Wide::ONE;
    Vector { value, size: 1.0 }
}

/// The acceleration of free fall, in the weights at G: no other field is drawn that is proportional
/// to mass.
fn fall(scene: &Scene<'_>) -> Vector {
    let constants = scene.constants;
    let loads = constants
        .body
        .loads
        .iter()
        .filter(|load| load.key == Key::Fields);
    loads.fold(Vector::ZERO, |all, load| match &load.what {
        What::Force(force @ Written::Scaled(factor, fall), place)
            if matches!(**factor, Scalar::Mass) && is_uniform(scene, force, place) =>
        {
            let arm = scene.arm(place);
            let is_at_center = arm.value.iter().all(|part| *part == Wide::ZERO);
            if is_at_center {
                all + scene.vector(fall)
            } else {
                all
            }
        }
        _ => all,
    })
}
